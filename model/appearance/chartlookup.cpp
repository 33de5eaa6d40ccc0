// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/chartlookup.h"

#include "model/appearance/cubicweights.h"

#include <algorithm>
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
    findSources();
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
    const std::vector<std::uint8_t> still = colours(texture);
    const std::vector<float> moved = sampled(std::vector<float>(still.begin(), still.end()), field);
    std::vector<std::uint8_t> rounded(moved.size());
    std::ranges::transform(moved, rounded.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
    });
    return rounded;
}

bool ChartLookup::isSquareInside(int left, int top, std::uint16_t chart) const
{
    if (left < 1 || top < 1 || left + 2 >= m_used.width || top + 2 >= m_used.height)
        return false;
    const std::uint16_t* corner = m_charts.data() + cell(left - 1, top - 1);
    for (int row = 0; row < 4; ++row, corner += m_used.width + 1)
        if (corner[0] != chart || corner[1] != chart || corner[2] != chart || corner[3] != chart)
            return false;
    return true;
}

std::array<float, 3> ChartLookup::cubic(const float* values, int left, int top, const Vec2f& part) const
{
    const CubicWeights x = cubicWeights(part.x());
    const CubicWeights y = cubicWeights(part.y());
    const std::array down{y.w0, y.w1, y.w2, y.w3};
    Eigen::Array4f sums = Eigen::Array4f::Zero(); // the last counts nothing: it is the next texel's first
    for (int row = 0; row < 4; ++row) {
        // Texels of a chart that lie side by side are used texels one after the other.
        const float* four = values + std::size_t{3} * m_indices[cell(left - 1, top - 1 + row)];
        const float of = down[static_cast<std::size_t>(row)];
        sums += x.w0 * of * Eigen::Map<const Eigen::Array4f>(four);
        sums += x.w1 * of * Eigen::Map<const Eigen::Array4f>(four + 3);
        sums += x.w2 * of * Eigen::Map<const Eigen::Array4f>(four + 6);
        sums += x.w3 * of * Eigen::Map<const Eigen::Array4f>(four + 9);
    }
    return {sums[0], sums[1], sums[2]};
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

std::vector<float> ChartLookup::sampled(std::span<const float> values, const std::vector<Vec2f>& field) const
{
    std::vector<float> moved(values.size());
    std::vector<float> padded(values.size() + 1); // for the last texel's fourth value
    std::ranges::copy(values, padded.begin());
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = place(k);
        const Vec2f at(static_cast<float>(x) + field[k].x(), static_cast<float>(y) + field[k].y());
        const int left = std::clamp(static_cast<int>(at.x()), 0, m_used.width - 1);
        const int top = std::clamp(static_cast<int>(at.y()), 0, m_used.height - 1);
        const Vec2f part = at - Vec2f(static_cast<float>(left), static_cast<float>(top));
        const auto chart = static_cast<std::uint16_t>(m_used.charts[k] + 1);
        std::ranges::copy(isSquareInside(left, top, chart) ? cubic(padded.data(), left, top, part)
                                                           : linear(values, k, left, top, part),
                          moved.begin() + static_cast<std::ptrdiff_t>(3 * k));
    }
    return moved;
}

std::vector<float> ChartLookup::atNodes(const std::vector<Vec2f>& field, const WarpGrid& grid) const
{
    constexpr int passes = 3; // means draw nodes at edges inwards, what is left is added
    const auto width = static_cast<std::size_t>(grid.width);
    const auto nodes = static_cast<std::size_t>(grid.nodes());
    std::vector<float> values(2 * nodes);
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Eigen::Vector3f> sums(nodes, Eigen::Vector3f::Zero());
        for (std::size_t k = 0; k < field.size(); ++k) {
            const auto [x, y] = place(k);
            const Vec2f at(static_cast<float>(x), static_cast<float>(y));
            const Vec2f left = field[k] - warpAt(values, grid, at);
            const Vec2f cell = at / static_cast<float>(grid.spacing);
            const int i = x / grid.spacing;
            const int j = y / grid.spacing;
            const float tx = cell.x() - static_cast<float>(i);
            const float ty = cell.y() - static_cast<float>(j);
            for (const auto& [di, dj, weight] : {std::tuple{0, 0, (1 - tx) * (1 - ty)},
                                                 {1, 0, tx * (1 - ty)},
                                                 {0, 1, (1 - tx) * ty},
                                                 {1, 1, tx * ty}})
                if (weight > 0)
                    sums[static_cast<std::size_t>(j + dj) * width + static_cast<std::size_t>(i + di)] +=
                        weight * Eigen::Vector3f(left.x(), left.y(), 1);
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
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = place(k);
        field[k] = shortened(k, warpAt(nodes, grid, Vec2f(static_cast<float>(x), static_cast<float>(y))));
    }
    return field;
}

std::vector<Vec2f> ChartLookup::inverse(std::span<const float> nodes, const WarpGrid& grid) const
{
    constexpr int iterations = 12; // each leaves as much of the error as the warp stretches
    std::vector<Vec2f> field(m_used.texels.size());
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = place(k);
        const Vec2f from(static_cast<float>(x), static_cast<float>(y));
        Vec2f found = Vec2f::Zero();
        for (int iteration = 0; iteration < iterations; ++iteration) {
            const Vec2f before = found;
            found = -warpAt(nodes, grid, from + found);
            if ((found - before).squaredNorm() < 1e-6F)
                break;
        }
        field[k] = found;
    }
    keepInside(field);
    return field;
}

} // namespace quadrille
