// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/combinedtextures.h"

#include "model/core/symmetriceigen.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double vanishing = 1e-10; ///< of the largest eigenvalue: those below are taken for zero

/// Eigenvectors of products that are not zero, largest first.
Eigen::MatrixXd leadingVectors(const Eigen::MatrixXd& products, Eigen::VectorXd* values = nullptr)
{
    const SymmetricEigen solved = symmetricEigen(products);
    const Eigen::VectorXd all = solved.values.reverse();
    Eigen::Index count = 0;
    while (count < all.size() && all[count] > std::max(0.0, vanishing * all[0]))
        ++count;
    if (values != nullptr)
        *values = all.head(count);
    return solved.vectors.rowwise().reverse().leftCols(count);
}

} // namespace

SnapshotSpace::SnapshotSpace(Eigen::MatrixXd products)
    : m_products(std::move(products)), m_vectors(leadingVectors(m_products))
{
}

Eigen::MatrixXd SnapshotSpace::reconstructions(std::int64_t count) const
{
    const auto kept = m_vectors.leftCols(std::min<Eigen::Index>(count, m_vectors.cols()));
    return kept * kept.transpose();
}

Eigen::MatrixXd SnapshotSpace::projections(std::span<const std::int64_t> training,
                                           std::span<const std::int64_t> others) const
{
    const auto count = std::ssize(training);
    // Products of training samples with each other and with the others, as seen from the training's mean.
    Eigen::MatrixXd own(count, count);
    Eigen::MatrixXd across(count, std::ssize(others));
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            own(i, j) =
                m_products(training[static_cast<std::size_t>(i)], training[static_cast<std::size_t>(j)]);
        for (Eigen::Index j = 0; j < across.cols(); ++j)
            across(i, j) =
                m_products(training[static_cast<std::size_t>(i)], others[static_cast<std::size_t>(j)]);
    }
    const Eigen::VectorXd means = own.rowwise().mean();
    const Eigen::RowVectorXd acrossMeans = across.colwise().mean();
    own.colwise() -= means;
    own.rowwise() -= own.colwise().mean().eval();
    across.colwise() -= means;
    across.rowwise() -= acrossMeans - Eigen::RowVectorXd::Constant(across.cols(), means.mean());
    Eigen::VectorXd values;
    const Eigen::MatrixXd vectors = leadingVectors(own, &values);
    Eigen::MatrixXd shares = vectors * (values.cwiseInverse().asDiagonal() * (vectors.transpose() * across));
    // What is left of one is the mean's.
    shares.rowwise() += ((1 - shares.colwise().sum().array()) / static_cast<double>(count)).matrix().eval();
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(m_products.rows(), across.cols());
    for (Eigen::Index i = 0; i < count; ++i)
        weights.row(training[static_cast<std::size_t>(i)]) = shares.row(i);
    return weights;
}

CombinedTextures::CombinedTextures(const SampleSet& textures, const Eigen::MatrixXd& weights,
                                   const std::filesystem::path& folder, const Progress& progress,
                                   const Executor& executor)
    : m_rows(static_cast<std::uint64_t>(textures.size), folder)
{
    combineSamples(
        textures, weights,
        [&](std::int64_t first, std::span<const float> mean, std::span<const float> combinations) {
            std::vector<std::uint8_t> rounded(mean.size());
            for (Eigen::Index row = 0; row < weights.cols(); ++row) {
                const auto values =
                    combinations.subspan(static_cast<std::size_t>(row) * mean.size(), mean.size());
                std::ranges::transform(mean, values, rounded.begin(), [](float of, float offset) {
                    return static_cast<std::uint8_t>(std::lround(std::clamp(of + offset, 0.0F, 255.0F)));
                });
                m_rows.write(row, static_cast<std::uint64_t>(first), std::as_bytes(std::span(rounded)));
            }
        },
        progress, executor);
}

std::vector<std::uint8_t> CombinedTextures::colours(std::int64_t combination) const
{
    std::vector<std::uint8_t> colours(m_rows.rowBytes());
    m_rows.read(combination, 0, std::as_writable_bytes(std::span(colours)));
    return colours;
}

} // namespace quadrille
