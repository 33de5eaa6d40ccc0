// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/backdrop.h"

#include "model/render/color.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Colours of a background; the gradients are those of the editor's viewport.
struct Palette
{
    std::uint32_t top;
    std::uint32_t bottom;
    float floor; ///< how much brighter the ground is, 0 … 1 towards white
    float line;  ///< grid lines towards `lineColor`
    std::uint32_t lineColor;
    float shadow; ///< darkest shadow
};
constexpr Palette darkPalette{0x3A3D42, 0x23252A, 0.035F, 0.20F, 0xC8CEDA, 0.62F};
constexpr Palette lightPalette{0xF2F4F7, 0xD5DAE1, 0.30F, 0.42F, 0x8C97A8, 0.46F};

const Palette& paletteOf(RenderOptions::Background background)
{
    return background == RenderOptions::Background::Dark ? darkPalette : lightPalette;
}

double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

Backdrop::Backdrop(const RenderOptions& options, const Projection& projection, const Camera& camera,
                   const GroundPlane& ground, ShadowMap shadow)
    : m_options(options)
    , m_projection(projection)
    , m_ground(ground)
    , m_shadow(std::move(shadow))
    , m_drop(ground.height - projection.eye[ground.vertical()])
    , m_middle(ground.flat(camera.target))
    , m_radius((camera.target - camera.eye).norm())
{
    m_isSeen = m_drop < 0 && (options.grid || options.shadow);
    const Palette& palette = paletteOf(options.background);
    const Vec3f top(static_cast<float>(palette.top >> 16U), static_cast<float>(palette.top >> 8U & 0xFFU),
                    static_cast<float>(palette.top & 0xFFU));
    const Vec3f bottom(static_cast<float>(palette.bottom >> 16U),
                       static_cast<float>(palette.bottom >> 8U & 0xFFU),
                       static_cast<float>(palette.bottom & 0xFFU));
    for (int y = 0; y < options.height; ++y) {
        const float t = (static_cast<float>(y) + 0.5F) / static_cast<float>(options.height);
        m_gradient.push_back(SrgbTables::instance().toLinear(Vec3f(top + (bottom - top) * t)));
    }
}

float Backdrop::groundNearness(int sampleX, int sampleY) const
{
    if (!m_isSeen)
        return 0;
    const double down = m_projection.ray(sampleX + 0.5, sampleY + 0.5)[m_ground.vertical()];
    return static_cast<float>(std::max(down / m_drop, 0.0));
}

LinearPixel Backdrop::at(int pixelX, int pixelY) const
{
    const bool transparent = m_options.background == RenderOptions::Background::Transparent;
    LinearPixel pixel;
    if (!transparent)
        pixel = {m_gradient[static_cast<std::size_t>(pixelY)], 1};
    if (!m_isSeen)
        return pixel;
    const int samples = m_options.supersampling;
    const Vec3d ray = m_projection.ray((pixelX + 0.5) * samples, (pixelY + 0.5) * samples);
    const Eigen::Index up = m_ground.vertical();
    const double distance = m_drop / ray[up];
    if (!(ray[up] < 0))
        return pixel;
    const Vec2d point = m_ground.flat(m_projection.eye + ray * distance);
    const double away = std::sqrt((point - m_middle).squaredNorm());
    const auto strength = static_cast<float>(1 - smoothStep(0.35 * m_radius, 1.5 * m_radius, away));
    if (strength <= 0)
        return pixel;

    const Palette& palette = paletteOf(m_options.background);
    const float shadow = m_options.shadow ? m_shadow.at(point) * palette.shadow : 0.0F;
    if (transparent)
        return {Vec3f::Zero(), shadow};
    if (m_options.grid) {
        pixel.color += (Vec3f::Ones() - pixel.color) * (palette.floor * strength);
        const Vec3d right = m_projection.right * (samples / m_projection.focal);
        const Vec3d down = m_projection.up * (-samples / m_projection.focal);
        const Vec2d alongX = m_ground.flat(distance * (right - ray * (right[up] / ray[up])));
        const Vec2d alongY = m_ground.flat(distance * (down - ray * (down[up] / ray[up])));
        const double metre = 1 / m_options.axes.metresPerUnit;
        const Vec2d footprint = (alongX.cwiseAbs() + alongY.cwiseAbs()) / metre;
        const float line = gridCoverage(point / metre, footprint, 0.012) * palette.line * strength;
        static const Vec3f darkLine = linearColor(darkPalette.lineColor);
        static const Vec3f lightLine = linearColor(lightPalette.lineColor);
        const Vec3f& color = m_options.background == RenderOptions::Background::Dark ? darkLine : lightLine;
        pixel.color += (color - pixel.color) * line;
    }
    pixel.color *= 1 - shadow;
    return pixel;
}

} // namespace quadrille
