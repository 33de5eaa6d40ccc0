// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/plainalgebra.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

using Value = HarmonicField::Value;

std::vector<Value> randomValues(std::size_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Value> values(count);
    for (Value& value : values) {
        for (double& component : value)
            component = number(random);
    }
    return values;
}

/// The cotangent Laplacian, by the angles at the corners.
Eigen::MatrixXd denseLaplacian(const Bar& bar)
{
    const auto size = static_cast<Eigen::Index>(bar.positions.size());
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(size, size);
    for (const Triangle& triangle : bar.topology->triangles()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto here = triangle[c].value;
            const auto a = triangle[(c + 1) % 3].value;
            const auto b = triangle[(c + 2) % 3].value;
            const Vec3d u = (bar.positions[a] - bar.positions[here]).cast<double>();
            const Vec3d v = (bar.positions[b] - bar.positions[here]).cast<double>();
            const double weight = 0.5 * u.dot(v) / u.cross(v).norm();
            laplacian(a, b) -= weight;
            laplacian(b, a) -= weight;
            laplacian(a, a) += weight;
            laplacian(b, b) += weight;
        }
    }
    return laplacian;
}

} // namespace

TEST(HarmonicField, IsThatOfADenseSolve)
{
    const Bar bar = makeBar(9, 2, 1.0F, 0.3F);
    const TransferTarget target(*bar.topology, bar.positions);
    const std::vector<std::size_t> marks{0, 40, 77, 101};
    const std::vector<Value> values = randomValues(marks.size());
    std::vector<double> x;
    HarmonicField(target.harmonic(), marks).solve(values, x);

    Eigen::MatrixXd matrix = denseLaplacian(bar);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(matrix.rows(), 4);
    // The bar is welded already: its vertices are those of the surface, in the order in which faces use them.
    for (std::size_t m = 0; m < marks.size(); ++m) {
        for (const VertexIndex v : bar.topology->triangles()[marks[m]]) {
            matrix.row(v.value).setZero();
            matrix(v.value, v.value) = 1;
            right.row(v.value) = Eigen::RowVector4d::Map(values[m].data());
        }
    }
    const Eigen::MatrixXd expected = solutionOf(matrix, right);
    for (std::uint32_t v = 0; v < bar.positions.size(); ++v) {
        const int row = target.harmonic().rowOf(target.surface().vertices()[v]);
        for (Eigen::Index c = 0; c < 4; ++c)
            EXPECT_NEAR(x[static_cast<std::size_t>(4 * row + c)], expected(v, c), 1e-6) << v;
    }
}

TEST(HarmonicField, StaysWithinWhatIsGiven)
{
    // Slivers: their cotangents are far below zero.
    const Bar bar = makeBar(4, 8, 30.0F, 0.3F);
    const TransferTarget target(*bar.topology, bar.positions);
    std::vector<double> x;
    const std::vector<std::size_t> marks{0, 100, 180};
    const std::vector<Value> values{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
    HarmonicField(target.harmonic(), marks).solve(values, x);
    for (std::size_t i = 0; i + 4 < x.size(); ++i) {
        EXPECT_GE(x[i], -1e-6);
        EXPECT_LE(x[i], 1 + 1e-6);
    }
}

TEST(HarmonicField, SharedCornersHaveTheMean)
{
    const Bar bar = makeBar(5, 2, 1.0F, 0.3F);
    const TransferTarget target(*bar.topology, bar.positions);
    std::vector<double> x;
    HarmonicField(target.harmonic(), std::vector<std::size_t>{0, 1})
        .solve(std::vector<Value>{{2, 0, 0, 0}, {4, 0, 0, 0}}, x);
    const std::vector<Triangle>& triangles = bar.topology->triangles();
    const auto valueAt = [&](VertexIndex v) {
        return x[static_cast<std::size_t>(4 * target.harmonic().rowOf(target.surface().vertices()[v.value]))];
    };
    EXPECT_EQ(triangles[0][0], triangles[1][0]);
    EXPECT_NEAR(valueAt(triangles[0][0]), 3, 1e-6);
    EXPECT_NEAR(valueAt(triangles[0][1]), 2, 1e-6);
    EXPECT_NEAR(valueAt(triangles[1][2]), 4, 1e-6);
}

TEST(HarmonicField, ReachesComponentsWithoutMarksByTheirBridges)
{
    const Bar bars = makeBar(5, 2, 1.0F, 0.3F, true, 2);
    const TransferTarget target(*bars.topology, bars.positions);
    std::vector<double> x;
    HarmonicField(target.harmonic(), std::vector<std::size_t>{3}).solve(std::vector<Value>{{1, 2, 3, 4}}, x);
    for (std::size_t i = 0; i + 4 < x.size(); i += 4) {
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(x[i + c], static_cast<double>(c + 1), 1e-5);
    }
}
