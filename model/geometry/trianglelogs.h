// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poissonsystem.h"
#include "model/geometry/poseframes.h"

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// How one pose differs from another, triangle by triangle: logarithms of the polar factors R·S of the map
/// from source to target (SMCAS eq. 1, 5), which keeps the unit normal, in closed form.
/// In the plane of the source triangle S = e^s·(cosh h·I + sinh h·U) with U = [u1 u2; u2 −u1] of unit
/// length. Double precision, one array per quantity.
struct TriangleLogs
{
    std::vector<double> axisX; ///< unit axis of R; zero where R is the identity
    std::vector<double> axisY;
    std::vector<double> axisZ;
    std::vector<double> halfAngle;  ///< of R; in [0, π/2] before `chooseBranches`, in [−π, π] afterwards
    std::vector<double> cosine;     ///< of the half angle in [0, π/2]
    std::vector<double> logScale;   ///< s
    std::vector<double> logStretch; ///< h ≥ 0
    std::vector<double> u1;
    std::vector<double> u2;

    std::size_t size() const { return halfAngle.size(); }
};

/// Logarithms from source to target, the target first turned back by a rotation.
/// Triangles without area in either pose get meaningless values; see `borrowRotations`.
TriangleLogs triangleLogs(const PoseFrames& source, const PoseFrames& target,
                          const Eigen::Quaterniond& targetRotation);

/// Gives triangles without area the rotation of the nearest ones that have some, over their edges; the
/// identity where there are none. \param triangles  those without area, ascending.
void borrowRotations(const PoissonSystem& system, std::span<const int> triangles, TriangleLogs& logs);

/// Chooses for each rotation the way round (by θ about its axis or by 360° − θ the other way) that fits its
/// neighbours, so that parts turned past 180 degrees against the others go one way as a whole. Regions grow
/// over the edges with the least difference first, from the triangle that turns least. Where all neighbours
/// fit, nothing changes. Parts wound by more than a whole turn lose their winding: nothing tells them apart.
void chooseBranches(const PoissonSystem& system, TriangleLogs& logs);

/// How the stretch S moves from none to all.
enum class StretchPath
{
    Geodesic, ///< exp(λ·log S), SMCAS eq. 5
    Linear,   ///< (1 − λ)·I + λ·S, IA4D eq. 2
};

/// The edges of every triangle of the source deformed by exp(λ·log R) and the stretch at λ. The target
/// deformed towards the source by 1 − λ has the same edges, before it is turned. \param out  one per
/// triangle.
void deformEdges(const PoseFrames& source, const TriangleLogs& logs, double lambda, StretchPath path,
                 std::span<TriangleEdges> out);

} // namespace quadrille
