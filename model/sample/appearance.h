// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"
#include "model/sample/texelmap.h"

namespace quadrille {

/// Light and misalignment of a take of `frames` frames, smooth in time; differs with the seed.
SampleAppearance makeAppearance(std::int64_t frames, int textureSize, std::uint64_t seed);

/// The body with a texture that shows nothing finer than the texels of smaller ones: it would flicker as it
/// moves over them. \param size  side of the smaller ones, texels; a power of two.
SampleBody forTexturesOf(int size, SampleBody body);

/// What a camera rig would have baked into the texture of one frame: the body's own colours, shifted by the
/// frame's warp and shaded by its light as the posed surface lies.
/// \param body  by forTexturesOf. \param texels map of the atlas at the size of the appearance.
Image frameTexture(const SampleBody& body, const TexelMap& texels, Positions posed,
                   const SampleAppearance& appearance, FrameIndex frame);

} // namespace quadrille
