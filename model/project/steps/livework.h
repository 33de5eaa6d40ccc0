// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/liveplayer.h"
#include "model/project/media/opensequence.h"
#include "model/project/steps/buildstep.h"
#include "model/project/store/result.h"
#include "model/synthesis/clips/clip.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// The steps whose results a live graph of some motion spaces is made of.
std::vector<std::string> liveGraphSteps(const std::vector<std::string>& spaces);
/// Their graph. \param context  has the results of liveGraphSteps. \throws Error as sharedMotionSpace;
/// ProjectInvalid where there is no such space; Cancelled.
std::shared_ptr<const LiveGraph> liveGraphFrom(const std::shared_ptr<SequenceOpener>& opener,
                                               const std::vector<std::string>& spaces,
                                               const StepContext& context, const Progress& progress = {});

// What an entry of “live” says to a player.

LiveSettings settingsOf(const LiveEntry& entry);
/// \param axes  those of the project.
LiveStart startOf(const LiveEntry& entry, const CoordinateSystem& axes);
/// Frames of its clip.
std::int64_t performedFrames(const LiveEntry& entry);
/// One for each tick.
std::vector<LiveInput> inputsOf(const LiveEntry& entry);
/// The other way round: only what changes. Ticks are those of the inputs.
std::vector<LiveChange> changesOf(std::span<const LiveInput> inputs);

/// The captured frame that a frame of a space shows of a take. \param frames  of the sequence, some.
FrameIndex capturedFrame(const SpaceTakeEntry& entry, const SpaceTake& take, std::size_t frame,
                         std::int64_t frames);

/// The frames of the takes of live performances: of each sequence of the project once, as provenances count.
class LiveTakes
{
public:
    /// \throws Error as SequenceOpener::open, detectContacts; Cancelled.
    LiveTakes(SequenceOpener& opener, const std::vector<std::string>& spaces, const Progress& progress = {});

    const CharacterFrames& frames() const { return *m_frames; } ///< metres, with contacts
    const std::vector<std::string>& names() const { return m_names; }
    /// \param spaces  of the player's graph, as the entry lists them.
    FrameProvenance of(const LiveProvenance& provenance, const LiveGraph& graph,
                       const std::vector<const MotionSpaceEntry*>& spaces) const;
    /// Both frames of a look; the first one alone where only one of them is mirrored.
    FrameProvenance of(const LiveLook& look, const LiveGraph& graph,
                       const std::vector<const MotionSpaceEntry*>& spaces) const;

private:
    std::vector<std::string> m_names;
    std::optional<CharacterFrames> m_frames;
};

/// A performance as a clip, metres; feet that stand in the takes stand still where the entry says so, and
/// there are feet. Beside it how each frame came about.
struct PerformedLive
{
    Clip clip;
    std::vector<LiveState> states;       ///< of each frame
    std::vector<LiveDecision> decisions; ///< in the order in which they were made
};

/// \param graph  of the entry's spaces. \throws Error as contactsCorrected, LivePlayer; Cancelled.
PerformedLive performLive(const std::shared_ptr<const LiveGraph>& graph, const LiveEntry& entry,
                          const Project& project, const LiveTakes& takes, const Progress& progress = {});

} // namespace quadrille
