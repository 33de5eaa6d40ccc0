// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The Cholesky factorisations, each beside Eigen's: sparse ones of Laplacians of closed surfaces, as the
// Poisson systems have, and dense ones of kernel matrices, as the latent models have.
#include "model/core/densekernels.h"
#include "model/geometry/poissonsystem.h"
#include "tests/model/transition/bars.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>
#include <map>

using namespace quadrille;

namespace {

using Plain = DenseMatrix::Plain;

using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/// The Laplacian of a bar of some vertices with one of them held, for both factorisations.
struct SparseProblem
{
    std::vector<std::array<int, 2>> edges;
    Eigen::SparseMatrix<double> matrix;
    std::unique_ptr<const CholeskyPattern> pattern;
    std::vector<double> values;

    explicit SparseProblem(int vertices)
    {
        const Bar bar = makeBar(vertices / 40, 10, 2.0F, 0.3F);
        const auto size = static_cast<int>(bar.positions.size());
        std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};
        for (const Triangle& triangle : bar.topology->triangles()) {
            for (std::size_t c = 0; c < 3; ++c) {
                const auto a = static_cast<int>(triangle[c].value);
                const auto b = static_cast<int>(triangle[(c + 1) % 3].value);
                if (a > b)
                    continue; // the other side has it
                edges.push_back({a, b});
                entries.emplace_back(a, a, 1.0);
                entries.emplace_back(b, b, 1.0);
                entries.emplace_back(a, b, -1.0);
                entries.emplace_back(b, a, -1.0);
            }
        }
        matrix.resize(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        pattern = std::make_unique<const CholeskyPattern>(size, edges);
        values.assign(static_cast<std::size_t>(size), 0.0);
        for (int row = 0; row < size; ++row)
            values[static_cast<std::size_t>(pattern->rowOf(row))] = matrix.coeff(row, row);
        values.insert(values.end(), edges.size(), -1.0);
    }
};

const SparseProblem& sparseProblem(const benchmark::State& run)
{
    static std::map<int, SparseProblem> problems;
    const auto size = static_cast<int>(run.range(0));
    return problems.try_emplace(size, size).first->second;
}

void sparsePattern(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    for (auto _ : run)
        benchmark::DoNotOptimize(CholeskyPattern(problem.pattern->size(), problem.edges).rows().data());
}

void sparseFactor(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    CholeskyFactor factor;
    for (auto _ : run)
        factor.factorise(*problem.pattern, problem.values);
}

void sparseSolve(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    CholeskyFactor factor;
    factor.factorise(*problem.pattern, problem.values);
    const auto groups = static_cast<std::size_t>(run.range(1));
    std::vector<double> x(
        static_cast<std::size_t>(problem.pattern->size() + 1) * CholeskyFactor::lanes * groups, 0.1);
    for (auto _ : run) {
        std::vector<double> solution = x;
        factor.solve(solution, groups);
        benchmark::DoNotOptimize(solution.data());
    }
}

void sparsePatternByEigen(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    for (auto _ : run) {
        Solver solver;
        solver.analyzePattern(problem.matrix);
        benchmark::DoNotOptimize(solver.info());
    }
}

void sparseFactorByEigen(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    Solver solver;
    solver.analyzePattern(problem.matrix);
    for (auto _ : run)
        solver.factorize(problem.matrix);
}

/// Three right-hand sides.
void sparseSolveByEigen(benchmark::State& run)
{
    const SparseProblem& problem = sparseProblem(run);
    const Solver solver(problem.matrix);
    const Eigen::MatrixX3d right = Eigen::MatrixX3d::Constant(problem.matrix.rows(), 3, 0.1);
    for (auto _ : run) {
        const Eigen::MatrixX3d solution = solver.solve(right);
        benchmark::DoNotOptimize(solution.data());
    }
}

/// A kernel matrix of positions along a curve, and its factor.
struct DenseProblem
{
    Plain kernel;
    DenseMatrix factor;
    Plain plainFactor;
    DenseMatrix triangle; ///< another lower one
    DenseMatrix triangleResult;

    explicit DenseProblem(Eigen::Index size) : kernel(size, size), triangleResult(size, size)
    {
        for (Eigen::Index i = 0; i < size; ++i)
            for (Eigen::Index j = 0; j < size; ++j)
                kernel(i, j) = std::exp(-0.001 * static_cast<double>((i - j) * (i - j)));
        kernel.diagonal().array() += 1e-3;
        factor = DenseMatrix(kernel);
        factoriseCholesky(factor);
        plainFactor = factor.view();
        triangle = factor;
    }
};

DenseProblem problemOf(const benchmark::State& run)
{
    return DenseProblem(run.range(0));
}

void denseFactor(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const DenseMatrix kernel(problem.kernel);
    for (auto _ : run) {
        DenseMatrix factor = kernel;
        benchmark::DoNotOptimize(factoriseCholesky(factor));
    }
}

void denseFactorByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    for (auto _ : run) {
        const Eigen::LLT<Eigen::MatrixXd> factor(problem.kernel);
        benchmark::DoNotOptimize(factor.matrixLLT().data());
    }
}

void denseInverse(benchmark::State& run)
{
    DenseProblem problem = problemOf(run);
    for (auto _ : run) {
        invertLower(problem.factor, problem.triangleResult);
        benchmark::DoNotOptimize(problem.triangleResult.row(0));
    }
}

void denseInverseByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const Eigen::MatrixXd factor = problem.plainFactor;
    for (auto _ : run) {
        Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(run.range(0), run.range(0));
        factor.triangularView<Eigen::Lower>().solveInPlace(inverse);
        benchmark::DoNotOptimize(inverse.data());
    }
}

/// L⁻¹·B with a number of columns.
void denseSolve(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const DenseMatrix right(Plain::Ones(run.range(0), run.range(1)));
    for (auto _ : run) {
        DenseMatrix x = right;
        solveLower(problem.factor, x);
        benchmark::DoNotOptimize(x.row(0));
    }
}

void denseSolveByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const Eigen::MatrixXd factor = problem.plainFactor;
    const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(run.range(0), run.range(1));
    for (auto _ : run) {
        Eigen::MatrixXd x = right;
        factor.triangularView<Eigen::Lower>().solveInPlace(x);
        benchmark::DoNotOptimize(x.data());
    }
}

void denseProduct(benchmark::State& run)
{
    DenseProblem problem = problemOf(run);
    for (auto _ : run) {
        multiplyLower(problem.factor, problem.triangle, problem.triangleResult);
        benchmark::DoNotOptimize(problem.triangleResult.row(0));
    }
}

void denseProductByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const Eigen::MatrixXd factor = problem.plainFactor;
    const Eigen::MatrixXd other = factor;
    Eigen::MatrixXd product(factor.rows(), factor.cols());
    for (auto _ : run) {
        product.noalias() = factor.triangularView<Eigen::Lower>() * other;
        benchmark::DoNotOptimize(product.data());
    }
}

void denseSquare(benchmark::State& run)
{
    DenseProblem problem = problemOf(run);
    for (auto _ : run) {
        squareLowerTransposed(problem.factor, problem.triangleResult);
        benchmark::DoNotOptimize(problem.triangleResult.row(0));
    }
}

void denseSquareByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const Eigen::MatrixXd factor = problem.plainFactor;
    Eigen::MatrixXd product(factor.rows(), factor.cols());
    for (auto _ : run) {
        product.setZero();
        product.selfadjointView<Eigen::Lower>().rankUpdate(factor.transpose());
        benchmark::DoNotOptimize(product.data());
    }
}

/// AᵀB + BᵀA.
void denseSymmetric(benchmark::State& run)
{
    DenseProblem problem = problemOf(run);
    for (auto _ : run) {
        multiplySymmetric(problem.factor, problem.triangle, problem.triangleResult);
        benchmark::DoNotOptimize(problem.triangleResult.row(0));
    }
}

void denseSymmetricByEigen(benchmark::State& run)
{
    const DenseProblem problem = problemOf(run);
    const Eigen::MatrixXd factor = problem.plainFactor;
    const Eigen::MatrixXd other = factor;
    Eigen::MatrixXd half(factor.rows(), factor.cols());
    for (auto _ : run) {
        // The other half is its transpose.
        half.triangularView<Eigen::Lower>() = factor.transpose() * other;
        half.triangularView<Eigen::Lower>() += other.transpose() * factor;
        benchmark::DoNotOptimize(half.data());
    }
}

void denseExponentials(benchmark::State& run)
{
    std::vector<double> values(static_cast<std::size_t>(run.range(0) * run.range(0)), -1.5);
    for (auto _ : run) {
        std::fill(values.begin(), values.end(), -1.5);
        exponentials(values);
        benchmark::DoNotOptimize(values.data());
    }
}

void denseExponentialsByEigen(benchmark::State& run)
{
    Eigen::ArrayXd values(run.range(0) * run.range(0));
    for (auto _ : run) {
        values.setConstant(-1.5);
        values = values.exp();
        benchmark::DoNotOptimize(values.data());
    }
}

void sparseSizes(benchmark::internal::Benchmark* run)
{
    run->ArgName("vertices")->Arg(3000)->Arg(10000)->Unit(benchmark::kMicrosecond);
}

void denseSizes(benchmark::internal::Benchmark* run)
{
    run->ArgName("frames")->Arg(160)->Arg(200)->Arg(400)->Unit(benchmark::kMicrosecond);
}

void denseSolveSizes(benchmark::internal::Benchmark* run)
{
    run->ArgNames({"frames", "columns"})->Unit(benchmark::kMicrosecond);
    for (const int size : {160, 400})
        for (const int columns : {1, 3, 60})
            run->Args({size, columns});
}

} // namespace

BENCHMARK(sparsePattern)->Apply(sparseSizes);
BENCHMARK(sparsePatternByEigen)->Apply(sparseSizes);
BENCHMARK(sparseFactor)->Apply(sparseSizes);
BENCHMARK(sparseFactorByEigen)->Apply(sparseSizes);
BENCHMARK(sparseSolve)
    ->ArgNames({"vertices", "groups"})
    ->ArgsProduct({{3000, 10000}, {1, 3}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(sparseSolveByEigen)->Apply(sparseSizes);
BENCHMARK(denseFactor)->Apply(denseSizes);
BENCHMARK(denseFactorByEigen)->Apply(denseSizes);
BENCHMARK(denseInverse)->Apply(denseSizes);
BENCHMARK(denseInverseByEigen)->Apply(denseSizes);
BENCHMARK(denseSolve)->Apply(denseSolveSizes);
BENCHMARK(denseSolveByEigen)->Apply(denseSolveSizes);
BENCHMARK(denseProduct)->Apply(denseSizes);
BENCHMARK(denseProductByEigen)->Apply(denseSizes);
BENCHMARK(denseSquare)->Apply(denseSizes);
BENCHMARK(denseSquareByEigen)->Apply(denseSizes);
BENCHMARK(denseSymmetric)->Apply(denseSizes);
BENCHMARK(denseSymmetricByEigen)->Apply(denseSizes);
BENCHMARK(denseExponentials)->Apply(denseSizes);
BENCHMARK(denseExponentialsByEigen)->Apply(denseSizes);
