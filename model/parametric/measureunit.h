// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/parameters.h"

namespace quadrille {

/// "m/s", "deg/s" or "m"; empty of what is placed by hand.
const char* unitOf(SpaceMeasure measure);

} // namespace quadrille
