// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/silhouettes.h"

#include "model/render/mipmap.h"
#include "model/render/picture.h"

namespace quadrille {

namespace {

constexpr int pictureSide = 512; ///< pixels

RenderOptions colourOptions(UpAxis up)
{
    RenderOptions options;
    options.width = options.height = pictureSide;
    options.supersampling = 1;
    options.shading = RenderOptions::Shading::Flat;
    options.background = RenderOptions::Background::Transparent;
    options.grid = options.shadow = false;
    options.axes.up = up;
    return options;
}

} // namespace

std::vector<Camera> ringOfCameras(Positions positions, UpAxis up, int count)
{
    const Vec3d vertical = upVector(up);
    const Vec3d front = defaultDirection(up);
    const Framing framing{.up = up, .direction = front - front.dot(vertical) * vertical};
    const Camera first = frameTurntable(boundsOf(positions), framing);
    std::vector<Camera> cameras;
    cameras.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        cameras.push_back(turned(first, up, static_cast<double>(i) / count));
    return cameras;
}

Silhouettes::Silhouettes(Positions positions, const TopologyData& topology, std::vector<Camera> cameras,
                         UpAxis up, const std::shared_ptr<const Image>& texture)
    : m_positions(positions)
    , m_topology(topology)
    , m_cameras(std::move(cameras))
    , m_up(up)
    , m_normals(positions.size(), Vec3f::Zero())
{
    const auto scaled = std::make_shared<const MipTexture>(texture);
    for (const Camera& camera : m_cameras) {
        const Image& picture = m_pictures.emplace_back(render(camera, scaled));
        std::vector<std::uint8_t>& mask = m_masks.emplace_back();
        mask.reserve(picture.pixels.size() / 4);
        for (std::size_t alpha = 3; alpha < picture.pixels.size(); alpha += 4)
            mask.push_back(picture.pixels[alpha]);
    }
}

PictureQuality Silhouettes::compare(const std::shared_ptr<const Image>& texture,
                                    const Progress& progress) const
{
    const auto scaled = std::make_shared<const MipTexture>(texture);
    PictureQuality sum{.similarity = 0};
    for (std::size_t i = 0; i < m_cameras.size(); ++i) {
        progress.report(static_cast<std::int64_t>(i), std::ssize(m_cameras));
        const PictureQuality quality =
            pictureQuality(m_pictures[i], render(m_cameras[i], scaled), m_masks[i]);
        sum.similarity += quality.similarity;
        sum.meanSquaredError += quality.meanSquaredError;
    }
    const auto count = static_cast<double>(m_cameras.size());
    return {sum.similarity / count, sum.meanSquaredError / count};
}

Image Silhouettes::render(const Camera& camera, const std::shared_ptr<const MipTexture>& texture) const
{
    const RenderOptions options = colourOptions(m_up);
    const Projection projection(camera, options.width, options.height);
    const Backdrop backdrop(options, projection, camera, {.up = m_up}, {});
    return drawPicture({m_positions, m_normals, m_topology, std::span(&texture, 1)}, projection,
                       Lights(projection, m_up), backdrop, options);
}

} // namespace quadrille
