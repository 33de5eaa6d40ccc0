// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/project/document/findentry.h"
#include "model/transition/acceleration.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitioncomparison.h"
#include "tests/model/project/stripproject.h"

#include <algorithm>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

namespace {

class EvaluationSteps : public StripProject
{
protected:
    EvaluationSteps() { project.graphs = {GraphEntry::paper()}; }
    void evaluate(std::initializer_list<const char*> tables)
    {
        for (const char* table : tables)
            project.evaluations.emplace_back().table = table;
    }
    RebuildReport run() { return StripProject::run("evaluations"); }
};

} // namespace

TEST_F(EvaluationSteps, Fig7HoldsTheComparisonOfTransitions)
{
    evaluate({"fig7"});
    run();
    const CharacterFrames character = frames();
    const PoseDistances poses = poseDistances(character);
    const TransitionComparison expected =
        compareTransitions(poses.distances, poses.layout, {.fps = 6}, accelerationDifferences(character, 6));
    const auto surface = column<double>("evaluation/fig7", "surface");
    const auto deviation = column<double>("evaluation/fig7", "acceleration-deviation");
    ASSERT_EQ(surface.size(), 9U);
    for (std::size_t row = 0; row < surface.size(); ++row) {
        EXPECT_EQ(surface[row], expected.variants[row].surface.mean);
        EXPECT_EQ(deviation[row], expected.variants[row].acceleration.deviation);
    }
    EXPECT_THAT(
        column<std::string>("evaluation/fig7", "transition"),
        ElementsAre("linear", "dtw", "dtw", "dtw", "dtw", "dtw+vls", "dtw+vls", "dtw+vls", "dtw+vls"));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig7", "slope"), ElementsAre(0, 2, 3, 4, 5, 2, 3, 4, 5));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig7-scale", "pairs"), ElementsAre(expected.pairs));
}

TEST_F(EvaluationSteps, Fig9HasARowForEachGraphAndAlpha)
{
    evaluate({"fig9"});
    project.evaluations[0].alphas = {0.02, 0.5};
    run();
    const PoseDistances poses = poseDistances(frames());
    const TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 6});
    const TransitionCosts costs(*transitions.cost, *transitions.length, poses.distances.maxCoeff(),
                                poses.layout);
    const auto expected = sweepAlpha(costs, costMinima(costs), project.evaluations[0].alphas);
    EXPECT_THAT(column<std::string>("evaluation/fig9", "graph"),
                ElementsAre("motion", "essential", "motion", "essential"));
    EXPECT_THAT(column<double>("evaluation/fig9", "alpha"), ElementsAre(0.02, 0.02, 0.5, 0.5));
    EXPECT_THAT(column<double>("evaluation/fig9", "mean-cost"),
                ElementsAre(expected[0].motion.pathCosts.mean, expected[0].essential.pathCosts.mean,
                            expected[1].motion.pathCosts.mean, expected[1].essential.pathCosts.mean));
    EXPECT_THAT(column<double>("evaluation/fig9-equal-density", "common-mean-cost"),
                ElementsAre(expected[0].motionMeanOverCommonPairs, expected[0].essentialMeanOverCommonPairs,
                            expected[1].motionMeanOverCommonPairs, expected[1].essentialMeanOverCommonPairs));
    const auto last = column<std::int64_t>("evaluation/fig9-components", "last");
    EXPECT_EQ(*std::max_element(last.begin(), last.end()), 13);
}

TEST_F(EvaluationSteps, Table1IsAboutTheSequencesWithJointAngles)
{
    std::string bvh = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\nJOINT b\n{\nOFFSET 0 1 0\n"
                      "CHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n"
                      "MOTION\nFrames: 9\nFrame Time: 0.1\n";
    for (int f = 0; f < 9; ++f)
        bvh += "0 " + std::to_string(60 * std::sin(0.7 * f + 0.1)) + "\n";
    folder.write("quick.bvh", bvh);
    project.sequences[1].jointAngles = "quick.bvh";
    evaluate({"table1"});
    run();
    EXPECT_THAT(column<std::int64_t>("evaluation/table1", "frames"), ElementsAre(9, 9));
    EXPECT_THAT(column<std::int64_t>("evaluation/table1", "pairs"), ElementsAre(36, 36));
    // The strip bends as the angle does.
    EXPECT_GT(column<double>("evaluation/table1", "pearson-surface")[0], 0.999);
    EXPECT_GT(column<double>("evaluation/table1", "distance-correlation-surface")[0], 0.999);
    EXPECT_THAT(column<std::string>("evaluation/table1-joints", "joint"), ElementsAre("b"));
    folder.write("quick.bvh", bvh + " ");
    EXPECT_THAT(computed(run()), UnorderedElementsAre("evaluations/table1"));
    project.graphs.resize(1);
    const auto surface = column<double>("evaluation/table1", "pearson-surface");
    project.graphs[0].pose.metric = PoseMetric::Euclidean;
    run();
    EXPECT_EQ(column<double>("evaluation/table1", "pearson-surface"), surface);
}

TEST_F(EvaluationSteps, Fig4IsAboutDrawnPairsAndThePosesThatDifferMost)
{
    evaluate({"fig4"});
    project.evaluations[0].count = 3;
    run();
    const auto pairs = column<std::string>("evaluation/fig4", "pairs");
    EXPECT_EQ(std::count(pairs.begin(), pairs.end(), "drawn"), 3 * 9);
    EXPECT_EQ(std::count(pairs.begin(), pairs.end(), "furthest"), 3 * 9);
    EXPECT_EQ(column<double>("evaluation/fig4-pairs", "pose-distance").size(), 4U * 3U);
    // The strip only bends: the surface keeps its edges better than straight lines do.
    EXPECT_EQ(column<std::string>("evaluation/fig4-pairs", "method")[9], "linear");
    const auto edges = column<double>("evaluation/fig4-pairs", "edge-change");
    EXPECT_LT(edges[9], 0);
    EXPECT_LT(std::abs(edges[11]), 0.2 * std::abs(edges[9]));
    const Table<float> distances = poseDistances(frames()).distances;
    EXPECT_EQ(column<double>("evaluation/fig4-pairs", "pose-distance").back(),
              static_cast<double>(distances.maxCoeff()));
    project.evaluations[0].seed = 2;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("evaluations/fig4"));
}

TEST_F(EvaluationSteps, Fig11And12FollowTheCentreOfABlend)
{
    evaluate({"fig11", "fig12"});
    project.evaluations[0].sequences = {"quick", "slow"};
    run();
    EXPECT_THAT(column<std::string>("evaluation/fig11-summary", "variant"),
                ElementsAre("source", "destination", "plain", "mid-window", "every-step"));
    EXPECT_THAT(column<std::string>("evaluation/fig11-summary", "sequence"),
                ElementsAre("quick", "slow", "quick → slow", "quick → slow", "quick → slow"));
    const auto frames = column<std::int64_t>("evaluation/fig11-summary", "frames");
    const auto variants = column<std::string>("evaluation/fig11", "variant");
    EXPECT_EQ(std::count(variants.begin(), variants.end(), "every-step"), frames[4]);
    EXPECT_GE(frames[4], std::max(frames[0], frames[1]));
    EXPECT_EQ(column<std::string>("evaluation/fig12-summary", "variant").size(), 5U);
}

TEST_F(EvaluationSteps, Table2ShowsPosesAtNewTimes)
{
    evaluate({"table2"});
    project.evaluations[0].count = 4;
    run();
    EXPECT_THAT(column<std::string>("evaluation/table2", "search"),
                ElementsAre("pairs", "pairs", "pairs", "pairs", "global", "global", "global", "global"));
    const auto wanted = column<std::int64_t>("evaluation/table2", "wanted");
    const auto obtained = column<std::int64_t>("evaluation/table2", "obtained");
    const auto error = column<std::int64_t>("evaluation/table2", "error");
    EXPECT_EQ(wanted[0], 0);
    EXPECT_EQ(wanted[3], 23); // all frames of the project
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_EQ(error[k], obtained[k] - wanted[k]);
    const auto cost = column<double>("evaluation/table2-summary", "cost");
    EXPECT_LE(cost[1], cost[0] + 1e-9); // over all keys no dearer than pair by pair
    EXPECT_THAT(column<std::string>("evaluation/table2-summary", "optimal"),
                ElementsAre("from key to key", "yes"));
    const auto bound = column<double>("evaluation/table2-summary", "bound");
    EXPECT_LE(bound[0], cost[1] + 1e-9);
    EXPECT_NEAR(bound[1], cost[1], 1e-9);
    project.evaluations[0].sequences = {"slow"};
    EXPECT_THAT(computed(run()), UnorderedElementsAre("evaluations/table2"));
    EXPECT_THAT(column<std::string>("evaluation/table2", "sequence"), ::testing::Each("slow"));
}

TEST_F(EvaluationSteps, JunctionsAreJudgedWithBothBlends)
{
    evaluate({"junctions"});
    project.evaluations[0].count = 5;
    run();
    const auto blends = column<std::string>("evaluation/junctions", "blend");
    const auto drawnFrom = column<std::string>("evaluation/junctions", "drawn-from");
    const auto minima = std::count(drawnFrom.begin(), drawnFrom.end(), "minima") / 3;
    EXPECT_GT(minima, 0);
    EXPECT_EQ(std::count(drawnFrom.begin(), drawnFrom.end(), "essential"), 15);
    for (const char* blend : {"paper", "gentle", "gentle-corrected"})
        EXPECT_EQ(std::count(blends.begin(), blends.end(), blend), 5 + minima);
    EXPECT_EQ(column<std::int64_t>("evaluation/junctions-predictors", "transitions").front(), 5 + minima);
    EXPECT_THAT(column<std::string>("evaluation/junctions-criteria", "criterion"),
                ElementsAre("acceleration", "frozen", "centre-step", "foot-slip", "volume", "all",
                            "acceleration", "frozen", "centre-step", "foot-slip", "volume", "all",
                            "acceleration", "frozen", "centre-step", "foot-slip", "volume", "all"));
    EXPECT_EQ(column<std::int64_t>("evaluation/junctions-criteria", "measured")[5], 5);
    EXPECT_EQ(column<std::string>("evaluation/junctions-predictors", "predictor").size(), 15U);
    const PoseDistances poses = poseDistances(frames());
    const TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 6});
    const auto from = column<std::string>("evaluation/junctions", "from");
    const auto fromFrame = column<std::int64_t>("evaluation/junctions", "from-frame");
    const auto to = column<std::string>("evaluation/junctions", "to");
    const auto toFrame = column<std::int64_t>("evaluation/junctions", "to-frame");
    const auto sum = column<double>("evaluation/junctions", "sum");
    for (std::size_t row = 0; row < sum.size(); ++row) {
        const auto i = fromFrame[row] + (from[row] == "slow" ? 0 : 14);
        const auto j = toFrame[row] + (to[row] == "slow" ? 0 : 14);
        EXPECT_NEAR(sum[row], transitions.cost(i, j), 1e-6);
    }
}

TEST_F(EvaluationSteps, DensityVariesOneThingAtATime)
{
    project.graphs = {GraphEntry()};
    evaluate({"density"});
    computed(run());
    const auto variants = column<std::string>("evaluation/density", "variant");
    const auto essential = column<std::int64_t>("evaluation/density", "essential-transitions");
    const auto takes = column<std::int64_t>("evaluation/density", "takes");
    const auto greatest = column<double>("evaluation/density", "d-max");
    computed(StripProject::run("graph"));
    EXPECT_EQ(variants.front(), "as set");
    EXPECT_EQ(essential.front(), column<std::int64_t>("graph-statistics", "transitions").front());
    EXPECT_EQ(takes.front(), 2);
    EXPECT_FLOAT_EQ(static_cast<float>(greatest.front()), matrix("pose-distance").maxCoeff());
    for (std::size_t row = 0; row < variants.size(); ++row) {
        const bool isJoined = variants[row].find("joined") != std::string::npos;
        const bool isQuantile = variants[row].find("quantile") != std::string::npos;
        EXPECT_EQ(takes[row], isJoined ? 1 : 2) << variants[row];
        EXPECT_EQ(greatest[row] < greatest.front(), isQuantile) << variants[row];
    }
}

TEST_F(EvaluationSteps, TakeTheSettingsOfTheGraphWhereItHasSome)
{
    evaluate({"fig9"});
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("graph/pose-distance", "graph/transitions", "evaluations/fig9"));
    project.graphs[0].character.clear();
    EXPECT_TRUE(computed(run()).empty());
    project.graphs[0].alpha = 0.5; // not of those that are compared
    EXPECT_TRUE(computed(run()).empty());
    project.graphs[0].slope = 2;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/transitions", "evaluations/fig9"));
    project.evaluations[0].alphas = {0.01};
    EXPECT_THAT(computed(run()), UnorderedElementsAre("evaluations/fig9"));
}

TEST_F(EvaluationSteps, AreMadeForEachCharacterThatTheyAreAbout)
{
    project.characters = {characterOf("a", ""), characterOf("b", "")};
    project.sequences[0].character = "a";
    project.sequences[1].character = "b";
    project.graphs.clear();
    evaluate({"fig9", "fig9"});
    project.evaluations[1].character = "b";
    project.evaluations[1].alphas = {0.7};
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("graph/a/pose-distance", "graph/a/root-poses", "graph/a/transitions",
                                     "graph/a/foot-drifts", "graph/a/liveliness", "graph/b/pose-distance",
                                     "graph/b/root-poses", "graph/b/transitions", "graph/b/foot-drifts",
                                     "graph/b/liveliness", "evaluations/fig9/a", "evaluations/fig9/b"));
    project.evaluations.erase(project.evaluations.begin());
    EXPECT_THAT(column<double>("evaluation/fig9", "alpha"), ElementsAre(0.7, 0.7));
}
