// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decode.h"

#include <Eigen/Core>

namespace quadrille {

/// Fits warps of a model's space to what is known of a texture, one step of Gauss and Newton at a time: how
/// the decoded texture changes with each Eigen warp is told by its own slopes. What looks like Lucas & Kanade
/// with as many unknowns as there are Eigen warps.
class WarpFit
{
public:
    /// \param texture,known  as completeTexture has them. All stay where they are for as long as this lives.
    /// \param unexplained  variance of a texel, grey levels².
    WarpFit(const AppearanceDecoder& decoder, const Image& texture, std::span<const std::uint8_t> known,
            double unexplained);

    /// What is made small: squares of differences over known texels, mean of R, G and B, and of coefficients
    /// of warps as far as they are unlikely.
    double costOf(const Image& decoded, const std::vector<float>& warps) const;

    /// By how much the coefficients of warps should change.
    /// \param decoded  the texture with the coefficients as they are.
    /// \throws Error Cancelled. Cost: O(known texels · Eigen warps²).
    Eigen::VectorXd step(const Image& decoded, const std::vector<float>& warps,
                         const Progress& progress) const;

private:
    /// A known and covered texel with four neighbours of its chart.
    struct Texel
    {
        std::size_t place = 0;
        int x = 0;
        int y = 0;
    };

    /// By how much each Eigen warp moves a texel.
    void warpsAt(const Texel& texel, Eigen::Ref<Eigen::Matrix2Xd> warps) const;

    const AppearanceModel& m_model;
    const Image& m_texture;
    std::vector<Texel> m_texels;
    Eigen::VectorXd m_prior;  ///< what squares of coefficients count
    Eigen::Matrix2Xf m_warps; ///< of each node all Eigen warps: 2 × (nodes · Eigen warps)
};

} // namespace quadrille
