// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/latentkernels.h"

#include "model/core/densekernels.h"
#include "model/core/simd.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Row i of the exponents of the kernel.
QUADRILLE_SIMD_CLONES
void exponentRow(const double* points, std::ptrdiff_t stride, Eigen::Index dimensions, Eigen::Index i,
                 Eigen::Index count, double factor, double* row)
{
    std::fill_n(row, count, 0.0);
    for (Eigen::Index c = 0; c < dimensions; ++c) {
        const double* const x = points + c * stride;
        const double own = x[i];
#pragma omp simd
        for (Eigen::Index j = 0; j < count; ++j) {
            const double difference = own - x[j];
            row[j] += factor * (difference * difference);
        }
    }
}

QUADRILLE_SIMD_CLONES
void assembleRow(const double* points, std::ptrdiff_t stride, Eigen::Index dimensions, Eigen::Index i,
                 Eigen::Index count, double radial, double linear, const double* kernel, double* row)
{
#pragma omp simd
    for (Eigen::Index j = 0; j < count; ++j)
        row[j] = radial * kernel[j];
    if (linear == 0)
        return;
    for (Eigen::Index c = 0; c < dimensions; ++c) {
        const double* const x = points + c * stride;
        const double own = linear * x[i];
#pragma omp simd
        for (Eigen::Index j = 0; j < count; ++j)
            row[j] += own * x[j];
    }
}

/// Products of a row of derivative and kernel before the diagonal. \return their sum.
QUADRILLE_SIMD_CLONES
double multiplyRow(const double* derivative, const double* kernel, Eigen::Index count, double* row)
{
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (Eigen::Index j = 0; j < count; ++j) {
        row[j] = derivative[j] * kernel[j];
        sum += row[j];
    }
    return sum;
}

/// One dimension of a row of addRadialGradient. \return Σ_j row_j·(x_i − x_j)².
QUADRILLE_SIMD_CLONES
double radialRow(const double* row, const double* x, Eigen::Index i, double scale, double* gradient)
{
    const double own = x[i];
    double sum = 0;
    double squared = 0;
#pragma omp simd reduction(+ : sum, squared)
    for (Eigen::Index j = 0; j < i; ++j) {
        const double difference = own - x[j];
        const double part = row[j] * difference;
        sum += part;
        squared += part * difference;
        gradient[j] -= scale * part;
    }
    gradient[i] += scale * sum;
    return squared;
}

/// One dimension of a row of addLinearGradient. \return Σ_{j<i} derivative_j·x_j.
QUADRILLE_SIMD_CLONES
double linearRow(const double* derivative, const double* x, Eigen::Index i, double scale, double* gradient)
{
    const double own = scale * x[i];
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (Eigen::Index j = 0; j < i; ++j) {
        sum += derivative[j] * x[j];
        gradient[j] += own * derivative[j];
    }
    return sum;
}

} // namespace

void radialKernel(const DenseMatrix& points, double precision, DenseMatrix& kernel)
{
    for (Eigen::Index i = 0; i < points.columns(); ++i) {
        const Eigen::Index count = DenseMatrix::filled(i + 1);
        exponentRow(points.row(0), points.stride(), points.rows(), i, count, -0.5 * precision, kernel.row(i));
        exponentials({kernel.row(i), static_cast<std::size_t>(count)});
    }
}

void assembleKernel(const DenseMatrix& points, const DenseMatrix& kernel, double radial, double linear,
                    double noise, DenseMatrix& sum)
{
    for (Eigen::Index i = 0; i < points.columns(); ++i) {
        assembleRow(points.row(0), points.stride(), points.rows(), i, DenseMatrix::filled(i + 1), radial,
                    linear, kernel.row(i), sum.row(i));
        sum(i, i) += noise;
    }
}

RadialSums addRadialGradient(const DenseMatrix& points, const DenseMatrix& derivative,
                             const DenseMatrix& kernel, double scale, double precision, double* row,
                             DenseMatrix& gradient)
{
    RadialSums sums;
    for (Eigen::Index i = 0; i < points.columns(); ++i) {
        sums.value += derivative(i, i) + 2 * multiplyRow(derivative.row(i), kernel.row(i), i, row);
        for (Eigen::Index c = 0; c < points.rows(); ++c)
            sums.squared += 2 * radialRow(row, points.row(c), i, -2 * scale * precision, gradient.row(c));
    }
    return sums;
}

double addLinearGradient(const DenseMatrix& points, const DenseMatrix& derivative, double scale,
                         DenseMatrix& gradient)
{
    double sum = 0;
    for (Eigen::Index i = 0; i < points.columns(); ++i) {
        const double* const row = derivative.row(i);
        for (Eigen::Index c = 0; c < points.rows(); ++c) {
            const double* const x = points.row(c);
            const double before = linearRow(row, x, i, 2 * scale, gradient.row(c));
            gradient(c, i) += 2 * scale * (before + row[i] * x[i]);
            sum += x[i] * (2 * before + row[i] * x[i]);
        }
    }
    return sum;
}

} // namespace quadrille
