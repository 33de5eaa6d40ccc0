// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// Values that belong to each frame beside its pose, such as the coefficients of an appearance model: they
/// join the rows of the root, are learned with its poses and vary with them.
///
/// What is given for each captured frame (TrainingTake::coefficients) is warped to the reference with the
/// poses (AlignedTake::coefficients), blended with them, learned as further columns (PartTraining::blocks),
/// and comes back for each frame of a variation (variationCoefficients).
struct CoefficientKind
{
    std::string name;
    double share = 6; ///< total variance of all its values, in mean variances of a coordinate

    bool operator==(const CoefficientKind&) const = default;
};

/// Further columns of training rows that have a scale of their own.
struct BlockColumns
{
    std::string name;
    Eigen::Index first = 0; ///< column
    Eigen::Index count = 0;
    double scale = 1; ///< that the values were multiplied by

    bool operator==(const BlockColumns&) const = default;
};

/// Values of a block in pose vectors, the mean added. \return frames × values.
RowMatrix blockValues(const Eigen::Ref<const RowMatrix>& poseVectors, const BlockColumns& block);

/// Values between frames: linear, clamped at both ends. \param values  frames × values, at least one frame.
/// \param positions  in frames, fractional. \return one row for each position.
RowMatrix valuesAt(const RowMatrix& values, std::span<const double> positions);

} // namespace quadrille
