// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/transitioncomparison.h"

#include "model/transition/acceleration.h"
#include "model/transition/transitiontable.h"
#include "model/transition/warppath.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Sum, sum of squares and maximum of one figure.
struct Moments
{
    double sum = 0;
    double squares = 0;
    double largest = 0;

    void add(double value)
    {
        sum += value;
        squares += value * value;
        largest = std::max(largest, value);
    }
    void add(const Moments& other)
    {
        sum += other.sum;
        squares += other.squares;
        largest = std::max(largest, other.largest);
    }
    /// In units of `unit`.
    MeanAndDeviation over(std::int64_t count, double unit) const
    {
        if (count == 0 || unit <= 0)
            return {};
        const double mean = sum / static_cast<double>(count);
        const double variance = std::max(0.0, squares / static_cast<double>(count) - mean * mean);
        return {.mean = mean / unit, .deviation = std::sqrt(variance) / unit};
    }
};

/// The figures of the transitions from one frame.
struct Figures
{
    std::int64_t pairs = 0;
    Moments surface;
    Moments surfacePerFrame;
    Moments acceleration;
    Moments length;

    void add(const Figures& other)
    {
        pairs += other.pairs;
        surface.add(other.surface);
        surfacePerFrame.add(other.surfacePerFrame);
        acceleration.add(other.acceleration);
        length.add(other.length);
    }
};

struct Inputs
{
    TableView<float> distances;
    const FrameLayout& layout;
    TableView<float> accelerations;
};

/// \param settings  those of the variant: windows of one length where they do not vary.
Figures figuresOf(const Inputs& inputs, TransitionKind kind, const TransitionSettings& settings,
                  const Progress& progress, const Executor& executor)
{
    const bool linear = kind == TransitionKind::Linear;
    const Progress first = progress.part(0, 0.3);
    const TransitionTable table =
        linear ? linearTransitionTable(inputs.distances, inputs.layout, settings, first)
               : transitionTable(inputs.distances, inputs.layout, settings, first, executor);
    const WarpPaths paths(inputs.distances, inputs.layout, settings);
    const NodeIndex frames = inputs.layout.frameCount();
    const auto fromFrame = [&](NodeIndex i) {
        Figures figures;
        for (NodeIndex j = 0; j < frames; ++j) {
            const int length = table.length(i, j);
            if (length == 0)
                continue;
            const auto cost = static_cast<double>(table.cost(i, j));
            ++figures.pairs;
            figures.surface.add(cost);
            figures.surfacePerFrame.add(settings.cost == TransitionCost::Sum ? cost / length : cost);
            figures.length.add(length);
            if (inputs.accelerations.size() == 0)
                continue;
            const FramePair pair{.source = i, .destination = j};
            const Transition transition = linear ? *paths.linear(pair) : *paths.of(table, pair);
            figures.acceleration.add(accelerationCost(inputs.accelerations, transition));
        }
        return figures;
    };
    // Summed in the order of the frames, so that no thread changes a digit.
    std::vector<Figures> ofFrames(static_cast<std::size_t>(frames));
    executor.run(makeTasks<Figures>(
                     frames,
                     [&](std::int64_t task, const Progress&) {
                         return std::vector<Figures>{fromFrame(static_cast<NodeIndex>(task))};
                     },
                     [&](std::int64_t task, std::span<const Figures> figures) {
                         ofFrames[static_cast<std::size_t>(task)] = figures.front();
                     }),
                 progress.part(0.3, 1));
    Figures all;
    for (const Figures& figures : ofFrames)
        all.add(figures);
    return all;
}

struct VariantFigures
{
    TransitionVariant variant;
    Figures figures;
};

std::vector<VariantFigures> figuresOfAll(const Inputs& inputs, const TransitionSettings& settings,
                                         const Progress& progress, const Executor& executor)
{
    std::vector<VariantFigures> all{{.variant = {.kind = TransitionKind::Linear, .slope = 0}, .figures = {}}};
    for (const TransitionKind kind : {TransitionKind::Warped, TransitionKind::VaryingLengths}) {
        for (int slope = TransitionSettings::leastSlope; slope <= TransitionSettings::greatestSlope; ++slope)
            all.push_back({.variant = {.kind = kind, .slope = slope}, .figures = {}});
    }
    for (std::size_t v = 0; v < all.size(); ++v) {
        TransitionSettings own = settings;
        if (all[v].variant.slope > 0)
            own.slope = all[v].variant.slope;
        own.length = TransitionLength::Path;
        own.shortestWindow = settings.shortest();
        own.longestWindow =
            all[v].variant.kind == TransitionKind::VaryingLengths ? settings.longest() : settings.shortest();
        const auto count = static_cast<double>(all.size());
        all[v].figures = figuresOf(
            inputs, all[v].variant.kind, own,
            progress.part(static_cast<double>(v) / count, static_cast<double>(v + 1) / count), executor);
    }
    return all;
}

} // namespace

TransitionComparison compareTransitions(TableView<float> distances, const FrameLayout& layout,
                                        const TransitionSettings& settings, TableView<float> accelerations,
                                        const Progress& progress, const Executor& executor)
{
    checkSettings(settings);
    assert(accelerations.size() == 0 || accelerations.rows() == layout.frameCount());
    const Inputs inputs{.distances = distances, .layout = layout, .accelerations = accelerations};
    const std::vector<VariantFigures> all = figuresOfAll(inputs, settings, progress, executor);
    // A pair for which one exists has room for two windows of l_min frames, and then all exist.
    const Figures& linear = all.front().figures;
    TransitionComparison comparison{.pairs = linear.pairs,
                                    .largestLinearCost = linear.surface.largest,
                                    .largestLinearAcceleration = linear.acceleration.largest,
                                    .variants = {}};
    for (const VariantFigures& one : all) {
        assert(one.figures.pairs == linear.pairs);
        TransitionVariant variant = one.variant;
        variant.surface = one.figures.surface.over(linear.pairs, comparison.largestLinearCost);
        variant.surfacePerFrame = one.figures.surfacePerFrame.over(linear.pairs, 1);
        variant.acceleration =
            one.figures.acceleration.over(linear.pairs, comparison.largestLinearAcceleration);
        variant.length = one.figures.length.over(linear.pairs, 1);
        comparison.variants.push_back(variant);
    }
    return comparison;
}

} // namespace quadrille
