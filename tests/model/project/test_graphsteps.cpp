// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/quality/liveliness.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"
#include "tests/model/project/stripproject.h"

#include <algorithm>
#include <array>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::UnorderedElementsAre;

namespace {

class GraphSteps : public StripProject
{
protected:
    GraphSteps() { project.graphs = {GraphEntry::paper()}; }
    RebuildReport run() { return StripProject::run("graph"); }
};

} // namespace

TEST_F(GraphSteps, HoldWhatTheFunctionsCompute)
{
    run();
    const PoseDistances poses = poseDistances(frames());
    EXPECT_TRUE((matrix("pose-distance") == poses.distances).all());
    EXPECT_TRUE(
        (matrix("euclidean-distance") == poseDistances(frames(), {.metric = PoseMetric::Euclidean}).distances)
            .all());
    const TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 6});
    project.settings.axes.metresPerUnit = 0.01;
    run();
    EXPECT_LT((matrix("euclidean-distance") -
               poseDistances(frames(), {.metric = PoseMetric::Euclidean}).distances / 100)
                  .abs()
                  .maxCoeff(),
              1e-5)
        << "metres in every unit";
    project.settings.axes.metresPerUnit = 1;
    run();
    EXPECT_TRUE((matrix("transition-cost") == *transitions.cost).all());
    const Table<float> lengths = matrix("transition-length");
    EXPECT_TRUE((lengths.isFinite() == (*transitions.length > 0)).all());
    EXPECT_EQ(lengths(0, 22), static_cast<float>(transitions.length(0, 22)));

    const TransitionCosts costs(*transitions.cost, *transitions.length, poses.distances.maxCoeff(),
                                poses.layout);
    const Digraph essential = essentialGraph(costs, 0.01).graph;
    const auto from = column<std::int64_t>("essential-graph-edges", "i");
    const auto weights = column<double>("essential-graph-edges", "weight");
    ASSERT_EQ(from.size(), essential.edges().size());
    for (std::size_t e = 0; e < from.size(); ++e) {
        EXPECT_EQ(from[e], essential.edges()[e].from);
        EXPECT_EQ(weights[e], essential.edges()[e].weight);
    }
}

TEST_F(GraphSteps, WeighHowFarFeetAreDragged)
{
    project.sequences[0].range = FrameRange{FrameIndex(2), FrameIndex(13)}; // the first ones are flat
    project.graphs[0].durations = {1, 1.5};
    project.sequences[0].contacts = {{"left", {FrameIndex(0), FrameIndex(11)}}};
    project.sequences[1].contacts = {{"left", {FrameIndex(0), FrameIndex(3)}}};
    for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
        project.graphs[0].cost = cost;
        project.graphs[0].steps.contacts = 0.5;
        run();
        const Table<float> drifts = matrix("transition-drift");
        EXPECT_GT(drifts.maxCoeff(), 0);
        const Table<float> costs = matrix("transition-cost");
        const Table<float> lengths = matrix("transition-length");
        const auto from = column<std::int64_t>("essential-graph-edges", "i");
        const auto to = column<std::int64_t>("essential-graph-edges", "j");
        const auto weights = column<double>("essential-graph-edges", "weight");
        const auto kinds = column<std::string>("essential-graph-edges", "kind");
        const auto greatest = static_cast<double>(matrix("pose-distance").maxCoeff());
        for (std::size_t e = 0; e < from.size(); ++e) {
            if (kinds[e] == "original")
                continue;
            const auto at = [&](const Table<float>& table) {
                return static_cast<double>(table(from[e], to[e]));
            };
            const double times = cost == TransitionCost::Sum ? at(lengths) : 1;
            EXPECT_NEAR(
                weights[e],
                (at(costs) + 0.5 / dragOfOneFoot * at(drifts) * times) / greatest + 0.01 * at(lengths), 1e-5);
        }
    }
    project.graphs[0].steps = {};
    const RebuildReport report = run();
    EXPECT_TRUE(std::none_of(report.steps.begin(), report.steps.end(),
                             [](const auto& step) { return step.step == "graph/foot-drifts"; }));
}

TEST_F(GraphSteps, EdgesNameTheSequenceAndTheFrameOfBothEnds)
{
    run();
    const FrameLayout layout = poseDistances(frames()).layout;
    const std::vector<std::string> names{"slow", "quick"};
    for (const char* table : {"essential-graph-edges", "motion-graph-edges"}) {
        const auto ends = {std::array{"i", "from-sequence", "from-frame"},
                           std::array{"j", "to-sequence", "to-frame"}};
        for (const auto& [node, sequence, frame] : ends) {
            const auto nodes = column<std::int64_t>(table, node);
            const auto sequences = column<std::string>(table, sequence);
            const auto frames = column<std::int64_t>(table, frame);
            ASSERT_FALSE(nodes.empty());
            for (std::size_t e = 0; e < nodes.size(); ++e) {
                const int s = layout.sequenceOf(static_cast<NodeIndex>(nodes[e]));
                EXPECT_EQ(sequences[e], names[static_cast<std::size_t>(s)]);
                EXPECT_EQ(frames[e], nodes[e] - layout.firstOf(s));
            }
        }
    }
}

TEST_F(GraphSteps, EdgesTellWhatTheirCostsAreMadeOf)
{
    project.graphs.front().steps = GraphEntry().steps;
    for (SequenceEntry& sequence : project.sequences)
        sequence.contacts = {{.foot = "left", .frames = {FrameIndex(2), FrameIndex(4)}}};
    run();
    for (const char* table : {"essential-graph-edges", "motion-graph-edges"}) {
        const auto cost = column<double>(table, "cost");
        const auto pose = column<double>(table, "pose-cost");
        const auto contacts = column<double>(table, "contact-cost");
        const auto velocity = column<double>(table, "velocity-cost");
        double feet = 0;
        for (std::size_t e = 0; e < cost.size(); ++e) {
            EXPECT_NEAR(pose[e] + contacts[e] + velocity[e], cost[e], 1e-6 * cost[e]) << table;
            EXPECT_LE(pose[e], cost[e] * (1 + 1e-6));
            feet += contacts[e];
        }
        EXPECT_GT(feet, 0) << "a foot stands in some frames and not in others: " << table;
    }
    // Costs of poses alone.
    project.graphs.front().steps = {};
    run();
    const auto cost = column<double>("essential-graph-edges", "cost");
    const auto pose = column<double>("essential-graph-edges", "pose-cost");
    for (std::size_t e = 0; e < cost.size(); ++e)
        EXPECT_DOUBLE_EQ(pose[e], cost[e]);
}

TEST_F(GraphSteps, NameTheFramesThatNoWalkReachesOrLeaves)
{
    run();
    // Windows have two frames: no transition arrives at the first frame of a sequence, or leaves the last.
    using Texts = std::vector<std::string>;
    const Texts graphs = column<std::string>("graph-components", "graph");
    const auto essential = std::count(graphs.begin(), graphs.end(), "essential");
    ASSERT_EQ(essential, 6);
    const auto firstSix = [](auto values) {
        values.resize(6);
        return values;
    };
    EXPECT_EQ(firstSix(column<std::string>("graph-components", "sequence")),
              (Texts{"slow", "slow", "slow", "quick", "quick", "quick"}));
    using Numbers = std::vector<std::int64_t>;
    EXPECT_EQ(firstSix(column<std::int64_t>("graph-components", "first")), (Numbers{0, 1, 13, 0, 1, 8}));
    EXPECT_EQ(firstSix(column<std::int64_t>("graph-components", "last")), (Numbers{0, 12, 13, 0, 7, 8}));
    EXPECT_EQ(firstSix(column<std::int64_t>("graph-components", "component")),
              (Numbers{-1, 0, -1, -1, 0, -1}));
    EXPECT_EQ(firstSix(column<std::string>("graph-components", "reachable")),
              (Texts{"no", "yes", "yes", "no", "yes", "yes"}));
    EXPECT_EQ(firstSix(column<std::string>("graph-components", "returns")),
              (Texts{"yes", "yes", "no", "yes", "yes", "no"}));
}

TEST_F(GraphSteps, OnlyWhatASettingReachesIsComputedAgain)
{
    EXPECT_EQ(computed(run()).size(), 7U);
    EXPECT_TRUE(computed(run()).empty());
    project.graphs[0].alpha = 0.1;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/graphs", "graph/edges"));
    const auto fromTransitions =
        UnorderedElementsAre("graph/transitions", "graph/cost-overview", "graph/graphs", "graph/edges");
    project.graphs[0].slope = 2;
    EXPECT_THAT(computed(run()), fromTransitions);
    project.graphs[0].durations = {0.5, 1.0};
    EXPECT_THAT(computed(run()), fromTransitions);
    const auto fromDistances = UnorderedElementsAre("graph/pose-distance", "graph/transitions",
                                                    "graph/cost-overview", "graph/graphs", "graph/edges");
    project.graphs[0].pose.stretchWeight = 0.5;
    EXPECT_THAT(computed(run()), fromDistances);
    project.graphs[0].pose.triangles = 5;
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("graph/pose-distance", "graph/euclidean-distance", "graph/transitions",
                                     "graph/cost-overview", "graph/graphs", "graph/edges"));
    EXPECT_TRUE((matrix("euclidean-distance") ==
                 poseDistances(frames(), {.metric = PoseMetric::Euclidean, .triangles = 5}).distances)
                    .all());
    folder.write("slow/f_3.obj", bentStrip(-0.2));
    EXPECT_EQ(computed(run()).size(), 7U);
}

TEST_F(GraphSteps, CostsAreScaledByLivelinessOnDemand)
{
    project.graphs[0].costScale = CostScale::Liveliness;
    EXPECT_EQ(computed(run()).size(), 8U);
    const Table<double> liveliness = livelinessOf(frameMeasures(frames(), {}, UpAxis::Y), frames().layout());
    EXPECT_TRUE((matrix("liveliness") == liveliness.cast<float>()).all());
    const PoseDistances poses = poseDistances(frames());
    const TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 6});
    EXPECT_TRUE((matrix("transition-cost") == *transitions.cost).all());
    const Table<double> stored = matrix("liveliness").cast<double>();
    const TransitionCosts costs(costPerLiveliness(*transitions.cost, poses.layout, stored),
                                *transitions.length, poses.distances.maxCoeff(), poses.layout);
    const Digraph essential = essentialGraph(costs, 0.01).graph;
    const auto weights = column<double>("essential-graph-edges", "weight");
    ASSERT_EQ(weights.size(), essential.edges().size());
    for (std::size_t e = 0; e < weights.size(); ++e)
        EXPECT_EQ(weights[e], essential.edges()[e].weight);
    project.graphs[0].costScale = CostScale::None;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/cost-overview", "graph/graphs", "graph/edges"));
}

TEST_F(GraphSteps, WindowsComeFromDurationsAtTheRateOfTheProject)
{
    EXPECT_EQ(transitionSettings(GraphEntry::paper(), 25).shortest(), 9);
    EXPECT_EQ(transitionSettings(GraphEntry::paper(), 25).longest(), 50);
    EXPECT_EQ(transitionSettings(GraphEntry::paper(), 25).shortestBetween(20, 100), 9);
    GraphEntry entry;
    EXPECT_EQ(transitionSettings(entry, 25).shortest(), 15);
    EXPECT_EQ(transitionSettings(entry, 25).longest(), 50);
    // Where a take is too short: three tenths of it, rounded up.
    EXPECT_EQ(transitionSettings(entry, 25).shortestBetween(50, 100), 15);
    EXPECT_EQ(transitionSettings(entry, 25).shortestBetween(100, 41), 13);
    EXPECT_EQ(transitionSettings(entry, 25).shortestBetween(1, 41), 1);
    entry.durations = {0.2, 1.0};
    EXPECT_EQ(transitionSettings(entry, 25).shortest(), 5);
    EXPECT_EQ(transitionSettings(entry, 25).longest(), 25);
    EXPECT_EQ(transitionSettings(entry, 29.97).shortest(), 6);
    EXPECT_EQ(transitionSettings(entry, 29.97).longest(), 29);
}

TEST_F(GraphSteps, AProjectWithoutTheSectionHasNone)
{
    project.graphs.clear();
    EXPECT_THROW(run(), Error);
}
