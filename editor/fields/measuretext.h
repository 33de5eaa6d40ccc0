// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/parameters.h"

#include <QString>

namespace quadrille {

/// A value of a motion space's parameter with its unit, in the user's language: “1.40 m/s”, “-30 °/s”.
QString measureText(double value, SpaceMeasure measure);

} // namespace quadrille
