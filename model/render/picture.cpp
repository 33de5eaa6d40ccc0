// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/picture.h"

#include "model/render/color.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr int tilePixels = 32;

/// What samples of one triangle share; entries belong to the corners of the ScreenTriangle.
struct Patch
{
    std::uint32_t item = ScreenTriangle::noPiece;
    std::array<Vec3f, 3> normals = {Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero()};
    std::array<Vec2f, 3> uvs = {Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    /// Change of nearness × edge value to the right and down.
    std::array<Vec2f, 3> texelSteps = {Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    std::array<float, 3> wireScale{}; ///< edge value → distance from the edge in samples; 0: no edge
    float wireStrength = 0;
    const MipTexture* texture = nullptr;
};

/// Shades the samples of a picture.
class Painter
{
public:
    Painter(const ShadedFigure& figure, const ScreenScene& scene, const Lights& lights,
            const RenderOptions& options)
        : m_figure(figure), m_scene(scene), m_lights(lights), m_options(options)
    {
    }

    void preparePatch(std::uint32_t item, Patch& patch) const;
    /// Linear light of the sample.
    Vec3f paint(const Patch& patch, int x, int y, const Vec3f& toEye) const;

private:
    void prepareWire(const ScreenTriangle& t, Patch& patch) const;
    float wire(const Patch& patch, const std::array<std::int64_t, 3>& edges) const;

    const ShadedFigure& m_figure;
    const ScreenScene& m_scene;
    const Lights& m_lights;
    const RenderOptions& m_options;
    Vec3f m_clay = linearColor(0xC9C3BB);
    Vec3f m_wire = linearColor(0x2B3442);
};

/// The value at each corner of a drawn triangle, from those at the corners of the whole one.
template <typename Value>
std::array<Value, 3> cornerValues(const ScreenScene& scene, const ScreenTriangle& t,
                                  const std::array<Value, 3>& whole)
{
    std::array<Value, 3> values;
    for (std::size_t i = 0; i < 3; ++i) {
        if (t.piece == ScreenTriangle::noPiece) {
            values[i] = whole[t.order[i]];
        } else {
            const Vec3f& weights = scene.pieces[t.piece][i];
            values[i] = whole[0] * weights[0] + whole[1] * weights[1] + whole[2] * weights[2];
        }
    }
    return values;
}

void Painter::preparePatch(std::uint32_t item, Patch& patch) const
{
    const ScreenTriangle& t = m_scene.triangles[item];
    const TopologyData& topology = m_figure.topology;
    patch.item = item;
    const Triangle& corners = topology.triangles[t.triangle];
    const float side = t.isBack ? -1.0F : 1.0F;
    patch.normals = cornerValues<Vec3f>(m_scene, t,
                                        {m_figure.normals[corners[0].value] * side,
                                         m_figure.normals[corners[1].value] * side,
                                         m_figure.normals[corners[2].value] * side});
    patch.texture = nullptr;
    if (!m_figure.textures.empty()) {
        const std::size_t material =
            topology.triangleMaterials.empty() ? 0 : topology.triangleMaterials[t.triangle];
        patch.texture = m_figure.textures[std::min(material, m_figure.textures.size() - 1)].get();
    }
    if (patch.texture) {
        const auto& uvs = topology.triangleUvs[t.triangle];
        patch.uvs = cornerValues<Vec2f>(m_scene, t,
                                        {topology.uvs[uvs[0]], topology.uvs[uvs[1]], topology.uvs[uvs[2]]});
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t a = (i + 1) % 3;
            const std::size_t b = (i + 2) % 3;
            patch.texelSteps[i] = Vec2f(static_cast<float>(t.y[a] - t.y[b]) * 256.0F,
                                        static_cast<float>(t.x[b] - t.x[a]) * 256.0F) *
                                  t.nearness[i];
        }
    }
    if (m_options.shading == RenderOptions::Shading::Wireframe)
        prepareWire(t, patch);
}

void Painter::prepareWire(const ScreenTriangle& t, Patch& patch) const
{
    float lowest = std::numeric_limits<float>::infinity();
    const auto doubleArea = static_cast<float>(std::int64_t{t.x[1] - t.x[0]} * (t.y[2] - t.y[0]) -
                                               std::int64_t{t.y[1] - t.y[0]} * (t.x[2] - t.x[0]));
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3;
        const std::size_t b = (i + 2) % 3;
        const auto dx = static_cast<float>(t.x[b] - t.x[a]);
        const auto dy = static_cast<float>(t.y[b] - t.y[a]);
        const float length = std::max(std::sqrt(dx * dx + dy * dy), 1.0F);
        lowest = std::min(lowest, doubleArea / length);
        patch.wireScale[i] = 1.0F / (length * 256.0F);
        if (t.piece == ScreenTriangle::noPiece)
            continue;
        const PieceCorners& weights = m_scene.pieces[t.piece];
        const bool isCut = !((weights[a].array() == 0) && (weights[b].array() == 0)).any();
        if (isCut)
            patch.wireScale[i] = 0;
    }
    // Lines of triangles smaller than a few pixels would cover everything: they get fainter instead.
    const float pixels = lowest / (256.0F * static_cast<float>(m_options.supersampling));
    patch.wireStrength = std::clamp(pixels / 5.0F, 0.15F, 0.85F);
}

float Painter::wire(const Patch& patch, const std::array<std::int64_t, 3>& edges) const
{
    const float halfWidth = 0.55F * static_cast<float>(m_options.supersampling);
    float covered = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (patch.wireScale[i] > 0) {
            const float distance = static_cast<float>(edges[i]) * patch.wireScale[i];
            covered = std::max(covered, std::clamp(halfWidth + 0.5F - distance, 0.0F, 1.0F));
        }
    }
    return covered * patch.wireStrength;
}

Vec3f Painter::paint(const Patch& patch, int x, int y, const Vec3f& toEye) const
{
    const ScreenTriangle& t = m_scene.triangles[patch.item];
    const auto edges = edgeValues(t, x, y);
    std::array<float, 3> weights;
    float sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] = static_cast<float>(edges[i]) * t.nearness[i];
    const float scale = 1.0F / sum;
    for (float& weight : weights)
        weight *= scale;

    Vec3f color = m_clay;
    if (patch.texture) {
        const Vec2f uv = patch.uvs[0] * weights[0] + patch.uvs[1] * weights[1] + patch.uvs[2] * weights[2];
        Vec2f alongX = Vec2f::Zero();
        Vec2f alongY = Vec2f::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2f offset = patch.uvs[i] - uv;
            alongX += offset * (patch.texelSteps[i].x() * scale);
            alongY += offset * (patch.texelSteps[i].y() * scale);
        }
        const Vec2f size(static_cast<float>(patch.texture->width()),
                         static_cast<float>(patch.texture->height()));
        const float level = MipTexture::levelFor(alongX.cwiseProduct(size), alongY.cwiseProduct(size));
        color = SrgbTables::instance().toLinear(patch.texture->sample(uv, level));
    }
    if (m_options.shading == RenderOptions::Shading::Flat)
        return color;

    const Vec3f blended =
        patch.normals[0] * weights[0] + patch.normals[1] * weights[1] + patch.normals[2] * weights[2];
    const float length = std::sqrt(blended.squaredNorm());
    const Vec3f normal = length > 0 ? Vec3f(blended / length) : toEye;
    Vec3f lit = m_lights.shade(color, normal, toEye, patch.texture ? texturedMaterial : clayMaterial);
    if (m_options.shading != RenderOptions::Shading::Wireframe)
        return lit;
    return lit + (m_wire - lit) * wire(patch, edges);
}

/// Thresholds of ordered dithering, in (0, 1).
float ditherThreshold(int x, int y)
{
    // Bits of x ^ y and y interleaved, most significant last: the 8 × 8 Bayer matrix.
    const auto a = static_cast<unsigned>(x ^ y);
    const auto b = static_cast<unsigned>(y);
    const unsigned rank =
        (a & 1U) << 5U | (b & 1U) << 4U | (a & 2U) << 2U | (b & 2U) << 1U | (a & 4U) >> 1U | (b & 4U) >> 2U;
    return (static_cast<float>(rank) + 0.5F) / 64.0F;
}

/// \param dither where smooth gradients would show steps.
void store(const LinearPixel& pixel, bool dither, int x, int y, std::uint8_t* out)
{
    if (pixel.alpha == 0) {
        std::fill_n(out, 4, std::uint8_t{0});
        return;
    }
    const SrgbTables& tables = SrgbTables::instance();
    const float scale = 1 / pixel.alpha;
    for (int i = 0; i < 3; ++i) {
        const float value = pixel.color[i] * scale;
        out[i] = dither ? static_cast<std::uint8_t>(tables.toSrgbFine(value) + ditherThreshold(x, y))
                        : tables.toSrgb(value);
    }
    out[3] = static_cast<std::uint8_t>(std::lrint(pixel.alpha * 255.0F));
}

class PictureTask
{
public:
    PictureTask(const ScreenScene& scene, const Painter& painter, const Projection& projection,
                const Backdrop& backdrop, const RenderOptions& options, Image& image)
        : m_scene(scene)
        , m_painter(painter)
        , m_projection(projection)
        , m_backdrop(backdrop)
        , m_options(options)
        , m_image(image)
    {
    }

    void paintTile(int tile, TileBuffer& buffer) const
    {
        const int left = tile % m_scene.tilesAcross * tilePixels;
        const int top = tile / m_scene.tilesAcross * tilePixels;
        const int right = std::min(left + tilePixels, m_options.width);
        const int bottom = std::min(top + tilePixels, m_options.height);
        const auto t = static_cast<std::size_t>(tile);
        const bool isEmpty = m_scene.tileStarts[t] == m_scene.tileStarts[t + 1];
        if (isEmpty && m_backdrop.isNothing())
            return; // as pictures begin
        if (!isEmpty)
            drawTile(m_scene, tile, buffer, static_cast<float>(1 / m_projection.farDistance));
        Patch patch;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                LinearPixel pixel;
                if (!isEmpty)
                    pixel = figureAt(x, y, buffer, patch);
                const bool isBackdrop = pixel.alpha == 0;
                if (pixel.alpha < 1) {
                    const LinearPixel behind = m_backdrop.at(x, y);
                    pixel.color += behind.color * (1 - pixel.alpha);
                    pixel.alpha += behind.alpha * (1 - pixel.alpha);
                }
                store(pixel, isBackdrop, x, y, m_image.pixel(x, y));
            }
        }
    }

private:
    /// The mean of the pixel's samples that see the figure.
    LinearPixel figureAt(int pixelX, int pixelY, const TileBuffer& buffer, Patch& patch) const
    {
        const int samples = m_options.supersampling;
        const int firstX = pixelX * samples;
        const int firstY = pixelY * samples;
        LinearPixel pixel;
        Vec3f toEye = Vec3f::Zero();
        int hits = 0;
        for (int y = firstY; y < firstY + samples; ++y) {
            for (int x = firstX; x < firstX + samples; ++x) {
                const std::size_t sample = buffer.index(x, y);
                const std::uint32_t item = buffer.items[sample];
                if (item == ScreenTriangle::noPiece ||
                    buffer.nearness[sample] < m_backdrop.groundNearness(x, y))
                    continue;
                if (hits++ == 0) {
                    const Vec3d ray = m_projection.ray(firstX + 0.5 * samples, firstY + 0.5 * samples);
                    toEye = (ray / -std::sqrt(ray.squaredNorm())).cast<float>();
                }
                if (patch.item != item)
                    m_painter.preparePatch(item, patch);
                pixel.color += m_painter.paint(patch, x, y, toEye);
            }
        }
        const float share = 1.0F / static_cast<float>(samples * samples);
        pixel.color *= share;
        pixel.alpha = hits == samples * samples ? 1.0F : static_cast<float>(hits) * share;
        return pixel;
    }

    const ScreenScene& m_scene;
    const Painter& m_painter;
    const Projection& m_projection;
    const Backdrop& m_backdrop;
    const RenderOptions& m_options;
    Image& m_image;
};

} // namespace

Image drawPicture(const ShadedFigure& figure, const Projection& projection, const Lights& lights,
                  const Backdrop& backdrop, const RenderOptions& options)
{
    const int samples = options.supersampling;
    const ScreenScene scene =
        projectScene(figure.positions, figure.topology.triangles, projection, options.width * samples,
                     options.height * samples, tilePixels * samples);
    const Painter painter(figure, scene, lights, options);
    Image image(options.width, options.height);
    const PictureTask task(scene, painter, projection, backdrop, options, image);
    tbb::parallel_for(tbb::blocked_range<int>(0, scene.tileCount()), [&](const auto& range) {
        TileBuffer buffer(scene.tileSize);
        for (int tile = range.begin(); tile != range.end(); ++tile)
            task.paintTile(tile, buffer);
    });
    return image;
}

} // namespace quadrille
