// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/completion.h"

#include "model/appearance/chartlookup.h"
#include "model/appearance/projection.h"
#include "model/appearance/warpfit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Everything that finding the coefficients of one texture needs.
class Completion
{
public:
    Completion(const AppearanceDecoder& decoder, const Image& texture, std::span<const std::uint8_t> known,
               const CompletionOptions& options)
        : m_decoder(decoder)
        , m_model(decoder.model())
        , m_texture(texture)
        , m_known(known)
        , m_options(options)
        , m_lookup(m_model.texels)
        , m_mask(texture.width, texture.height)
        , m_unexplained(unexplainedVariance(m_model.textures, options.noise))
        , m_fit(decoder, texture, known, m_unexplained)
    {
        for (std::size_t i = 0; i < known.size(); ++i)
            std::fill_n(m_mask.pixels.data() + 4 * i, 4, known[i] != 0 ? std::uint8_t{255} : std::uint8_t{0});
        m_coefficients.warps.resize(static_cast<std::size_t>(m_model.warps.count));
    }

    AppearanceCoefficients find(const Progress& progress)
    {
        if (m_options.estimate && m_model.warps.count > 0)
            estimateWarp();
        double cost = fitTexture();
        for (int round = 0; round < m_options.rounds && m_model.warps.count > 0; ++round) {
            const Progress part = progress.part(static_cast<double>(round) / m_options.rounds,
                                                (round + 1.0) / m_options.rounds);
            const AppearanceCoefficients before = m_coefficients;
            if (!moveWarp(part, cost))
                break;
            const double now = fitTexture();
            constexpr double leastGain = 1e-3;
            if (now > cost) {
                m_coefficients = before;
                break;
            }
            if (cost - now < leastGain * cost)
                break;
            cost = now;
        }
        progress.report(1);
        return m_coefficients;
    }

private:
    void estimateWarp()
    {
        const std::vector<float> warp = m_options.estimate(m_texture, m_decoder.decodeAligned({}), m_known);
        const WarpGrid& grid = m_model.grid;
        std::vector<std::uint8_t> isKnown(static_cast<std::size_t>(m_model.warps.size));
        for (const std::uint32_t texel : m_model.texels.texels) {
            const int x = static_cast<int>(texel) % m_texture.width;
            const int y = static_cast<int>(texel) / m_texture.width;
            if (m_known[texel] == 0 || x % grid.spacing != 0 || y % grid.spacing != 0)
                continue;
            const auto node =
                static_cast<std::size_t>(y / grid.spacing) * static_cast<std::size_t>(grid.width) +
                static_cast<std::size_t>(x / grid.spacing);
            isKnown[2 * node] = isKnown[2 * node + 1] = 1;
        }
        const Eigen::VectorXf found =
            likeliestCoefficients(m_model.warps, warp, isKnown,
                                  unexplainedVariance(m_model.warps, m_options.warpNoise))
                .cast<float>();
        m_coefficients.warps.assign(found.begin(), found.end());
    }

    /// Finds the aligned texture while the warp stays. \return the cost that is left.
    double fitTexture()
    {
        const std::vector<Vec2f> field =
            m_model.warps.size == 0
                ? std::vector<Vec2f>(m_model.texels.texels.size(), Vec2f::Zero())
                : m_lookup.inverse(combined(m_model.warps, m_coefficients.warps), m_model.grid);
        const std::vector<std::uint8_t> colours = m_lookup.colours(m_texture, field);
        std::vector<std::uint8_t> isKnown = m_lookup.colours(m_mask, field);
        for (std::uint8_t& value : isKnown)
            value = value == 255 ? 1 : 0; // all of the texels that it lies between
        const Eigen::VectorXf found =
            likeliestCoefficients(m_model.textures, std::vector<float>(colours.begin(), colours.end()),
                                  isKnown, m_unexplained)
                .cast<float>();
        m_coefficients.textures.assign(found.begin(), found.end());
        m_decoder.decode(m_coefficients, m_scratch, m_decoded);
        return m_fit.costOf(m_decoded, m_coefficients.warps);
    }

    /// Moves the warp while the aligned texture stays, by less where the whole step makes it worse.
    /// \return false where no step makes it better.
    bool moveWarp(const Progress& progress, double cost)
    {
        const Eigen::VectorXf step = m_fit.step(m_decoded, m_coefficients.warps, progress).cast<float>();
        const std::vector<float> before = m_coefficients.warps;
        for (float share : {1.0F, 0.5F, 0.25F, 0.125F}) {
            for (std::size_t c = 0; c < before.size(); ++c)
                m_coefficients.warps[c] = before[c] + share * step[static_cast<Eigen::Index>(c)];
            m_decoder.decode(m_coefficients, m_scratch, m_decoded);
            if (m_fit.costOf(m_decoded, m_coefficients.warps) < cost)
                return true;
        }
        m_coefficients.warps = before;
        return false;
    }

    const AppearanceDecoder& m_decoder;
    const AppearanceModel& m_model;
    const Image& m_texture;
    std::span<const std::uint8_t> m_known;
    const CompletionOptions& m_options;
    ChartLookup m_lookup;
    Image m_mask; ///< white where the texture is known
    double m_unexplained;
    WarpFit m_fit;
    AppearanceCoefficients m_coefficients;
    DecodeScratch m_scratch;
    Image m_decoded; ///< with the coefficients as they are
};

/// Puts texels that are known over those of the model, and spreads their differences over what is next to
/// them in the same chart.
class Blend
{
public:
    Blend(const UsedTexels& used, const Image& texture, std::span<const std::uint8_t> known, int reach)
        : m_texture(texture), m_known(known), m_reach(reach), m_charts(known.size())
    {
        for (std::size_t t = 0; t < used.texels.size(); ++t)
            m_charts[used.texels[t]] = static_cast<std::uint16_t>(used.charts[t] + 1);
    }

    void apply(Image& completed) const
    {
        const Image model = completed;
        for (int y = 0; y < completed.height; ++y) {
            for (int x = 0; x < completed.width; ++x) {
                if (m_known[placeOf(x, y)] != 0)
                    std::copy_n(m_texture.pixel(x, y), 4, completed.pixel(x, y));
                else if (m_charts[placeOf(x, y)] != 0)
                    spread(model, x, y, completed.pixel(x, y));
            }
        }
    }

private:
    std::size_t placeOf(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_texture.width) +
               static_cast<std::size_t>(x);
    }

    /// Adds the mean difference of known texels around, the more the nearer they are.
    void spread(const Image& model, int x, int y, std::uint8_t* colour) const
    {
        Vec3d sum = Vec3d::Zero();
        double weights = 0;
        double nearest = m_reach;
        for (int v = std::max(0, y - m_reach); v <= std::min(model.height - 1, y + m_reach); ++v) {
            for (int u = std::max(0, x - m_reach); u <= std::min(model.width - 1, x + m_reach); ++u) {
                if (m_known[placeOf(u, v)] == 0 || m_charts[placeOf(u, v)] != m_charts[placeOf(x, y)])
                    continue;
                const double distance = std::hypot(u - x, v - y);
                const double weight = std::max(0.0, m_reach - distance) / (distance * distance);
                for (int c = 0; c < 3; ++c)
                    sum[c] += weight * (m_texture.pixel(u, v)[c] - model.pixel(u, v)[c]);
                weights += weight;
                nearest = std::min(nearest, distance);
            }
        }
        if (weights <= 0)
            return;
        const double share = 1 - (nearest - 1) / (m_reach - 1);
        for (int c = 0; c < 3; ++c)
            colour[c] = static_cast<std::uint8_t>(
                std::clamp(std::lround(colour[c] + share * sum[c] / weights), 0L, 255L));
    }

    const Image& m_texture;
    std::span<const std::uint8_t> m_known;
    int m_reach;
    std::vector<std::uint16_t> m_charts; ///< per texel of the atlas, from 1 on; 0: not used
};

} // namespace

CompletedTexture completeTexture(const AppearanceDecoder& decoder, const Image& texture,
                                 std::span<const std::uint8_t> known, const CompletionOptions& options,
                                 const Progress& progress)
{
    const UsedTexels& used = decoder.model().texels;
    assert(texture.width == used.width && texture.height == used.height);
    assert(4 * known.size() == texture.pixels.size());
    CompletedTexture result;
    result.coefficients = Completion(decoder, texture, known, options).find(progress);
    result.texture = decoder.decode(result.coefficients);
    Blend(used, texture, known, std::max(2, options.blend)).apply(result.texture);
    return result;
}

} // namespace quadrille
