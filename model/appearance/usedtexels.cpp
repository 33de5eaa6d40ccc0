// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/usedtexels.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace quadrille {

namespace {

using Corners = std::array<Eigen::Vector2d, 3>;

constexpr std::uint16_t noChart = std::numeric_limits<std::uint16_t>::max();

/// Per triangle its chart. UVs at one place are one, however often the file lists them.
std::vector<std::uint16_t> chartsOf(const TopologyData& data, int& chartCount)
{
    std::vector<std::uint32_t> order(data.uvs.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](std::uint32_t uv) { return std::pair(data.uvs[uv].x(), data.uvs[uv].y()); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(place(a), a) < std::pair(place(b), b);
    });
    std::vector<std::uint32_t> parent(data.uvs.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        parent[order[k]] = k > 0 && place(order[k]) == place(order[k - 1]) ? parent[order[k - 1]] : order[k];
    const auto root = [&](std::uint32_t uv) {
        while (parent[uv] != uv)
            uv = parent[uv] = parent[parent[uv]];
        return uv;
    };
    for (const auto& t : data.triangleUvs)
        for (const std::uint32_t uv : {t[1], t[2]})
            parent[root(uv)] = root(t[0]);
    std::vector<std::uint16_t> chartOfRoot(data.uvs.size(), noChart);
    std::vector<std::uint16_t> charts;
    charts.reserve(data.triangleUvs.size());
    chartCount = 0;
    for (const auto& t : data.triangleUvs) {
        std::uint16_t& chart = chartOfRoot[root(t[0])];
        if (chart == noChart) {
            if (chartCount == noChart)
                refuse("The UV layout falls into more than 65,535 pieces",
                       "Unwrap the mesh into fewer charts.");
            chart = static_cast<std::uint16_t>(chartCount++);
        }
        charts.push_back(chart);
    }
    return charts;
}

/// Textures repeat: whole turns are taken off, so that a triangle begins in the atlas.
/// \param p  from the upper left corner, in sizes of the atlas; becomes texels.
void moveIntoAtlas(Corners& p, int width, int height)
{
    const Eigen::Vector2d first = p[0].cwiseMin(p[1]).cwiseMin(p[2]).array().floor();
    for (Eigen::Vector2d& corner : p)
        corner = (corner - first).cwiseProduct(Eigen::Vector2d(width, height));
}

/// Which chart each texel of an atlas belongs to.
class ChartMap
{
public:
    ChartMap(int width, int height)
        : m_width(width)
        , m_height(height)
        , m_charts(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), noChart)
    {
    }

    std::uint16_t& at(int x, int y) { return m_charts[index(x, y)]; }
    std::uint16_t at(int x, int y) const { return m_charts[index(x, y)]; }
    const std::vector<std::uint16_t>& charts() const { return m_charts; }

    /// \param p  not left of nor above the atlas; what reaches beyond it comes in again on the other side.
    /// \return whether the triangle covers the centre of any texel.
    bool paint(const Corners& p, std::uint16_t chart)
    {
        constexpr double edge = 1e-6; // a centre on the edge counts, whatever was rounded
        const auto [low, high] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
        const double top = std::ceil(low - 0.5 - edge);
        const double bottom = std::min(std::floor(high - 0.5 + edge), top + m_height - 1);
        bool isSeen = false;
        for (double y = top; y <= bottom; ++y) {
            const auto [left, right] = span(p, std::clamp(y + 0.5, low, high));
            const double begin = std::ceil(left - 0.5 - edge);
            const double end = std::min(std::floor(right - 0.5 + edge), begin + m_width - 1);
            for (double x = begin; x <= end; ++x) {
                put(x, y, chart);
                isSeen = true;
            }
        }
        return isSeen;
    }

    /// The texels that the longest side of a triangle passes.
    void paintSliver(const Corners& p, std::uint16_t chart)
    {
        std::size_t longest = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if ((p[(k + 1) % 3] - p[k]).norm() > (p[(longest + 1) % 3] - p[longest]).norm())
                longest = k;
        const Eigen::Vector2d along = p[(longest + 1) % 3] - p[longest];
        const double steps = std::ceil(std::min(along.norm(), 1.0 * m_width * m_height)) + 1;
        for (double k = 0; k <= steps; ++k) {
            const Eigen::Vector2d q = p[longest] + along * (k / steps);
            put(std::floor(q.x()), std::floor(q.y()), chart);
        }
    }

    /// Gives free texels up to `gutter` from a chart to the nearest.
    void grow(int gutter)
    {
        // Per row the nearest texel of a chart to each side first, then the best of the rows around.
        std::vector<Near> nearest(m_charts.size());
        for (int y = 0; y < m_height; ++y)
            findInRow(y, gutter, nearest);
        std::vector<Near> best(static_cast<std::size_t>(m_width));
        for (int y = 0; y < m_height; ++y) {
            std::fill(best.begin(), best.end(), Near());
            for (int row = std::max(0, y - gutter); row <= std::min(m_height - 1, y + gutter); ++row) {
                const std::int32_t rowDistance = (row - y) * (row - y);
                const Near* in = nearest.data() + index(0, row);
                for (std::size_t x = 0; x < best.size(); ++x)
                    if (in[x].chart != noChart)
                        best[x] = std::min(best[x], Near{in[x].distance + rowDistance, in[x].chart});
            }
            for (int x = 0; x < m_width; ++x) {
                const Near& found = best[static_cast<std::size_t>(x)];
                if (found.distance <= gutter * gutter)
                    at(x, y) = found.chart;
            }
        }
    }

private:
    struct Near
    {
        std::int32_t distance = std::numeric_limits<std::int32_t>::max(); ///< squared
        std::uint16_t chart = noChart;

        bool operator<(const Near& other) const
        {
            return distance < other.distance || (distance == other.distance && chart < other.chart);
        }
    };

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }

    void put(double x, double y, std::uint16_t chart)
    {
        std::uint16_t& texel =
            at(static_cast<int>(std::fmod(x, m_width)), static_cast<int>(std::fmod(y, m_height)));
        texel = std::min(texel, chart);
    }

    /// From where to where a triangle reaches at a height that is within it.
    static std::pair<double, double> span(const Corners& p, double y)
    {
        double left = std::numeric_limits<double>::infinity();
        double right = -left;
        for (std::size_t k = 0; k < 3; ++k) {
            // From top to bottom, so that neighbours round alike.
            const bool isDown = p[k].y() < p[(k + 1) % 3].y();
            const Eigen::Vector2d& a = p[isDown ? k : (k + 1) % 3];
            const Eigen::Vector2d& b = p[isDown ? (k + 1) % 3 : k];
            if (y < a.y() || y > b.y())
                continue;
            const double x = a.y() == b.y() ? a.x() : a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
            left = std::min(left, x);
            right = std::max(right, x);
        }
        return {left, right};
    }

    void findInRow(int y, int gutter, std::vector<Near>& nearest) const
    {
        for (const int step : {1, -1}) {
            int seen = -1;
            for (int x = step > 0 ? 0 : m_width - 1; x >= 0 && x < m_width; x += step) {
                if (at(x, y) != noChart)
                    seen = x;
                if (seen < 0 || std::abs(x - seen) > gutter)
                    continue;
                Near& here = nearest[index(x, y)];
                here = std::min(here, Near{(x - seen) * (x - seen), at(seen, y)});
            }
        }
    }

    int m_width;
    int m_height;
    std::vector<std::uint16_t> m_charts;
};

} // namespace

UsedTexels usedTexels(const Topology& topology, int width, int height, int gutter)
{
    if (!topology.hasUvs())
        throw Error(ErrorCode::NoUvs);
    constexpr int largest = 1 << 15;
    if (width <= 0 || height <= 0 || width > largest || height > largest || gutter < 0 || gutter > largest)
        refuse("Textures have a size of 1 to 32,768 texels, and gutters are not negative",
               "Change the sizes.");
    const TopologyData& data = topology.data();
    UsedTexels used{.width = width, .height = height};
    const std::vector<std::uint16_t> charts = chartsOf(data, used.chartCount);
    std::vector<Corners> triangles(charts.size());
    std::vector<std::size_t> slivers;
    ChartMap map(width, height);
    for (std::size_t t = 0; t < charts.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Eigen::Vector2d uv = data.uvs[data.triangleUvs[t][c]].cast<double>();
            triangles[t][c] = Eigen::Vector2d(uv.x(), 1 - uv.y());
        }
        moveIntoAtlas(triangles[t], width, height);
        if (!triangles[t][0].allFinite() || !triangles[t][1].allFinite() || !triangles[t][2].allFinite())
            continue;
        if (!map.paint(triangles[t], charts[t]))
            slivers.push_back(t);
    }
    const std::vector<std::uint16_t> covering = map.charts();
    // Triangles between the centres show texels, too.
    ChartMap thin(width, height);
    for (const std::size_t t : slivers)
        thin.paintSliver(triangles[t], charts[t]);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (map.at(x, y) == noChart)
                map.at(x, y) = thin.at(x, y);
    if (gutter > 0)
        map.grow(gutter);
    for (std::size_t texel = 0; texel < covering.size(); ++texel) {
        const std::uint16_t chart = map.charts()[texel];
        if (chart == noChart)
            continue;
        used.texels.push_back(static_cast<std::uint32_t>(texel));
        used.charts.push_back(chart);
        used.covered.push_back(covering[texel] != noChart ? 1 : 0);
    }
    if (used.texels.empty())
        refuse("No texel of the texture is used by the UV layout",
               "Export the mesh with finite UVs that are not all at one place.");
    return used;
}

} // namespace quadrille
