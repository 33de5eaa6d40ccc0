// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille::widgets {

/// How figures are drawn.
enum class Shading
{
    Textured,
    Clay,
    Wireframe, ///< edges over clay
    Scalar     ///< clay where a figure has no scalars
};

/// What scalars belong to.
enum class ScalarPlace
{
    PerVertex,
    PerTriangle
};

} // namespace quadrille::widgets
