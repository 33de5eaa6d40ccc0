// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Blends of four takes at the corners of a square.
#include "model/project/checks/validate.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/references.h"
#include "tests/model/largestdistance.h"
#include "tests/model/project/fullproject.h"
#include "tests/model/project/tubeproject.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <numeric>
#include <utility>

using namespace quadrille;
using namespace quadrille::test;
using quadrille::test::largestDistance;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace {

std::string problemsOf(const Project& project)
{
    std::string texts;
    for (const ProjectProblem& each : validate(project))
        texts += each.pointer + ": " + each.toString() + "\n";
    return texts;
}

class VariationSquare : public ::testing::Test
{
protected:
    VariationEntry& variation() { return project.variations.front(); }
    BlendEntry& blend() { return variation().blends.front(); }
    SamplesEntry& samples() { return variation().samples.front(); }

    Project project = fullProject();
};

/// Four takes of the tube: small and large swaying, quick and slow.
class TubeSquare : public TubeProject
{
protected:
    TubeSquare()
    {
        write("slow calm", 22, 0.06);
        write("slow wild", 25, 0.09);
        for (const char* take : {"slow calm", "slow wild"}) {
            project.sequences.push_back(sequenceOf(take, take));
            sway().training.emplace_back().sequence = take;
        }
        BlendEntry blend;
        blend.from = "calm";
        blend.to = "wild";
        blend.across.emplace();
        blend.across->from = "slow calm";
        blend.across->to = "slow wild";
        sway().blends = {blend};
        sway().samples.clear();
        sway().chain.burnIn = 5; // there is a chain around every node
    }
    void sample(double weight, double across)
    {
        SamplesEntry& samples = sway().samples.emplace_back();
        samples.of = "calm";
        samples.to = "wild";
        samples.weight = weight;
        samples.across.emplace();
        samples.across->of = "slow calm";
        samples.across->to = "slow wild";
        samples.across->weight = across;
        samples.count = 1;
    }
    void sampleOf(const std::string& take, const std::string& to, double weight)
    {
        SamplesEntry& samples = sway().samples.emplace_back();
        samples.of = take;
        samples.to = to;
        samples.weight = weight;
        samples.count = 1;
    }
    std::vector<Vec3f> frames(int number) { return loadFrames(opened(variationClip("sway", number))); }
    void learnsTheNodesOfItsGridAndBlendsBetweenThem();
    void isTheBlendOfTwoTakesOnItsEdgesAndATakeAtItsCorners();
    void movesWithItsWeightsWithoutAJump();
};

void TubeSquare::learnsTheNodesOfItsGridAndBlendsBetweenThem()
{
    sample(0.25, 0.5);
    const auto spread = std::exchange(sway().extent.spread, 0); // in the tempo of the takes
    computed(run("variations"));
    sway().extent.spread = spread;
    // Four takes, four edges and the middle on the reference's 18 frames.
    EXPECT_THAT(item("variations/sway/tip/latents").shape(), ElementsAre(9 * 18, 3));
    EXPECT_THAT(column<std::string>("variations/sway/takes", "take"),
                ElementsAre("calm", "wild", "slow calm", "slow wild", "calm–wild 0.5", "calm–slow calm 0.5",
                            "calm–wild × slow calm–slow wild 0.5 0.5", "wild–slow wild 0.5",
                            "slow calm–slow wild 0.5"));
    // Drawn around two nodes: the middle row is learned.
    EXPECT_THAT(column<double>("variations/sway/tip/chains", "acceptance"), SizeIs(2));
    // 3/8 of 17 and 21 steps, 1/8 of 14 and 24 are 19.
    EXPECT_EQ(opened("variations/sway/1").frameCount(), 20);
    EXPECT_THAT(column<std::string>("variations/sway/report", "across-to"), Contains("slow wild"));
    EXPECT_THAT(column<double>("variations/sway/report", "across-weight"), Contains(0.5));
}

void TubeSquare::isTheBlendOfTwoTakesOnItsEdgesAndATakeAtItsCorners()
{
    sway().samples.clear();
    sample(0.25, 0);
    sampleOf("calm", "wild", 0.25);
    sample(1, 0.75);
    sampleOf("wild", "slow wild", 0.75);
    sample(0, 1);
    sampleOf("slow calm", "", 0);
    computed(run("variations"));
    EXPECT_EQ(frames(1), frames(2));
    EXPECT_EQ(frames(3), frames(4));
    EXPECT_EQ(frames(5), frames(6));
    EXPECT_NE(frames(1), frames(3));
}

void TubeSquare::movesWithItsWeightsWithoutAJump()
{
    sway().samples.clear();
    // Across a learned node, and onto an edge.
    constexpr double step = 1e-6;
    sample(0.5 - step, 0.5 - step);
    sample(0.5 + step, 0.5 + step);
    sample(0.3, step);
    sample(0.3, 0);
    computed(run("variations"));
    EXPECT_LT(largestDistance(frames(1), frames(2)), 1e-4);
    EXPECT_LT(largestDistance(frames(3), frames(4)), 1e-4);
    EXPECT_GT(largestDistance(frames(2), frames(3)), 1e-3);
}

} // namespace

TEST_F(VariationSquare, IsValidWithFourTakes)
{
    EXPECT_FALSE(hasErrors(validate(project))) << problemsOf(project);
}

TEST_F(VariationSquare, HasFourDifferentCorners)
{
    blend().across->to = "softly";
    samples().across->of = "talk";
    const std::string texts = problemsOf(project);
    EXPECT_THAT(texts,
                HasSubstr("/variations/0/blends/0/across/to: “softly” is at two corners of the square"));
    EXPECT_THAT(texts,
                HasSubstr("/variations/0/samples/0/across/of: “talk” is at two corners of the square"));
}

TEST_F(VariationSquare, HasCornersThatAreLearned)
{
    blend().across->from = "shout";
    samples().across->to.clear();
    const std::string texts = problemsOf(project);
    EXPECT_THAT(texts, HasSubstr("/variations/0/blends/0/across/from: “shout” is none of the takes"));
    EXPECT_THAT(texts, HasSubstr("/variations/0/samples/0/across/to: “” is none of the takes"));
}

TEST_F(VariationSquare, HasWeightsFrom0To1)
{
    blend().across->weights = {0.5, 1};
    samples().across->weight = -0.1;
    const std::string texts = problemsOf(project);
    EXPECT_THAT(texts, HasSubstr("/variations/0/blends/0/across/weights: Weights must lie between 0 and 1"));
    EXPECT_THAT(texts, HasSubstr("/variations/0/samples/0/across/weight: The weight of a blend must be"));
}

TEST_F(VariationSquare, LiesAcrossFromTwoTakes)
{
    samples().to.clear();
    samples().weight = 0;
    EXPECT_THAT(problemsOf(project),
                HasSubstr("/variations/0/samples/0/across: Two takes lie across from one alone"));
}

TEST_F(VariationSquare, SharesNoEdgeWithABlendOfTheSameWeights)
{
    BlendEntry again;
    again.from = "softly again";
    again.to = "softly";
    again.weights = {0.1};
    variation().blends.push_back(again);
    EXPECT_FALSE(hasErrors(validate(project)));
    // Three quarters of the way back are a quarter of the way.
    variation().blends.back().weights = {0.1, 0.75};
    EXPECT_THAT(problemsOf(project),
                HasSubstr("/variations/0/blends/1: “softly again” and “softly” are blended twice"));
}

TEST_F(VariationSquare, FollowsTheNamesOfItsTakes)
{
    renameEntry(project, NamedKind::Sequence, "softly", "gently");
    EXPECT_EQ(blend().across->from, "gently");
    EXPECT_EQ(samples().across->of, "gently");
    EXPECT_EQ(samples().across->to, "softly again");
}

TEST_F(VariationSquare, GoesWithEachOfItsTakes)
{
    for (const char* take : {"talk", "again", "softly", "softly again"}) {
        Project without = fullProject();
        removeEntries(without, NamedKind::Sequence, {take});
        if (without.variations.empty())
            continue;
        EXPECT_TRUE(without.variations.front().blends.empty()) << take;
        EXPECT_TRUE(std::ranges::none_of(without.variations.front().samples, [](const SamplesEntry& each) {
            return each.across.has_value();
        })) << take;
    }
}

// One test, because the models of takes and nodes are learned once for each project.
TEST_F(TubeSquare, IsLearnedAtItsNodesAndBlendedBetweenThem)
{
    learnsTheNodesOfItsGridAndBlendsBetweenThem();
    isTheBlendOfTwoTakesOnItsEdgesAndATakeAtItsCorners();
    movesWithItsWeightsWithoutAJump();
}

TEST_F(TubeSquare, IsMeasuredAgainstTrueBlendsInTheMiddleOfItsCells)
{
    EvaluationEntry evaluation;
    evaluation.table = "cvs-fig7";
    project.evaluations = {evaluation};
    computed(run("evaluations"));
    EXPECT_THAT(column<double>("evaluation/cvs-fig7-means", "weight"),
                ElementsAre(0.25, 0.25, 0.25, 0.25, 0.75, 0.75, 0.75, 0.75));
    EXPECT_THAT(column<double>("evaluation/cvs-fig7-means", "across-weight"),
                ElementsAre(0.25, 0.25, 0.75, 0.75, 0.25, 0.25, 0.75, 0.75));
    // Learned blends between them bring the blends nearer to the true ones.
    const auto nearby = column<double>("evaluation/cvs-fig7-means", "from-nearby");
    const auto takes = column<double>("evaluation/cvs-fig7-means", "from-takes");
    EXPECT_GT(std::ranges::min(nearby), 0);
    EXPECT_LT(std::accumulate(nearby.begin(), nearby.end(), 0.0),
              0.8 * std::accumulate(takes.begin(), takes.end(), 0.0));
}
