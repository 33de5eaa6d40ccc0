// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/units.h"

#include <memory>
#include <vector>

namespace quadrille {

/// A texture with its smaller versions, for sampling at any size. Immutable.
class MipTexture
{
public:
    /// \pre The image is not empty.
    explicit MipTexture(std::shared_ptr<const Image> image);

    int width() const { return level(0).width; }
    int height() const { return level(0).height; }

    /// The colour at texture coordinates (origin at the lower left, repeated outside 0 … 1), bilinear in each
    /// of the two nearest sizes.
    /// \param level 0 for the full size, 1 for half, …
    /// \return sRGB red, green, blue, 0 … 255.
    Vec3f sample(const Vec2f& uv, float level) const;

    /// The level at which one step in the picture is one texel, for the change of the coordinates (in texels)
    /// along a step to the right and a step down.
    static float levelFor(const Vec2f& alongX, const Vec2f& alongY);

private:
    const Image& level(int index) const;
    Vec3f bilinear(const Image& image, const Vec2f& uv) const;

    std::shared_ptr<const Image> m_full;
    std::vector<Image> m_smaller;
};

} // namespace quadrille
