// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A variation of captured frames of one take in their timing: one frame for each of them.
struct TakeVariation
{
    std::string name;             ///< of its clip, "variations/walks/3"
    NodeIndex first = 0;          ///< captured frame that its first frame varies
    NodeIndex last = 0;           ///< and its last one; of the same take
    std::vector<Vec3f> positions; ///< frames × vertices, where the take was captured

    NodeIndex frameCount() const { return last - first + 1; }
    bool varies(NodeIndex node) const { return first <= node && node <= last; }
};

/// A span of a walk as a clip shows it, and what it is drawn from.
struct SpanDraw
{
    std::optional<WalkSpan> frames;       ///< captured frames that are shown; nothing where none are
    std::int64_t start = 0;               ///< frame of the clip that shows the first of them
    bool isRepeat = false;                ///< some of them were shown by a span before
    std::optional<std::size_t> variation; ///< as captured when empty
    int playing = 0;                      ///< of the walk, where it is played several times
};

/// The span of a walk that a frame of its plan belongs to; for one between two spans the first of them.
std::size_t spanAt(const ClipPlan& plan, std::int64_t frame);

/// Whether a frame of a plan lies between two spans.
bool isBetweenSpans(const ClipPlan& plan, std::int64_t frame);

/// Chooses what repeats are drawn from: the first use of captured frames stays as captured; each span that
/// shows frames again which a variation of their take varies gets the next such variation, in the order
/// given, from the first again after the last. \param playings  of the plan, one behind the other, such as
/// those of a loop: all but the first show frames again. \return one for each span of the walk, for each
/// playing.
std::vector<SpanDraw> drawRepeats(const ClipPlan& plan, const FrameLayout& layout,
                                  std::span<const TakeVariation> variations, int playings = 1);

} // namespace quadrille
