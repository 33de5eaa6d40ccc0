// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/similarity.h"

namespace quadrille {

double dissimilarity(const SimilarityTable& table, std::size_t sourceFrame, const NodeWeights& source,
                     std::size_t targetFrame, const NodeWeights& target)
{
    const std::span<const float> block = table.block(sourceFrame, targetFrame);
    double sum = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(source.count); ++s) {
        const std::span<const float> row =
            block.subspan(static_cast<std::size_t>(source.nodes[s]) * table.targetNodes, table.targetNodes);
        double ofRow = 0;
        for (std::size_t t = 0; t < static_cast<std::size_t>(target.count); ++t)
            ofRow += target.weights[t] * static_cast<double>(row[static_cast<std::size_t>(target.nodes[t])]);
        sum += source.weights[s] * ofRow;
    }
    return sum * table.scale();
}

} // namespace quadrille
