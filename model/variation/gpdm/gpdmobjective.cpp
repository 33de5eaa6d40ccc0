// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/core/symmetriceigen.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/gpdm/latentkernels.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// R with G = R·Rᵀ, lower triangular, for a G that is singular as a rule. Its eigenvectors show what of G is
/// rounding: the pivots of a factorisation do not, and entries divided by them grow without a limit.
DenseMatrix triangularRoot(const RowMatrix& gram)
{
    const SymmetricEigen solved = symmetricEigen(gram);
    const Eigen::MatrixXd root = solved.vectors * solved.values.cwiseMax(0).cwiseSqrt().asDiagonal();
    const Eigen::HouseholderQR<Eigen::MatrixXd> triangular(root.transpose());
    const RowMatrix lower = Eigen::MatrixXd(triangular.matrixQR().triangularView<Eigen::Upper>()).transpose();
    return DenseMatrix(lower);
}

/// A kernel matrix, what it is made of and what is made of it.
struct KernelWork
{
    DenseMatrix points; ///< dimensions × positions
    DenseMatrix radial;
    DenseMatrix factor;
    DenseMatrix inverse;  ///< of the factor
    DenseMatrix gradient; ///< by the points

    void resize(Eigen::Index dimensions, Eigen::Index count)
    {
        if (points.rows() == dimensions && points.columns() == count)
            return;
        points = DenseMatrix(dimensions, count);
        gradient = points;
        radial = DenseMatrix(count, count);
        factor = radial;
        inverse = radial;
    }

    /// Factorises; where rounding forbids it, with the least addition to the diagonal that helps.
    /// \return the addition as a share of the mean diagonal; infinity where nothing helps.
    double factorise(double precision, double scale, double linear, double noise)
    {
        constexpr double least = 1e-14;
        constexpr double greatest = 1e-4;
        radialKernel(points, precision, radial);
        assembleKernel(points, radial, scale, linear, noise, factor);
        if (factoriseCholesky(factor))
            return 0;
        const double diagonal =
            scale + noise + linear * points.view().squaredNorm() / static_cast<double>(points.columns());
        for (double share = least; share <= greatest * 2; share *= 10) {
            assembleKernel(points, radial, scale, linear, noise + share * diagonal, factor);
            if (factoriseCholesky(factor))
                return share;
        }
        return std::numeric_limits<double>::infinity();
    }
};

/// Σ ln of the hyperparameters.
double logSum(const GpdmHyperparameters& h)
{
    return std::log(h.alpha1) + std::log(h.alpha2) + std::log(h.alpha3) + std::log(h.beta1) +
           std::log(h.beta2) + std::log(h.beta3) + std::log(h.beta4);
}

} // namespace

struct GpdmObjective::Work
{
    Eigen::Index frames = 0;
    Eigen::Index coordinates = 0;
    std::vector<RowSpan> spans;
    std::vector<Eigen::Index> inputs; ///< frames that another one follows
    DenseMatrix root;                 ///< of the Gram matrix
    KernelWork pose;
    KernelWork dynamics;
    DenseMatrix projected; ///< L⁻¹·R
    DenseMatrix half;      ///< see poseGradient
    DenseMatrix derivative;
    DenseMatrix product;
    DenseMatrix next;    ///< frames that follow the inputs
    DenseMatrix weights; ///< K_X⁻¹·next
    DenseMatrix linearGradient;
    std::vector<double> row;
    double jitter = 0;
    double poseWeight = 1;
    double unweighted = 0;

    void load(const RowMatrix& latents);
    double poseValue(const GpdmHyperparameters& h);
    double dynamicsValue(const GpdmHyperparameters& h);
    void poseGradient(const GpdmHyperparameters& h, Gradient& gradient);
    void dynamicsGradient(const GpdmHyperparameters& h, Gradient& gradient);
};

void GpdmObjective::Work::load(const RowMatrix& latents)
{
    const Eigen::Index dimensions = latents.cols();
    const auto count = static_cast<Eigen::Index>(inputs.size());
    pose.resize(dimensions, frames);
    dynamics.resize(dimensions, count);
    if (next.rows() != count || next.columns() != dimensions)
        next = DenseMatrix(count, dimensions);
    pose.points.view() = latents.transpose();
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Index frame = inputs[static_cast<std::size_t>(i)];
        dynamics.points.view().col(i) = latents.row(frame).transpose();
        next.view().row(i) = latents.row(frame + 1);
    }
}

double GpdmObjective::Work::poseValue(const GpdmHyperparameters& h)
{
    jitter = std::max(jitter, pose.factorise(h.alpha2, h.alpha1, 0, 1 / h.alpha3));
    if (!std::isfinite(jitter))
        return jitter;
    invertLower(pose.factor, pose.inverse);
    multiplyLower(pose.inverse, root, projected);
    const double trace = projected.view().squaredNorm();
    return 0.5 * (static_cast<double>(coordinates) * logDeterminant(pose.factor) + trace);
}

double GpdmObjective::Work::dynamicsValue(const GpdmHyperparameters& h)
{
    jitter = std::max(jitter, dynamics.factorise(h.beta2, h.beta1, h.beta3, 1 / h.beta4));
    if (!std::isfinite(jitter))
        return jitter;
    weights = next;
    solveLower(dynamics.factor, weights);
    const double trace = weights.view().squaredNorm();
    return 0.5 * (static_cast<double>(next.columns()) * logDeterminant(dynamics.factor) + trace);
}

/// With V = L⁻¹ and Q = V·R the derivative by K_Y is ½·(D·K⁻¹ − K⁻¹GK⁻¹) = Vᵀ·S·V, S = ½·(D − Q·Qᵀ). Let T be
/// the lower triangle of S with half its diagonal: Vᵀ·S·V = Vᵀ·(T·V) + (T·V)ᵀ·V, products of triangles only.
void GpdmObjective::Work::poseGradient(const GpdmHyperparameters& h, Gradient& gradient)
{
    squareLower(projected, half);
    for (Eigen::Index i = 0; i < half.filledRows(); ++i) {
        double* const values = half.row(i);
        for (Eigen::Index j = 0; j < i; ++j)
            values[j] *= -0.5 * poseWeight;
        values[i] = 0.25 * poseWeight * (static_cast<double>(coordinates) - values[i]);
        std::fill(values + i + 1, values + half.filledColumns(), 0.0);
    }
    multiplyLower(half, pose.inverse, product);
    multiplySymmetric(pose.inverse, product, derivative);

    pose.gradient.view().setZero();
    const RadialSums sums = addRadialGradient(pose.points, derivative, pose.radial, h.alpha1, h.alpha2,
                                              row.data(), pose.gradient);
    gradient.latents = pose.gradient.view().transpose();
    gradient.hyperparameters.alpha1 = sums.value + 1 / h.alpha1;
    gradient.hyperparameters.alpha2 = -0.5 * h.alpha1 * sums.squared + 1 / h.alpha2;
    gradient.hyperparameters.alpha3 =
        -derivative.view().diagonal().sum() / (h.alpha3 * h.alpha3) + 1 / h.alpha3;
}

void GpdmObjective::Work::dynamicsGradient(const GpdmHyperparameters& h, Gradient& gradient)
{
    solveLowerTransposed(dynamics.factor, weights);
    invertLower(dynamics.factor, dynamics.inverse);
    DenseMatrix& byKernel = dynamics.factor; // not needed any more
    squareLowerTransposed(dynamics.inverse, byKernel);
    const Eigen::Index dimensions = next.columns();
    for (Eigen::Index i = 0; i < byKernel.rows(); ++i) {
        double* const values = byKernel.row(i);
        for (Eigen::Index j = 0; j <= i; ++j) {
            double outer = 0;
            for (Eigen::Index c = 0; c < dimensions; ++c)
                outer += weights(i, c) * weights(j, c);
            values[j] = 0.5 * (static_cast<double>(dimensions) * values[j] - outer);
        }
    }

    dynamics.gradient.view().setZero();
    const RadialSums sums = addRadialGradient(dynamics.points, byKernel, dynamics.radial, h.beta1, h.beta2,
                                              row.data(), dynamics.gradient);
    const double linear = addLinearGradient(dynamics.points, byKernel, h.beta3, dynamics.gradient);
    for (Eigen::Index i = 0; i < byKernel.rows(); ++i) {
        const Eigen::Index frame = inputs[static_cast<std::size_t>(i)];
        gradient.latents.row(frame) += dynamics.gradient.view().col(i).transpose();
        gradient.latents.row(frame + 1) += weights.view().row(i);
    }
    gradient.hyperparameters.beta1 = sums.value + 1 / h.beta1;
    gradient.hyperparameters.beta2 = -0.5 * h.beta1 * sums.squared + 1 / h.beta2;
    gradient.hyperparameters.beta3 = linear + 1 / h.beta3;
    gradient.hyperparameters.beta4 = -byKernel.view().diagonal().sum() / (h.beta4 * h.beta4) + 1 / h.beta4;
}

GpdmObjective::GpdmObjective(const RowMatrix& gram, Eigen::Index coordinates, std::span<const RowSpan> spans)
    : m_work(std::make_unique<Work>())
{
    Work& work = *m_work;
    work.frames = gram.rows();
    work.coordinates = coordinates;
    work.spans.assign(spans.begin(), spans.end());
    for (const RowSpan& span : spans)
        for (Eigen::Index frame = span.first; frame < span.last(); ++frame)
            work.inputs.push_back(frame);
    work.root = triangularRoot(gram);
    work.projected = DenseMatrix(work.frames, work.frames);
    work.half = work.projected;
    work.product = work.projected;
    work.derivative = work.projected;
    work.row.resize(static_cast<std::size_t>(work.frames));
}

GpdmObjective::~GpdmObjective() = default;

double GpdmObjective::jitter() const
{
    return m_work->jitter;
}

void GpdmObjective::setPoseWeight(double weight)
{
    m_work->poseWeight = weight;
}

double GpdmObjective::unweighted() const
{
    return m_work->unweighted;
}

double GpdmObjective::value(const GpdmState& state)
{
    Work& work = *m_work;
    work.jitter = 0;
    work.load(state.latents);
    double firsts = 0;
    for (const RowSpan& span : work.spans)
        firsts += state.latents.row(span.first).squaredNorm();
    const double poses = work.poseValue(state.hyperparameters);
    const double others =
        work.dynamicsValue(state.hyperparameters) + 0.5 * firsts + logSum(state.hyperparameters);
    work.unweighted = poses + others;
    return work.poseWeight * poses + others;
}

double GpdmObjective::value(const GpdmState& state, Gradient& gradient)
{
    const double result = value(state);
    if (!std::isfinite(result)) {
        gradient.latents.setZero(state.latents.rows(), state.latents.cols());
        gradient.hyperparameters = {0, 0, 0, 0, 0, 0, 0};
        return result;
    }
    m_work->poseGradient(state.hyperparameters, gradient);
    m_work->dynamicsGradient(state.hyperparameters, gradient);
    for (const RowSpan& span : m_work->spans)
        gradient.latents.row(span.first) += state.latents.row(span.first);
    return result;
}

} // namespace quadrille
