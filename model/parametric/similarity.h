// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/parametric/motionspace.h"

#include <span>
#include <vector>

namespace quadrille {

struct SimilaritySettings
{
    double velocityWeight = 1; ///< λ_v of the difference of velocities; not negative

    bool operator==(const SimilaritySettings&) const = default;
};

/// How far the frames of two motion spaces are apart, for each pair of their nodes (IA4D section 3.2.1):
/// d = (‖ΔX‖ + λ_v·‖ΔV‖) / vertices, the norms over all coordinates of all vertices. A plain value.
struct SimilarityTable
{
    std::size_t sourceFrames = 0;
    std::size_t targetFrames = 0;
    std::size_t sourceNodes = 0;
    std::size_t targetNodes = 0;
    /// d, metres a vertex: source frames × target frames × source nodes × target nodes.
    std::vector<float> distances;
    std::vector<float> leasts; ///< of each pair of frames the least: source frames × target frames
    float greatest = 0;        ///< of all

    std::size_t pairOf(std::size_t sourceFrame, std::size_t targetFrame) const
    {
        return sourceFrame * targetFrames + targetFrame;
    }
    /// Source nodes × target nodes.
    std::span<const float> block(std::size_t sourceFrame, std::size_t targetFrame) const
    {
        const std::size_t size = sourceNodes * targetNodes;
        return std::span(distances).subspan(pairOf(sourceFrame, targetFrame) * size, size);
    }
    /// Takes d to the dissimilarity E_S = 1000·d / greatest d; 0 where all poses are the same.
    double scale() const { return greatest > 0 ? 1000 / static_cast<double>(greatest) : 0; }

    bool operator==(const SimilarityTable&) const = default;
};

/// Compares all frames and nodes of two spaces, or of a space with itself. Poses of a reference are the
/// linear blend of the takes and its displacements. Velocities are those of vertices over the ground, seen
/// from the body, for a frame of time: from a frame to the next one, at the end of a space without a cycle
/// from the frame before. Unlike in the paper, whose meshes stay in place, the way over the ground counts:
/// else a body that walks would go over to one that stands without notice, and its feet would slide.
/// Distances are exact to 1e-6 of the greatest one; poses that are the same may differ by so much.
/// \pre The spaces have one topology and up axis. \throws Error BadArgument (a negative weight), Cancelled.
/// Cost: frames² · nodes² · vertices; 24 bytes for each vertex, node and frame while it is computed.
SimilarityTable similarities(const MotionSpace& source, const MotionSpace& target,
                             const SimilaritySettings& settings = {}, const Progress& progress = {});

/// The dissimilarity E_S of two blends, 0 … 1000: the bilinear approximation of IA4D eq. 5.
/// \pre Frames and nodes are of the table.
double dissimilarity(const SimilarityTable& table, std::size_t sourceFrame, const NodeWeights& source,
                     std::size_t targetFrame, const NodeWeights& target);

} // namespace quadrille
