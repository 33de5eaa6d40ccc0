// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/makeclip.h"
#include "model/transition/posedistance.h"
#include "tests/model/largestdistance.h"
#include "tests/model/transition/swayingtube.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille::test {

/// The sequence with every frame turned and moved over the ground, z up.
inline MeshSequence movedOverGround(const MeshSequence& sequence, const GroundMotion& motion)
{
    const RigidMotion placed = motion.inSpace(Ground(UpAxis::Z));
    std::vector<Vec3f> positions = loadFrames(sequence);
    for (Vec3f& position : positions)
        position = placed(position.cast<double>()).cast<float>();
    return makeSequence(
        sequence.name, sequence.topology,
        std::make_shared<MemoryFrames>(std::move(positions), sequence.topology->vertexCount()), sequence.fps);
}

/// Takes of a tube, with all that clips are made from; z up.
struct TubeTakes
{
    CharacterFrames character;
    RootPoses roots;
    Table<float> distances;
    TransitionSettings settings{.shortestWindow = 4, .longestWindow = 8};
    WarpPaths paths;

    explicit TubeTakes(const std::vector<MeshSequence>& takes)
        : character(takes)
        , roots(rootPoses(character, UpAxis::Z))
        , distances(poseDistances(character).distances)
        , paths(distances, character.layout(), settings)
    {
    }

    ClipPlan plan(const Walk& walk, const PlanOptions& options = {}) const
    {
        return planClip(roots, character.layout(), paths, walk, options);
    }
    Clip clip(const Walk& walk, const PlanOptions& options = {}) const
    {
        return makeClip(character, plan(walk, options));
    }
    /// A frame as captured, moved as planned.
    std::vector<Vec3f> placed(NodeIndex node, const GroundMotion& motion) const
    {
        std::vector<Vec3f> positions;
        const RigidMotion inSpace = motion.inSpace(Ground(roots.up));
        const Frame frame = character.frame(node);
        for (const Vec3f& position : frame.positions())
            positions.push_back(inSpace(position.cast<double>()).cast<float>());
        return positions;
    }
};

/// Two takes of 20 frames of different speeds, and a third of 20.
inline std::vector<MeshSequence> threeTakes()
{
    const auto topology = tubeTopology(12, 9);
    return {swayingTube(topology, 12, 20, 0.02), swayingTube(topology, 12, 20, 0.03),
            swayingTube(topology, 12, 20, 0.025)};
}

/// Both windows advance together.
inline Transition advancingTogether(NodeIndex source, NodeIndex destination, int length)
{
    Transition transition{
        .frames = {source, destination}, .sourceWindow = length, .destinationWindow = length, .cost = 1};
    for (int t = 0; t < length; ++t)
        transition.path.push_back({source + t, destination - length + 1 + t});
    return transition;
}

} // namespace quadrille::test
