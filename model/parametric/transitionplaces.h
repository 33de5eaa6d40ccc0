// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/weightspace.h"

#include <vector>

namespace quadrille {

/// Where transitions leave and enter a space, besides the place where it is played. They belong to the space,
/// so that all that is known of them is computed once, however many dimensions there are.
struct TransitionPlaces
{
    int dimension = 0;
    SpacePoint step{};                ///< of each axis
    std::vector<SpacePoint> places;   ///< all within the space, none twice
    std::vector<NodeWeights> weights; ///< of each place
};

/// The nodes of a space, then a grid over the range of its takes; grid points outside of the space are taken
/// to their nearest places within.
/// \param steps  of each axis' range, at least 1 (IA4D section 3.2.4: 10).
TransitionPlaces transitionPlaces(const WeightSpace& space, int steps);

/// The frame of a space that a time is nearest to. \param frame  fractional, not negative.
std::size_t nearestFrame(double frame, std::size_t frames, bool isCyclic);

/// In how many frames a place moves to another one. \param stepsAFrame  of the axis on which it is farthest.
int framesBetween(const TransitionPlaces& places, const SpacePoint& from, const SpacePoint& to,
                  double stepsAFrame = 1);

} // namespace quadrille
