// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// How poses come from latent positions.
enum class PoseDraw
{
    Mean,   ///< the most probable pose
    Sample, ///< one draw for the whole trajectory
};

} // namespace quadrille
