// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/posespread.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Takes that are nearer to each other than this share of how far their frames are apart are the same.
constexpr double leastShare = 1e-3;

} // namespace

RowMatrix posesOnParent(const PartTraining& training, const BodyPart& part)
{
    const Eigen::Index coordinates = 3 * std::ssize(part.vertices);
    if (part.overlap.empty())
        return training.rows.leftCols(coordinates);
    RowMatrix rows = training.rows.leftCols(coordinates);
    for (Eigen::Index f = 0; f < rows.rows(); ++f) {
        Eigen::RowVector3d shift = Eigen::RowVector3d::Zero();
        Eigen::Index place = 0;
        for (const VertexIndex vertex : part.vertices) {
            if (std::ranges::binary_search(part.overlap, vertex))
                shift += rows.block<1, 3>(f, 3 * place);
            ++place;
        }
        shift /= static_cast<double>(part.overlap.size());
        for (Eigen::Index v = 0; v < place; ++v)
            rows.block<1, 3>(f, 3 * v) -= shift;
    }
    return rows;
}

PoseSpread::PoseSpread(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
                       std::span<const SpreadGroup> groups, Eigen::Index vertices, const Progress& progress)
    : m_poses(state, RowMatrix(rows.rows(), 0), Eigen::RowVectorXd())
    , m_priorVariance(state.hyperparameters.alpha1)
    , m_gram(gramMatrix(rows.leftCols(3 * vertices), progress))
    , m_vertices(vertices)
{
    for (const SpreadGroup& group : groups)
        addReference(group);
}

PoseSpread::PoseSpread(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
                       std::span<const RowSpan> takes, Eigen::Index vertices, const Progress& progress)
    : PoseSpread(state, rows, std::vector<SpreadGroup>{{1, {takes.begin(), takes.end()}}}, vertices, progress)
{
}

void PoseSpread::addReference(const SpreadGroup& group)
{
    const auto identity = RowMatrix::Identity(m_gram.rows(), m_gram.rows());
    std::vector<PosedTrajectory> captured;
    double ownSquares = 0;
    Eigen::Index frames = 0;
    for (const RowSpan& take : group.takes) {
        captured.push_back({.coefficients = identity.middleRows(take.first, take.count)});
        ownSquares += distanceSquares(captured.back().coefficients);
        frames += take.count;
    }
    const auto values = static_cast<double>(std::max<Eigen::Index>(frames * m_vertices, 1));
    const double own = std::sqrt(ownSquares / values);
    const double apart = between(captured);
    const bool isGuess = apart <= leastShare * own;
    m_isGuess = m_isGuess || isGuess;
    m_reference += group.share * (isGuess ? shareOfOneTake * own : apart);
}

PosedTrajectory PoseSpread::posed(const RowMatrix& trajectory) const
{
    PoseCombination combination = m_poses.combination(trajectory);
    return {.coefficients = std::move(combination.coefficients),
            .uncertainty = combination.variances.maxCoeff() / m_priorVariance};
}

/// Of poses from their mean, summed over poses and vertices.
double PoseSpread::distanceSquares(const RowMatrix& coefficients) const
{
    const RowMatrix apart = coefficients.rowwise() - coefficients.colwise().mean();
    return std::max(0.0, (apart * m_gram).cwiseProduct(apart).sum());
}

double PoseSpread::bending(const PosedTrajectory& trajectory) const
{
    const Eigen::Index bends = trajectory.coefficients.rows() - 2;
    if (bends < 1 || m_vertices == 0)
        return 0;
    const RowMatrix& c = trajectory.coefficients;
    const RowMatrix second = c.bottomRows(bends) - 2 * c.middleRows(1, bends) + c.topRows(bends);
    const double squares = std::max(0.0, (second * m_gram).cwiseProduct(second).sum());
    return std::sqrt(squares / static_cast<double>(bends * m_vertices));
}

double PoseSpread::between(std::span<const PosedTrajectory> trajectories) const
{
    if (trajectories.size() < 2 || m_vertices == 0)
        return 0;
    const Eigen::Index frames = trajectories.front().coefficients.rows();
    RowMatrix poses(std::ssize(trajectories), m_gram.rows());
    double sum = 0;
    for (Eigen::Index f = 0; f < frames; ++f) {
        for (Eigen::Index t = 0; t < poses.rows(); ++t)
            poses.row(t) = trajectories[static_cast<std::size_t>(t)].coefficients.row(f);
        sum += std::sqrt(distanceSquares(poses) / static_cast<double>((poses.rows() - 1) * m_vertices));
    }
    return sum / static_cast<double>(frames);
}

} // namespace quadrille
