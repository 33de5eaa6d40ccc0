// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"
#include "model/appearance/chartlookup.h"
#include "model/appearance/decodekernels.h"
#include "model/core/image.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille {

class RowWarp;

/// What a decoder needs besides its model while it makes a texture; kept from one to the next it need not be
/// allocated again. One for each thread.
struct DecodeScratch
{
    std::vector<std::uint32_t> aligned;      ///< what is looked up in, R G B A, with some texels around it
    bool isOpaque = true;                    ///< it is, where it is used
    std::vector<float> warp;                 ///< 2 values per node
    std::vector<float> rows;                 ///< warps of the texels of two rows of nodes
    std::vector<float> blendWarp;            ///< that of a blend, where two are mixed
    std::vector<float> ownWarp;              ///< that of one of them
    std::array<std::vector<float>, 2> moves; ///< from theirs to that of the blend
};

/// A texture, and what moves it.
struct MovedTexture
{
    const Image& texture;        ///< of the atlas's size
    std::span<const float> warp; ///< 2 values per node
};

/// Makes textures of an AppearanceModel's coefficients: about 9 ms for 1024² with 20 components of textures
/// and 10 of warps, where half of the texels are used (bench_appearancemodel). From any number of threads.
class AppearanceDecoder
{
public:
    /// \param background  the texels that are not used are its; none: those of the mean texture, spread, so
    /// that smaller pictures of a texture show no seams.
    /// \pre The background has the atlas's size.
    explicit AppearanceDecoder(std::shared_ptr<const AppearanceModel> model,
                               std::optional<Image> background = std::nullopt);

    const AppearanceModel& model() const { return *m_model; }
    /// The nodes around used texels; warps of others count nothing.
    std::span<const NodeRun> nodes() const { return m_nodes; }

    /// The texture: aligned texels, looked up at x + warp(x), cubic where the chart is as wide as that takes,
    /// else linear. A look-up never leaves the chart of its texel: texels of others do not count, and where
    /// none is left it moves back towards x.
    Image decode(const AppearanceCoefficients& coefficients) const;
    /// \overload into a picture that may have been used before.
    void decode(const AppearanceCoefficients& coefficients, DecodeScratch& scratch, Image& texture) const;
    /// The aligned texture, without a warp.
    Image decodeAligned(std::span<const float> textures) const;

    /// A texture de-aligned by any warp, such as one that was estimated.
    /// \param colours  R, G, B of each used texel. \param warp  2 values per node.
    Image dealigned(std::span<const std::uint8_t> colours, std::span<const float> warp) const;
    /// Two textures, each moved by a warp of its own, looked up as above, and mixed. What they hold in
    /// gutters may be anything: looked up, gutters have the colours of the nearest covered texels. \param
    /// weight  of the second, 0 … 1. \param mixed  its covered texels are replaced. \pre It has the atlas's
    /// size.
    void mix(const MovedTexture& first, const MovedTexture& second, float weight, DecodeScratch& scratch,
             Image& mixed) const;

private:
    /// Used texels of a chart one beside the other.
    struct Run
    {
        int x = 0;
        int y = 0;
        int length = 0;
        std::uint16_t chart = 0; ///< from 1 on
    };
    using LookedUp = std::array<std::uint32_t, lookupsAtOnce>;

    void align(std::span<const float> coefficients, DecodeScratch& scratch) const;
    /// Up to lookupsAtOnce texels of a run. \param done  of its texels. \return how many they are.
    int lookUp(const DecodeScratch& scratch, const Run& run, int done, const RowWarp& warp,
               LookedUp& texels) const;
    void fill(std::span<const std::uint8_t> colours, DecodeScratch& scratch) const;
    /// Gutters have the colours of the nearest covered texels.
    void fill(const Image& texture, DecodeScratch& scratch) const;
    void dealign(DecodeScratch& scratch, Image& texture) const;
    std::uint32_t carefulTexel(const std::uint32_t* aligned, const Run& run, int column, Vec2f offset) const;
    void copyUsed(const DecodeScratch& scratch, Image& texture) const;

    std::shared_ptr<const AppearanceModel> m_model;
    ChartLookup m_lookup;
    std::vector<Run> m_runs;
    std::vector<NodeRun> m_nodes;
    // Planes have some texels around those of the atlas.
    std::uint32_t m_stride = 0;
    std::uint32_t m_origin = 0;           ///< the place of the first texel
    std::vector<std::uint32_t> m_places;  ///< of each used texel
    std::vector<std::uint16_t> m_charts;  ///< of each place, from 1 on; 0: not used
    std::vector<std::uint16_t> m_squares; ///< the same where all 4 × 4 that a look-up takes are of it, else 0
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_gutters; ///< place, and that of its colour
    Image m_background;
};

} // namespace quadrille
