// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/poseinterpolation.h"

#include "model/core/error.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>

namespace quadrille {

namespace {

constexpr std::size_t lanes = CholeskyFactor::lanes;

void checkVertexCount(const PoissonSystem& system, Positions positions)
{
    if (positions.size() != system.vertexCount()) {
        throw Error(ErrorCode::VertexCountMismatch, {{},
                                                     {},
                                                     {{"expected", std::to_string(system.vertexCount())},
                                                      {"found", std::to_string(positions.size())}}});
    }
}

/// Part of a rotation by at most 180 degrees.
Eigen::Quaterniond partOf(const Eigen::Quaterniond& rotation, double lambda)
{
    const double sine = rotation.vec().norm();
    if (sine == 0)
        return Eigen::Quaterniond::Identity();
    const double sign = rotation.w() < 0 ? -1 : 1;
    const double angle = lambda * std::atan2(sine, sign * rotation.w());
    Eigen::Quaterniond part;
    part.w() = std::cos(angle);
    part.vec() = rotation.vec() * (sign * std::sin(angle) / sine);
    return part;
}

/// Σ x·yᵀ over the vertices in use, x of the target, y of the source, both centred.
Eigen::Matrix3d covariance(const PreparedPose& target, const PreparedPose& source)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    const std::vector<std::int32_t>& components = source.system().topology().components();
    for (std::size_t v = 0; v < components.size(); ++v) {
        if (components[v] < 0)
            continue;
        const Vec3d x = target.positions()[v].cast<double>() - target.centre();
        const Vec3d y = source.positions()[v].cast<double>() - source.centre();
        sum.noalias() += x * y.transpose();
    }
    return sum;
}

} // namespace

PreparedPose::PreparedPose(std::shared_ptr<const PoissonSystem> system, Positions positions)
    : m_system((checkVertexCount(*system, positions), std::move(system)))
    , m_positions(positions.begin(), positions.end())
    , m_frames(poseFrames(m_system->topology().triangles(), positions))
    , m_poisson(*m_system, m_frames)
    , m_componentCentres(m_system->componentSizes().size(), Vec3d::Zero())
{
    const std::vector<std::int32_t>& components = m_system->topology().components();
    for (std::size_t v = 0; v < components.size(); ++v) {
        if (components[v] >= 0)
            m_componentCentres[static_cast<std::size_t>(components[v])] += positions[v].cast<double>();
    }
    double used = 0;
    for (std::size_t c = 0; c < m_componentCentres.size(); ++c) {
        m_centre += m_componentCentres[c];
        used += m_system->componentSizes()[c];
        m_componentCentres[c] /= m_system->componentSizes()[c];
    }
    m_centre /= used;
}

/// From the source's coordinates, with its centre at the origin, to those of the result.
struct PoseInterpolation::Placement
{
    Eigen::Matrix3d rotation;
    Vec3d centre;
};

PoseInterpolation::PoseInterpolation(std::shared_ptr<const PreparedPose> source,
                                     std::shared_ptr<const PreparedPose> target)
    : m_source(std::move(source)), m_target(std::move(target))
{
    assert(&m_source->system() == &m_target->system());
    m_rotation = rotationOfCovariance(covariance(*m_target, *m_source));
    m_logs = triangleLogs(m_source->frames(), m_target->frames(), m_rotation);
    std::ranges::set_union(m_source->frames().degenerate, m_target->frames().degenerate,
                           std::back_inserter(m_degenerate));
    borrowRotations(m_source->system(), m_degenerate, m_logs);
    chooseBranches(m_source->system(), m_logs);
}

std::vector<TriangleEdges> PoseInterpolation::deformedEdges(double lambda, InterpolationMethod method) const
{
    std::vector<TriangleEdges> edges(m_logs.size());
    deformEdges(m_source->frames(), m_logs, lambda,
                method == InterpolationMethod::Slerp ? StretchPath::Linear : StretchPath::Geodesic, edges);
    // Triangles without area turn with their neighbours; their edges go straight otherwise.
    for (const int index : m_degenerate) {
        const auto m = static_cast<std::size_t>(index);
        const Vec3d axis(m_logs.axisX[m], m_logs.axisY[m], m_logs.axisZ[m]);
        const auto turnedBy = [&](double part) {
            const Eigen::AngleAxisd turn(2 * part * m_logs.halfAngle[m], axis);
            return axis.isZero() ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(turn);
        };
        const Eigen::Quaterniond turn = turnedBy(lambda);
        const Eigen::Quaterniond back = (m_rotation * turnedBy(1)).conjugate();
        const Triangle& triangle = m_source->system().topology().triangles()[m];
        const auto edge = [&](const PreparedPose& pose, std::size_t corner) -> Vec3d {
            return (pose.positions()[triangle[corner].value] - pose.positions()[triangle[2].value])
                .cast<double>();
        };
        const auto deformed = [&](std::size_t corner) -> Vec3d {
            return turn *
                   ((1 - lambda) * edge(*m_source, corner) + lambda * (back * edge(*m_target, corner)));
        };
        Vec3d::Map(edges[m].first.data()) = deformed(0);
        Vec3d::Map(edges[m].second.data()) = deformed(1);
    }
    return edges;
}

void PoseInterpolation::place(const Placement& placement, double lambda,
                              std::span<const std::vector<double>> solutions, std::span<const double> weights,
                              MutablePositions out) const
{
    const PoissonSystem& system = m_source->system();
    const std::vector<std::int32_t>& components = system.topology().components();
    const auto solved = [&](std::size_t v) {
        const std::size_t row = static_cast<std::size_t>(system.rows()[v]) * lanes;
        Vec3d sum = Vec3d::Zero();
        for (std::size_t s = 0; s < solutions.size(); ++s)
            sum += weights[s] * Vec3d::Map(solutions[s].data() + row);
        return sum;
    };
    const Eigen::Matrix3d back = m_rotation.conjugate().toRotationMatrix();
    const auto between = [&](const Vec3d& source, const Vec3d& target) -> Vec3d {
        return (1 - lambda) * (source - m_source->centre()) + lambda * (back * (target - m_target->centre()));
    };
    std::vector<Vec3d> shifts(m_source->componentCentres().size(), Vec3d::Zero());
    for (std::size_t v = 0; v < components.size(); ++v) {
        if (components[v] >= 0)
            shifts[static_cast<std::size_t>(components[v])] += solved(v);
    }
    for (std::size_t c = 0; c < shifts.size(); ++c) {
        shifts[c] = between(m_source->componentCentres()[c], m_target->componentCentres()[c]) -
                    shifts[c] / system.componentSizes()[c];
    }
    for (std::size_t v = 0; v < components.size(); ++v) {
        const Vec3d local =
            components[v] >= 0
                ? Vec3d(solved(v) + shifts[static_cast<std::size_t>(components[v])])
                : between(m_source->positions()[v].cast<double>(), m_target->positions()[v].cast<double>());
        out[v] = (placement.rotation * local + placement.centre).cast<float>();
    }
}

void PoseInterpolation::at(double lambda, MutablePositions out, InterpolationMethod method,
                           const RigidMotion& placeSource, const RigidMotion& placeTarget) const
{
    assert(lambda >= 0 && lambda <= 1 && out.size() == m_source->positions().size());
    const auto placed = [](const RigidMotion& motion, const Vec3f& position) {
        return motion(position.cast<double>());
    };
    if (lambda == 0 || lambda == 1 || method == InterpolationMethod::Linear) {
        for (std::size_t v = 0; v < out.size(); ++v) {
            Vec3d sum = Vec3d::Zero();
            if (lambda < 1)
                sum += (1 - lambda) * placed(placeSource, m_source->positions()[v]);
            if (lambda > 0)
                sum += lambda * placed(placeTarget, m_target->positions()[v]);
            out[v] = sum.cast<float>();
        }
        return;
    }
    const std::vector<TriangleEdges> edges = deformedEdges(lambda, method);
    std::array<std::vector<double>, 2> solutions;
    m_source->poisson().solve(edges, solutions[0]);
    m_target->poisson().solve(edges, solutions[1]);
    const Eigen::Quaterniond turn = placeTarget.rotation * m_rotation * placeSource.rotation.conjugate();
    const Placement placement{(partOf(turn, lambda) * placeSource.rotation).toRotationMatrix(),
                              (1 - lambda) * placeSource(m_source->centre()) +
                                  lambda * placeTarget(m_target->centre())};
    place(placement, lambda, solutions, std::array{1 - lambda, lambda}, out);
}

void PoseInterpolation::oneSided(Side side, double lambda, MutablePositions out,
                                 InterpolationMethod method) const
{
    const std::vector<TriangleEdges> edges = deformedEdges(lambda, method);
    std::array<std::vector<double>, 1> solutions;
    (side == Side::Source ? m_source : m_target)->poisson().solve(edges, solutions[0]);
    const Placement placement{partOf(m_rotation, lambda).toRotationMatrix(),
                              (1 - lambda) * m_source->centre() + lambda * m_target->centre()};
    place(placement, lambda, solutions, std::array{1.0}, out);
}

std::vector<Vec3f> interpolatePoses(const std::shared_ptr<const Topology>& topology, Positions source,
                                    Positions target, double lambda, InterpolationMethod method)
{
    const auto system = std::make_shared<const PoissonSystem>(topology);
    const PoseInterpolation between(std::make_shared<const PreparedPose>(system, source),
                                    std::make_shared<const PreparedPose>(system, target));
    std::vector<Vec3f> out(source.size());
    between.at(lambda, out, method);
    return out;
}

} // namespace quadrille
