// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

namespace quadrille {

/// How far the poses that a model makes of its training latents are from the training poses: mean distance of
/// a vertex over all frames, metres (CVS Fig. 4).
/// \param rows  centred training rows; three coordinates of each vertex come first.
double modelError(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows, Eigen::Index vertices);

/// The same for as many principal components of the rows as there are dimensions.
double principalError(const Eigen::Ref<const RowMatrix>& rows, int dimensions, Eigen::Index vertices);

} // namespace quadrille
