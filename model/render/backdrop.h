// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/render/ground.h"
#include "model/render/rendersettings.h"
#include "model/render/tiles.h"

#include <vector>

namespace quadrille {

/// A colour in linear light, multiplied by its coverage.
struct LinearPixel
{
    Vec3f color = Vec3f::Zero();
    float alpha = 0;
};

/// What a figure stands on and before: ground with grid and shadow, background gradient.
class Backdrop
{
public:
    /// \param projection in samples. \param shadow on the ground. \param camera gives the middle of the
    /// ground that is seen.
    Backdrop(const RenderOptions& options, const Projection& projection, const Camera& camera,
             const GroundPlane& ground, ShadowMap shadow);

    /// Whether pixels without a figure are transparent, all of them.
    bool isNothing() const
    {
        return !m_isSeen && m_options.background == RenderOptions::Background::Transparent;
    }
    /// Nearness of the ground in the middle of a sample; 0 where it is not seen.
    float groundNearness(int sampleX, int sampleY) const;
    /// What is seen in a pixel where no figure is.
    LinearPixel at(int pixelX, int pixelY) const;

private:
    const RenderOptions& m_options;
    const Projection& m_projection;
    GroundPlane m_ground;
    ShadowMap m_shadow;
    bool m_isSeen; ///< the eye is above the ground
    double m_drop; ///< ground height − eye height
    Vec2d m_middle;
    double m_radius;               ///< where the ground begins to fade
    std::vector<Vec3f> m_gradient; ///< per pixel row
};

} // namespace quadrille
