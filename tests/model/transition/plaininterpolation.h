// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"
#include "model/transition/poseinterpolation.h"

#include <vector>

namespace quadrille {

/// Pose interpolation word by word from SMCAS eq. 3–7 in double precision, as a reference: gradient operator
/// as a sparse matrix, polar factors by SVD, logarithms of matrices, a factorisation by Eigen at each call.
/// Turns go the short way in each triangle by itself, plus whole turns where given; all triangles must have
/// an area.
std::vector<Vec3d> interpolatePlainly(const Topology& topology, Positions source, Positions target,
                                      double lambda, InterpolationMethod method,
                                      const std::vector<int>& wholeTurns = {});

/// Largest distance between corresponding vertices.
double largestDistance(Positions a, const std::vector<Vec3d>& b);

} // namespace quadrille
