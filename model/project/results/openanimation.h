// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/opencharacter.h"
#include "model/project/steps/animate.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// An animation with its clip and all that the clip was made of; a value that several threads may hold.
struct AnimationResult
{
    AnimationEntry entry; ///< as it was then
    std::shared_ptr<const OpenedCharacter> character;
    AnimationWalk walk;
    ClipPlan plan;               ///< before post-processing, with variations that it shows
    std::vector<SpanDraw> spans; ///< of the walk, and what they are drawn from
    /// That `spans` and origins count; null where none were asked for.
    std::shared_ptr<const std::vector<TakeVariation>> variations;
    MeshSequence sequence;                ///< after it
    std::vector<FrameProvenance> origins; ///< of the frames of `sequence`
    std::optional<GroundMotion> travel;   ///< of a loop, see PostProcessed
    std::int64_t framesBeforeRetime = 0;  ///< see PostProcessed
    bool isFinal = false;                 ///< otherwise the best walk so far

    /// The variation that a number of an origin means, as "NAME/3"; empty for 0.
    std::string variationName(std::int32_t number) const
    {
        constexpr std::size_t section = std::string_view("variations/").size();
        return number == 0 ? std::string()
                           : variations->at(static_cast<std::size_t>(number) - 1).name.substr(section);
    }
};

using AnimationResultPointer = std::shared_ptr<const AnimationResult>;

/// Opens an animation from its results, which are brought up to date first.
/// \param better  receives the best that there is while a better one is sought, from the thread that seeks.
/// Whoever has it makes it wait: it is asked for no sooner than `pause` seconds after it came back.
/// \throws Error of the step that failed; ProjectInvalid where there is no such animation, or it has no
/// takes; Cancelled.
AnimationResultPointer openAnimation(WorkingProject working, const std::string& name,
                                     const Progress& progress = {},
                                     const std::function<void(AnimationResultPointer)>& better = {},
                                     double pause = 0);

} // namespace quadrille
