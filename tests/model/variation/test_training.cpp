// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/training.h"
#include "tests/model/codeof.h"
#include "tests/model/variation/swayingtakes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

using test::strideAt;
using test::swayedTube;

AlignedTake takeOf(int frames, double start)
{
    AlignedTake take{.name = "take", .warp = {}, .poses = {}, .placements = {}};
    for (int f = 0; f < frames; ++f) {
        const std::vector<Vec3f> pose = swayedTube(start + 0.2 * f);
        take.poses.insert(take.poses.end(), pose.begin(), pose.end());
        take.placements.push_back(strideAt(f + static_cast<int>(10 * start)));
    }
    return take;
}

BodyPart partOf(std::initializer_list<unsigned> vertices, int parent)
{
    BodyPart part{.name = "part", .parent = parent};
    for (const unsigned vertex : vertices)
        part.vertices.emplace_back(vertex);
    return part;
}

double variance(const RowMatrix& columns)
{
    return (columns.rowwise() - columns.colwise().mean()).squaredNorm() / static_cast<double>(columns.rows());
}

TEST(Displacements, OfAQuarterTurnAndAStepAreAsWorkedOutByHand)
{
    const Eigen::Quaterniond quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3d::UnitY()));
    const std::vector<RigidMotion> placements = {{quarter, {1, 0, 0}}, {quarter * quarter, {1, 0, -2}}};
    const std::vector<Displacement> displacements = displacementsOf(placements);
    ASSERT_EQ(displacements.size(), 2U);
    EXPECT_EQ(displacements[0], displacements[1]);
    // −z of the world is x of a frame that is turned by a quarter about y.
    const Displacement expected = {2, 0, 0, 0, std::numbers::pi / 2, 0};
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(displacements[0][k], expected[k], 1e-12);
}

TEST(Displacements, LeadBackToThePlacements)
{
    std::vector<RigidMotion> placements;
    for (int f = 0; f < 40; ++f)
        placements.push_back(strideAt(f));
    // Turns of nearly half a circle, and none.
    placements.push_back(
        {placements.back().rotation * Eigen::AngleAxisd(3.1415, Vec3d(1, 2, 3).normalized()), {0, 1, 2}});
    placements.push_back(placements.back());
    const std::vector<RigidMotion> again = integrated(displacementsOf(placements), placements.front());
    ASSERT_EQ(again.size(), placements.size());
    for (std::size_t f = 0; f < again.size(); ++f) {
        EXPECT_LT((again[f].translation - placements[f].translation).norm(), 1e-6);
        EXPECT_LT(again[f].rotation.angularDistance(placements[f].rotation), 1e-6);
    }
}

TEST(Displacements, DoNotDependOnWhereATakeBegins)
{
    std::vector<RigidMotion> placements;
    std::vector<RigidMotion> elsewhere;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2, Vec3d(1, 3, -1).normalized()));
    for (int f = 0; f < 10; ++f) {
        placements.push_back(strideAt(f));
        elsewhere.push_back(
            {turn * placements.back().rotation, turn * placements.back().translation + Vec3d(5, -2, 7)});
    }
    const auto a = displacementsOf(placements);
    const auto b = displacementsOf(elsewhere);
    for (std::size_t f = 0; f < a.size(); ++f) {
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(a[f][k], b[f][k], 1e-12);
    }
}

TEST(PartTraining, StacksVerticesOfAllTakesCentred)
{
    const std::vector<AlignedTake> takes = {takeOf(6, 0), takeOf(6, 1)};
    const BodyPart part = partOf({3, 10, 55}, 0);
    const PartTraining training = partTraining(takes, part);
    ASSERT_EQ(training.rows.rows(), 12);
    ASSERT_EQ(training.rows.cols(), 9);
    EXPECT_TRUE(training.blocks.empty());
    EXPECT_EQ(training.spans, (std::vector<RowSpan>{{0, 6}, {6, 6}}));
    EXPECT_LT(training.rows.colwise().mean().norm(), 1e-12);
    for (Eigen::Index row = 0; row < 12; ++row) {
        const Eigen::RowVectorXd vector = training.rows.row(row) + training.mean;
        std::vector<Vec3f> out(3);
        partPose({vector.data(), 9}, out);
        const AlignedTake& take = takes[static_cast<std::size_t>(row / 6)];
        for (std::size_t v = 0; v < 3; ++v)
            EXPECT_EQ(out[v], take.pose(static_cast<std::size_t>(row % 6))[part.vertices[v].value]);
    }
}

TEST(PartTraining, GivesDisplacementsTheShareThatWasAskedFor)
{
    const std::vector<AlignedTake> takes = {takeOf(9, 0), takeOf(9, 2)};
    const BodyPart root = partOf({0, 7, 20, 21, 40}, -1);
    for (const double share : {6.0, 0.5}) {
        const PartTraining training = partTraining(takes, root, share);
        ASSERT_EQ(training.rows.cols(), 21);
        EXPECT_NEAR(variance(training.rows.rightCols(6)), share * variance(training.rows.leftCols(15)) / 15,
                    1e-9);
        const Displacement found =
            partDisplacements(training.rows.row(12) + training.mean, training, {}).front();
        const Displacement expected = displacementsOf(takes[1].placements)[3];
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(found[k], expected[k], 1e-12);
    }
}

// Two takes go the same way, the second as the reference does, the first in jerks: what is learned is how far
// they go in a frame of their own.
TEST(PartTraining, LearnsDisplacementsInTheTakesOwnTime)
{
    std::vector<AlignedTake> takes = {takeOf(9, 0), takeOf(9, 0)};
    TakeWarp& warp = takes[0].warp;
    for (const double position : {0.0, 0.25, 0.5, 2.5, 4.0, 4.125, 6.0, 7.0, 8.0})
        warp.positions.push_back(position);
    for (std::size_t t = 0; t < 2; ++t) {
        for (std::size_t f = 0; f < 9; ++f) {
            const double time = t == 0 ? warp.positions[f] : static_cast<double>(f);
            takes[t].placements[f] = {Eigen::Quaterniond::Identity(), Vec3d(0.02 * time, 0, 0)};
        }
    }
    const PartTraining training = partTraining(takes, partOf({0, 7, 20, 21, 40}, -1));
    EXPECT_LT((training.rows.topRightCorner(9, 6) - training.rows.bottomRightCorner(9, 6)).norm(), 1e-9);
    const RowMatrix vectors = training.rows.topRows(9).rowwise() + training.mean;
    const std::vector<Displacement> found = partDisplacements(vectors, training, warp);
    const std::vector<Displacement> expected = displacementsOf(takes[0].placements);
    for (std::size_t f = 0; f < 9; ++f)
        EXPECT_NEAR(found[f][0], expected[f][0], 1e-12) << f;
}

TEST(PartTraining, GivesEachKindOfCoefficientsItsShare)
{
    std::vector<AlignedTake> takes = {takeOf(9, 0), takeOf(9, 2)};
    for (AlignedTake& take : takes)
        take.coefficients = {RowMatrix::Random(9, 4) * 100, RowMatrix::Random(9, 1)};
    const BodyPart root = partOf({0, 7, 20, 21, 40}, -1);
    const std::vector<CoefficientKind> kinds{{"texture", 2}, {"warp", 0.5}};
    const PartTraining training = partTraining(takes, root, 6, kinds);
    ASSERT_EQ(training.rows.cols(), 15 + 6 + 4 + 1);
    const double coordinate = variance(training.rows.leftCols(15)) / 15;
    EXPECT_NEAR(variance(training.rows.middleCols(21, 4)), 2 * coordinate, 1e-9);
    EXPECT_NEAR(variance(training.rows.rightCols(1)), 0.5 * coordinate, 1e-9);
    const RowMatrix whole = training.rows.rowwise() + training.mean;
    ASSERT_EQ(training.blocks.size(), 3U);
    EXPECT_EQ(training.blocks[0].name, displacementBlock);
    EXPECT_EQ(training.blocks[2].name, "warp");
    EXPECT_LT((blockValues(whole, training.blocks[1]).bottomRows(9) - takes[1].coefficients[0]).norm(), 1e-9);
    EXPECT_LT((blockValues(whole, training.blocks[2]).topRows(9) - takes[0].coefficients[1]).norm(), 1e-9);
    // Other parts learn their vertices alone, and without kinds nothing is changed.
    EXPECT_TRUE(partTraining(takes, partOf({3}, 0), 6, kinds).blocks.empty());
    EXPECT_LT((partTraining(takes, root).rows - training.rows.leftCols(21)).norm(), 1e-12);
}

TEST(PartTraining, ScalesByOneWhereNothingMoves)
{
    AlignedTake still = takeOf(4, 0);
    still.placements.assign(4, RigidMotion());
    EXPECT_EQ(partTraining(std::span(&still, 1), partOf({0, 1}, -1)).blocks.front().scale, 1);
}

TEST(PartTraining, RefusesWhatItCannotLearnFrom)
{
    const AlignedTake take = takeOf(4, 0);
    const BodyPart root = partOf({0}, -1);
    EXPECT_EQ(test::codeOf([&] { partTraining({}, root); }), ErrorCode::BadArgument);
    EXPECT_EQ(test::codeOf([&] { partTraining(std::span(&take, 1), root, 0); }), ErrorCode::BadArgument);
    const std::vector<CoefficientKind> kinds{{"texture", -1}};
    EXPECT_EQ(test::codeOf([&] { partTraining(std::span(&take, 1), root, 6, kinds); }),
              ErrorCode::BadArgument);
}

} // namespace
} // namespace quadrille
