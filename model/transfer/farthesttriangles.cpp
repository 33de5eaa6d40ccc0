// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/farthesttriangles.h"

#include <limits>

namespace quadrille {

std::vector<TriangleIndex> farthestTriangles(const TriangleRows& rows, const std::vector<bool>& isUsable,
                                             std::vector<TriangleIndex> chosen, std::size_t count)
{
    Eigen::VectorXf distances(rows.rows());
    for (Eigen::Index t = 0; t < rows.rows(); ++t)
        distances[t] = isUsable[static_cast<std::size_t>(t)] ? std::numeric_limits<float>::max() : -1;
    const auto take = [&](Eigen::Index t) {
        distances = distances.cwiseMin((rows.rowwise() - rows.row(t)).rowwise().squaredNorm());
    };
    for (const TriangleIndex t : chosen)
        take(static_cast<Eigen::Index>(t.value));
    Eigen::Index next = 0;
    while (chosen.size() < count && distances.maxCoeff(&next) > 0) {
        chosen.emplace_back(static_cast<std::size_t>(next));
        take(next);
    }
    return chosen;
}

} // namespace quadrille
