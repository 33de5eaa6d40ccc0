// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/chartlookup.h"

#include "model/appearance/decodekernels.h"
#include "model/appearance/lookupkernels.h"
#include "model/appearance/rowwarp.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

constexpr auto none = static_cast<std::uint32_t>(-1);

} // namespace

ChartLookup::ChartLookup(UsedTexels used) : m_used(std::move(used))
{
    m_charts.resize(cell(m_used.width, m_used.height) + 1);
    m_indices.assign(m_charts.size(), none);
    const auto width = static_cast<std::uint32_t>(m_used.width);
    for (std::size_t k = 0; k < m_used.texels.size(); ++k) {
        const std::uint32_t texel = m_used.texels[k];
        const auto [x, y] = m_places.emplace_back(
            std::array{static_cast<int>(texel % width), static_cast<int>(texel / width)});
        m_charts[cell(x, y)] = static_cast<std::uint16_t>(m_used.charts[k] + 1);
        m_indices[cell(x, y)] = static_cast<std::uint32_t>(k);
    }
    findSquares();
    findSources();
}

void ChartLookup::findSquares()
{
    m_squares.resize(m_charts.size());
    const auto isWhole = [&](int x, int y, int before, int behind) {
        if (x < before || y < before || x + behind >= m_used.width || y + behind >= m_used.height)
            return false;
        const std::uint16_t chart = m_charts[cell(x, y)];
        for (int row = y - before; row <= y + behind; ++row)
            for (int column = x - before; column <= x + behind; ++column)
                if (m_charts[cell(column, row)] != chart)
                    return false;
        return true;
    };
    for (const auto& [x, y] : m_places)
        if (isWhole(x, y, 0, 1))
            m_squares[cell(x, y)] = isWhole(x, y, 1, 2) ? 4 : 2;
}

void ChartLookup::findSources()
{
    m_sources.assign(m_used.texels.size(), none);
    std::vector<std::uint32_t> front;
    for (std::size_t k = 0; k < m_sources.size(); ++k) {
        if (m_used.covered[k] != 0) {
            m_sources[k] = static_cast<std::uint32_t>(k);
            front.push_back(static_cast<std::uint32_t>(k));
        }
    }
    for (std::size_t next = 0; next < front.size(); ++next) {
        const auto [x, y] = place(front[next]);
        for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            if (x + dx < 0 || y + dy < 0)
                continue;
            const std::uint32_t beside = m_indices[cell(x + dx, y + dy)];
            if (beside == none || m_sources[beside] != none ||
                m_used.charts[beside] != m_used.charts[front[next]])
                continue;
            m_sources[beside] = m_sources[front[next]];
            front.push_back(beside);
        }
    }
    // Charts between the centres of texels have nothing but gutter.
    for (std::size_t k = 0; k < m_sources.size(); ++k)
        if (m_sources[k] == none)
            m_sources[k] = static_cast<std::uint32_t>(k);
}

bool ChartLookup::isInside(const Vec2f& place, std::uint16_t chart) const
{
    if (!(place.x() >= 0 && place.y() >= 0 && place.x() < static_cast<float>(m_used.width) &&
          place.y() < static_cast<float>(m_used.height)))
        return false;
    const int left = static_cast<int>(place.x());
    const int top = static_cast<int>(place.y());
    if (isSquare(cell(left, top), chart, 2))
        return true;
    const std::uint16_t* charts = m_charts.data() + cell(left, top);
    const bool isWide = place.x() > static_cast<float>(left);
    const bool isHigh = place.y() > static_cast<float>(top);
    const int below = m_used.width + 1;
    return charts[0] == chart && (!isWide || charts[1] == chart) && (!isHigh || charts[below] == chart) &&
           (!isWide || !isHigh || charts[below + 1] == chart);
}

Vec2f ChartLookup::shortened(std::size_t texel, const Vec2f& displacement) const
{
    constexpr int parts = 8;
    const auto [x, y] = place(texel);
    const Vec2f from(static_cast<float>(x), static_cast<float>(y));
    const auto chart = static_cast<std::uint16_t>(m_used.charts[texel] + 1);
    if (isInside(from + displacement, chart))
        return displacement;
    // What points out of an edge slides along it.
    const bool isAcross = std::abs(displacement.x()) > std::abs(displacement.y());
    const Vec2f larger = isAcross ? Vec2f(displacement.x(), 0) : Vec2f(0, displacement.y());
    for (int part = parts; part > 0; --part)
        for (const Vec2f& direction : {displacement, larger}) {
            Vec2f shorter = direction * (static_cast<float>(part) / parts);
            if (isInside(from + shorter, chart))
                return shorter;
        }
    const Vec2f smaller = displacement - larger;
    return isInside(from + smaller, chart) ? smaller : Vec2f::Zero();
}

void ChartLookup::keepInside(std::vector<Vec2f>& field) const
{
    for (std::size_t k = 0; k < field.size(); ++k)
        field[k] = field[m_sources[k]]; // those of covered texels stay
    for (std::size_t k = 0; k < field.size(); ++k)
        field[k] = shortened(k, field[k]);
}

std::vector<std::uint8_t> ChartLookup::colours(const Image& texture) const
{
    std::vector<std::uint8_t> colours;
    colours.reserve(3 * m_used.texels.size());
    for (const std::uint32_t source : m_sources) {
        const std::uint8_t* pixel = texture.pixels.data() + std::size_t{4} * m_used.texels[source];
        colours.insert(colours.end(), pixel, pixel + 3);
    }
    return colours;
}

std::vector<std::uint8_t> ChartLookup::colours(const Image& texture, const std::vector<Vec2f>& field) const
{
    std::vector<std::uint8_t> rounded = colours(texture);
    std::vector<float> still(rounded.begin(), rounded.end());
    still.push_back(0);
    std::vector<float> moved(still.size());
    sample(still, field, moved);
    roundToBytes(moved.data(), static_cast<int>(rounded.size()), rounded.data());
    return rounded;
}

std::array<float, 3> ChartLookup::linear(std::span<const float> values, std::size_t texel, int left, int top,
                                         const Vec2f& part) const
{
    std::array<float, 3> sums{};
    float whole = 0;
    for (const auto& [dx, dy, weight] : {std::tuple{0, 0, (1 - part.x()) * (1 - part.y())},
                                         {1, 0, part.x() * (1 - part.y())},
                                         {0, 1, (1 - part.x()) * part.y()},
                                         {1, 1, part.x() * part.y()}}) {
        if (!(weight > 0) || m_charts[cell(left + dx, top + dy)] != m_used.charts[texel] + 1)
            continue;
        const float* value = values.data() + std::size_t{3} * m_indices[cell(left + dx, top + dy)];
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += weight * value[c];
        whole += weight;
    }
    for (std::size_t c = 0; c < 3; ++c)
        sums[c] = whole > 0 ? sums[c] / whole : values[3 * texel + c];
    return sums;
}

void ChartLookup::sample(std::span<const float> values, const std::vector<Vec2f>& field,
                         std::span<float> looked) const
{
    assert(values.size() == 3 * field.size() + 1 && looked.size() >= 3 * field.size());
    std::vector<SquareLookup> squares;
    constexpr std::size_t atOnce = 256;
    squares.reserve(atOnce);
    const auto lookUp = [&] {
        lookUpSquares(values.data(), squares.data(), static_cast<int>(squares.size()), looked.data());
        squares.clear();
    };
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = place(k);
        const Vec2f at(static_cast<float>(x) + field[k].x(), static_cast<float>(y) + field[k].y());
        const int left = std::clamp(static_cast<int>(at.x()), 0, m_used.width - 1);
        const int top = std::clamp(static_cast<int>(at.y()), 0, m_used.height - 1);
        const Vec2f part = at - Vec2f(static_cast<float>(left), static_cast<float>(top));
        const auto chart = static_cast<std::uint16_t>(m_used.charts[k] + 1);
        if (!isSquare(cell(left, top), chart, 4)) {
            std::ranges::copy(linear(values, k, left, top, part),
                              looked.begin() + static_cast<std::ptrdiff_t>(3 * k));
            continue;
        }
        // Texels of a chart that lie side by side are used texels one after the other.
        const std::uint32_t* first = m_indices.data() + cell(left - 1, top - 1);
        const auto below = static_cast<std::ptrdiff_t>(m_used.width) + 1;
        squares.push_back({{first[0], first[below], first[2 * below], first[3 * below]},
                           part.x(),
                           part.y(),
                           static_cast<std::uint32_t>(k)});
        if (squares.size() == atOnce)
            lookUp();
    }
    lookUp();
}

std::vector<float> ChartLookup::atNodes(const std::vector<Vec2f>& field, const WarpGrid& grid) const
{
    constexpr int passes = 3; // means draw nodes at edges inwards, what is left is added
    const auto width = static_cast<std::size_t>(grid.width);
    const auto nodes = static_cast<std::size_t>(grid.nodes());
    std::vector<float> values(2 * nodes);
    std::vector<float> rows;
    using Sum = Eigen::Array4f; // of x, y and weights; the last counts nothing
    std::vector<Sum> line(width + 1);
    const auto part = [&](int texel) {
        return static_cast<float>(texel % grid.spacing) / static_cast<float>(grid.spacing);
    };
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Sum> sums(nodes + width, Sum::Zero());
        RowWarp warp(grid, values, m_used.width, rows);
        for (std::size_t k = 0; k < field.size();) {
            const int y = place(k)[1];
            warp.moveTo(y);
            std::ranges::fill(line, Sum::Zero());
            for (; k < field.size() && place(k)[1] == y; ++k) {
                const int x = place(k)[0];
                const Vec2f left = field[k] - warp.of(x);
                const Sum value(left.x(), left.y(), 1, 0);
                const float weight = part(x);
                Sum* node = line.data() + x / grid.spacing;
                node[0] += (1 - weight) * value;
                node[1] += weight * value;
            }
            const float weight = part(y);
            Sum* above = sums.data() + static_cast<std::size_t>(y / grid.spacing) * width;
            for (std::size_t i = 0; i < width; ++i) {
                above[i] += (1 - weight) * line[i];
                above[width + i] += weight * line[i];
            }
        }
        for (std::size_t node = 0; node < nodes; ++node)
            if (sums[node].z() > 0)
                for (const std::size_t axis : {0U, 1U})
                    values[2 * node + axis] += sums[node][static_cast<Eigen::Index>(axis)] / sums[node].z();
    }
    return values;
}

std::vector<Vec2f> ChartLookup::atTexels(std::span<const float> nodes, const WarpGrid& grid) const
{
    std::vector<Vec2f> field(m_used.texels.size());
    std::vector<float> rows;
    RowWarp warp(grid, nodes, m_used.width, rows);
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = place(k);
        if (k == 0 || place(k - 1)[1] != y)
            warp.moveTo(y);
        field[k] = shortened(k, warp.of(x));
    }
    return field;
}

std::vector<Vec2f> ChartLookup::inverse(std::span<const float> nodes, const WarpGrid& grid) const
{
    std::vector<Vec2f> field(m_used.texels.size());
    std::vector<float> columns;
    for (std::size_t k = 0; k < field.size(); k += columns.size()) {
        const int y = place(k)[1];
        columns.clear();
        for (std::size_t next = k; next < field.size() && place(next)[1] == y; ++next)
            columns.push_back(static_cast<float>(place(next)[0]));
        undoWarp(nodes.data(), grid, columns.data(), y, static_cast<int>(columns.size()), nullptr,
                 field[k].data());
    }
    keepInside(field);
    return field;
}

} // namespace quadrille
