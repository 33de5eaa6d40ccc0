// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/sampling.h"
#include "tests/model/plainalgebra.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Poses of some coordinates that follow the latents smoothly, centred.
struct Taught
{
    LatentLoops loops = latentLoops(2, 20);
    RowMatrix rows;
    Eigen::RowVectorXd mean;

    explicit Taught(Eigen::Index coordinates)
        : rows((loops.state.latents * normals(3, coordinates, 11)).array().sin() * 0.2)
        , mean(normals(1, coordinates, 12))
    {
        rows.rowwise() -= rows.colwise().mean().eval();
    }

    PoseReconstruction reconstruction() const { return {loops.state, rows, mean}; }
};

/// CVS eq. 4 without the noise.
double plainKernel(const GpdmHyperparameters& p, const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b)
{
    return p.alpha1 * std::exp(-p.alpha2 / 2 * (a - b).squaredNorm());
}

/// Mean (without the offset) and covariance over the frames by inverses.
struct PlainReconstruction
{
    RowMatrix means;
    RowMatrix covariance;

    PlainReconstruction(const Taught& taught, const RowMatrix& trajectory)
    {
        const GpdmHyperparameters& p = taught.loops.state.hyperparameters;
        const RowMatrix& X = taught.loops.state.latents;
        const auto kernel = [&](const RowMatrix& a, const RowMatrix& b) {
            Eigen::MatrixXd K(a.rows(), b.rows());
            for (Eigen::Index i = 0; i < a.rows(); ++i)
                for (Eigen::Index j = 0; j < b.rows(); ++j)
                    K(i, j) = plainKernel(p, a.row(i), b.row(j));
            return K;
        };
        const Eigen::MatrixXd K = kernel(X, X) + Eigen::MatrixXd::Identity(X.rows(), X.rows()) / p.alpha3;
        const Eigen::MatrixXd cross = kernel(X, trajectory);
        const Eigen::MatrixXd inverse = inverseOf(K);
        means = cross.transpose() * inverse * taught.rows;
        covariance = kernel(trajectory, trajectory) - cross.transpose() * inverse * cross;
    }
};

} // namespace

// x = 0, y = (2, −1), α₁ = 3, α₂ = 2, α₃ = 1: K = 4, k(z) = 3·e^(−z²).
TEST(PoseReconstruction, solvesOneFrameAsByHand)
{
    const GpdmState state{.latents = RowMatrix::Zero(1, 1),
                          .hyperparameters = {.alpha1 = 3, .alpha2 = 2, .alpha3 = 1}};
    RowMatrix rows(1, 2);
    rows << 2, -1;
    const PoseReconstruction reconstruction(state, rows, Eigen::RowVector2d(10, 20));
    const Eigen::RowVectorXd at = Eigen::RowVectorXd::Constant(1, 0.5);
    const double k = 3 * std::exp(-0.25);
    double pose[2];
    reconstruction.mean(at, pose);
    EXPECT_NEAR(pose[0], 10 + 2 * k / 4, 1e-6); // single precision
    EXPECT_NEAR(pose[1], 20 - k / 4, 1e-6);
    EXPECT_NEAR(reconstruction.variance(at), 3 - k * k / 4, 1e-12);
}

// 37 coordinates and 7 frames fill neither panels nor groups.
TEST(PoseReconstruction, meansAndVariancesAreThoseOfThePlainFormula)
{
    const Taught taught(37);
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix trajectory = taught.loops.state.latents.middleRows(5, 7) + 0.1 * normals(7, 3, 1);
    const PlainReconstruction plain(taught, trajectory);
    const RowMatrix means = reconstruction.means(trajectory);
    ASSERT_EQ(means.cols(), 37);
    EXPECT_LT((means - (plain.means.rowwise() + taught.mean)).cwiseAbs().maxCoeff(), 1e-6);
    std::vector<double> pose(37);
    for (Eigen::Index f = 0; f < 7; ++f) {
        EXPECT_NEAR(reconstruction.variance(trajectory.row(f)), plain.covariance(f, f), 1e-9);
        reconstruction.mean(trajectory.row(f), pose);
        EXPECT_LT((Eigen::Map<const Eigen::RowVectorXd>(pose.data(), 37) - means.row(f)).norm(), 1e-6);
    }
}

TEST(PoseReconstruction, returnsTheTrainingPosesAndItsVarianceGrowsAwayFromThem)
{
    Taught taught(30);
    taught.loops.state.hyperparameters.alpha3 = 1e6;
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix means = reconstruction.means(taught.loops.state.latents);
    // The noise is 1 mm; single precision adds less than 1e-5.
    EXPECT_LT((means - (taught.rows.rowwise() + taught.mean)).cwiseAbs().maxCoeff(), 2e-3);
    const double alpha1 = taught.loops.state.hyperparameters.alpha1;
    EXPECT_LT(reconstruction.variance(taught.loops.state.latents.row(4)), 1e-6);
    EXPECT_NEAR(reconstruction.variance(Eigen::RowVectorXd::Constant(3, 20)), alpha1, 1e-12);
}

// Standard error of a covariance from n draws: √((c_ij² + c_ii·c_jj)/n); five are allowed.
TEST(PoseReconstruction, drawsOfEachCoordinateHaveTheJointCovariance)
{
    const Taught taught(3000);
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix trajectory = taught.loops.state.latents.middleRows(5, 4) + 0.4 * normals(4, 3, 1);
    const RowMatrix expected = PlainReconstruction(taught, trajectory).covariance;
    const RowMatrix from =
        reconstruction.draw(trajectory, 5, PoseDeviation::Coordinates) - reconstruction.means(trajectory);
    const RowMatrix found = from * from.transpose() / 3000;
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = 0; j < 4; ++j) {
            const double c = expected(i, j);
            EXPECT_NEAR(found(i, j), c, 5 * std::sqrt((c * c + expected(i, i) * expected(j, j)) / 3000));
        }
    // Neighbours in time go together.
    EXPECT_GT(expected(0, 1), 0.2 * std::sqrt(expected(0, 0) * expected(1, 1)));
}

// Here coordinates depend on each other, so that many draws take the place of many coordinates.
TEST(PoseReconstruction, drawsInTheTrainingSpanHaveThatVarianceInAllAndStayInTheSpan)
{
    const Taught taught(60);
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix trajectory = taught.loops.state.latents.middleRows(5, 3) + 0.4 * normals(3, 3, 1);
    const RowMatrix means = reconstruction.means(trajectory);
    const RowMatrix expected = PlainReconstruction(taught, trajectory).covariance;
    RowMatrix found = RowMatrix::Zero(3, 3);
    constexpr int draws = 2000;
    for (int i = 0; i < draws; ++i) {
        const RowMatrix from =
            reconstruction.draw(trajectory, static_cast<std::uint64_t>(i), PoseDeviation::TrainingSpan) -
            means;
        found += from * from.transpose() / (60.0 * draws);
        if (i == 0) {
            const RowMatrix weights =
                leastSquares(taught.rows * taught.rows.transpose(), taught.rows * from.transpose());
            EXPECT_LT((taught.rows.transpose() * weights - from.transpose()).norm(), 1e-4 * from.norm());
        }
    }
    EXPECT_LT((found - expected).norm(), 0.1 * expected.norm());
}

TEST(PoseReconstruction, drawsFollowFromTheirSeed)
{
    const Taught taught(25);
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix trajectory = taught.loops.trajectory(0);
    for (const PoseDeviation deviation : {PoseDeviation::Coordinates, PoseDeviation::TrainingSpan}) {
        EXPECT_EQ(reconstruction.draw(trajectory, 1, deviation),
                  reconstruction.draw(trajectory, 1, deviation));
        EXPECT_NE(reconstruction.draw(trajectory, 1, deviation),
                  reconstruction.draw(trajectory, 2, deviation));
    }
}

// All frames alike, no noise to speak of, and a part that does not move at all.
TEST(PoseReconstruction, staysFiniteWithASingularKernel)
{
    Taught taught(12);
    taught.loops.state.latents.setConstant(0.3);
    taught.loops.state.hyperparameters.alpha3 = 1e30;
    taught.rows.setZero();
    const PoseReconstruction reconstruction = taught.reconstruction();
    const RowMatrix trajectory = taught.loops.trajectory(0);
    EXPECT_TRUE(reconstruction.means(trajectory).isApprox(taught.mean.replicate(20, 1)));
    for (const PoseDeviation deviation : {PoseDeviation::Coordinates, PoseDeviation::TrainingSpan})
        EXPECT_LT((reconstruction.draw(trajectory, 1, deviation).rowwise() - taught.mean).norm(), 1e-2);
    EXPECT_TRUE(reconstruction.means(RowMatrix(0, 3)).size() == 0);
}
