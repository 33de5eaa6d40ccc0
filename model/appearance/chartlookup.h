// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/usedtexels.h"
#include "model/appearance/warpgrid.h"
#include "model/core/image.h"

#include <span>

namespace quadrille {

/// Looks textures and displacements up within the charts of an atlas: what belongs to one chart is never
/// mixed with another. Displacements are in texels, x to the right and y downwards; fields have one for each
/// used texel.
class ChartLookup
{
public:
    explicit ChartLookup(UsedTexels used);

    const UsedTexels& used() const { return m_used; }
    std::int64_t count() const { return static_cast<std::int64_t>(m_used.texels.size()); }
    /// Column and row of a used texel.
    const std::array<int, 2>& place(std::size_t texel) const { return m_places[texel]; }
    /// The used texel whose colour a used texel has: of gutters the nearest covered one, else itself.
    std::size_t source(std::size_t texel) const { return m_sources[texel]; }

    /// Carries the field from covered texels into the gutters of their charts, then shortens displacements
    /// until a bilinear sample at their end takes texels of the chart only.
    void keepInside(std::vector<Vec2f>& field) const;
    /// The colours of a texture: R, G, B per used texel; in gutters those of the nearest covered texels, as
    /// what textures hold there may be anything. \pre The texture has the size of the atlas.
    std::vector<std::uint8_t> colours(const Image& texture) const;
    /// Colours looked up at x + field(x), rounded to nearest: cubic where the chart is as wide as that takes,
    /// else linear between its texels.
    std::vector<std::uint8_t> colours(const Image& texture, const std::vector<Vec2f>& field) const;

    /// Three values per used texel, looked up in the same way. \param values  three of each used texel, and
    /// one more that counts nothing. \param looked  three of each; other memory than the values.
    void sample(std::span<const float> values, const std::vector<Vec2f>& field,
                std::span<float> looked) const;

    /// The field at the nodes of a grid: a mean of the texels less than a spacing away, the nearest counting
    /// most. Zero at nodes that none of them is near, on which no used texel depends.
    std::vector<float> atNodes(const std::vector<Vec2f>& field, const WarpGrid& grid) const;
    /// The field that nodes stand for, kept inside the charts. \param nodes  x, y of each, in rows.
    std::vector<Vec2f> atTexels(std::span<const float> nodes, const WarpGrid& grid) const;
    /// The field w with w(x) = −warp(x + w(x)), which undoes a warp, by fixed-point iteration; kept inside
    /// the charts. It converges where the warp does not fold.
    std::vector<Vec2f> inverse(std::span<const float> nodes, const WarpGrid& grid) const;

private:
    std::size_t cell(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_used.width + 1) +
               static_cast<std::size_t>(x);
    }
    /// Whether the sample at a place takes texels of the chart only.
    bool isInside(const Vec2f& place, std::uint16_t chart) const;
    std::array<float, 3> linear(std::span<const float> values, std::size_t texel, int left, int top,
                                const Vec2f& part) const;
    Vec2f shortened(std::size_t texel, const Vec2f& displacement) const;
    /// Whether square × square texels are of one chart that a look-up between a texel and the next takes.
    bool isSquare(std::size_t cell, std::uint16_t chart, int square) const
    {
        return m_charts[cell] == chart && m_squares[cell] >= square;
    }
    void findSquares();
    void findSources();

    UsedTexels m_used;
    std::vector<std::array<int, 2>> m_places;
    std::vector<std::uint16_t> m_charts; ///< of all texels from 1 on; 0 where unused, and beyond the edges
    std::vector<std::uint8_t> m_squares; ///< of all texels how many texels beside each other are of its chart
    std::vector<std::uint32_t> m_indices; ///< of all texels among the used ones
    std::vector<std::uint32_t>
        m_sources; ///< per used texel that from which field and colour are carried to it
};

} // namespace quadrille
