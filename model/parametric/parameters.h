// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/parametric/weightspace.h"
#include "model/sequence/axes.h"
#include "model/synthesis/clips/ground.h"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// What a parameter of a motion space measures.
enum class SpaceMeasure
{
    Speed,      ///< mean speed over the ground along a circle, metres a second
    Turning,    ///< mean rate of turning to the left, degrees a second
    JumpHeight, ///< by how much the body's centre is higher at most than at first, metres
    JumpLength, ///< way over the ground while nothing touches it, metres
    Height,     ///< of a vertex where it is farthest from the body's centre, metres
    Forward,    ///< of the same, how far before the body's centre
    Side,       ///< of the same, how far to its left
    ByHand,     ///< places of takes are given
};

struct SpaceParameter
{
    std::string name;
    SpaceMeasure measure = SpaceMeasure::Speed;
    VertexIndex vertex{0}; ///< of Height, Forward and Side

    bool operator==(const SpaceParameter&) const = default;
};

/// A movement from its first to its last frame, as a space stores it.
struct PerformedMovement
{
    std::span<const Vec3f> poses; ///< frames × vertices
    std::size_t vertexCount = 0;
    std::span<const GroundMotion> steps;
    std::span<const double> seconds;
    bool isCyclic = false; ///< its last step counts
    UpAxis up = UpAxis::Y;
};

/// \pre Some frames; the vertex is one of the mesh. \return 0 for ByHand.
double measured(const SpaceParameter& parameter, const PerformedMovement& movement);

/// The way from parameters to places in a space (IA4D section 3.1.4). The parameters of a blend are not quite
/// where takes that are placed by theirs would have it: a quadratic polynomial of the parameters tells the
/// place at which they are met.
struct ParameterMap
{
    int dimension = 0;
    /// Of each coordinate of the place its coefficients: 1, p₀ …, then pᵢ·pⱼ with i ≤ j, of parameters that
    /// are scaled to 0 … 1.
    Eigen::MatrixXd coefficients;
    SpacePoint least{};
    SpacePoint greatest{};      ///< of the takes
    SpacePoint meanResidual{};  ///< by how much parameters are missed, root of the mean square, in their unit
    SpacePoint worstResidual{}; ///< and at most

    /// The place where parameters are met; they are taken to their limits first.
    SpacePoint placeOf(const SpacePoint& parameters) const;
};

/// Fits the map to what is measured all over a space, a twentieth of each range apart.
/// \param measure  the parameters of the blend at a place. \throws Error BadArgument (parameters that do not
/// grow with their place, with their names).
ParameterMap fitParameterMap(const WeightSpace& space, const std::vector<SpaceParameter>& parameters,
                             const std::function<SpacePoint(const SpacePoint& place)>& measure);

} // namespace quadrille
