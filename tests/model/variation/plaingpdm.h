// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

namespace quadrille::test {

/// CVS eq. 4 of all pairs of rows.
RowMatrix plainPoseKernel(const RowMatrix& latents, const GpdmHyperparameters& parameters);

/// CVS eq. 6 of all pairs of rows.
RowMatrix plainDynamicsKernel(const RowMatrix& inputs, const GpdmHyperparameters& parameters);

/// The objective as it is written down: dense matrices, K⁻¹·Y formed, and where a gradient is asked for,
/// inverses and the derivatives of whole matrices.
double plainObjective(const RowMatrix& rows, std::span<const RowSpan> spans, const GpdmState& state,
                      GpdmObjective::Gradient* gradient = nullptr);

} // namespace quadrille::test
