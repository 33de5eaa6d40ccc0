// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/animate.h"
#include "model/project/opencharacter.h"

#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// An animation as it was solved, with all that its views show; a value that several threads may hold.
struct AnimationResult
{
    AnimationEntry entry; ///< as it was then
    std::shared_ptr<const OpenedCharacter> character;
    AnimationWalk walk;
    ClipPlan plan;                       ///< before post-processing
    MeshSequence sequence;               ///< after it
    std::vector<FrameOrigin> origins;    ///< of the frames of `sequence`
    std::optional<GroundMotion> travel;  ///< of a loop, see PostProcessed
    std::int64_t framesBeforeRetime = 0; ///< see PostProcessed
    bool isFinal = false;                ///< otherwise the best walk so far
};

} // namespace quadrille
