// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <string>

namespace quadrille::test {

/// Variations of two takes, the first of them as often as asked: learned and sampled in no time, and good
/// whatever they look like.
inline VariationEntry quickVariation(const std::string& name, const std::string& first,
                                     const std::string& second, int count)
{
    VariationEntry entry;
    entry.name = name;
    entry.training.resize(2);
    entry.training[0].sequence = first;
    entry.training[1].sequence = second;
    entry.cycles = false;
    entry.learning.restarts = 0;
    entry.learning.tolerance = 1e-4;
    entry.chain = {.leapfrogSteps = 10, .burnIn = 20, .thinning = 2};
    entry.limits = {
        .poseDistance = 10, .skate = 10, .intersections = 1, .volumeChange = 10, .collapse = 1, .sink = 10};
    entry.samples = {{.of = first, .count = count}};
    return entry;
}

} // namespace quadrille::test
