// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/atlas.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numeric>
#include <optional>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr int cells = 320; ///< of the square's side
constexpr int margin = 2;  ///< cells kept free around a chart
using Row = std::bitset<cells>;

/// The cells that a chart covers, with its margin.
struct Mask
{
    std::vector<Row> rows;
    int width = 0;
    Vec2f low; ///< of the chart, in cells
};

std::optional<Mask> rasterise(const SurfaceMesh& mesh, const FlatChart& chart, double scale)
{
    Mask mask;
    mask.low = Vec2f::Constant(1e9F);
    Vec2f high = Vec2f::Constant(-1e9F);
    std::vector<Vec2f> places;
    for (const Vec2f& p : chart.places) {
        places.emplace_back(p * static_cast<float>(scale));
        mask.low = mask.low.cwiseMin(places.back());
        high = high.cwiseMax(places.back());
    }
    const int width = static_cast<int>(high.x() - mask.low.x()) + 2 * margin + 2;
    const int height = static_cast<int>(high.y() - mask.low.y()) + 2 * margin + 2;
    if (width >= cells || height >= cells)
        return std::nullopt;
    std::vector<Row> covered(static_cast<std::size_t>(height));
    for (const std::uint32_t t : chart.triangles) {
        std::array<Vec2f, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto v =
                std::lower_bound(chart.vertices.begin(), chart.vertices.end(), mesh.triangles[t][c].value) -
                chart.vertices.begin();
            p[c] = places[static_cast<std::size_t>(v)] - mask.low + Vec2f::Constant(margin);
        }
        // Samples along the triangle, two to a cell; cheap and never too few.
        const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
        const int n = static_cast<int>(2 * longest) + 2;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n - i; ++j) {
                const float a = static_cast<float>(i) / static_cast<float>(n);
                const float b = static_cast<float>(j) / static_cast<float>(n);
                const Vec2f q = a * p[0] + b * p[1] + (1 - a - b) * p[2];
                covered[static_cast<std::size_t>(q.y())].set(static_cast<std::size_t>(q.x()));
            }
    }
    mask.rows.resize(covered.size());
    mask.width = width;
    for (int y = 0; y < height; ++y)
        for (int d = -margin; d <= margin; ++d) {
            if (y + d < 0 || y + d >= height)
                continue;
            const int from = y + d;
            const Row& row = covered[static_cast<std::size_t>(from)];
            Row wide = row;
            for (int x = 1; x <= margin; ++x)
                wide |= (row << static_cast<std::size_t>(x)) | (row >> static_cast<std::size_t>(x));
            mask.rows[static_cast<std::size_t>(y)] |= wide;
        }
    return mask;
}

bool fits(const std::vector<Row>& used, const Mask& mask, int x, int y)
{
    for (std::size_t row = 0; row < mask.rows.size(); ++row)
        if ((used[static_cast<std::size_t>(y) + row] & (mask.rows[row] << static_cast<std::size_t>(x))).any())
            return false;
    return true;
}

/// Lower left corners of all charts in cells, or nothing when they do not fit at this scale.
std::optional<std::vector<Vec2f>> place(const std::vector<Mask>& masks, const std::vector<std::size_t>& order)
{
    std::vector<Row> used(cells);
    std::vector<Vec2f> corners(masks.size());
    for (const std::size_t m : order) {
        const Mask& mask = masks[m];
        const int lastY = cells - static_cast<int>(mask.rows.size());
        bool isPlaced = false;
        for (int y = 0; y <= lastY && !isPlaced; ++y)
            for (int x = 0; x + mask.width <= cells && !isPlaced; ++x) {
                if (!fits(used, mask, x, y))
                    continue;
                for (std::size_t row = 0; row < mask.rows.size(); ++row)
                    used[static_cast<std::size_t>(y) + row] |= mask.rows[row] << static_cast<std::size_t>(x);
                corners[m] = Vec2f(static_cast<float>(x + margin), static_cast<float>(y + margin)) - mask.low;
                isPlaced = true;
            }
        if (!isPlaced)
            return std::nullopt;
    }
    return corners;
}

/// Face and hands get more texels than their area alone would.
double sizeOf(const std::string& chart)
{
    constexpr std::array<std::pair<const char*, double>, 9> sizes = {{{"head front", 1.75},
                                                                      {"head back", 1.35},
                                                                      {"palm", 1.6},
                                                                      {"finger", 1.6},
                                                                      {"hand", 1.8},
                                                                      {"torso front", 1.2},
                                                                      {"leg", 0.85},
                                                                      {"sole", 0.8},
                                                                      {"shoe", 1.3}}};
    for (const auto& [part, size] : sizes)
        if (chart.find(part) != std::string::npos)
            return size;
    return 1.0;
}

} // namespace

std::vector<std::vector<Vec2f>> packCharts(const SurfaceMesh& mesh, const std::vector<FlatChart>& charts,
                                           const std::vector<double>& sizes)
{
    double low = 40; // cells per metre
    double high = 400;
    std::vector<std::vector<Vec2f>> best;
    for (int step = 0; step < 9; ++step) {
        const double scale = 0.5 * (low + high);
        std::vector<Mask> masks;
        for (std::size_t c = 0; c < charts.size(); ++c)
            if (auto mask = rasterise(mesh, charts[c], scale * sizes[c]))
                masks.push_back(std::move(*mask));
        std::vector<std::size_t> order(masks.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return masks[a].rows.size() > masks[b].rows.size();
        });
        const auto corners = masks.size() == charts.size() ? place(masks, order) : std::nullopt;
        if (!corners) {
            high = scale;
            continue;
        }
        low = scale;
        best.assign(charts.size(), {});
        for (std::size_t c = 0; c < charts.size(); ++c)
            for (const Vec2f& p : charts[c].places)
                best[c].emplace_back((p * static_cast<float>(scale * sizes[c]) + (*corners)[c]) /
                                     static_cast<float>(cells));
    }
    return best;
}

Atlas makeAtlas(const SurfaceMesh& mesh, const Body& body)
{
    Atlas atlas;
    atlas.charts = cutCharts(mesh, body);
    const std::size_t count = atlas.charts.names.size();
    std::vector<FlatChart> charts(count);
    std::vector<double> sizes(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t c) {
        charts[c] = flattenChart(mesh, atlas.charts, static_cast<std::uint16_t>(c));
        sizes[c] = sizeOf(atlas.charts.names[c]);
    });
    const auto packed = packCharts(mesh, charts, sizes);
    atlas.triangleUvs.resize(mesh.triangles.size());
    for (std::size_t c = 0; c < count; ++c) {
        const auto first = static_cast<std::uint32_t>(atlas.uvs.size());
        atlas.uvs.insert(atlas.uvs.end(), packed[c].begin(), packed[c].end());
        for (const std::uint32_t t : charts[c].triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto v = std::lower_bound(charts[c].vertices.begin(), charts[c].vertices.end(),
                                                mesh.triangles[t][k].value) -
                               charts[c].vertices.begin();
                atlas.triangleUvs[t][k] = first + static_cast<std::uint32_t>(v);
            }
    }
    return atlas;
}

} // namespace quadrille
