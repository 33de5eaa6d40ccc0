// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace quadrille {

/// An affine space fitted to samples by principal components: sample ≈ mean + coefficientsᵀ · components.
struct LinearSpace
{
    std::vector<float> mean;       ///< n values
    std::vector<float> components; ///< k × n, orthonormal rows, largest variance first
    std::vector<double>
        eigenvalues; ///< of the covariance, all that are not zero (may be more than k), descending
    std::vector<double> coefficients; ///< samples × k, row-major

    std::int64_t size() const { return static_cast<std::int64_t>(mean.size()); } ///< n
    std::int64_t count() const                                                   ///< k
    {
        return mean.empty() ? 0 : static_cast<std::int64_t>(components.size() / mean.size());
    }
    std::int64_t samples() const
    {
        return count() == 0 ? 0 : static_cast<std::int64_t>(coefficients.size()) / count();
    }
    bool operator==(const LinearSpace&) const = default;
};

} // namespace quadrille
