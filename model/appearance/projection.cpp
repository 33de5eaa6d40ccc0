// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/projection.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace quadrille {

namespace {

std::vector<float> inSinglePrecision(const Eigen::VectorXd& values)
{
    const Eigen::VectorXf rounded = values.cast<float>();
    return {rounded.begin(), rounded.end()};
}

} // namespace

SpaceProjection::SpaceProjection(const QuantisedSpace& space, const Progress& progress)
    : m_space(space), m_products(componentProducts(space, {}, progress))
{
}

Eigen::VectorXd SpaceProjection::project(std::span<const float> sample) const
{
    if (m_space.count == 0)
        return {};
    return m_products.solve(sampleProducts(m_space, sample));
}

double unexplainedVariance(const QuantisedSpace& space, double deviation)
{
    const auto first = std::min(space.eigenvalues.size(), static_cast<std::size_t>(space.count));
    const auto leftOut = std::span(space.eigenvalues).subspan(first);
    return deviation * deviation + std::accumulate(leftOut.begin(), leftOut.end(), 0.0) /
                                       static_cast<double>(std::max<std::int64_t>(space.size, 1));
}

Eigen::VectorXd priorPrecisions(const QuantisedSpace& space)
{
    assert(static_cast<std::int64_t>(space.eigenvalues.size()) >= space.count);
    constexpr double least = 1e-12; // of a component that does not vary
    const Eigen::Map<const Eigen::VectorXd> variances(space.eigenvalues.data(), space.count);
    return variances.cwiseMax(least).cwiseInverse();
}

Eigen::VectorXd likeliestCoefficients(const QuantisedSpace& space, std::span<const float> sample,
                                      std::span<const std::uint8_t> known, double unexplained)
{
    if (space.count == 0)
        return {};
    Eigen::MatrixXd products = componentProducts(space, known);
    products.diagonal() += unexplained * priorPrecisions(space);
    return products.ldlt().solve(sampleProducts(space, sample, known));
}

AppearanceCoefficients project(const AppearanceModel& model, std::span<const float> texture,
                               std::span<const float> warp, const Progress& progress)
{
    const SpaceProjection textures(model.textures, progress.part(0, 0.9));
    const SpaceProjection warps(model.warps, progress.part(0.9, 1));
    return {inSinglePrecision(textures.project(texture)), inSinglePrecision(warps.project(warp))};
}

} // namespace quadrille
