// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactersteps.h"

#include <cstdint>

namespace quadrille {

/// The steps that compare all poses of a character: pose distances first, then Euclidean distances and root
/// poses, which the first makes along with its own where they are wanted, too.
std::vector<BuildStep> poseSteps(const CharacterInputs& work);

/// What distances of poses depend on beside the frames.
std::vector<JsonLine> distanceSettings(const PoseDistanceSettings& settings);

/// Of so many tables of all pairs of frames, for BuildStep::bytes.
std::function<std::uint64_t(const Progress&)> bytesOfTables(const CharacterInputs& work, double tables);

} // namespace quadrille
