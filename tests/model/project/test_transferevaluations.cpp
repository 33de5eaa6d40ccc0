// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/transfererrors.h"
#include "model/project/checks/validate.h"
#include "tests/model/project/transferproject.h"

#include <gmock/gmock.h>
#include <numeric>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Lt;

namespace {

/// “slow”, performed by a bent strip of its own mesh: what comes out ought to be “slow” itself.
class TransferEvaluations : public TransferProject
{
protected:
    TransferEvaluations()
    {
        for (int f = 0; f < 14; ++f)
            folder.write("far/f_" + std::to_string(f) + ".obj", bentStrip(0.3 * std::sin(0.35 * f), 5));
        project.sequences.push_back(sequenceOf("far", "far"));
        for (SequenceEntry& sequence : project.sequences)
            sequence.character = sequence.name == "scan" ? "scan" : "strip";
        transfer().target = {"slow", FrameIndex(4)};
        transfer().reference = transfer().target;
        transfer().truth = "sequences/slow";
        project.evaluations.emplace_back().table = "transfer-error";
        project.evaluations.back().character = "strip";
    }

    RebuildReport evaluate() { return run("evaluations"); }
    std::vector<double> values(const std::string& column)
    {
        return this->column<double>("evaluation/transfer-error", column);
    }
};

} // namespace

TEST_F(TransferEvaluations, CompareBothFieldsWithAndWithoutCorrectionWithTheTruth)
{
    EXPECT_THAT(computed(evaluate()), ElementsAre("evaluations/transfer-error/strip"));
    const std::string name = "evaluation/transfer-error";
    EXPECT_THAT(column<std::string>(name, "transfer"),
                ::testing::ElementsAreArray(std::vector<std::string>(16, "slowly")));
    const auto field = column<std::string>(name, "field");
    const auto pose = column<std::string>(name, "pose");
    const auto stretch = column<std::string>(name, "stretch");
    const auto marks = column<std::string>(name, "marks");
    for (std::size_t k = 0; k < 16; ++k) {
        EXPECT_EQ(field[k], k < 8 ? "quaternions" : "logarithms") << k;
        EXPECT_EQ(pose[k], k % 8 < 4 ? "pose corrected" : "pose as it is") << k;
        EXPECT_EQ(stretch[k], k % 4 < 2 ? "stretched" : "turned only") << k;
        EXPECT_EQ(marks[k], k % 2 == 0 ? "surroundings" : "triangles") << k;
    }
    EXPECT_THAT(column<std::int64_t>(name, "frames"), Each(14));
    // All triangles are paired, and they only turn.
    EXPECT_THAT(values("worst-error"), Each(Lt(0.05)));
    EXPECT_THAT(values("mark-error"), Each(Lt(2)));
    EXPECT_THAT(column<std::int64_t>(name + "-frames", "frame").size(), 16 * 14U);
    const auto each = column<double>(name + "-frames", "placed-mean-error");
    EXPECT_NEAR(std::accumulate(each.begin(), each.begin() + 14, 0.0) / 14, values("placed-mean-error")[0],
                1e-12);
}

TEST_F(TransferEvaluations, TellWhereTheBodyIsFromHowItIsPosed)
{
    evaluate();
    const auto own = values("mean-error");
    const auto ownPlaced = values("placed-mean-error");
    transfer().truth = "sequences/far";
    EXPECT_THAT(computed(evaluate()), ElementsAre("evaluations/transfer-error/strip"));
    for (std::size_t kind = 0; kind < own.size(); ++kind) {
        EXPECT_NEAR(values("mean-error")[kind], own[kind], 1e-5);
        EXPECT_LT(ownPlaced[kind], 0.3);
        EXPECT_NEAR(values("placed-mean-error")[kind], 5, ownPlaced[kind] + 1e-5);
    }
}

/// The row of the entry's own settings is what anybody finds who compares the clip with the truth.
TEST_F(TransferEvaluations, MeasureWhatTheTransferMakes)
{
    transfer().field = FieldKind::Logarithms;
    transfer().correctsPose = false;
    transfer().carriesStretch = false;
    transfer().marksSurroundings = false;
    transfer().pairs.resize(3); // the rest is spread
    project.settings.axes.metresPerUnit = 0.01;
    run("transfers");
    evaluate();
    SequenceOpener opened = opener();
    const MeshSequence made = opened.openClip("transfers/slowly")->sequence;
    const MeshSequence slow = opened.open("slow")->sequence;
    TransferErrors all;
    for (FrameIndex f(0); f.value < 14; ++f) {
        const TransferErrors errors = transferErrors(made.frame(f).positions(), slow.frame(f).positions());
        all.moved.mean += errors.moved.mean / 14;
        all.placed.worst = std::max(all.placed.worst, errors.placed.worst);
    }
    constexpr int own = 15;
    EXPECT_GT(all.moved.mean, 0.01);
    EXPECT_NEAR(values("mean-error")[own], all.moved.mean / 100, 1e-8);
    EXPECT_NEAR(values("placed-worst-error")[own], all.placed.worst / 100, 1e-6);
    double height = 0; // of frame 4
    for (int edge = 0; edge < 4; ++edge)
        height += 100 * std::sin(edge * 0.3 * std::sin(0.35 * 4));
    EXPECT_NEAR(values("mean-share")[own], all.moved.mean / height, 1e-5);
    EXPECT_NE(values("mean-error")[own], values("mean-error")[7]) << "the field makes no difference";
}

TEST_F(TransferEvaluations, AreComputedAgainWhereTheTruthOrTheTransferChanges)
{
    transfer().truth = "sequences/far";
    evaluate();
    EXPECT_THAT(computed(evaluate()), IsEmpty());
    folder.write("far/f_3.obj", bentStrip(0.2, 5));
    EXPECT_THAT(computed(evaluate()), ElementsAre("evaluations/transfer-error/strip"));
    transfer().pairs.pop_back();
    EXPECT_THAT(computed(evaluate()), ElementsAre("evaluations/transfer-error/strip"));
    // A truth that is made is made first.
    TransferEntry other = transfer();
    other.name = "other";
    other.truth.clear();
    project.transfers.push_back(other);
    transfer().truth = "transfers/other";
    EXPECT_THAT(computed(evaluate()),
                ElementsAre("transfers/other/clip", "evaluations/transfer-error/strip"));
    EXPECT_NEAR(values("worst-error")[0], 0, 1e-6);
}

TEST_F(TransferEvaluations, SayWhatIsWrong)
{
    transfer().truth = "sequences/quick";
    EXPECT_THAT(failure("evaluations"), HasSubstr("“sequences/quick” has 9 frames, “sequences/slow” has 14"));
    folder.write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    project.sequences.push_back(sequenceOf("other", "other.obj"));
    project.characters.push_back(characterOf("other", ""));
    project.sequences.back().character = "other";
    transfer().truth = "sequences/other";
    EXPECT_THAT(failure("evaluations"), HasSubstr("“sequences/other” is not of the mesh of “slow”"));
    EXPECT_THAT(validate(project), IsEmpty());
    transfer().truth.clear();
    const ProjectProblems problems = validate(project);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems.front().toString(),
                HasSubstr("No transfer of the project says what it ought to be"));
}
