// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Blends of four takes at the corners of a square.
#include "model/project/references.h"
#include "model/project/validate.h"
#include "tests/model/project/fullproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;

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
        EXPECT_TRUE(without.variations.front().samples.empty()) << take;
    }
}
