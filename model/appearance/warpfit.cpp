// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/warpfit.h"

#include "model/appearance/projection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace quadrille {

namespace {

double meanAt(const Image& image, std::size_t place)
{
    const std::uint8_t* pixel = image.pixels.data() + 4 * place;
    return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

} // namespace

WarpFit::WarpFit(const AppearanceDecoder& decoder, const Image& texture, std::span<const std::uint8_t> known,
                 double unexplained)
    : m_model(decoder.model()), m_texture(texture)
{
    const UsedTexels& used = m_model.texels;
    const auto width = static_cast<std::uint32_t>(used.width);
    std::vector<std::uint16_t> charts(texture.pixels.size() / 4);
    for (std::size_t t = 0; t < used.texels.size(); ++t)
        charts[used.texels[t]] = static_cast<std::uint16_t>(used.charts[t] + 1);
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        const std::uint32_t place = used.texels[t];
        const auto x = static_cast<int>(place % width);
        const auto y = static_cast<int>(place / width);
        if (used.covered[t] == 0 || known[place] == 0 || x == 0 || y == 0 || x + 1 == used.width ||
            y + 1 == used.height)
            continue;
        const std::array<std::size_t, 4> beside{place - 1, place + 1, place - width, place + width};
        if (std::ranges::all_of(beside, [&](std::size_t other) { return charts[other] == charts[place]; }))
            m_texels.push_back({place, x, y});
    }
    const QuantisedSpace& warps = m_model.warps;
    m_prior = unexplained * priorPrecisions(warps);
    m_warps.resize(2, warps.size / 2 * warps.count);
    for (std::int64_t node = 0; node < warps.size / 2; ++node) {
        for (std::int64_t c = 0; c < warps.count; ++c)
            m_warps.col(node * warps.count + c) << warps.component(c, 2 * node),
                warps.component(c, 2 * node + 1);
    }
}

double WarpFit::costOf(const Image& decoded, const std::vector<float>& warps) const
{
    double cost = 0;
    for (const Texel& texel : m_texels) {
        const double difference = meanAt(m_texture, texel.place) - meanAt(decoded, texel.place);
        cost += difference * difference;
    }
    const Eigen::Map<const Eigen::VectorXf> coefficients(warps.data(),
                                                         static_cast<Eigen::Index>(warps.size()));
    return cost + coefficients.cast<double>().cwiseAbs2().dot(m_prior);
}

void WarpFit::warpsAt(const Texel& texel, Eigen::Ref<Eigen::Matrix2Xd> warps) const
{
    const WarpGrid& grid = m_model.grid;
    const int i = std::min(texel.x / grid.spacing, grid.width - 1);
    const int j = std::min(texel.y / grid.spacing, grid.height - 1);
    const double u = static_cast<double>(texel.x - i * grid.spacing) / grid.spacing;
    const double v = static_cast<double>(texel.y - j * grid.spacing) / grid.spacing;
    warps.setZero();
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = corner % 2 != 0;
        const bool below = corner / 2 != 0;
        const double weight = (right ? u : 1 - u) * (below ? v : 1 - v);
        const Eigen::Index node = Eigen::Index{std::min(j + (below ? 1 : 0), grid.height - 1)} * grid.width +
                                  std::min(i + (right ? 1 : 0), grid.width - 1);
        warps += weight * m_warps.middleCols(node * warps.cols(), warps.cols()).cast<double>();
    }
}

Eigen::VectorXd WarpFit::step(const Image& decoded, const std::vector<float>& warps,
                              const Progress& progress) const
{
    const Eigen::Index count = m_model.warps.count;
    const auto width = static_cast<std::size_t>(decoded.width);
    Eigen::MatrixXd products = m_prior.asDiagonal();
    const Eigen::Map<const Eigen::VectorXf> coefficients(warps.data(),
                                                         static_cast<Eigen::Index>(warps.size()));
    Eigen::VectorXd slopes = -m_prior.cwiseProduct(coefficients.cast<double>());
    constexpr std::size_t atOnce = 512; // texels
    Eigen::MatrixXd changes(count, atOnce);
    Eigen::VectorXd differences(atOnce);
    Eigen::Matrix2Xd moves(2, count);
    for (std::size_t first = 0; first < m_texels.size(); first += atOnce) {
        progress.report(static_cast<std::int64_t>(first), static_cast<std::int64_t>(m_texels.size()));
        const std::size_t some = std::min(atOnce, m_texels.size() - first);
        for (std::size_t t = 0; t < some; ++t) {
            const Texel& texel = m_texels[first + t];
            const std::size_t place = texel.place;
            const Eigen::RowVector2d gradient(
                (meanAt(decoded, place + 1) - meanAt(decoded, place - 1)) / 2,
                (meanAt(decoded, place + width) - meanAt(decoded, place - width)) / 2);
            const auto at = static_cast<Eigen::Index>(t);
            warpsAt(texel, moves);
            changes.col(at) = (gradient * moves).transpose();
            differences[at] = meanAt(m_texture, place) - meanAt(decoded, place);
        }
        const auto used = changes.leftCols(static_cast<Eigen::Index>(some));
        products.selfadjointView<Eigen::Lower>().rankUpdate(used);
        slopes += used * differences.head(static_cast<Eigen::Index>(some));
    }
    progress.report(1);
    return products.selfadjointView<Eigen::Lower>().ldlt().solve(slopes);
}

} // namespace quadrille
