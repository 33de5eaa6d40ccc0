// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/usedtexels.h"
#include "model/core/image.h"

namespace quadrille {

/// Gives each texel that is not used the colour of the nearest one that is, and makes all of them opaque.
/// \pre The texture has the atlas's size. Cost: O(texels).
void spreadTexels(const UsedTexels& texels, Image& texture);

} // namespace quadrille
