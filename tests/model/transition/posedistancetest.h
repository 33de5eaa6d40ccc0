// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/transition/posedistance.h"
#include "tests/model/codeof.h"

#include <Eigen/Geometry>
#include <functional>
#include <gtest/gtest.h>

namespace quadrille::test {

using test::codeOf;

using Pose = std::vector<Vec3f>;

/// A topology of some triangles.
inline std::shared_ptr<const Topology> topologyOf(std::uint32_t vertices,
                                                  const std::vector<std::array<int, 3>>& faces)
{
    TopologyData data{.vertexCount = vertices};
    for (const auto& [a, b, c] : faces)
        data.triangles.push_back({VertexIndex(a), VertexIndex(b), VertexIndex(c)});
    return std::make_shared<Topology>(std::move(data));
}

inline MeshSequence sequenceOf(const std::shared_ptr<const Topology>& topology,
                               const std::vector<Pose>& poses, const std::string& name = "take")
{
    std::vector<Vec3f> positions;
    for (const Pose& pose : poses)
        positions.insert(positions.end(), pose.begin(), pose.end());
    return makeSequence(name, topology,
                        std::make_shared<MemoryFrames>(std::move(positions), topology->vertexCount()), 25);
}

inline CharacterFrames characterOf(const MeshSequence& sequence)
{
    return CharacterFrames(std::span(&sequence, 1));
}

/// The only distance of two poses.
inline double distanceOf(const std::shared_ptr<const Topology>& topology, const Pose& a, const Pose& b,
                         const PoseDistanceSettings& settings = {})
{
    return poseDistances(characterOf(sequenceOf(topology, {a, b})), settings).distances(0, 1);
}

inline std::shared_ptr<const Topology> tetrahedron()
{
    return topologyOf(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}
inline const Pose corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

inline Pose moved(const Pose& pose, const Eigen::Affine3d& motion)
{
    Pose result;
    for (const Vec3f& p : pose)
        result.push_back((motion * p.cast<double>()).cast<float>());
    return result;
}

inline Eigen::Affine3d someMotion()
{
    return Eigen::Translation3d(4, -2, 1) * Eigen::AngleAxisd(2.5, Vec3d(1, 2, -1).normalized());
}

} // namespace quadrille::test
