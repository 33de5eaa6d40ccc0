// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "tests/model/project/walkproject.h"

#include <gmock/gmock.h>

namespace quadrille {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Le;

class MotionSpaceEvaluations : public test::WalkProject
{
protected:
    MotionSpaceEvaluations()
    {
        addTake("left", {.size = 1.2, .turn = 0.01});
        addTake("right", {.period = 18, .turn = -0.01});
        project.motionSpaces.push_back(spaceOf("turn", {"left", "right"}));
        project.motionSpaces[1].parameters[0].measure = SpaceMeasure::Turning;
    }
    void evaluate(const std::string& table)
    {
        project.evaluations.emplace_back().table = table;
        for (const StepReport& step : run("evaluations").steps)
            EXPECT_NE(step.state, StepState::Failed) << step.error->what();
    }
};

} // namespace

TEST_F(MotionSpaceEvaluations, MeasureBlendsByTheirReferences)
{
    evaluate("ia4d-table1");
    const std::string table = "evaluation/ia4d-table1";
    EXPECT_THAT(column<std::string>(table, "space"),
                ElementsAre("walk", "walk", "walk", "walk", "turn", "turn", "turn", "turn"));
    EXPECT_THAT(column<std::int64_t>(table, "references"), ElementsAre(0, 1, 3, 7, 0, 1, 3, 7));
    const std::vector<double> errors = column<double>(table, "greatest-error");
    const std::vector<std::int64_t> memory = column<std::int64_t>(table, "memory");
    EXPECT_EQ(memory[0], 0);
    for (const std::size_t row : {1U, 2U, 3U, 5U, 6U, 7U}) {
        EXPECT_LT(errors[row], errors[row - 1]) << row;
        EXPECT_GT(memory[row], memory[row - 1]) << row;
    }
}

TEST_F(MotionSpaceEvaluations, MeasureBlendsFromTakeToTake)
{
    evaluate("ia4d-fig4");
    const std::string table = "evaluation/ia4d-fig4";
    const std::vector<double> weights = column<double>(table, "weight");
    const std::vector<double> errors = column<double>(table, "greatest-error");
    const std::vector<std::int64_t> references = column<std::int64_t>(table, "references");
    ASSERT_EQ(weights.size(), 2U * 4 * 21);
    for (std::size_t row = 0; row < weights.size(); ++row) {
        if (weights[row] == 0 || weights[row] == 1) {
            EXPECT_LT(errors[row], 1e-4) << "takes are what they are";
        } else if (weights[row] == 0.5 && references[row] > 0) {
            EXPECT_LT(errors[row], 1e-4) << "the first reference lies there";
        }
    }
}

TEST_F(MotionSpaceEvaluations, CompareTransitions)
{
    evaluate("ia4d-table2");
    const std::string table = "evaluation/ia4d-table2";
    EXPECT_THAT(column<std::string>(table, "source"),
                ElementsAre("walk", "walk", "walk", "walk", "walk", "turn", "turn", "turn", "turn", "turn"));
    const std::vector<double> costs = column<double>(table, "cost");
    EXPECT_LT(costs[0], costs[2]) << "one fixed transition is better than all";
    EXPECT_LT(costs[5], costs[7]);
    EXPECT_EQ(costs[5], column<double>("transitions/turn/walk/report", "cost")[0]);
}

TEST_F(MotionSpaceEvaluations, CompareInterpolatedDistances)
{
    evaluate("ia4d-table3");
    const std::string table = "evaluation/ia4d-table3";
    EXPECT_THAT(column<std::int64_t>(table, "bisections"), ElementsAre(0, 1, 2, 0, 1, 2));
    const std::vector<double> means = column<double>(table, "mean-error");
    EXPECT_GT(means[0], means[1]);
    EXPECT_GT(means[1], means[2]);
    EXPECT_THAT(column<double>(table, "greatest-error"), Each(Le(100)));
}

TEST_F(MotionSpaceEvaluations, WarnWhereThereIsNothingToMeasure)
{
    project.characters = {test::characterOf("tube", "")};
    project.evaluations.emplace_back().table = "ia4d-table2";
    EXPECT_TRUE(validate(project).empty());
    project.motionSpaces.pop_back();
    const ProjectProblems problems = validate(project);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_FALSE(hasErrors(problems));
    EXPECT_THROW(run("evaluations"), Error) << "there is nothing to compute";
}

} // namespace quadrille
