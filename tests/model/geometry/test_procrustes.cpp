// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <random>

using namespace quadrille;

namespace {

class Procrustes : public ::testing::Test
{
protected:
    double normal() { return m_normal(m_engine); }
    Eigen::Matrix3d normalMatrix()
    {
        return Eigen::Matrix3d::NullaryExpr([this] { return normal(); });
    }
    Eigen::Quaterniond turn()
    {
        return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
    }

private:
    std::mt19937 m_engine{5};
    std::normal_distribution<double> m_normal;
};

/// Kabsch: the best rotation by SVD.
Eigen::Matrix3d kabsch(const Eigen::Matrix3d& covariance)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d reflect = Eigen::Matrix3d::Identity();
    reflect(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * reflect * svd.matrixV().transpose();
}

} // namespace

TEST_F(Procrustes, AgreesWithKabschWithoutReflections)
{
    for (int k = 0; k < 2000; ++k) {
        const Eigen::Matrix3d covariance = std::pow(10.0, 6 * normal()) * normalMatrix();
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance);
        const Vec3d sigma = svd.singularValues() / svd.singularValues()[0];
        const double gap = sigma[1] + (covariance.determinant() < 0 ? -1 : 1) * sigma[2];
        const Eigen::Quaterniond q = rotationOfCovariance(covariance);
        EXPECT_NEAR(q.norm(), 1, 1e-14);
        EXPECT_GE(q.w(), 0);
        // Rounding is amplified by what tells the best rotation from the next.
        EXPECT_LT((q.toRotationMatrix() - kabsch(covariance)).norm(), 1e-13 + 1e-14 / std::pow(gap, 2))
            << gap;
    }
}

TEST_F(Procrustes, FindsTheRotationOfFlatAndLongShapes)
{
    for (const Vec3d& extent :
         {Vec3d(1, 1, 0), Vec3d(1, 0.3, 0), Vec3d(1, 1e-3, 1e-3), Vec3d(1, 1e-5, 1e-6), Vec3d(1, 1, 1)}) {
        for (int k = 0; k < 50; ++k) {
            const Eigen::Quaterniond expected = turn();
            const Eigen::Quaterniond pose = turn();
            const Eigen::Matrix3d spread = pose * Eigen::Matrix3d(extent.asDiagonal()) * pose.conjugate();
            const Eigen::Matrix3d covariance = expected * spread;
            EXPECT_LT(rotationOfCovariance(covariance).angularDistance(expected), 1e-9) << extent.transpose();
        }
    }
}

TEST_F(Procrustes, TakesTheSmallestRotationOfALine)
{
    // A line along x that is to point along y: any further turn about y would be as good.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance(1, 0) = 2;
    const Eigen::Quaterniond quarter(Eigen::AngleAxisd(M_PI / 2, Vec3d::UnitZ()));
    EXPECT_LT(rotationOfCovariance(covariance).angularDistance(quarter), 1e-9);
}

TEST_F(Procrustes, DoesNotTurnAPoint)
{
    EXPECT_EQ(rotationOfCovariance(Eigen::Matrix3d::Zero()).coeffs(),
              Eigen::Quaterniond::Identity().coeffs());
    const std::vector<Vec3f> point(3, Vec3f(1, 2, 3));
    const std::vector<Vec3f> target(3, Vec3f(1, 5, 3));
    const RigidMotion motion = rigidProcrustes(point, target);
    EXPECT_EQ(motion.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
    EXPECT_EQ(motion(Vec3d(1, 2, 3)), Vec3d(1, 5, 3));
}

TEST_F(Procrustes, DoesNotTurnEqualPosesAtAll)
{
    const Eigen::Matrix3d half = normalMatrix();
    const Eigen::Matrix3d symmetric = half * half.transpose();
    EXPECT_EQ(rotationOfCovariance((symmetric + symmetric.transpose()) / 2).coeffs(),
              Eigen::Quaterniond::Identity().coeffs());
}

TEST_F(Procrustes, BringsAMovedPoseBack)
{
    const Eigen::Quaterniond rotation = turn();
    const Vec3d translation(3, -1, 2);
    std::vector<Vec3f> moved;
    std::vector<Vec3f> target;
    for (int v = 0; v < 40; ++v) {
        const Vec3d p(normal(), 2 * normal(), 0.5 * normal());
        moved.push_back(p.cast<float>());
        target.push_back((rotation * moved.back().cast<double>() + translation).cast<float>());
    }
    const RigidMotion motion = rigidProcrustes(moved, target);
    EXPECT_LT(motion.rotation.angularDistance(rotation), 1e-7); // rounding of the positions
    for (std::size_t v = 0; v < moved.size(); ++v)
        EXPECT_LT((motion(moved[v].cast<double>()) - target[v].cast<double>()).norm(), 1e-6);
}

TEST_F(Procrustes, CountsVerticesByTheirWeights)
{
    std::vector<Vec3f> moved;
    std::vector<Vec3f> target;
    for (int v = 0; v < 12; ++v) {
        moved.push_back(Vec3d(normal(), normal(), normal()).cast<float>());
        target.push_back(moved.back() + 0.1F * Vec3d(normal(), normal(), normal()).cast<float>());
    }
    // Weights of 1, 2 and 0 are as good as one, two or none of the vertices.
    std::vector<double> weights;
    std::vector<Vec3f> movedAgain;
    std::vector<Vec3f> targetAgain;
    for (std::size_t v = 0; v < moved.size(); ++v) {
        weights.push_back(static_cast<double>(v % 3));
        for (std::size_t i = 0; i < v % 3; ++i) {
            movedAgain.push_back(moved[v]);
            targetAgain.push_back(target[v]);
        }
    }
    const RigidMotion motion = rigidProcrustes(moved, target, weights);
    const RigidMotion expected = rigidProcrustes(movedAgain, targetAgain);
    EXPECT_LT((motion.rotation.coeffs() - expected.rotation.coeffs()).norm(), 1e-12);
    EXPECT_LT((motion.translation - expected.translation).norm(), 1e-12);
}
