// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/linearspace.h"
#include "model/core/executor.h"

#include <Eigen/Core>
#include <functional>
#include <span>

namespace quadrille {

/// Samples of equal size that are read a stretch of values at a time: all of them together may not fit into
/// memory.
struct SampleSet
{
    std::int64_t count = 0; ///< samples
    std::int64_t size = 0;  ///< values of each
    /// Writes the values [first, first + values.size()) of a sample; called from any thread, for every value
    /// twice.
    std::function<void(std::int64_t sample, std::int64_t first, std::span<float> values)> read;
};

/// Products of all pairs of samples as seen from their mean, count × count: without error in whole numbers of
/// 0 … 255, in double precision otherwise. \throws Error BadArgument where there is no sample or no value,
/// Cancelled, and what `read` throws. Cost: O(count² · size).
Eigen::MatrixXd centredProducts(const SampleSet& samples, const Progress& progress = {},
                                const Executor& executor = localExecutor());

/// The values [first, first + length) of the mean of samples, and of their combinations, one after the other.
using CombinedValues =
    std::function<void(std::int64_t first, std::span<const float> mean, std::span<const float> combinations)>;

/// Combines samples as seen from their mean, a stretch of values at a time.
/// \param weights  samples × combinations. \param store  called from any thread, for each stretch once.
/// \throws as centredProducts. Cost: O(count · combinations · size).
void combineSamples(const SampleSet& samples, const Eigen::MatrixXd& weights, const CombinedValues& store,
                    const Progress& progress = {}, const Executor& executor = localExecutor());

/// The mean of samples and the directions in which they vary most.
///
/// The products of all pairs of samples are summed first, without error in whole numbers of 0 … 255 and in
/// double precision otherwise, then their eigenvectors are taken (Sirovich 1987, the “method of snapshots”).
/// Of each component the largest absolute entry is positive. Eigenvalues are of the covariance with divisor
/// `count`; those below 1e-10 of the largest are taken for zero.
///
/// \param components  how many are wanted, at most; there are no more than eigenvalues that are not zero.
/// \param progress,executor  the result does not depend on the number of threads.
/// \throws Error BadArgument where there is no sample or no value, Cancelled, and what `read` throws.
/// Cost: O(count² · size + count³); memory: the result, 64 · count² bytes and 16 MB for each thread.
LinearSpace principalComponents(const SampleSet& samples, std::int64_t components,
                                const Progress& progress = {}, const Executor& executor = localExecutor());

/// The space of the first components alone, or of all where there are no more. Eigenvalues stay.
LinearSpace firstComponents(const LinearSpace& space, std::int64_t count);

} // namespace quadrille
