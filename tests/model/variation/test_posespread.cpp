// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/posespread.h"
#include "posedloops.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Mean over the frames of the root mean square distance of a vertex from its mean over the runs.
double plainSpread(const std::vector<RowMatrix>& runs)
{
    const auto n = static_cast<double>(runs.size());
    RowMatrix mean = RowMatrix::Zero(runs[0].rows(), runs[0].cols());
    for (const RowMatrix& run : runs)
        mean += run / n;
    double sum = 0;
    for (Eigen::Index f = 0; f < mean.rows(); ++f) {
        double squares = 0;
        for (const RowMatrix& run : runs)
            squares += (run.row(f) - mean.row(f)).squaredNorm();
        sum += std::sqrt(squares / ((n - 1) * static_cast<double>(mean.cols() / 3)));
    }
    return sum / static_cast<double>(mean.rows());
}

/// A vertex that moves along one axis, with six displacements behind it that do not count.
PoseSpread ofOneVertex(const std::vector<double>& heights, std::span<const RowSpan> takes)
{
    const Eigen::Index count = std::ssize(heights);
    RowMatrix rows = RowMatrix::Constant(count, 9, 100);
    GpdmState state{.latents = RowMatrix(count, 1)};
    for (Eigen::Index i = 0; i < count; ++i) {
        rows.row(i).head(3) << 0, heights[static_cast<std::size_t>(i)], 0;
        state.latents(i, 0) = static_cast<double>(i);
        rows(i, 5) = 50 * static_cast<double>(i);
    }
    return {state, rows, takes, 1};
}

} // namespace

TEST(PoseSpread, betweenTakesIsThatOfTheirPoses)
{
    // Two takes of two frames, 0.2 and 0.6 m apart: 0.1 and 0.3 m from their mean.
    const std::vector<RowSpan> takes{{0, 2}, {2, 2}};
    const PoseSpread spread = ofOneVertex({0, 0.1, 0.2, 0.7}, takes);
    EXPECT_NEAR(spread.reference(), std::sqrt(2.0) * 0.2, 1e-12);
}

TEST(PoseSpread, ofOneTakeAndOfTheSameTakesComesFromHowFarItMoves)
{
    // 0.3 m to both sides of the mean.
    const double expected = 0.15 * 0.3;
    const std::vector<RowSpan> one{{0, 2}};
    EXPECT_NEAR(ofOneVertex({0, 0.6}, one).reference(), expected, 1e-12);
    const std::vector<RowSpan> same{{0, 2}, {2, 2}};
    EXPECT_NEAR(ofOneVertex({0, 0.6, 0, 0.6}, same).reference(), expected, 1e-12);
    EXPECT_EQ(ofOneVertex({0.4, 0.4, 0.4, 0.4}, same).reference(), 0);
}

TEST(PoseSpread, betweenTrajectoriesIsThatOfReconstructedPoses)
{
    const PosedLoops posed(3, 20);
    std::vector<RowMatrix> runs;
    std::vector<PosedTrajectory> trajectories;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const RowMatrix trajectory = posed.loops.trajectory(1) + 0.05 * normals(20, 3, seed);
        runs.push_back(posed.reconstruction().means(trajectory));
        trajectories.push_back(posed.poses.posed(trajectory));
    }
    // Poses are summed in single precision there.
    EXPECT_NEAR(posed.poses.between(trajectories), plainSpread(runs), 1e-4 * plainSpread(runs));
    EXPECT_EQ(posed.poses.between(std::span(trajectories).first(1)), 0);
    const std::vector<PosedTrajectory> twice{trajectories[0], trajectories[0]};
    EXPECT_NEAR(posed.poses.between(twice), 0, 1e-9);
}

TEST(PoseSpread, isUnsureWhereNothingWasLearned)
{
    const PosedLoops posed(2, 20);
    const RowMatrix learned = posed.loops.trajectory(0);
    EXPECT_LT(posed.poses.posed(learned).uncertainty, 0.01);
    RowMatrix astray = learned;
    astray.row(7).setConstant(9);
    EXPECT_NEAR(posed.poses.posed(astray).uncertainty, 1, 1e-6);
    const double variance = posed.reconstruction().variance(learned.row(3) * 1.4);
    EXPECT_NEAR(posed.poses.posed(learned.row(3) * 1.4).uncertainty,
                variance / posed.loops.state.hyperparameters.alpha1, 1e-12);
}

// A part of four vertices that moves as a whole, of which three are the overlap: on its parent it only moves
// by what its last vertex does alone, and by what it turns.
TEST(PoseSpread, ofALimbIsThatOnItsParent)
{
    BodyPart part;
    for (std::size_t v = 0; v < 4; ++v)
        part.vertices.emplace_back(v);
    part.overlap = {VertexIndex(0), VertexIndex(1), VertexIndex(2)};
    PartTraining training;
    training.mean = Eigen::RowVectorXd::Constant(12, 0.5);
    training.rows.resize(2, 12);
    const Eigen::RowVector3d move(0.3, -0.2, 0.1);
    for (Eigen::Index v = 0; v < 4; ++v) {
        training.rows.row(0).segment<3>(3 * v) = move;
        training.rows.row(1).segment<3>(3 * v) = v == 3 ? Eigen::RowVector3d(0, 0, 0.1) : -move;
    }
    const RowMatrix rows = posesOnParent(training, part);
    EXPECT_LT(rows.row(0).norm(), 1e-12);
    EXPECT_LT(rows.row(1).head(9).norm(), 1e-12);
    EXPECT_LT((rows.row(1).tail(3) - (Eigen::RowVector3d(0, 0, 0.1) + move)).norm(), 1e-12);
    part.overlap.clear();
    EXPECT_EQ(posesOnParent(training, part), training.rows);
}

TEST(PoseSpread, ofAPartWithoutVerticesIsNone)
{
    const LatentLoops loops = latentLoops(2, 10);
    const PoseSpread spread(loops.state, RowMatrix(20, 0), loops.spans, 0);
    EXPECT_EQ(spread.reference(), 0);
    const std::vector<PosedTrajectory> two{spread.posed(loops.trajectory(0)),
                                           spread.posed(loops.trajectory(1))};
    EXPECT_EQ(spread.between(two), 0);
}
