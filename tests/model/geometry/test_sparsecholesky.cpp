// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/sparsecholesky.h"
#include "tests/model/plainalgebra.h"

#include <gtest/gtest.h>
#include <random>
#include <set>

namespace quadrille {
namespace {

struct Problem
{
    std::vector<std::array<int, 2>> edges;
    Eigen::MatrixXd matrix;
};

/// Diagonally dominant with entries at random places; the edges in random order and direction.
Problem randomProblem(int size, int edgeCount, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> row(0, size - 1);
    std::uniform_real_distribution<double> real(-1, 1);
    Problem problem;
    problem.matrix = Eigen::MatrixXd::Zero(size, size);
    std::set<std::pair<int, int>> seen;
    for (int e = 0; e < edgeCount; ++e) {
        const int a = row(random);
        const int b = row(random);
        if (a == b || !seen.insert({std::min(a, b), std::max(a, b)}).second)
            continue;
        problem.edges.push_back({a, b});
        const double value = real(random);
        problem.matrix(a, b) = problem.matrix(b, a) = value;
        problem.matrix(a, a) += std::abs(value);
        problem.matrix(b, b) += std::abs(value);
    }
    problem.matrix.diagonal().array() += 0.1;
    return problem;
}

/// Solves for columns, by the factorisation under test.
Eigen::MatrixXd solved(const Problem& problem, const Eigen::MatrixXd& right)
{
    const int size = static_cast<int>(problem.matrix.rows());
    const CholeskyPattern pattern(size, problem.edges);
    std::vector<double> values;
    values.resize(static_cast<std::size_t>(size));
    for (int r = 0; r < size; ++r)
        values[static_cast<std::size_t>(pattern.rowOf(r))] = problem.matrix(r, r);
    for (const auto& [a, b] : problem.edges)
        values.push_back(problem.matrix(a, b));
    CholeskyFactor factor;
    factor.factorise(pattern, values);
    const auto columns = static_cast<std::size_t>(right.cols());
    const auto place = [&pattern, columns](int r, Eigen::Index c) {
        return static_cast<std::size_t>(pattern.rowOf(r)) * columns + static_cast<std::size_t>(c);
    };
    std::vector<double> x((static_cast<std::size_t>(size) + 1) * columns, 7.0);
    for (int r = 0; r < size; ++r) {
        for (Eigen::Index c = 0; c < right.cols(); ++c)
            x[place(r, c)] = right(r, c);
    }
    factor.solve(x, columns / CholeskyFactor::lanes);
    Eigen::MatrixXd out(size, right.cols());
    for (int r = 0; r < size; ++r) {
        for (Eigen::Index c = 0; c < right.cols(); ++c)
            out(r, c) = x[place(r, c)];
    }
    EXPECT_EQ(x.back(), 7.0);
    return out;
}

TEST(SparseCholesky, SolvesByHand)
{
    // [4 2; 2 5]: x = (1, 2) from the right side (8, 12).
    Problem problem;
    problem.edges = {{1, 0}};
    problem.matrix.resize(2, 2);
    problem.matrix << 4, 2, 2, 5;
    Eigen::MatrixXd right(2, 4);
    right << 8, 4, 0, 2, 12, 2, 0, 5;
    const Eigen::MatrixXd x = solved(problem, right);
    Eigen::MatrixXd expected(2, 4);
    expected << 1, 1, 0, 0, 2, 0, 0, 1;
    EXPECT_LT((x - expected).norm(), 1e-14);
}

TEST(SparseCholesky, AgreesWithADenseSolver)
{
    // From unconnected rows over sparse to nearly dense.
    for (const auto& [size, edgeCount] :
         {std::pair{1, 0}, {9, 0}, {40, 30}, {60, 120}, {200, 300}, {150, 2000}, {30, 2000}}) {
        for (unsigned seed = 1; seed <= 4; ++seed) {
            const Problem problem = randomProblem(size, edgeCount, seed);
            const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 4);
            const Eigen::MatrixXd expected = test::solutionOf(problem.matrix, right);
            EXPECT_LT((solved(problem, right) - expected).norm() / expected.norm(), 1e-12)
                << size << ", " << edgeCount << ", " << seed;
        }
    }
}

TEST(SparseCholesky, AgreesOnAGrid)
{
    Problem problem;
    const Eigen::Index side = 17;
    problem.matrix = Eigen::MatrixXd::Zero(side * side, side * side);
    const auto link = [&](Eigen::Index a, Eigen::Index b) {
        problem.edges.push_back({static_cast<int>(a), static_cast<int>(b)});
        problem.matrix(a, b) = problem.matrix(b, a) = -1;
        problem.matrix(a, a) += 1;
        problem.matrix(b, b) += 1;
    };
    for (Eigen::Index r = 0; r < side; ++r) {
        for (Eigen::Index c = 0; c < side; ++c) {
            if (c + 1 < side)
                link(r * side + c, r * side + c + 1);
            if (r + 1 < side)
                link(r * side + c, r * side + c + side);
        }
    }
    problem.matrix(0, 0) += 1;
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(side * side, 4);
    const Eigen::MatrixXd expected = test::solutionOf(problem.matrix, right);
    EXPECT_LT((solved(problem, right) - expected).norm() / expected.norm(), 1e-12);
}

TEST(SparseCholesky, SolvesForTwelveAsForThreeTimesFour)
{
    for (const auto& [size, edgeCount] : {std::pair{1, 0}, {9, 0}, {60, 120}, {200, 300}, {150, 2000}}) {
        const Problem problem = randomProblem(size, edgeCount, 1);
        const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 12);
        const Eigen::MatrixXd all = solved(problem, right);
        const Eigen::MatrixXd expected = test::solutionOf(problem.matrix, right);
        EXPECT_LT((all - expected).norm() / expected.norm(), 1e-12) << size;
        for (Eigen::Index c = 0; c < 12; c += 4)
            EXPECT_LT((all.middleCols(c, 4) - solved(problem, right.middleCols(c, 4))).norm(), 1e-12) << size;
    }
}

// Rounding may leave nothing of a pivot that is zero in theory.
TEST(SparseCholesky, EndsOnSingularMatrices)
{
    Problem problem;
    problem.edges = {{0, 1}};
    problem.matrix.resize(2, 2);
    problem.matrix << 1, -1, -1, 1;
    EXPECT_TRUE(solved(problem, Eigen::MatrixXd::Zero(2, 4)).allFinite());
}

} // namespace
} // namespace quadrille
