// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/quantisedspace.h"

#include "model/appearance/blockkernels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr float mostSteps = std::numeric_limits<std::int8_t>::max();
constexpr float mostMeanSteps = std::numeric_limits<std::int16_t>::max();

float largestMagnitude(std::span<const float> values)
{
    float largest = 0;
    for (const float value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

/// Values in steps; all zero where a step is worth nothing. \return what one is worth.
template <typename Step>
float toSteps(std::span<const float> values, float worth, Step* steps)
{
    const float perStep = worth > 0 ? 1 / worth : 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        steps[i] = static_cast<Step>(std::nearbyint(values[i] * perStep));
    return worth;
}

/// The part of n values that lies in a block.
template <typename Value>
std::span<const Value> inBlock(std::span<const Value> values, std::int64_t block)
{
    const auto from = static_cast<std::size_t>(block * QuantisedSpace::blockSize);
    return values.subspan(from, std::min<std::size_t>(QuantisedSpace::blockSize, values.size() - from));
}

} // namespace

QuantisedSpace quantised(const LinearSpace& space, const Progress& progress)
{
    QuantisedSpace result;
    result.size = space.size();
    result.count = space.count();
    result.eigenvalues = space.eigenvalues;
    result.coefficients = space.coefficients;
    const std::int64_t blocks = result.blocks();
    result.mean.resize(static_cast<std::size_t>(blocks * QuantisedSpace::blockSize));
    result.meanStep =
        toSteps(std::span(space.mean), largestMagnitude(space.mean) / mostMeanSteps, result.mean.data());
    result.scales.resize(static_cast<std::size_t>(blocks * result.count));
    result.steps.resize(static_cast<std::size_t>(blocks * result.count * QuantisedSpace::blockSize));
    for (std::int64_t b = 0; b < blocks; ++b) {
        progress.report(b, blocks);
        for (std::int64_t c = 0; c < result.count; ++c) {
            const auto component = std::span(space.components)
                                       .subspan(static_cast<std::size_t>(c * result.size),
                                                static_cast<std::size_t>(result.size));
            const std::span<const float> values = inBlock<float>(component, b);
            const std::int64_t at = b * result.count + c;
            result.scales[static_cast<std::size_t>(at)] =
                toSteps(values, largestMagnitude(values) / mostSteps,
                        result.steps.data() + at * QuantisedSpace::blockSize);
        }
    }
    progress.report(1);
    return result;
}

void combineBlock(const QuantisedSpace& space, std::int64_t block, std::span<const float> coefficients,
                  std::span<float> values)
{
    assert(static_cast<std::int64_t>(coefficients.size()) <= space.count);
    assert(values.size() == QuantisedSpace::blockSize);
    combineSteps(space.mean.data() + block * QuantisedSpace::blockSize, space.meanStep, space.block(block),
                 space.scales.data() + block * space.count, coefficients.data(),
                 static_cast<std::int64_t>(coefficients.size()), values.data());
}

std::vector<float> combined(const QuantisedSpace& space, std::span<const float> coefficients)
{
    std::vector<float> values;
    combine(space, coefficients, values);
    return values;
}

void combine(const QuantisedSpace& space, std::span<const float> coefficients, std::vector<float>& values)
{
    values.resize(space.mean.size());
    for (std::int64_t b = 0; b < space.blocks(); ++b)
        combineBlock(space, b, coefficients,
                     std::span(values).subspan(static_cast<std::size_t>(b * QuantisedSpace::blockSize),
                                               QuantisedSpace::blockSize));
    values.resize(static_cast<std::size_t>(space.size));
}

Eigen::MatrixXd componentProducts(const QuantisedSpace& space, std::span<const std::uint8_t> known,
                                  const Progress& progress)
{
    assert(known.empty() || static_cast<std::int64_t>(known.size()) == space.size);
    const std::int64_t count = space.count;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, count);
    std::vector<std::int32_t> products(static_cast<std::size_t>(count * count));
    std::vector<std::int8_t> kept(
        known.empty() ? 0 : static_cast<std::size_t>(count * QuantisedSpace::blockSize));
    for (std::int64_t b = 0; b < space.blocks(); ++b) {
        progress.report(b, space.blocks());
        const std::int8_t* steps = space.block(b);
        if (!known.empty()) {
            const auto counts = inBlock(known, b);
            std::copy_n(steps, kept.size(), kept.begin());
            for (std::size_t at = 0; at < kept.size(); at += QuantisedSpace::blockSize) {
                for (std::size_t i = 0; i < counts.size(); ++i)
                    kept[at + i] = counts[i] != 0 ? kept[at + i] : std::int8_t{0};
            }
            steps = kept.data();
        }
        multiplySteps(steps, count, products.data());
        const float* scales = space.scales.data() + b * count;
        for (std::int64_t row = 0; row < count; ++row) {
            for (std::int64_t column = 0; column <= row; ++column)
                sums(row, column) +=
                    static_cast<double>(products[static_cast<std::size_t>(row * count + column)]) *
                    static_cast<double>(scales[row]) * static_cast<double>(scales[column]);
        }
    }
    progress.report(1);
    sums.triangularView<Eigen::StrictlyUpper>() = sums.transpose();
    return sums;
}

Eigen::VectorXd sampleProducts(const QuantisedSpace& space, std::span<const float> sample,
                               std::span<const std::uint8_t> known)
{
    assert(static_cast<std::int64_t>(sample.size()) == space.size);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(space.count);
    Eigen::VectorXd products(space.count);
    std::vector<double> differences(QuantisedSpace::blockSize);
    for (std::int64_t b = 0; b < space.blocks(); ++b) {
        const auto values = inBlock(sample, b);
        const std::int16_t* mean = space.mean.data() + b * QuantisedSpace::blockSize;
        std::ranges::fill(differences, 0.0);
        for (std::size_t i = 0; i < values.size(); ++i)
            differences[i] = static_cast<double>(values[i]) -
                             static_cast<double>(space.meanStep) * static_cast<double>(mean[i]);
        if (!known.empty()) {
            const auto counts = inBlock(known, b);
            for (std::size_t i = 0; i < counts.size(); ++i)
                differences[i] *= static_cast<double>(counts[i]);
        }
        multiplyValues(space.block(b), space.count, differences.data(), products.data());
        for (std::int64_t c = 0; c < space.count; ++c)
            sums(c) += products(c) *
                       static_cast<double>(space.scales[static_cast<std::size_t>(b * space.count + c)]);
    }
    return sums;
}

} // namespace quadrille
