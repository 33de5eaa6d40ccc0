// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace quadrille {

/// Numbers and the weight they have in a sum.
struct WeightedPose
{
    const float* values = nullptr;
    float weight = 0;
};

/// out = Σ weight · values. \pre Each has as many values as out; at least one pose.
void addPoses(std::span<const WeightedPose> poses, std::span<float> out);

} // namespace quadrille
