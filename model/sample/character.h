// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/bodymesh.h"

namespace quadrille {

/// Proportions of the second body: shorter, stockier, with longer arms.
Proportions targetProportions();

/// Edge lengths that are short at face, fingers and feet. \param scale on all lengths.
EdgeLength edgeLengthFor(const Body& body, double scale);

} // namespace quadrille
