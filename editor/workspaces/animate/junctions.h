// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/openanimation.h"

#include <optional>
#include <vector>

namespace quadrille {

/// Frames of a clip, both included.
struct ClipFrames
{
    std::int64_t first = 0;
    std::int64_t last = 0;
    bool operator==(const ClipFrames&) const = default;
};

/// A transition with what its weight is made of; both parts without a unit, as the weights of the graph.
struct PricedJunction
{
    FramePair frames;
    JunctionEntry names;
    int length = 0;         ///< L, frames
    double deformation = 0; ///< D/d_max
    double duration = 0;    ///< α·L
    double weight() const { return deformation + duration; }
};

/// A transition of a clip.
struct ClipJunction
{
    PricedJunction transition;
    /// Where the clip that is shown has it; nothing where post-processing has cut it away.
    std::optional<ClipFrames> shown;
};

PricedJunction priced(const CharacterGraph& graph, const FramePair& frames);

/// The transitions of a result, in the order in which they are performed.
std::vector<ClipJunction> junctionsOf(const AnimationResult& result);

/// The frame of the clip that is shown which comes from a frame before post-processing, or is nearest to it
/// on the same transition; nothing where there is none. Without loop and retiming it is the frame itself;
/// else cost: O(frames).
std::optional<std::int64_t> shownFrame(const AnimationResult& result, std::int64_t planned);

/// What could take the place of a transition: the cheapest others that lie near it and leave the frames
/// before and behind as they are, each some frames apart from all others, cheapest first. Near is within half
/// a second at both ends; apart is three frames at one end at least. Cost: O(n log n) in the transitions that
/// are as near. \param junction place in junctionsOf. \param decided  whose banned transitions are left out.
std::vector<PricedJunction> alternativesTo(const AnimationResult& result, std::size_t junction,
                                           const JunctionsEntry& decided, std::size_t count = 10);

/// The transitions of the graph that are hardly another than this one, which is the first of them: both ends
/// lie within two frames. Only those between the same two takes.
std::vector<JunctionEntry> neighboursOf(const CharacterGraph& graph, const FramePair& transition);

/// The walk of a result, for the file.
std::vector<WalkSpanEntry> walkSpansOf(const AnimationResult& result);
/// The walk of a result as an entry that keeps it. Its turn is in degrees, its place in the project's unit
/// and axes.
WalkEntry walkEntryOf(const AnimationResult& result);

// Decisions; each takes back those that contradict it.
void ban(JunctionsEntry& junctions, const JunctionEntry& junction);
void lock(JunctionsEntry& junctions, const JunctionEntry& junction);
/// \param instead  the transition whose place it takes.
void choose(JunctionsEntry& junctions, const JunctionEntry& junction, const JunctionEntry& instead);
/// Takes back whatever was decided about it.
void forget(JunctionsEntry& junctions, const JunctionEntry& junction);
bool contains(const std::vector<JunctionEntry>& junctions, const JunctionEntry& junction);

} // namespace quadrille
