// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/motionspace.h"
#include "model/parametric/similarity.h"
#include "model/project/store/result.h"

#include <memory>

namespace quadrille {

// What the steps of the section “motion_spaces” store, and what others take from it.

/// All of a space but its name, topology and up axis.
Result motionSpaceResult(const MotionSpace& space);
/// The space that was stored, the same in all bits but for what is not; that is left as it is in a new one.
/// \pre The result is one of motionSpaceResult.
MotionSpace motionSpaceOf(const Result& stored);

/// How far blends are from the non-linear ones all over a space, and what its parameters are.
/// \throws Error Cancelled. Cost: a non-linear blend of all frames for each place.
Result motionSpaceQuality(const MotionSpace& space, const Progress& progress = {});

Result similarityResult(const SimilarityTable& table);
/// \pre The result is one of similarityResult.
SimilarityTable similaritiesOf(const Result& stored);

/// Transitions that are found while spaces play against those that are computed before, as IA4D Table 2 has
/// them, for the same random states. \throws Error Cancelled.
Result transitionReport(const MotionSpace& source, const MotionSpace& target,
                        const std::shared_ptr<const SimilarityTable>& table, const Progress& progress = {});

} // namespace quadrille
