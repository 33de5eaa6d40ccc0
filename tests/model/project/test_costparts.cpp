// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/costparts.h"
#include "model/synthesis/clips/stepcosts.h"

#include <array>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// Two takes of six frames. All poses are 2 rad apart and move otherwise for 0.5 rad; the one foot stands in
/// the first take alone, which counts 3 rad, and every transition drags it by half of what costs as much
/// again.
struct SplitCase
{
    static constexpr double contactWeight = 3;
    FrameLayout layout{std::array<std::int64_t, 2>{6, 6}};
    TransitionSettings settings{.fps = 10, .shortestWindow = 3, .longestWindow = 3};
    Stances stances{.feet = {{"left", {0}}}, .height = 2};
    Table<float> distances = Table<float>::Constant(12, 12, 2);
    Table<float> steps = distances + 0.5F;
    Table<float> drifts = Table<float>::Constant(12, 12, static_cast<float>(dragOfOneFoot / 2));

    SplitCase()
    {
        stances.standing = {1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};
        for (NodeIndex i = 0; i < 12; ++i)
            for (NodeIndex j = 0; j < 12; ++j)
                steps(i, j) += static_cast<float>(contactWeight * differingFeet(stances, i, j));
    }

    /// \param share  of liveliness, that all costs are divided by.
    CostParts of(const FramePair& pair, float share = 1)
    {
        const TransitionTable transitions = transitionTable(steps, layout, settings);
        Table<float> cost = *transitions.cost;
        if (drifts.size() > 0)
            addDrifts(cost, drifts, *transitions.length, settings.cost == TransitionCost::Sum,
                      {.contacts = contactWeight});
        const TransitionCosts costs(cost / share, *transitions.length, 100, layout);
        const WarpPaths paths(steps, layout, settings);
        const CostSplit::StepOf step = [this](NodeIndex i, NodeIndex j) { return steps(i, j); };
        const CostSplit split{
            .distances = distances, .step = step, .stances = stances, .contactWeight = contactWeight};
        const auto transition = paths.of(transitions, pair);
        EXPECT_EQ(transition.has_value(), costs.hasTransition(pair.source, pair.destination));
        if (!transition)
            return {};
        const float known = costs.cost()(pair.source, pair.destination);
        const CostParts parts =
            split.of(*transition, drifts.size() > 0 ? drifts(pair.source, pair.destination) : 0, known);
        EXPECT_NEAR(parts.sum(), static_cast<double>(known), 1e-5);
        return parts;
    }
};

void expectParts(const CostParts& parts, double pose, double contacts, double velocity)
{
    EXPECT_NEAR(parts.pose, pose, 1e-5);
    EXPECT_NEAR(parts.contacts, contacts, 1e-5);
    EXPECT_NEAR(parts.velocity, velocity, 1e-5);
}

} // namespace

TEST(CostSplit, TellsPosesFeetAndSpeedsApart)
{
    SplitCase split;
    // Three steps of each; feet: three that differ, and half of one that is dragged for three frames.
    expectParts(split.of({1, 9}), 3 * 2, 3 * 3 + 3 * 3 / 2.0, 3 * 0.5);
    split.settings.cost = TransitionCost::Mean;
    expectParts(split.of({1, 9}), 2, 3 + 3 / 2.0, 0.5);
    expectParts(split.of({1, 9}, 4), 0.5, 4.5 / 4, 0.125);
    // In one take the foot stands in both frames; it is dragged all the same.
    expectParts(split.of({0, 5}), 2, 3 / 2.0, 0.5);
}

TEST(CostSplit, KnowsNothingOfDraggedFeetWhereCostsDoNot)
{
    SplitCase split;
    split.settings.cost = TransitionCost::Mean;
    split.drifts = {};
    expectParts(split.of({1, 9}), 2, 3, 0.5);
    expectParts(split.of({4, 9}), 0, 0, 0); // no window of three frames is left there
}
