// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/kernelregression.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace quadrille {

namespace {

constexpr std::int64_t mostFolds = 8;

Eigen::MatrixXd kernelOf(const Eigen::MatrixXd& squaredDistances, double length)
{
    return (squaredDistances.array() / (-2 * length * length)).exp();
}

/// Rows that are left out, and those that stay.
struct Fold
{
    std::vector<Eigen::Index> out;
    std::vector<Eigen::Index> kept;
};

std::vector<Fold> foldsOf(std::span<const std::int64_t> groups)
{
    const auto rows = std::ssize(groups);
    const bool isOne = groups.front() == groups.back();
    const std::int64_t count =
        isOne ? std::min<std::int64_t>(4, rows) : std::min(mostFolds, groups.back() + 1);
    std::vector<Fold> folds(static_cast<std::size_t>(count));
    for (Eigen::Index row = 0; row < rows; ++row) {
        const std::int64_t own = isOne ? row * count / rows : groups[static_cast<std::size_t>(row)] % count;
        for (std::int64_t fold = 0; fold < count; ++fold) {
            Fold& each = folds[static_cast<std::size_t>(fold)];
            (fold == own ? each.out : each.kept).push_back(row);
        }
    }
    std::erase_if(folds, [](const Fold& fold) { return fold.out.empty() || fold.kept.empty(); });
    return folds;
}

/// The length in the middle of all that are tried.
double medianDistance(const Eigen::MatrixXd& squaredDistances)
{
    std::vector<double> all;
    for (Eigen::Index column = 1; column < squaredDistances.cols(); ++column) {
        const auto above = squaredDistances.col(column).head(column);
        std::ranges::copy_if(above, std::back_inserter(all), [](double squared) { return squared > 0; });
    }
    if (all.empty())
        return 0;
    const auto middle = all.begin() + std::ssize(all) / 2;
    std::ranges::nth_element(all, middle);
    return std::sqrt(*middle);
}

/// Half octaves of lengths about a middle one.
std::vector<double> lengthsAbout(double middle)
{
    std::vector<double> lengths;
    for (int step = -6; step <= 6; ++step)
        lengths.push_back(middle * std::exp2(0.5 * step));
    return lengths;
}

/// Two a decade, the least first: of scales that are as good the one that trusts less is taken.
std::vector<double> triedTrusts()
{
    std::vector<double> trusts;
    for (int step = -4; step <= 8; ++step)
        trusts.push_back(std::pow(10, 0.5 * step));
    return trusts;
}

/// The squared error of what is left out, for each trust.
std::vector<double> errorsOf(const Fold& fold, const Eigen::MatrixXd& kernel, const Eigen::MatrixXd& values,
                             std::span<const double> trusts, const Progress& progress)
{
    const Eigen::MatrixXd among = kernel(fold.kept, fold.kept);
    const Eigen::MatrixXd towards = kernel(fold.out, fold.kept);
    const Eigen::MatrixXd known = values(fold.kept, Eigen::all);
    const Eigen::RowVectorXd mean = known.colwise().mean();
    const Eigen::MatrixXd centred = known.rowwise() - mean;
    const Eigen::MatrixXd wanted = values(fold.out, Eigen::all).rowwise() - mean;
    std::vector<double> errors;
    for (const double trust : trusts) {
        progress.report(std::ssize(errors), std::ssize(trusts));
        Eigen::MatrixXd covariance = trust * among;
        covariance.diagonal().array() += 1;
        const Eigen::MatrixXd found = trust * (towards * covariance.llt().solve(centred));
        errors.push_back((found - wanted).squaredNorm());
    }
    return errors;
}

} // namespace

KernelRegression::KernelRegression(const Eigen::MatrixXd& squaredDistances, const Eigen::MatrixXd& values,
                                   const RegressionScale& scale)
    : m_scale(scale), m_mean(values.colwise().mean().transpose())
{
    assert(squaredDistances.rows() == values.rows() && scale.length > 0 && scale.trust >= 0);
    Eigen::MatrixXd covariance = scale.trust * kernelOf(squaredDistances, scale.length);
    covariance.diagonal().array() += 1;
    const Eigen::MatrixXd centred = values.rowwise() - m_mean.transpose();
    m_weights = (scale.trust * covariance.llt().solve(centred)).transpose();
}

Eigen::VectorXd KernelRegression::at(const Eigen::VectorXd& squaredDistances) const
{
    return m_mean + m_weights * kernelOf(squaredDistances, m_scale.length);
}

RegressionScale foundScale(const Eigen::MatrixXd& squaredDistances, const Eigen::MatrixXd& values,
                           std::span<const std::int64_t> groups, const Progress& progress,
                           const Executor& executor)
{
    assert(std::ssize(groups) == values.rows() && std::ranges::is_sorted(groups));
    progress.report(0.0);
    const double middle = medianDistance(squaredDistances);
    const std::vector<Fold> folds = foldsOf(groups);
    if (middle <= 0 || folds.empty() || values.cols() == 0)
        return {};
    const std::vector<double> lengths = lengthsAbout(middle);
    const std::vector<double> trusts = triedTrusts();
    const std::int64_t tasks = std::ssize(lengths) * std::ssize(folds);
    Eigen::MatrixXd errors(std::ssize(trusts), tasks);
    executor.run(makeTasks<double>(
                     tasks,
                     [&](std::int64_t task, const Progress& own) {
                         const double length = lengths[static_cast<std::size_t>(task / std::ssize(folds))];
                         return errorsOf(folds[static_cast<std::size_t>(task % std::ssize(folds))],
                                         kernelOf(squaredDistances, length), values, trusts, own);
                     },
                     [&](std::int64_t task, std::span<const double> each) {
                         std::ranges::copy(each, errors.col(task).begin());
                     }),
                 progress);
    double least = 0;
    for (const Fold& fold : folds) {
        const Eigen::RowVectorXd mean = values(fold.kept, Eigen::all).colwise().mean();
        least += (values(fold.out, Eigen::all).rowwise() - mean).squaredNorm();
    }
    RegressionScale best{.length = middle, .trust = 0};
    for (std::size_t trust = 0; trust < trusts.size(); ++trust) {
        for (std::size_t length = 0; length < lengths.size(); ++length) {
            const double error =
                errors.row(static_cast<Eigen::Index>(trust))
                    .segment(static_cast<Eigen::Index>(length) * std::ssize(folds), std::ssize(folds))
                    .sum();
            if (error < least) {
                least = error;
                best = {lengths[length], trusts[trust]};
            }
        }
    }
    return best;
}

} // namespace quadrille
