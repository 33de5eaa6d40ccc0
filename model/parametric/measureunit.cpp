// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/measureunit.h"

namespace quadrille {

const char* unitOf(SpaceMeasure measure)
{
    switch (measure) {
    case SpaceMeasure::Speed:
        return "m/s";
    case SpaceMeasure::Turning:
        return "deg/s";
    case SpaceMeasure::JumpHeight:
    case SpaceMeasure::JumpLength:
    case SpaceMeasure::Height:
    case SpaceMeasure::Forward:
    case SpaceMeasure::Side:
        return "m";
    case SpaceMeasure::ByHand:
        break;
    }
    return "";
}

} // namespace quadrille
