// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/supports.h"
#include "model/synthesis/finishing/repeats.h"
#include "model/transition/characterframes.h"
#include "model/transition/interpolationmethod.h"

namespace quadrille {

struct VariedPlanSettings
{
    /// How long poses take from captured frames to varied ones, and back, where a take goes on beyond what a
    /// variation varies, seconds; at most a third of the variation.
    double easeSeconds = 0.2;
    /// Over how long the way of a variation is evened out against that of the captured frames, seconds
    /// (standard deviation): its steps drive its body by fits and starts; standing feet then slip a little.
    double wayEvening = 0.06;
    InterpolationMethod interpolation = InterpolationMethod::Poisson;
};

/// A plan some of whose spans show variations, with the frames that it shows.
struct VariedPlan
{
    CharacterFrames character; ///< with takes of varied frames behind those of the character
    /// Its times count the frames of `character`; its origins count those of the character given, and its
    /// variations from 1.
    ClipPlan plan;
};

/// How far each of some frames is another one: less than 1 near the ends that are eased, smoothly.
/// \param frames  that an ease lasts; at most a third of all.
std::vector<double> easedWeights(std::size_t count, bool easesIn, bool easesOut, double frames);

/// Lets spans of a plan show variations, frame by frame, in transitions from and to them as well: these blend
/// from what is shown to what is shown. A variation lies on the ground so that its first and last frame stand
/// where the captured ones do, and what it is off by in between is shared out evenly, so that its feet keep
/// to the ground as well as they did; the walk goes where it went. \param spans  of the plan, by drawRepeats.
/// \param supports  what stands in each captured frame; empty where nobody knows: centres are laid over each
/// other then. \return the plan and the character as they are where nothing is drawn. \throws Error
/// VertexCountMismatch, what reading frames throws, Cancelled. Cost: two interpolations for each frame of an
/// ease; keeps the variations that are drawn in memory.
VariedPlan variedPlan(const CharacterFrames& character, ClipPlan plan, std::span<const SpanDraw> spans,
                      std::span<const TakeVariation> variations, std::span<const Support> supports = {},
                      const VariedPlanSettings& settings = {}, const Progress& progress = {});

} // namespace quadrille
