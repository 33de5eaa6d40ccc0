// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/pca.h"
#include "model/appearance/scratchrows.h"

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <vector>

namespace quadrille {

/// The principal components of samples as weights of the samples themselves (Sirovich 1987): nothing as large
/// as a sample is held, and spaces of any number of components, or of some of the samples, cost no second
/// look at them.
class SnapshotSpace
{
public:
    /// \param products  of all pairs of samples as seen from their mean, n × n; see centredProducts.
    /// Cost: O(n³).
    explicit SnapshotSpace(Eigen::MatrixXd products);

    /// As many as do not vary in vain: at most n − 1.
    std::int64_t components() const { return m_vectors.cols(); }
    /// n × n: a column for each sample, the weights that give its nearest point in the space of the first
    /// components. Fewer where there are no more.
    Eigen::MatrixXd reconstructions(std::int64_t count) const;
    /// n × others: a column for each of the others, the weights that give its nearest point in the space of
    /// all components of the training samples. \pre There is a training sample. Cost: O(training³).
    Eigen::MatrixXd projections(std::span<const std::int64_t> training,
                                std::span<const std::int64_t> others) const;

private:
    Eigen::MatrixXd m_products;
    Eigen::MatrixXd m_vectors; ///< n × components, largest variance first
};

/// Combinations of textures as colours, in a scratch file.
class CombinedTextures
{
public:
    /// \param textures  R, G, B of each used texel. \param weights  textures × combinations, of textures as
    /// seen from their mean, which is added. \param folder  where the scratch file lies.
    /// \throws Error Cancelled, WriteFailed, and what reading the textures throws.
    CombinedTextures(const SampleSet& textures, const Eigen::MatrixXd& weights,
                     const std::filesystem::path& folder, const Progress& progress,
                     const Executor& executor = localExecutor());

    /// Rounded to whole grey levels. \throws Error ReadFailed.
    std::vector<std::uint8_t> colours(std::int64_t combination) const;

private:
    ScratchRows m_rows;
};

} // namespace quadrille
