// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/pca.h"

#include "model/appearance/pcakernels.h"
#include "model/core/badargument.h"
#include "model/core/symmetriceigen.h"

#include <algorithm>
#include <cstring>
#include <tbb/cache_aligned_allocator.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr std::int64_t wave = 8; ///< blocks whose sums are kept at a time, to be added in their order

std::size_t filledUp(std::int64_t size, std::size_t unit)
{
    return (static_cast<std::size_t>(size) + unit - 1) / unit * unit;
}

/// How the values of samples are cut: into blocks of about so many bytes.
struct Blocks
{
    std::int64_t length = 0;
    std::int64_t count = 0;

    Blocks(const SampleSet& samples, std::int64_t bytes)
    {
        const auto depth = static_cast<std::int64_t>(pcaDepth);
        const auto values = bytes / static_cast<std::int64_t>(sizeof(float));
        length = std::clamp(values / samples.count / depth * depth, depth, 128 * depth);
        count = (samples.size + length - 1) / length;
    }
};

constexpr std::int64_t bytesOfSums = 16 << 20;        ///< a thread's share of memory
constexpr std::int64_t bytesOfCombinations = 1 << 20; ///< a core's cache: each component reads all of a block

/// Some values of all samples, a row for each sample, with zeros in columns that fill up; rows that fill up
/// hold anything. Threads read one block after the other into the same memory.
struct Block
{
    std::int64_t first = 0;
    std::size_t values = 0;
    std::size_t depth = 0;
    std::size_t stride = 0;
    bool isWhole = true;
    std::vector<double> mean;
    std::vector<float, tbb::cache_aligned_allocator<float>> rows;

    float* row(std::int64_t sample) { return rows.data() + static_cast<std::size_t>(sample) * stride; }
};

using ThreadBlocks = tbb::enumerable_thread_specific<Block>;

void readBlock(Block& block, const SampleSet& samples, const Blocks& blocks, std::int64_t index,
               const Progress& progress)
{
    block.first = index * blocks.length;
    block.values = static_cast<std::size_t>(std::min(blocks.length, samples.size - block.first));
    block.depth = filledUp(static_cast<std::int64_t>(block.values), pcaDepth);
    block.stride = block.depth + 16; // no power of two, as rows would then meet in the cache
    block.rows.resize(filledUp(samples.count, pcaRows) * block.stride);
    block.isWhole = true;
    block.mean.assign(block.values, 0);
    for (std::int64_t s = 0; s < samples.count; ++s) {
        const std::span row(block.row(s), block.values);
        samples.read(s, block.first, row);
        std::fill(block.row(s) + block.values, block.row(s + 1), 0.0F);
        block.isWhole = addRow(row.data(), row.size(), block.mean.data()) && block.isWhole;
        progress.report(s, samples.count);
    }
    for (double& mean : block.mean)
        mean /= static_cast<double>(samples.count);
}

/// Takes a value from all of each column.
template <typename Offset>
void subtract(Block& block, std::int64_t samples, const Offset& offsetOf)
{
    std::vector<float> offsets(block.mean.size());
    std::transform(block.mean.begin(), block.mean.end(), offsets.begin(), offsetOf);
    for (std::int64_t s = 0; s < samples; ++s) {
        float* row = block.row(s);
        for (std::size_t k = 0; k < offsets.size(); ++k)
            row[k] -= offsets[k];
    }
}

/// Products of all pairs of samples in a block, below and on the diagonal, four rows after the other. They
/// are taken from a place near the mean, a whole number where the values are.
std::vector<double> productsIn(Block& block, const SampleSet& samples, const Blocks& blocks,
                               std::int64_t index, const Progress& progress)
{
    readBlock(block, samples, blocks, index, progress.part(0, 0.5));
    subtract(block, samples.count,
             [&](double mean) { return static_cast<float>(block.isWhole ? std::round(mean) : mean); });
    const std::size_t rows = filledUp(samples.count, pcaRows);
    std::vector<double> products(rows * (rows + pcaRows) / 2);
    std::size_t place = 0;
    for (std::size_t first = 0; first < rows; first += pcaRows) {
        addRowProducts(block.rows.data(), block.stride, block.depth, first, block.isWhole,
                       products.data() + place);
        place += pcaRows * (first + pcaRows);
        progress.part(0.5, 1).report(static_cast<std::int64_t>(place),
                                     static_cast<std::int64_t>(products.size()));
    }
    return products;
}

/// Means of a block, then its part of each combination.
TaskSet::Result combinationsIn(Block& block, const SampleSet& samples, const Blocks& blocks,
                               std::int64_t index, const Eigen::MatrixXd& weights, const Progress& progress)
{
    readBlock(block, samples, blocks, index, progress.part(0, 0.5));
    subtract(block, samples.count, [](double mean) { return static_cast<float>(mean); });
    const Eigen::Index count = weights.cols();
    const std::size_t bytes = block.values * sizeof(float);
    TaskSet::Result result((static_cast<std::size_t>(count) + 1) * bytes);
    const std::vector<float> mean(block.mean.begin(), block.mean.end());
    std::memcpy(result.data(), mean.data(), bytes);
    std::vector<double> four(static_cast<std::size_t>(samples.count) * pcaRows);
    std::vector<float> sums(pcaRows * block.stride);
    for (Eigen::Index first = 0; first < count; first += pcaRows) {
        const Eigen::Index some = std::min<Eigen::Index>(pcaRows, count - first);
        std::fill(four.begin(), four.end(), 0.0);
        for (Eigen::Index s = 0; s < weights.rows(); ++s)
            for (Eigen::Index c = 0; c < some; ++c)
                four[static_cast<std::size_t>(s) * pcaRows + static_cast<std::size_t>(c)] =
                    weights(s, first + c);
        combineRows(block.rows.data(), static_cast<std::size_t>(samples.count), block.stride, block.depth,
                    four.data(), sums.data());
        for (Eigen::Index c = 0; c < some; ++c)
            std::memcpy(result.data() + static_cast<std::size_t>(first + c + 1) * bytes,
                        sums.data() + static_cast<std::size_t>(c) * block.stride, bytes);
        progress.part(0.5, 1).report(first, count);
    }
    return result;
}

/// Turns components whose largest absolute entry is negative.
void turn(LinearSpace& space, std::int64_t samples, std::int64_t count)
{
    tbb::parallel_for(std::int64_t{0}, count, [&](std::int64_t c) {
        const std::span component(space.components.data() + c * space.size(),
                                  static_cast<std::size_t>(space.size()));
        if (!turnRow(component.data(), component.size()))
            return;
        for (std::int64_t s = 0; s < samples; ++s) {
            double& coefficient = space.coefficients[static_cast<std::size_t>(s * count + c)];
            coefficient = -coefficient;
        }
    });
}

void refuseNothing(const SampleSet& samples)
{
    if (samples.count <= 0 || samples.size <= 0)
        refuse("Principal components need at least one sample with values", "Give samples.");
}

} // namespace

Eigen::MatrixXd centredProducts(const SampleSet& samples, const Progress& progress, const Executor& executor)
{
    refuseNothing(samples);
    const Blocks blocks(samples, bytesOfSums);
    ThreadBlocks own;
    const std::size_t rows = filledUp(samples.count, pcaRows);
    std::vector<double> sums(rows * (rows + pcaRows) / 2);
    for (std::int64_t begin = 0; begin < blocks.count; begin += wave) {
        const std::int64_t count = std::min(wave, blocks.count - begin);
        std::vector<std::vector<double>> parts(static_cast<std::size_t>(count));
        executor.run(makeTasks<double>(
                         count,
                         [&](std::int64_t task, const Progress& progressOfTask) {
                             return productsIn(own.local(), samples, blocks, begin + task, progressOfTask);
                         },
                         [&](std::int64_t task, std::span<const double> part) {
                             parts[static_cast<std::size_t>(task)].assign(part.begin(), part.end());
                         }),
                     progress.part(static_cast<double>(begin) / static_cast<double>(blocks.count),
                                   static_cast<double>(begin + count) / static_cast<double>(blocks.count)));
        for (const std::vector<double>& part : parts)
            std::transform(part.begin(), part.end(), sums.begin(), sums.begin(), std::plus());
    }
    Eigen::MatrixXd gram(samples.count, samples.count);
    std::size_t place = 0;
    for (std::int64_t row = 0; row < samples.count; ++row) {
        const std::size_t width = filledUp(row + 1, pcaRows);
        for (std::int64_t column = 0; column <= row; ++column)
            gram(row, column) = gram(column, row) = sums[place + static_cast<std::size_t>(column)];
        place += width;
    }
    const Eigen::VectorXd means = gram.rowwise().mean();
    const double mean = means.mean();
    gram.colwise() -= means;
    gram.rowwise() -= means.transpose();
    gram.array() += mean;
    return gram;
}

void combineSamples(const SampleSet& samples, const Eigen::MatrixXd& weights, const CombinedValues& store,
                    const Progress& progress, const Executor& executor)
{
    refuseNothing(samples);
    const Blocks blocks(samples, bytesOfCombinations);
    ThreadBlocks own;
    executor.run({.count = blocks.count,
                  .compute =
                      [&](std::int64_t task, const Progress& progressOfTask) {
                          return combinationsIn(own.local(), samples, blocks, task, weights, progressOfTask);
                      },
                  .store =
                      [&](std::int64_t task, std::span<const std::byte> result) {
                          const std::span values(reinterpret_cast<const float*>(result.data()),
                                                 result.size() / sizeof(float));
                          const std::size_t length =
                              values.size() / (static_cast<std::size_t>(weights.cols()) + 1);
                          store(task * blocks.length, values.first(length), values.subspan(length));
                      }},
                 progress);
}

LinearSpace principalComponents(const SampleSet& samples, std::int64_t components, const Progress& progress,
                                const Executor& executor)
{
    if (components < 0)
        refuse("There are no fewer components than none", "Ask for some.");
    const Eigen::MatrixXd gram = centredProducts(samples, progress.part(0, 0.6), executor);
    const SymmetricEigen solved = symmetricEigen(gram);
    const Eigen::VectorXd values = solved.values.reverse();
    LinearSpace space;
    constexpr double zero = 1e-10;
    for (Eigen::Index k = 0; k < values.size() && values[k] > std::max(0.0, zero * values[0]); ++k)
        space.eigenvalues.push_back(values[k] / static_cast<double>(samples.count));
    const std::int64_t count = std::min(components, static_cast<std::int64_t>(space.eigenvalues.size()));
    const Eigen::MatrixXd vectors = solved.vectors.rowwise().reverse().leftCols(count);
    const Eigen::VectorXd lengths = values.head(count).cwiseSqrt();
    const Eigen::MatrixXd weights = vectors * lengths.cwiseInverse().asDiagonal();
    space.mean.resize(static_cast<std::size_t>(samples.size));
    space.components.resize(static_cast<std::size_t>(count * samples.size));
    combineSamples(
        samples, weights,
        [&](std::int64_t first, std::span<const float> mean, std::span<const float> combinations) {
            std::ranges::copy(mean, space.mean.begin() + first);
            for (std::int64_t c = 0; c < count; ++c)
                std::copy_n(combinations.begin() + c * std::ssize(mean), std::ssize(mean),
                            space.components.begin() + c * samples.size + first);
        },
        progress.part(0.6, 1), executor);
    for (std::int64_t s = 0; s < samples.count; ++s)
        for (std::int64_t c = 0; c < count; ++c)
            space.coefficients.push_back(vectors(s, c) * lengths[c]);
    turn(space, samples.count, count);
    return space;
}

LinearSpace firstComponents(const LinearSpace& space, std::int64_t count)
{
    const auto kept = static_cast<std::ptrdiff_t>(std::min(count, space.count()));
    LinearSpace first{.mean = space.mean, .eigenvalues = space.eigenvalues};
    first.components.assign(space.components.begin(), space.components.begin() + kept * space.size());
    for (std::int64_t s = 0; s < space.samples(); ++s) {
        const auto row = space.coefficients.begin() + s * space.count();
        first.coefficients.insert(first.coefficients.end(), row, row + kept);
    }
    return first;
}

} // namespace quadrille
