// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/references.h"

#include "model/parametric/hybridblend.h"
#include "model/transition/poseinterpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Displacements are kept from this share of the tolerance on.
constexpr double keptShare = 0.2;
/// What the error in the middle of an edge may be, in tolerances: beside it, it may be a little greater.
constexpr double middleShare = 0.9;

NodeWeights middleOf(const std::array<int, 2>& edge)
{
    return {.nodes = {edge[0], edge[1]}, .weights = {0.5, 0.5}, .count = 2};
}

NodeWeights middleOf(const WeightSpace::Simplex& simplex, int dimension)
{
    NodeWeights weights{.nodes = simplex.nodes, .weights = {}, .count = dimension + 1};
    for (int c = 0; c <= dimension; ++c)
        weights.weights[static_cast<std::size_t>(c)] = 1.0 / (dimension + 1);
    return weights;
}

/// How far two nodes are apart, in shares of takes.
double lengthOf(const WeightSpace& space, const std::array<int, 2>& edge)
{
    std::vector<double> differences(space.takeCount());
    for (const BlendShare& share : space.nodes()[static_cast<std::size_t>(edge[0])].shares)
        differences[share.take] += share.share;
    for (const BlendShare& share : space.nodes()[static_cast<std::size_t>(edge[1])].shares)
        differences[share.take] -= share.share;
    double length = 0;
    for (const double difference : differences)
        length += std::abs(difference);
    return length;
}

std::array<int, 2> longestEdge(const WeightSpace& space, const WeightSpace::Simplex& simplex)
{
    std::array<int, 2> longest{};
    double greatest = -1;
    for (std::size_t a = 0; a <= static_cast<std::size_t>(space.dimension()); ++a) {
        for (std::size_t b = a + 1; b <= static_cast<std::size_t>(space.dimension()); ++b) {
            const std::array<int, 2> edge{std::min(simplex.nodes[a], simplex.nodes[b]),
                                          std::max(simplex.nodes[a], simplex.nodes[b])};
            const double length = lengthOf(space, edge);
            if (length > greatest) {
                greatest = length;
                longest = edge;
            }
        }
    }
    return longest;
}

/// A place where the blend is looked at, and the edge that is bisected if it is not good enough there.
struct Probe
{
    NodeWeights weights;
    std::array<int, 2> edge{};
    double error = 0;
};

std::vector<Probe> probesOf(const WeightSpace& space)
{
    std::vector<Probe> probes;
    for (const std::array<int, 2>& edge : space.edges())
        probes.push_back({middleOf(edge), edge});
    if (space.dimension() > 1) {
        for (const WeightSpace::Simplex& simplex : space.simplices())
            probes.push_back({middleOf(simplex, space.dimension()), longestEdge(space, simplex)});
    }
    return probes;
}

/// Sets the errors of those that are not known from before: nodes never move, so that what was measured
/// between some of them stays.
class ProbeErrors
{
public:
    ProbeErrors(const MotionSpace& space, const NonLinearBlend& nonLinear)
        : m_space(space), m_nonLinear(nonLinear)
    {
    }

    void measure(std::vector<Probe>& probes, const Progress& progress)
    {
        std::vector<std::vector<double>> shares;
        std::vector<NodeWeights> weights;
        for (const Probe& probe : probes) {
            if (!m_known.contains(probe.weights.nodes)) {
                shares.push_back(m_space.weights.shares(probe.weights));
                weights.push_back(probe.weights);
            }
        }
        std::vector<std::vector<double>> errors(m_space.frameCount(), std::vector<double>(shares.size()));
        m_nonLinear.blend(
            shares,
            [&](std::size_t blend, std::size_t frame, Positions truth) {
                std::vector<Vec3f> pose(truth.size());
                blendedPose(m_space, static_cast<double>(frame), weights[blend], pose);
                float greatest = 0;
                for (std::size_t v = 0; v < pose.size(); ++v)
                    greatest = std::max(greatest, (pose[v] - truth[v]).squaredNorm());
                errors[frame][blend] = std::sqrt(greatest);
            },
            progress);
        for (std::size_t b = 0; b < shares.size(); ++b) {
            double& known = m_known[weights[b].nodes];
            for (const std::vector<double>& ofFrame : errors)
                known = std::max(known, ofFrame[b]);
        }
        for (Probe& probe : probes)
            probe.error = m_known.at(probe.weights.nodes);
    }

private:
    const MotionSpace& m_space;
    const NonLinearBlend& m_nonLinear;
    std::map<std::array<int, 4>, double> m_known; ///< by the nodes, which all have equal shares
};

/// The edges to bisect, the worst first, each once.
std::vector<std::array<int, 2>> failing(std::vector<Probe> probes, double limit)
{
    std::stable_sort(probes.begin(), probes.end(),
                     [](const Probe& a, const Probe& b) { return a.error > b.error; });
    std::vector<std::array<int, 2>> edges;
    for (const Probe& probe : probes) {
        if (probe.error > limit && std::find(edges.begin(), edges.end(), probe.edge) == edges.end())
            edges.push_back(probe.edge);
    }
    return edges;
}

/// What a node that is not a take adds to the linear blend. \param truth  frames × vertices.
SpaceReference referenceOf(const MotionSpace& space, int node, std::span<const Vec3f> truth, double keep)
{
    SpaceReference reference;
    reference.starts.push_back(0);
    std::vector<Vec3f> displacements;
    float greatest = 0;
    std::vector<Vec3f> pose(space.vertexCount());
    for (std::size_t f = 0; f < space.frameCount(); ++f) {
        blendedPose(space, static_cast<double>(f), {.nodes = {node}, .weights = {1}, .count = 1}, pose);
        for (std::size_t v = 0; v < pose.size(); ++v) {
            const Vec3f displacement = truth[f * pose.size() + v] - pose[v];
            if (displacement.norm() > keep) {
                reference.vertices.push_back(static_cast<std::uint32_t>(v));
                displacements.push_back(displacement);
                greatest = std::max(greatest, displacement.cwiseAbs().maxCoeff());
            }
        }
        reference.starts.push_back(static_cast<std::uint32_t>(reference.vertices.size()));
    }
    reference.unit = greatest / static_cast<float>(std::numeric_limits<std::int16_t>::max());
    for (const Vec3f& displacement : displacements) {
        const Vec3f counts = displacement / reference.unit;
        auto& stored = reference.displacements.emplace_back();
        for (Eigen::Index d = 0; d < 3; ++d)
            stored[static_cast<std::size_t>(d)] = static_cast<std::int16_t>(std::lround(counts[d]));
    }
    return reference;
}

/// Poses of the takes in one frame, each prepared when it is needed for the first time.
class PreparedFrame
{
public:
    PreparedFrame(const MotionSpace& space, std::shared_ptr<const PoissonSystem> system, std::size_t frame)
        : m_space(space), m_system(std::move(system)), m_frame(frame), m_takes(space.takes.size())
    {
    }

    std::vector<Vec3f> blended(std::span<const double> shares, InterpolationMethod method)
    {
        std::shared_ptr<const PreparedPose> blend;
        std::vector<Vec3f> pose(m_space.vertexCount());
        double sum = 0;
        for (std::size_t t = 0; t < shares.size(); ++t) {
            if (shares[t] <= 0)
                continue;
            if (sum == 0) {
                blend = take(t);
                std::copy(blend->positions().begin(), blend->positions().end(), pose.begin());
            } else {
                if (!blend)
                    blend = std::make_shared<const PreparedPose>(m_system, pose);
                PoseInterpolation(blend, take(t)).at(shares[t] / (sum + shares[t]), pose, method);
                blend = nullptr;
            }
            sum += shares[t];
        }
        return pose;
    }

private:
    const std::shared_ptr<const PreparedPose>& take(std::size_t index)
    {
        if (!m_takes[index])
            m_takes[index] =
                std::make_shared<const PreparedPose>(m_system, m_space.takes[index].pose(m_frame));
        return m_takes[index];
    }

    const MotionSpace& m_space;
    std::shared_ptr<const PoissonSystem> m_system;
    std::size_t m_frame;
    std::vector<std::shared_ptr<const PreparedPose>> m_takes;
};

} // namespace

NonLinearBlend::NonLinearBlend(const MotionSpace& space, InterpolationMethod method)
    : m_space(space), m_system(std::make_shared<const PoissonSystem>(space.topology)), m_method(method)
{
}

void NonLinearBlend::blend(std::span<const std::vector<double>> shares, const Use& use,
                           const Progress& progress) const
{
    tbb::parallel_for(std::size_t{0}, m_space.frameCount(), [&](std::size_t f) {
        PreparedFrame frame(m_space, m_system, f);
        for (std::size_t b = 0; b < shares.size(); ++b) {
            progress.report(0);
            use(b, f, frame.blended(shares[b], m_method));
        }
    });
}

std::vector<Vec3f> NonLinearBlend::blend(const std::vector<double>& shares) const
{
    std::vector<Vec3f> poses(m_space.frameCount() * m_space.vertexCount());
    blend(std::span(&shares, 1), [&](std::size_t /*blend*/, std::size_t frame, Positions pose) {
        std::copy(pose.begin(), pose.end(),
                  poses.begin() + static_cast<std::ptrdiff_t>(frame * m_space.vertexCount()));
    });
    return poses;
}

HybridError hybridError(const MotionSpace& space, const NodeWeights& weights, const NonLinearBlend& nonLinear)
{
    const std::vector<Vec3f> truth = nonLinear.blend(space.weights.shares(weights));
    HybridError error;
    std::vector<Vec3f> pose(space.vertexCount());
    double sum = 0;
    for (std::size_t f = 0; f < space.frameCount(); ++f) {
        blendedPose(space, static_cast<double>(f), weights, pose);
        for (std::size_t v = 0; v < pose.size(); ++v) {
            const double distance = (pose[v] - truth[f * pose.size() + v]).norm();
            sum += distance;
            if (distance > error.greatest) {
                error.greatest = distance;
                error.frame = f;
            }
        }
    }
    error.mean = sum / static_cast<double>(truth.size());
    return error;
}

std::size_t SpaceReference::memory() const
{
    return starts.size() * sizeof(starts[0]) + vertices.size() * sizeof(vertices[0]) +
           displacements.size() * sizeof(displacements[0]);
}

void refine(MotionSpace& space, const MotionSpaceSettings& settings, const Progress& progress)
{
    if (space.weights.dimension() == 0)
        return;
    const NonLinearBlend nonLinear(space, settings.method);
    ProbeErrors errors(space, nonLinear);
    const auto most = static_cast<std::size_t>(settings.mostReferences);
    while (space.references.size() < most) {
        progress.report(static_cast<double>(space.references.size()) / static_cast<double>(most));
        std::vector<Probe> probes = probesOf(space.weights);
        errors.measure(probes, Progress(progress.token()));
        const std::vector<std::array<int, 2>> edges =
            failing(std::move(probes), middleShare * settings.tolerance);
        if (edges.empty())
            return;
        for (std::size_t e = 0; e < edges.size() && space.references.size() < most; ++e) {
            progress.report(static_cast<double>(space.references.size()) / static_cast<double>(most));
            const int node = space.weights.bisect(edges[e]);
            const std::vector<Vec3f> truth =
                nonLinear.blend(space.weights.shares({.nodes = {node}, .weights = {1}, .count = 1}));
            // As long as it says nothing, what is blended there is linear.
            space.references.emplace_back().starts.assign(space.frameCount() + 1, 0);
            space.references.back() = referenceOf(space, node, truth, keptShare * settings.tolerance);
        }
    }
}

} // namespace quadrille
