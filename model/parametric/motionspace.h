// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/parametric/parameters.h"
#include "model/parametric/spacetake.h"
#include "model/parametric/weightspace.h"
#include "model/sequence/axes.h"
#include "model/synthesis/clips/ground.h"
#include "model/transition/interpolationmethod.h"
#include "model/variation/alignment.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// What a reference adds to the linear blend of the takes (IA4D section 3.1.2): D of eq. 3, of the vertices
/// that are farther off than a fifth of the tolerance. Left out up to the tolerance itself, displacements
/// would end in steps of the surface that are as high.
struct SpaceReference
{
    std::vector<std::uint32_t> starts;   ///< frames + 1: where the vertices of each frame begin
    std::vector<std::uint32_t> vertices; ///< ascending in each frame
    std::vector<std::array<std::int16_t, 3>> displacements; ///< of them
    float unit = 0;                                         ///< of displacements, metres

    /// Bytes that it takes.
    std::size_t memory() const;
};

/// Takes of one kind of movement as one movement that parameters steer (IA4D section 3.1). A plain value.
/// Frames are those of the reference take; where the space is cyclic the first follows the last.
struct MotionSpace
{
    std::string name;
    std::shared_ptr<const Topology> topology;
    UpAxis up = UpAxis::Y;
    double fps = 25; ///< of the frames
    bool isCyclic = false;
    std::vector<SpaceTake> takes;
    /// Nodes are the takes, then the references; places are values of the parameters.
    WeightSpace weights;
    std::vector<SpaceReference> references;
    std::vector<SpaceParameter> parameters;
    ParameterMap map;

    std::size_t frameCount() const { return takes.front().steps.size(); }
    std::size_t vertexCount() const { return topology->vertexCount(); }
    /// The frame after another one: the last is followed by itself where the space is not cyclic.
    std::size_t next(std::size_t frame) const
    {
        return frame + 1 < frameCount() ? frame + 1 : isCyclic ? 0 : frame;
    }
};

struct MotionSpaceSettings
{
    AlignmentSettings alignment;
    InterpolationMethod method = InterpolationMethod::Slerp; ///< of the non-linear blend
    double tolerance = 0.005; ///< greatest error of the hybrid blend, metres; and what is stored of it
    int mostReferences = 31;  ///< bisection ends there
};

/// A take of a space.
struct SpaceTakeSource
{
    TrainingTake take;
    double speed = 1;                ///< in which it is played
    std::optional<SpacePoint> place; ///< on the axes by hand; measured where it is left out
};

/// Warps takes to common phase, closes their cycles, places them on the axes, bisects the space until the
/// hybrid blend is near enough to the non-linear one everywhere, and fits the map from parameters.
/// \param reference  whose frames are those of the space. \param templatePose  of all vertices, which all
/// spaces of a character share. \throws Error as alignTakes; BadArgument (places, parameters that cannot be
/// inverted, a take without a cycle among others that have one); Cancelled.
/// Cost: some hundred Poisson solves a reference.
MotionSpace makeMotionSpace(std::string name, std::span<const SpaceTakeSource> takes, std::size_t reference,
                            std::vector<SpaceParameter> parameters, Positions templatePose,
                            const MotionSpaceSettings& settings = {}, const Progress& progress = {});

} // namespace quadrille
