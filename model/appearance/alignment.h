// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/flow.h"
#include "model/appearance/linearspace.h"
#include "model/appearance/pca.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace quadrille {

class ScratchRows;

/// Textures of one atlas, by their numbers; read when asked for, from any thread.
struct TextureSource
{
    std::int64_t count = 0;
    std::function<std::shared_ptr<const Image>(std::int64_t)> read;
};

/// Keeps forward warps that were computed, such as in files, so that work goes on where it was cancelled.
/// Called from any thread. Warps depend on the textures, on UsedTexels and on AlignmentOptions, which are the
/// caller's to tell apart.
class FlowCache
{
public:
    /// What a warp belongs to.
    struct Key
    {
        std::int64_t texture = 0;
        std::int64_t reference = 0;
        FlowMethod method = FlowMethod::TvL1;
    };
    virtual ~FlowCache() = default;
    /// x, y at the nodes of the grid; none where it was not put. What has another size is computed again.
    virtual std::optional<std::vector<float>> get(const Key& key) const = 0;
    virtual void put(const Key& key, std::span<const float> warp) = 0;
};

struct AlignmentOptions
{
    FlowOptions flow;
    /// While the reference is looked for.
    FlowOptions search{.method = FlowMethod::Dis};
    int spacing = 4;                       ///< between nodes of warps, texels
    int rounds = 5;                        ///< at most, of looking for the reference
    std::optional<std::int64_t> reference; ///< known: not looked for
    /// Where scratch files lie: 3 bytes per texel, and 16 per node, of each texture. Empty: the system's
    /// folder.
    std::filesystem::path scratchFolder;
};

/// What aligning did to a texture; over covered texels.
struct AlignmentFigures
{
    double displacement = 0; ///< mean length of the forward warp, texels
    double before = 0;       ///< root mean square difference from the reference, grey levels of a channel
    double after = 0;        ///< the same of the aligned texture
};

/// Textures aligned to one of them. Forward warps f: aligned(x) = texture(x + f(x)); backward warps w:
/// texture(x) = aligned(x + w(x)).
class TextureAlignment
{
public:
    TextureAlignment(WarpGrid grid, std::int64_t textures, std::int64_t texels,
                     const std::filesystem::path& scratch);
    ~TextureAlignment();

    std::int64_t reference = 0;
    int rounds = 0; ///< that it took to find the reference
    std::vector<AlignmentFigures> figures;

    const WarpGrid& grid() const { return m_grid; }
    std::int64_t count() const { return m_count; }
    /// x, y at each node, texels.
    std::vector<float> forward(std::int64_t texture) const;
    std::vector<float> backward(std::int64_t texture) const;
    /// R, G, B of each used texel.
    std::vector<std::uint8_t> aligned(std::int64_t texture) const;
    /// Aligned textures, and backward warps, for principalComponents. They read from this object.
    SampleSet alignedSamples() const;
    SampleSet backwardSamples() const;

    void setForward(std::int64_t texture, std::span<const std::byte> warp);
    void setBackward(std::int64_t texture, std::span<const std::byte> warp);
    void setAligned(std::int64_t texture, std::span<const std::byte> colours);

private:
    std::uint64_t warpBytes() const { return static_cast<std::uint64_t>(m_grid.nodes()) * 2 * sizeof(float); }

    WarpGrid m_grid;
    std::int64_t m_count;
    std::uint64_t m_colours; ///< bytes of a texture
    std::unique_ptr<ScratchRows> m_rows;
};

/// Finds the reference by iterated medoid shift (SMCAS §5.1): it begins with the texture nearest to their
/// mean, aligns all to it, and goes on with the medoid of the aligned, until that was tried. Distances are
/// squares, of which the medoid is the texture nearest to the mean. Then all are aligned to it. Backward
/// warps invert the forward ones.
///
/// \param cache  none: nothing is kept.
/// \throws Error BadArgument where there is no texture, sizes differ from those of the atlas or options make
/// no sense; Cancelled, WriteFailed (scratch), and what the source throws. Cost: O(count · rounds) flows;
/// memory: some textures for each thread, the rest lies in scratch files.
std::shared_ptr<TextureAlignment> alignTextures(const TextureSource& textures, const ChartLookup& charts,
                                                const AlignmentOptions& options = {},
                                                FlowCache* cache = nullptr, const Progress& progress = {},
                                                const Executor& executor = localExecutor());

/// The same without warps: textures as they are, all warps zero, the one nearest to the mean as reference.
/// \throws as alignTextures.
std::shared_ptr<TextureAlignment> gatherTextures(const TextureSource& textures, const ChartLookup& charts,
                                                 const AlignmentOptions& options = {},
                                                 const Progress& progress = {},
                                                 const Executor& executor = localExecutor());

/// What a space of warps keeps of the warp of a sample: x, y per node.
std::vector<float> keptWarp(const LinearSpace& warps, std::int64_t sample);

/// Aligns textures anew by what a space of warps keeps of their backward warps, so that what it leaves out is
/// not lost, but stands in the aligned textures: de-aligned by the kept warp, they give the textures, but for
/// what bilinear look-ups blur, which is put back as far as a few iterations do it (back-projection, Irani &
/// Peleg 1991).
/// \param alignment  whose aligned textures are replaced. \param warps  fitted to its backward warps.
/// \throws Error Cancelled, WriteFailed (scratch), and what the source throws.
void realignTextures(const TextureSource& textures, const ChartLookup& charts, const LinearSpace& warps,
                     TextureAlignment& alignment, const Progress& progress = {},
                     const Executor& executor = localExecutor());

} // namespace quadrille
