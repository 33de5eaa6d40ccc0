// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/partoverlap.h"

#include <span>
#include <vector>

namespace quadrille::test {

/// A closed curve around a band and what it costs.
struct PlainSeam
{
    std::vector<std::uint32_t> vertices;
    double cost = 0;
};

/// The cheapest closed curve around the x axis: from every vertex the cheapest way round, on three layers of
/// the band that hang together behind the axis.
/// \param places  of the overlap's vertices in a pose along the x axis.
PlainSeam plainSeam(const PartOverlap& overlap, Positions places, std::span<const double> costs);

/// Parts in one piece, joined plainly: shares by PartOverlap, gradients mixed by singular value
/// decompositions and matrix logarithms, a Poisson system factorised anew, in double precision.
/// \param seams  of each part; the root's is empty.
std::vector<Vec3f> plainStitch(const Topology& topology, const BodyParts& parts, Positions pose,
                               std::span<const Positions> poses,
                               std::span<const std::vector<VertexIndex>> seams);

} // namespace quadrille::test
