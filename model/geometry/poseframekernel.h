// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace quadrille {

inline constexpr std::size_t frameBlockSize = 64;

/// Of some triangles: two edges in, their frames out (see PoseFrames).
struct FrameBlock
{
    std::array<std::array<double, frameBlockSize>, 3> first;
    std::array<std::array<double, frameBlockSize>, 3> second;
    std::array<std::array<double, frameBlockSize>, 4> quaternion;
    std::array<std::array<double, frameBlockSize>, 3> edges;
    std::array<double, frameBlockSize> doubleArea;
};

/// Computes frames and edges of a block; those of triangles without area are the identity.
/// \param least  twice the area from which a triangle counts.
void computeFrames(FrameBlock& block, double least);

} // namespace quadrille
