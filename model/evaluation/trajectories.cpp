// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/trajectories.h"

#include "model/transition/warppath.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace quadrille {

namespace {

/// The windows of a blend.
struct Windows
{
    NodeIndex source = 0;      ///< first frame
    NodeIndex destination = 0; ///< first frame
    int sourceLength = 0;
    int destinationLength = 0;
};

/// Sum of the distances where both windows go on evenly.
double evenCost(TableView<float> distances, const Windows& windows)
{
    const int cells = std::max(windows.sourceLength, windows.destinationLength);
    const auto frame = [cells](int length, int cell) {
        return cells < 2 ? 0 : (cell * (length - 1) + (cells - 1) / 2) / (cells - 1);
    };
    double sum = 0;
    for (int cell = 0; cell < cells; ++cell)
        sum += static_cast<double>(distances(windows.source + frame(windows.sourceLength, cell),
                                             windows.destination + frame(windows.destinationLength, cell)));
    return sum;
}

} // namespace

CurveMeasures measureCurve(std::span<const Vec2d> points)
{
    CurveMeasures measures;
    if (points.size() < 2)
        return measures;
    std::vector<Vec2d> steps;
    steps.reserve(points.size() - 1);
    for (std::size_t p = 1; p < points.size(); ++p) {
        steps.push_back(points[p] - points[p - 1]);
        measures.length += steps.back().norm();
    }
    measures.distance = (points.back() - points.front()).norm();
    const double shortest = 0.1 * measures.length / static_cast<double>(steps.size());
    std::erase_if(steps, [&](const Vec2d& step) { return !(step.norm() > shortest); });
    for (std::size_t s = 1; s < steps.size(); ++s) {
        const Vec2d& a = steps[s - 1];
        const Vec2d& b = steps[s];
        const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
        measures.greatestTurn = std::max(measures.greatestTurn, turn);
        measures.reversals += turn > std::numbers::pi / 2 ? 1 : 0;
    }
    return measures;
}

double netTurning(const MeshSequence& sequence, const Ground& ground)
{
    double turning = 0;
    for (std::int64_t f = 1; f < sequence.frameCount(); ++f) {
        const Frame before = sequence.frame(FrameIndex(f - 1));
        const Frame after = sequence.frame(FrameIndex(f));
        turning += groundAlignment(before.positions(), after.positions(), ground);
    }
    return turning;
}

Transition longBlend(TableView<float> distances, const FrameLayout& layout,
                     const TransitionSettings& settings)
{
    assert(layout.sequenceCount() == 2);
    const int longest = settings.longest();
    const int sourceCount = std::min(longest, static_cast<int>(layout.countOf(0)));
    const int destinationCount = std::min(longest, static_cast<int>(layout.countOf(1)));
    Windows best{.sourceLength = std::min(sourceCount, 2 * destinationCount),
                 .destinationLength = std::min(destinationCount, 2 * sourceCount)};
    double bestCost = std::numeric_limits<double>::infinity();
    for (NodeIndex i = layout.firstOf(0); i + best.sourceLength - 1 <= layout.lastOf(0); ++i) {
        for (NodeIndex j = layout.firstOf(1); j + best.destinationLength - 1 <= layout.lastOf(1); ++j) {
            Windows windows = best;
            windows.source = i;
            windows.destination = j;
            if (const double cost = evenCost(distances, windows); cost < bestCost) {
                bestCost = cost;
                best = windows;
            }
        }
    }
    const WarpPaths paths(distances, layout, settings);
    const FramePair ends{best.source, best.destination + best.destinationLength - 1};
    const auto found = paths.between(ends, best.sourceLength, best.destinationLength);
    assert(found);
    return *found;
}

std::vector<BlendTrajectory> blendTrajectories(const RootPoses& roots, const Transition& transition,
                                               std::optional<double> constantWeight)
{
    const Ground ground(roots.up);
    std::vector<BlendTrajectory> all;
    for (const BlendAlignment alignment :
         {BlendAlignment::None, BlendAlignment::MidWindow, BlendAlignment::EveryStep}) {
        BlendTrajectory trajectory{.alignment = alignment};
        std::vector<Vec2d> points;
        const BlendSettings settings{.alignment = alignment, .constantWeight = constantWeight};
        for (const auto& step : transitionMotion(roots, transition, settings).steps) {
            trajectory.centres.push_back(step.centre);
            points.push_back(ground.of(step.centre));
        }
        trajectory.measures = measureCurve(points);
        all.push_back(std::move(trajectory));
    }
    return all;
}

} // namespace quadrille
