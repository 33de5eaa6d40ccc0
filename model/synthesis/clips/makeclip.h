// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/clipplan.h"
#include "model/transition/characterframes.h"
#include "model/transition/poseinterpolation.h"

#include <memory>
#include <vector>

namespace quadrille {

/// Shows single frames of a plan, such as those that somebody scrubs over. What it needs of a topology is
/// prepared once. Immutable; safe from any thread.
class ClipPlayer
{
public:
    /// \pre The plan's origins are frames of the character.
    ClipPlayer(CharacterFrames character, ClipPlan plan,
               InterpolationMethod method = InterpolationMethod::Poisson);

    const ClipPlan& plan() const { return m_plan; }
    std::int64_t frameCount() const { return m_plan.frameCount(); }
    /// The same bytes as the frame of makeClip has. \pre 0 ≤ frame < frameCount().
    /// \throws Error as CharacterFrames::frame. Cost: two numeric factorisations where poses are blended.
    std::vector<Vec3f> frame(std::int64_t frame) const;
    /// All frames, in parallel. \throws Error as frame, Cancelled. Cost: beside the clip, the frames and
    /// prepared poses of a bounded number of frames.
    Clip clip(const Progress& progress = {}) const;

private:
    void blendInto(Clip& clip, std::span<const std::int64_t> frames, const Progress& progress) const;

    CharacterFrames m_character;
    ClipPlan m_plan;
    InterpolationMethod m_method;
    std::shared_ptr<const PoissonSystem> m_system;
};

/// The surfaces of a plan with the origin of each frame. The same for any number of threads.
/// \throws Error as ClipPlayer::clip.
Clip makeClip(const CharacterFrames& character, const ClipPlan& plan,
              InterpolationMethod method = InterpolationMethod::Poisson, const Progress& progress = {});

/// The frames of one transition alone: the first is exactly pose i, the last exactly pose j, moved over the
/// ground (SMCAS Alg. 1). \throws Error as makeClip.
Clip blendTransition(const CharacterFrames& character, const RootPoses& roots, const Transition& transition,
                     const PlanOptions& options = {},
                     InterpolationMethod method = InterpolationMethod::Poisson,
                     const Progress& progress = {});

} // namespace quadrille
