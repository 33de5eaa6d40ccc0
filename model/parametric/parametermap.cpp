// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/parameters.h"

#include <algorithm>

namespace quadrille {

SpacePoint ParameterMap::placeOf(const SpacePoint& parameters) const
{
    SpacePoint scaled{};
    SpacePoint place{};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        scaled[d] = (std::clamp(parameters[d], least[d], greatest[d]) - least[d]) / (greatest[d] - least[d]);
    for (Eigen::Index d = 0; d < dimension; ++d) {
        // The same sum as by monomials(), without memory of its own.
        const auto row = coefficients.row(d);
        double value = row[0];
        Eigen::Index next = 1;
        for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
            value += row[next++] * scaled[i];
        for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
            for (std::size_t j = i; j < static_cast<std::size_t>(dimension); ++j)
                value += row[next++] * scaled[i] * scaled[j];
        }
        place[static_cast<std::size_t>(d)] = value;
    }
    return place;
}

} // namespace quadrille
