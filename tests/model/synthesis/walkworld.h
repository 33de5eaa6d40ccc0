// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/essentialgraph.h"
#include "model/synthesis/walks/findwalk.h"
#include "tests/model/graph/randomtransitions.h"

#include <cmath>

namespace quadrille::test {

/// A small character for walks: every sequence goes over the ground (z up) at its own speed and bends its own
/// way; transitions between them are random.
struct WalkWorld
{
    static constexpr double alpha = 0.01;

    TransitionCosts costs;
    Digraph graph;
    RootPoses roots;

    explicit WalkWorld(const RandomTransitions& random)
        : costs(makeTransitions(random)), graph(essentialGraph(costs, alpha).graph), roots{.up = UpAxis::Z}
    {
        std::vector<double> headings;
        const FrameLayout& layout = costs.layout();
        for (int sequence = 0; sequence < layout.sequenceCount(); ++sequence) {
            double heading = sequence;
            Vec2d point(3.0 * sequence, 1);
            for (NodeIndex f = 0; f < layout.countOf(sequence); ++f) {
                roots.centres.emplace_back(point.x(), point.y(), 1 + 0.01 * (f % 3));
                headings.push_back(heading);
                point += (0.03 + 0.02 * (sequence % 3)) * Vec2d(std::cos(heading), std::sin(heading));
                heading += 0.04 * (sequence % 5 - 2);
            }
        }
        const auto frames = static_cast<Eigen::Index>(headings.size());
        Table<float> turns(frames, frames);
        for (Eigen::Index i = 0; i < frames; ++i) {
            for (Eigen::Index j = 0; j < frames; ++j)
                turns(i, j) = static_cast<float>(wrappedAngle(headings[static_cast<std::size_t>(i)] -
                                                              headings[static_cast<std::size_t>(j)]));
        }
        roots.turns = SharedTable<float>(std::move(turns));
    }

    /// Both windows advance together as far as their sequences go.
    Transition transition(const FramePair& frames) const
    {
        const FrameLayout& layout = costs.layout();
        Transition result{.frames = frames};
        const int length = costs.length()(frames.source, frames.destination);
        for (int t = 0; t < length; ++t)
            result.path.push_back(
                {std::min(frames.source + t, layout.lastOf(layout.sequenceOf(frames.source))),
                 std::max(frames.destination - (length - 1) + t,
                          layout.firstOf(layout.sequenceOf(frames.destination)))});
        return result;
    }

    WalkMaterial material() const
    {
        return {.graph = graph,
                .costs = costs,
                .alpha = alpha,
                .motion = {.roots = &roots,
                           .transition = [this](const FramePair& frames) { return transition(frames); }}};
    }

    FrameSet sequence(int index, const std::string& name = "sequence") const
    {
        return {name, {{costs.layout().firstOf(index), costs.layout().lastOf(index)}}};
    }
};

} // namespace quadrille::test
