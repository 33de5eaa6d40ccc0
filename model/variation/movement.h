// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/interpolationmethod.h"
#include "model/variation/alignment.h"
#include "model/variation/blends.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/parts/bodyparts.h"
#include "model/variation/training.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille {

struct MovementSettings
{
    AlignmentSettings alignment;
    double displacementShare = 6; ///< variance of the displacements, in mean variances of a coordinate
    std::vector<CoefficientKind> coefficients; ///< of the takes' coefficients
    InterpolationMethod interpolation = InterpolationMethod::Poisson;
};

/// Takes of one kind of movement, aligned and cut into parts: what models are learned from. A plain value.
struct Movement
{
    std::shared_ptr<const Topology> topology;
    BodyParts parts;
    /// `takes` are those of the training, then the pre-blends; reports are of the training alone.
    Alignment alignment;
    std::vector<MovementBlend> blends;
    std::vector<Preblend> preblends;    ///< of all blends in their order, as preblendsOf
    std::vector<PartTraining> training; ///< of each part, the rows of all takes; the root's is the first

    std::size_t capturedCount() const { return alignment.reports.size(); }
    const AlignedTake& take(std::size_t index) const { return alignment.takes.at(index); }
};

/// Aligns takes, blends two or four of them and makes the training rows of all parts.
/// \param parts  of the takes' mesh. \param templatePose  that all frames are laid onto; empty for the first
/// frame used of the reference.
/// \throws Error as alignTakes; as checkBlends; BadArgument (coefficients that
/// are not there for each kind and each frame of all takes); Cancelled.
Movement makeMovement(std::span<const TrainingTake> takes, std::size_t reference, const BodyParts& parts,
                      const std::vector<MovementBlend>& blends, const MovementSettings& settings = {},
                      Positions templatePose = {}, const Progress& progress = {});

/// Told while parts are learned, from any thread, one call at a time.
using PartWatch =
    std::function<void(std::size_t part, int iteration, double objective, const GpdmState& state)>;

/// Learns all parts, in parallel.
/// \return of each part; those that were cancelled have their best so far.
std::vector<GpdmLearning> learnParts(const Movement& movement, const GpdmSettings& settings,
                                     const Progress& progress = {}, const PartWatch& watch = {});

} // namespace quadrille
