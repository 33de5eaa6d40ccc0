// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/alignment.h"
#include "model/appearance/scratchrows.h"

#include <algorithm>

namespace quadrille {

namespace {

template <typename Value>
std::vector<Value> readValues(const ScratchRows& rows, std::int64_t row, std::uint64_t offset,
                              std::uint64_t bytes)
{
    std::vector<Value> values(bytes / sizeof(Value));
    rows.read(row, offset, std::as_writable_bytes(std::span(values)));
    return values;
}

} // namespace

// A row holds the forward warp, the backward one, and the colours.
TextureAlignment::TextureAlignment(WarpGrid grid, std::int64_t textures, std::int64_t texels,
                                   const std::filesystem::path& scratch)
    : figures(static_cast<std::size_t>(textures))
    , m_grid(grid)
    , m_count(textures)
    , m_colours(static_cast<std::uint64_t>(texels) * 3)
    , m_rows(std::make_unique<ScratchRows>(2 * warpBytes() + m_colours, scratch))
{
}

TextureAlignment::~TextureAlignment() = default;

std::vector<float> TextureAlignment::forward(std::int64_t texture) const
{
    return readValues<float>(*m_rows, texture, 0, warpBytes());
}

std::vector<float> TextureAlignment::backward(std::int64_t texture) const
{
    return readValues<float>(*m_rows, texture, warpBytes(), warpBytes());
}

std::vector<std::uint8_t> TextureAlignment::aligned(std::int64_t texture) const
{
    return readValues<std::uint8_t>(*m_rows, texture, 2 * warpBytes(), m_colours);
}

SampleSet TextureAlignment::alignedSamples() const
{
    return {m_count, static_cast<std::int64_t>(m_colours),
            [this](std::int64_t sample, std::int64_t first, std::span<float> values) {
                const auto offset = 2 * warpBytes() + static_cast<std::uint64_t>(first);
                const auto bytes = readValues<std::uint8_t>(*m_rows, sample, offset, values.size());
                std::copy(bytes.begin(), bytes.end(), values.begin());
            }};
}

SampleSet TextureAlignment::backwardSamples() const
{
    return {m_count, 2 * m_grid.nodes(),
            [this](std::int64_t sample, std::int64_t first, std::span<float> values) {
                m_rows->read(sample, warpBytes() + static_cast<std::uint64_t>(first) * sizeof(float),
                             std::as_writable_bytes(values));
            }};
}

void TextureAlignment::setForward(std::int64_t texture, std::span<const std::byte> warp)
{
    m_rows->write(texture, 0, warp);
}

void TextureAlignment::setBackward(std::int64_t texture, std::span<const std::byte> warp)
{
    m_rows->write(texture, warpBytes(), warp);
}

void TextureAlignment::setAligned(std::int64_t texture, std::span<const std::byte> colours)
{
    m_rows->write(texture, 2 * warpBytes(), colours);
}

} // namespace quadrille
