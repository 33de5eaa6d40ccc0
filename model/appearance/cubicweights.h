// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// What four values one beside the other count for at a place between the second and the third.
struct CubicWeights
{
    float w0, w1, w2, w3;
};

/// Catmull and Rom's (1974): exact for polynomials up to the second degree. Linear weights, between two
/// values, would blur textures at each look-up. \param part  of the way from the second value to the third.
[[gnu::always_inline]] inline CubicWeights cubicWeights(float part)
{
    return {((-0.5F * part + 1.0F) * part - 0.5F) * part, (1.5F * part - 2.5F) * part * part + 1.0F,
            ((-1.5F * part + 2.0F) * part + 0.5F) * part, (0.5F * part - 0.5F) * part * part};
}

} // namespace quadrille
