// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/transition/characterframes.h"
#include "model/transition/framepair.h"
#include "model/transition/poseinterpolation.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// How a pose between two others keeps their sizes (SMCAS Fig. 4): against lengths and volumes that go evenly
/// from one to the other, as parts of these.
struct ShapeChange
{
    double meanEdge = 0;      ///< mean change of the edge lengths; negative where the surface shrinks
    double edgeDeviation = 0; ///< root of the mean squared change
    double greatestEdge = 0;  ///< largest absolute change of an edge
    double volume = 0;        ///< change of the enclosed volume; infinite where the mesh is not closed
};

/// Edges of the triangles of a topology, each once, sorted.
std::vector<std::array<VertexIndex, 2>> edgesOf(const Topology& topology);

/// \param edges  of the topology. Those without length in both poses do not count.
/// \param lambda  where between the source (0) and the target (1) the pose is to be.
ShapeChange shapeChange(const Topology& topology, std::span<const std::array<VertexIndex, 2>> edges,
                        Positions source, Positions target, double lambda, Positions between);

/// The pose of a pair at λ, by one of the methods.
struct InterpolatedPair
{
    FramePair frames;
    InterpolationMethod method = InterpolationMethod::Poisson;
    double lambda = 0;
    ShapeChange change;
};

/// Interpolates pairs of poses by every method at some λ; the targets are first turned and moved onto the
/// sources. \param topology  of the character.
/// \return pairs × methods (linear, slerp, Poisson) × λ.
/// \throws Error what reading frames throws, Cancelled.
std::vector<InterpolatedPair> interpolatePairs(const CharacterFrames& character,
                                               const std::shared_ptr<const Topology>& topology,
                                               std::span<const FramePair> pairs,
                                               std::span<const double> lambdas,
                                               const Progress& progress = {});

/// Pairs of different frames, drawn at random: the same for the same seed, on every machine.
/// \return none where there are fewer than two frames.
std::vector<FramePair> drawPairs(NodeIndex frameCount, int count, std::uint64_t seed);

} // namespace quadrille
