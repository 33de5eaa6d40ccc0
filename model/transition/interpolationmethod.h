// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// How poses between two poses come about.
enum class InterpolationMethod
{
    Poisson, ///< rotations and stretches of the triangles geodesically, SMCAS eq. 3–7
    Slerp,   ///< rotations as above, stretches linearly, IA4D eq. 1–2
    Linear,  ///< vertices on straight lines, for comparison: limbs shrink
};

} // namespace quadrille
