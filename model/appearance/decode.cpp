// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/decode.h"

#include "model/appearance/decodekernels.h"
#include "model/appearance/rowwarp.h"
#include "model/appearance/spreadtexels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

namespace quadrille {

static_assert(std::endian::native == std::endian::little, "pixels are read as R + 256 · G + …");

namespace {

constexpr int valuesOfDecodedBlock = static_cast<int>(QuantisedSpace::blockSize);
static_assert(valuesOfDecodedBlock % 3 == 0, "no texel lies in two blocks");

/// The nodes around some texels, row by row.
std::vector<NodeRun> nodesAround(const UsedTexels& used, const WarpGrid& grid)
{
    if (grid.nodes() == 0)
        return {};
    std::vector<std::uint8_t> isUsed(static_cast<std::size_t>(grid.nodes()));
    for (const std::uint32_t texel : used.texels) {
        const int x = static_cast<int>(texel) % used.width;
        const int y = static_cast<int>(texel) / used.width;
        for (int j = y / grid.spacing; j * grid.spacing < y + grid.spacing && j < grid.height; ++j)
            for (int i = x / grid.spacing; i * grid.spacing < x + grid.spacing && i < grid.width; ++i)
                isUsed[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width) +
                       static_cast<std::size_t>(i)] = 1;
    }
    std::vector<NodeRun> runs;
    for (int j = 0; j < grid.height; ++j) {
        const std::uint8_t* row =
            isUsed.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width);
        for (int i = 0; i < grid.width; ++i) {
            if (row[i] == 0)
                continue;
            if (i > 0 && row[i - 1] != 0)
                ++runs.back().count;
            else
                runs.push_back({.row = j, .column = i, .count = 1});
        }
    }
    return runs;
}

// Around the texels of an atlas, so that look-ups need not ask where it ends.
constexpr std::uint32_t texelsBefore = 1;
constexpr std::uint32_t texelsBehind = 2;
constexpr std::size_t texelsAtEnd = std::size_t{2} * lookupLanes;
static_assert(lookupsAtOnce % lookupLanes == 0);

} // namespace

AppearanceDecoder::AppearanceDecoder(std::shared_ptr<const AppearanceModel> model,
                                     std::optional<Image> background)
    : m_model(std::move(model))
    , m_lookup(m_model->texels)
    , m_nodes(nodesAround(m_model->texels, m_model->grid))
{
    const UsedTexels& used = m_model->texels;
    const auto width = static_cast<std::uint32_t>(used.width);
    m_stride = width + texelsBefore + texelsBehind;
    m_origin = texelsBefore * m_stride + texelsBefore;
    m_charts.resize(std::size_t{m_stride} *
                        (static_cast<std::size_t>(used.height) + texelsBefore + texelsBehind) +
                    texelsAtEnd);
    m_squares.resize(m_charts.size());
    const auto placeOf = [this](int x, int y) {
        return m_origin + static_cast<std::uint32_t>(y) * m_stride + static_cast<std::uint32_t>(x);
    };
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        const std::uint32_t texel = used.texels[t];
        const auto x = static_cast<int>(texel % width);
        const auto y = static_cast<int>(texel / width);
        const auto chart = static_cast<std::uint16_t>(used.charts[t] + 1);
        m_places.push_back(placeOf(x, y));
        if (used.covered[t] == 0) {
            const auto& [sourceX, sourceY] = m_lookup.place(m_lookup.source(t));
            m_gutters.emplace_back(m_places.back(), placeOf(sourceX, sourceY));
        }
        m_charts[m_places.back()] = chart;
        if (!m_runs.empty() && m_runs.back().y == y && m_runs.back().chart == chart &&
            m_runs.back().x + m_runs.back().length == x)
            ++m_runs.back().length;
        else
            m_runs.push_back({x, y, 1, chart});
    }
    for (const std::uint32_t place : m_places) {
        const std::uint16_t chart = m_charts[place];
        const std::uint16_t* corner = &m_charts[place - m_origin];
        bool isWhole = true;
        for (std::size_t tap = 0; tap < 16 && isWhole; ++tap)
            isWhole = corner[tap / 4 * m_stride + tap % 4] == chart;
        if (isWhole)
            m_squares[place] = chart;
    }
    if (background) {
        assert(background->width == used.width && background->height == used.height);
        m_background = *std::move(background);
    } else {
        m_background = Image(used.width, used.height);
        DecodeScratch scratch;
        align({}, scratch);
        copyUsed(scratch, m_background);
        spreadTexels(used, m_background);
    }
}

void AppearanceDecoder::align(std::span<const float> coefficients, DecodeScratch& scratch) const
{
    const QuantisedSpace& space = m_model->textures;
    scratch.aligned.resize(m_charts.size());
    scratch.isOpaque = true;
    alignas(64) std::array<float, valuesOfDecodedBlock> values;
    alignas(64) std::array<std::uint8_t, valuesOfDecodedBlock + 1> bytes{};
    const std::uint32_t* place = m_places.data();
    const std::uint32_t* end = place + m_places.size();
    for (std::int64_t b = 0; b < space.blocks(); ++b) {
        combineBlock(space, b, coefficients, values);
        roundToBytes(values.data(), valuesOfDecodedBlock, bytes.data());
        for (int i = 0; i < valuesOfDecodedBlock && place != end; i += 3, ++place) {
            std::uint32_t texel = 0; // with a byte of the next
            std::memcpy(&texel, bytes.data() + i, sizeof(texel));
            scratch.aligned[*place] = texel | 0xFF000000U;
        }
    }
}

std::uint32_t AppearanceDecoder::carefulTexel(const std::uint32_t* aligned, const Run& run, int column,
                                              Vec2f offset) const
{
    const UsedTexels& used = m_model->texels;
    const auto placeOf = [&](float x, float y) {
        return m_origin + static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x);
    };
    const Vec2f from(static_cast<float>(run.x + column), static_cast<float>(run.y));
    const Vec2f last(static_cast<float>(used.width - 1), static_cast<float>(used.height - 1));
    constexpr int mostHalvings = 64;
    for (int halvings = 0; halvings < mostHalvings; ++halvings, offset *= 0.5F) {
        const Vec2f at = (from + offset).cwiseMax(0.0F).cwiseMin(last);
        const Vec2f corner(std::floor(at.x()), std::floor(at.y()));
        if (!std::isfinite(at.x() + at.y()))
            break;
        const Vec2f part = at - corner;
        std::array<float, 3> sum{};
        float weights = 0;
        for (int tap = 0; tap < 4; ++tap) {
            const bool right = tap % 2 != 0;
            const bool below = tap / 2 != 0;
            const std::size_t place =
                placeOf(corner.x(), corner.y()) + (right ? 1 : 0) + (below ? m_stride : 0);
            if (m_charts[place] != run.chart)
                continue;
            const float weight = (right ? part.x() : 1 - part.x()) * (below ? part.y() : 1 - part.y());
            weights += weight;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += weight * static_cast<float>(aligned[place] >> (8 * c) & 255U);
        }
        if (weights > 0) {
            std::uint32_t texel = 0xFF000000U;
            for (std::size_t c = 0; c < 3; ++c)
                texel |= static_cast<std::uint32_t>(std::min(255.0F, sum[c] / weights + 0.5F)) << (8 * c);
            return texel;
        }
    }
    return aligned[placeOf(from.x(), from.y())];
}

int AppearanceDecoder::lookUp(const DecodeScratch& scratch, const Run& run, int done, const RowWarp& warp,
                              LookedUp& texels) const
{
    const UsedTexels& used = m_model->texels;
    const RowLookup lookup{.plane = scratch.aligned.data() + m_origin,
                           .isOpaque = scratch.isOpaque,
                           .stride = static_cast<int>(m_stride),
                           .lastX = used.width - 1,
                           .lastY = used.height - 1,
                           .x = run.x + done,
                           .y = run.y,
                           .count = std::min(lookupsAtOnce, run.length - done)};
    const WarpRows rows = warp.at(lookup.x);
    alignas(64) std::array<std::int32_t, lookupsAtOnce> places;
    lookUpRow(lookup, rows, places.data(), texels.data());
    for (int i = 0; i < lookup.count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        if (m_squares[m_origin + static_cast<std::size_t>(places[n])] == run.chart)
            continue;
        const Vec2f offset(rows.x[0][i] + rows.weight * (rows.x[1][i] - rows.x[0][i]),
                           rows.y[0][i] + rows.weight * (rows.y[1][i] - rows.y[0][i]));
        texels[n] = carefulTexel(scratch.aligned.data(), run, done + i, offset);
    }
    return lookup.count;
}

void AppearanceDecoder::dealign(DecodeScratch& scratch, Image& texture) const
{
    RowWarp warp(m_model->grid, scratch.warp, m_model->texels.width, scratch.rows);
    alignas(64) LookedUp texels;
    for (const Run& run : m_runs) {
        warp.moveTo(run.y);
        for (int done = 0; done < run.length; done += lookupsAtOnce) {
            const int count = lookUp(scratch, run, done, warp, texels);
            std::memcpy(texture.pixel(run.x + done, run.y), texels.data(),
                        sizeof(std::uint32_t) * static_cast<std::size_t>(count));
        }
    }
}

void AppearanceDecoder::copyUsed(const DecodeScratch& scratch, Image& texture) const
{
    for (const Run& run : m_runs)
        std::memcpy(texture.pixel(run.x, run.y),
                    scratch.aligned.data() + m_origin + static_cast<std::size_t>(run.y) * m_stride +
                        static_cast<std::size_t>(run.x),
                    sizeof(std::uint32_t) * static_cast<std::size_t>(run.length));
}

void AppearanceDecoder::decode(const AppearanceCoefficients& coefficients, DecodeScratch& scratch,
                               Image& texture) const
{
    texture = m_background;
    align(coefficients.textures, scratch);
    const QuantisedSpace& warps = m_model->warps;
    if (warps.size == 0)
        return copyUsed(scratch, texture);
    combine(warps, coefficients.warps, scratch.warp);
    dealign(scratch, texture);
}

Image AppearanceDecoder::decode(const AppearanceCoefficients& coefficients) const
{
    DecodeScratch scratch;
    Image texture;
    decode(coefficients, scratch, texture);
    return texture;
}

Image AppearanceDecoder::decodeAligned(std::span<const float> textures) const
{
    DecodeScratch scratch;
    Image texture = m_background;
    align(textures, scratch);
    copyUsed(scratch, texture);
    return texture;
}

void AppearanceDecoder::fill(std::span<const std::uint8_t> colours, DecodeScratch& scratch) const
{
    assert(colours.size() == 3 * m_places.size());
    scratch.aligned.resize(m_charts.size());
    scratch.isOpaque = true;
    const std::uint8_t* colour = colours.data();
    for (const std::uint32_t place : m_places) {
        scratch.aligned[place] = 0xFF000000U | static_cast<std::uint32_t>(colour[0]) |
                                 static_cast<std::uint32_t>(colour[1]) << 8 |
                                 static_cast<std::uint32_t>(colour[2]) << 16;
        colour += 3;
    }
}

Image AppearanceDecoder::dealigned(std::span<const std::uint8_t> colours, std::span<const float> warp) const
{
    assert(std::ssize(warp) == 2 * m_model->grid.nodes());
    DecodeScratch scratch;
    fill(colours, scratch);
    scratch.warp.assign(warp.begin(), warp.end());
    Image texture = m_background;
    dealign(scratch, texture);
    return texture;
}

void AppearanceDecoder::fill(const Image& texture, DecodeScratch& scratch) const
{
    std::vector<std::uint32_t>& plane = scratch.aligned;
    plane.resize(m_charts.size());
    std::uint32_t shared = 0xFF000000U;
    for (const Run& run : m_runs) {
        std::uint32_t* texels = plane.data() + m_origin + static_cast<std::size_t>(run.y) * m_stride +
                                static_cast<std::size_t>(run.x);
        std::memcpy(texels, texture.pixel(run.x, run.y),
                    sizeof(std::uint32_t) * static_cast<std::size_t>(run.length));
        for (int i = 0; i < run.length; ++i)
            shared &= texels[i];
    }
    scratch.isOpaque = shared == 0xFF000000U;
    for (const auto& [place, source] : m_gutters)
        plane[place] = plane[source];
}

void AppearanceDecoder::mix(const MovedTexture& first, const MovedTexture& second, float weight,
                            DecodeScratch& scratch, Image& mixed) const
{
    const UsedTexels& used = m_model->texels;
    assert(mixed.width == used.width && mixed.height == used.height);
    assert(std::ssize(first.warp) == 2 * m_model->grid.nodes() && first.warp.size() == second.warp.size());
    alignas(64) LookedUp texels;
    for (const bool isSecond : {false, true}) {
        const MovedTexture& moved = isSecond ? second : first;
        fill(moved.texture, scratch);
        RowWarp warp(m_model->grid, moved.warp, used.width, scratch.rows);
        const std::uint8_t* covered = used.covered.data();
        for (const Run& run : m_runs) {
            warp.moveTo(run.y);
            for (int done = 0; done < run.length; done += lookupsAtOnce) {
                const int count = lookUp(scratch, run, done, warp, texels);
                auto* bytes = reinterpret_cast<std::uint8_t*>(texels.data());
                std::uint8_t* texel = mixed.pixel(run.x + done, run.y);
                if (isSecond)
                    mixBytes(texel, bytes, weight, std::int64_t{4} * count, bytes);
                for (int i = 0; i < count; ++i, texel += 4, bytes += 4)
                    if (*covered++ != 0)
                        std::memcpy(texel, bytes, 4);
            }
        }
    }
}

} // namespace quadrille
