// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/linearspace.h"
#include "model/core/progress.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tbb/cache_aligned_allocator.h>
#include <vector>

namespace quadrille {

/// A LinearSpace whose components take one byte a value. Values are held in blocks of some hundred, each
/// component with a scale of its own in each block: details stand in few places, and one scale for a whole
/// component adds 4.5 times the error (0.28 instead of 0.06 grey levels with 50 components of real textures).
/// Blocks are complete: what is missing in the last one is zero.
struct QuantisedSpace
{
    static constexpr std::int64_t blockSize = 1536; ///< values of a block

    std::int64_t size = 0;          ///< n, values of a sample
    std::int64_t count = 0;         ///< k, components
    float meanStep = 0;             ///< what one step of the mean is worth, in the unit of samples
    std::vector<std::int16_t> mean; ///< blocks × blockSize, in steps
    std::vector<float> scales;      ///< blocks × k: what one step of a component is worth there
    std::vector<std::int8_t, tbb::cache_aligned_allocator<std::int8_t>> steps; ///< blocks × k × blockSize
    std::vector<double> eigenvalues;  ///< of the covariance, as LinearSpace has them
    std::vector<double> coefficients; ///< samples × k, row-major

    std::int64_t blocks() const { return (size + blockSize - 1) / blockSize; }
    std::int64_t samples() const
    {
        return count == 0 ? 0 : static_cast<std::int64_t>(coefficients.size()) / count;
    }
    /// The steps of all components in one block, k × blockSize.
    const std::int8_t* block(std::int64_t index) const { return steps.data() + index * count * blockSize; }
    /// A value of a component.
    float component(std::int64_t index, std::int64_t value) const
    {
        const std::int64_t at = value / blockSize * count + index;
        return scales[static_cast<std::size_t>(at)] *
               static_cast<float>(steps[static_cast<std::size_t>(at * blockSize + value % blockSize)]);
    }
    bool operator==(const QuantisedSpace&) const = default;
};

/// Rounds a space to bytes. Cost: O(n · k).
QuantisedSpace quantised(const LinearSpace& space, const Progress& progress = {});

/// Writes mean + Σ coefficient · component for one block. Fewer coefficients than components: the others are
/// zero.
/// \param values  blockSize of them. \pre coefficients.size() ≤ k.
void combineBlock(const QuantisedSpace& space, std::int64_t block, std::span<const float> coefficients,
                  std::span<float> values);

/// All n values of mean + Σ coefficient · component. \pre coefficients.size() ≤ k.
std::vector<float> combined(const QuantisedSpace& space, std::span<const float> coefficients);
/// The same in place of other values.
void combine(const QuantisedSpace& space, std::span<const float> coefficients, std::vector<float>& values);

/// The products of all components with each other, k × k, exact but for the roundings of double precision.
/// \param known  per value, 1 where it counts and 0 elsewhere; empty: all count. Cost: O(n · k²).
Eigen::MatrixXd componentProducts(const QuantisedSpace& space, std::span<const std::uint8_t> known = {},
                                  const Progress& progress = {});

/// The products of all components with sample − mean, k values.
/// \param sample  n values. \param known  as above.
Eigen::VectorXd sampleProducts(const QuantisedSpace& space, std::span<const float> sample,
                               std::span<const std::uint8_t> known = {});

} // namespace quadrille
