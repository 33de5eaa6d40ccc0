// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/transitionsettings.h"

#include <cmath>
#include <random>
#include <vector>

namespace quadrille {

/// Distances without structure: symmetric, zero on the diagonal, of `levels` different values (many ties
/// where they are few).
inline Table<float> randomDistances(int frames, unsigned seed, int levels = 1 << 20)
{
    std::mt19937 random(seed);
    Table<float> distances = Table<float>::Zero(frames, frames);
    for (int i = 0; i < frames; ++i) {
        for (int j = 0; j < i; ++j) {
            const auto level = static_cast<int>(random() % static_cast<unsigned>(levels));
            distances(i, j) = distances(j, i) =
                0.1F + 0.9F * static_cast<float>(level) / static_cast<float>(levels);
        }
    }
    return distances;
}

/// Distances between the poses of a body that walks, in gaits of slowly changing period: a point on a wavy
/// closed curve in six dimensions.
inline Table<float> walkingDistances(int frames, unsigned seed, double period = 28)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Eigen::Array<double, 6, 1>> poses;
    double phase = 0;
    double drift = 0;
    for (int f = 0; f < frames; ++f) {
        phase += 2 * 3.14159265358979 / (period * (1 + 0.2 * std::sin(0.013 * f)));
        drift = 0.98 * drift + 0.1 * (uniform(random) - 0.5);
        Eigen::Array<double, 6, 1> pose;
        pose << std::cos(phase), std::sin(phase), 0.4 * std::cos(2 * phase + drift),
            0.4 * std::sin(2 * phase), 0.5 * drift, 0.3 * std::sin(0.01 * f);
        poses.push_back(pose);
    }
    Table<float> distances(frames, frames);
    for (int i = 0; i < frames; ++i) {
        for (int j = 0; j < frames; ++j)
            distances(i, j) = static_cast<float>(std::sqrt(
                (poses[static_cast<std::size_t>(i)] - poses[static_cast<std::size_t>(j)]).square().sum()));
    }
    return distances;
}

inline TransitionSettings windows(int shortest, int longest, int slope = 3,
                                  TransitionCost cost = TransitionCost::Sum)
{
    TransitionSettings settings;
    settings.shortestWindow = shortest;
    settings.longestWindow = longest;
    settings.slope = slope;
    settings.cost = cost;
    return settings;
}

} // namespace quadrille
