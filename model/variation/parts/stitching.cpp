// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/stitching.h"

#include "model/geometry/poissonsystem.h"
#include "model/geometry/procrustes.h"
#include "model/geometry/trianglelogs.h"
#include "model/variation/parts/stitchingplan.h"
#include "model/variation/parts/stretchrange.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <functional>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr std::size_t lanes = CholeskyFactor::lanes;

/// First the other motion, then this one.
RigidMotion after(const RigidMotion& motion, const RigidMotion& other)
{
    return {(motion.rotation * other.rotation).normalized(), motion(other.translation)};
}

std::vector<Vec3f> gathered(Positions positions, std::span<const std::uint32_t> places)
{
    std::vector<Vec3f> chosen;
    chosen.reserve(places.size());
    for (const std::uint32_t place : places)
        chosen.push_back(positions[place]);
    return chosen;
}

/// The mean of points that weigh.
Vec3d weightedMean(std::span<const Vec3f> points, std::span<const double> weights)
{
    Vec3d sum = Vec3d::Zero();
    double total = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += weights[i] * points[i].cast<double>();
        total += weights[i];
    }
    return total > 0 ? Vec3d(sum / total) : sum;
}

RigidMotion laidBy(ChildLaying laying, std::span<const Vec3f> child, std::span<const Vec3f> parent,
                   std::span<const double> weights)
{
    if (laying == ChildLaying::Rigidly)
        return rigidProcrustes(child, parent, weights);
    return {Eigen::Quaterniond::Identity(), weightedMean(parent, weights) - weightedMean(child, weights)};
}

/// What differs between two instances of an overlap.
struct OverlapPair
{
    std::vector<Vec3f> child;  ///< as given
    std::vector<Vec3f> parent; ///< as given
    RigidMotion ontoParent;    ///< of the child

    OverlapPair(const PartPlan& plan, const PartOverlap& overlap, Positions childPose, Positions parentPose,
                ChildLaying laying)
        : child(gathered(childPose, plan.inPart))
        , parent(gathered(parentPose, plan.inParent))
        , ontoParent(laidBy(laying, child, parent, overlap.areas()))
    {
    }

    std::vector<Vec3d> differences() const
    {
        const Eigen::Matrix3d turn = ontoParent.rotation.toRotationMatrix();
        std::vector<Vec3d> differences(child.size());
        for (std::size_t v = 0; v < child.size(); ++v)
            differences[v] =
                turn * child[v].cast<double>() + ontoParent.translation - parent[v].cast<double>();
        return differences;
    }
};

std::int64_t frameCountOf(const BodyParts& parts, std::span<const Positions> positions)
{
    return static_cast<std::int64_t>(positions.front().size() / parts.parts.front().vertices.size());
}

/// Of each part its vertices in one frame.
std::vector<Positions> frameOf(const BodyParts& parts, std::span<const Positions> positions,
                               std::int64_t frame)
{
    std::vector<Positions> poses;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const std::size_t count = parts.parts[p].vertices.size();
        poses.push_back(positions[p].subspan(static_cast<std::size_t>(frame) * count, count));
    }
    return poses;
}

/// The edges of a triangle turned by a rotation.
TriangleEdges turned(const Eigen::Matrix3d& turn, const Vec3d& first, const Vec3d& second)
{
    const Vec3d e1 = turn * first;
    const Vec3d e2 = turn * second;
    return {{e1.x(), e1.y(), e1.z(), 0}, {e2.x(), e2.y(), e2.z(), 0}};
}

TriangleEdges turned(const Eigen::Matrix3d& turn, const Vec3f& v1, const Vec3f& v2, const Vec3f& v3)
{
    const Vec3d third = v3.cast<double>();
    return turned(turn, v1.cast<double>() - third, v2.cast<double>() - third);
}

/// The edges of the triangles of an overlap, of each so much of the child as its share says, turned by where
/// the parent was laid.
std::vector<TriangleEdges> mixedEdges(const PartOverlap& overlap, const OverlapPair& pair,
                                      std::span<const double> shares, const Eigen::Matrix3d& turn)
{
    const PoseFrames source = poseFrames(overlap.triangles(), pair.parent);
    const PoseFrames target = poseFrames(overlap.triangles(), pair.child);
    TriangleLogs logs = triangleLogs(source, target, pair.ontoParent.rotation.conjugate());
    for (std::size_t t = 0; t < shares.size(); ++t) {
        logs.halfAngle[t] *= shares[t];
        logs.logScale[t] *= shares[t];
        logs.logStretch[t] *= shares[t];
    }
    std::vector<TriangleEdges> edges(shares.size());
    deformEdges(source, logs, 1, StretchPath::Geodesic, edges);
    for (TriangleEdges& edge : edges)
        edge = turned(turn, Vec3d::Map(edge.first.data()), Vec3d::Map(edge.second.data()));
    const Eigen::Matrix3d childTurn = turn * pair.ontoParent.rotation.toRotationMatrix();
    for (const std::vector<int>* degenerate : {&source.degenerate, &target.degenerate}) {
        for (const int index : *degenerate) {
            const auto t = static_cast<std::size_t>(index);
            const auto& [v1, v2, v3] = overlap.triangles()[t];
            const bool isChilds = shares[t] > 0.5;
            const std::vector<Vec3f>& of = isChilds ? pair.child : pair.parent;
            edges[t] = turned(isChilds ? childTurn : turn, of[v1.value], of[v2.value], of[v3.value]);
        }
    }
    return edges;
}

} // namespace

/// What is the same for all frames.
struct Stitching::Work
{
    std::shared_ptr<const Topology> topology;
    PoissonSystem system;
    PoissonPose poisson;
    std::vector<PartPlan> plans;
    std::vector<PartOverlap> overlaps; ///< of all parts but the root
    std::vector<ComponentPlan> components;
    std::vector<PartVertex> loose;    ///< that no triangle uses
    std::vector<std::size_t> looseOf; ///< their parts
    StretchRange stretches;

    Work(std::shared_ptr<const Topology> of, const BodyParts& parts, Positions pose,
         std::span<const Positions> shapes)
        : topology(std::move(of))
        , system(topology)
        , poisson(system, poseFrames(topology->triangles(), pose))
        , plans(planParts(*topology, parts))
        , components(planComponents(*topology, parts, pose))
    {
        if (!shapes.empty())
            stretches = StretchRange(*topology, pose, shapes);
        std::vector<bool> isKnown(topology->vertexCount(), false);
        for (std::size_t p = 0; p < plans.size(); ++p) {
            const BodyPart& part = parts.parts[p];
            if (p > 0)
                overlaps.emplace_back(*topology, part, pose);
            for (std::uint32_t place = 0; place < part.vertices.size(); ++place) {
                const std::uint32_t v = part.vertices[place].value;
                if (topology->components()[v] < 0 && !isKnown[v]) {
                    loose.push_back({v, place});
                    looseOf.push_back(p);
                }
                isKnown[v] = true;
            }
        }
        assert(std::ranges::find(isKnown, false) == isKnown.end());
    }
};

/// One frame on its way.
struct Stitching::Frame
{
    Frame(const Stitching& stitching, std::span<const Positions> given);

    EdgeCosts costs() const;
    std::vector<TriangleEdges> edges(const Seams& seams) const;
    void place(const std::vector<double>& solution, MutablePositions out) const;

    const BodyParts& parts;
    const Work& work;
    std::span<const Positions> poses;
    std::vector<RigidMotion> placements;
    std::vector<OverlapPair> pairs; ///< of all parts but the root
};

Stitching::Frame::Frame(const Stitching& stitching, std::span<const Positions> given)
    : parts(stitching.m_parts), work(*stitching.m_work), poses(given), placements(1)
{
    assert(poses.size() == parts.parts.size());
    for (std::size_t p = 1; p < poses.size(); ++p) {
        const auto parent = static_cast<std::size_t>(parts.parts[p].parent);
        pairs.emplace_back(work.plans[p], work.overlaps[p - 1], poses[p], poses[parent], stitching.m_laying);
        placements.push_back(after(placements[parent], pairs.back().ontoParent));
    }
}

Stitching::EdgeCosts Stitching::Frame::costs() const
{
    EdgeCosts costs(poses.size());
    for (std::size_t p = 1; p < poses.size(); ++p) {
        const PartOverlap& overlap = work.overlaps[p - 1];
        costs[p].assign(overlap.edgeCount(), 0.0);
        overlap.addCosts(pairs[p - 1].differences(), costs[p]);
    }
    return costs;
}

std::vector<TriangleEdges> Stitching::Frame::edges(const Seams& seams) const
{
    std::vector<TriangleEdges> edges(work.system.triangleCount());
    for (std::size_t p = 0; p < poses.size(); ++p) {
        const Eigen::Matrix3d turn = placements[p].rotation.toRotationMatrix();
        for (const PartTriangle& own : work.plans[p].own)
            edges[own.triangle] =
                turned(turn, poses[p][own.corners[0]], poses[p][own.corners[1]], poses[p][own.corners[2]]);
    }
    for (std::size_t p = 1; p < poses.size(); ++p) {
        const PartOverlap& overlap = work.overlaps[p - 1];
        std::vector<std::uint32_t> seam;
        for (const VertexIndex v : seams.curves[p]) {
            const auto place = std::ranges::lower_bound(parts.parts[p].overlap, v);
            seam.push_back(static_cast<std::uint32_t>(place - parts.parts[p].overlap.begin()));
        }
        const auto parent = static_cast<std::size_t>(parts.parts[p].parent);
        const std::vector<TriangleEdges> mixed = mixedEdges(overlap, pairs[p - 1], overlap.shares(seam),
                                                            placements[parent].rotation.toRotationMatrix());
        for (std::size_t t = 0; t < mixed.size(); ++t)
            edges[work.plans[p].overlapTriangles[t]] = mixed[t];
    }
    work.stretches.restrict(edges);
    return edges;
}

void Stitching::Frame::place(const std::vector<double>& solution, MutablePositions out) const
{
    const auto solved = [&](std::uint32_t v) -> Vec3d {
        return Vec3d::Map(solution.data() + static_cast<std::size_t>(work.system.rows()[v]) * lanes);
    };
    const auto laid = [&](std::size_t part, std::uint32_t place) {
        return placements[part](poses[part][place].cast<double>());
    };
    std::vector<Vec3d> shifts(work.system.componentSizes().size(), Vec3d::Zero());
    const auto shiftOf = [&](std::uint32_t v) -> Vec3d& {
        return shifts[static_cast<std::size_t>(work.topology->components()[v])];
    };
    for (const ComponentPlan& plan : work.components) {
        Vec3d shift = Vec3d::Zero();
        for (const PartVertex& anchor : plan.anchors)
            shift += laid(plan.part, anchor.place) - solved(anchor.vertex);
        shift /= static_cast<double>(plan.anchors.size());
        Vec3d carried = Vec3d::Zero();
        for (const PartVertex& carrier : plan.carriers)
            carried += solved(carrier.vertex) + shiftOf(carrier.vertex) - laid(plan.part, carrier.place);
        if (!plan.carriers.empty())
            shift += carried / static_cast<double>(plan.carriers.size());
        shifts[static_cast<std::size_t>(plan.component)] = shift;
    }
    for (std::uint32_t v = 0; v < out.size(); ++v) {
        if (work.topology->components()[v] >= 0)
            out[v] = (solved(v) + shiftOf(v)).cast<float>();
    }
    for (std::size_t i = 0; i < work.loose.size(); ++i)
        out[work.loose[i].vertex] = laid(work.looseOf[i], work.loose[i].place).cast<float>();
}

Stitching::Stitching(std::shared_ptr<const Topology> topology, BodyParts parts, Positions pose,
                     std::span<const Positions> shapes, ChildLaying laying)
    : m_parts(std::move(parts))
    , m_laying(laying)
    , m_work(std::make_unique<const Work>(std::move(topology), m_parts, pose, shapes))
{
}

Stitching::~Stitching() = default;

const Topology& Stitching::topology() const
{
    return *m_work->topology;
}

void Stitching::stitch(std::span<const Positions> poses, const Seams& seams, MutablePositions out) const
{
    const Frame frame(*this, poses);
    std::vector<double> solution;
    m_work->poisson.solve(frame.edges(seams), solution);
    frame.place(solution, out);
}

Stitching::Seams Stitching::cheapestSeams(const EdgeCosts& costs) const
{
    Seams seams{.curves = std::vector<std::vector<VertexIndex>>(m_parts.parts.size())};
    for (std::size_t p = 1; p < seams.curves.size(); ++p) {
        for (const std::uint32_t place : m_work->overlaps[p - 1].cheapestSeam(costs[p]))
            seams.curves[p].push_back(m_parts.parts[p].overlap[place]);
    }
    return seams;
}

Stitching::Seams Stitching::stitch(std::span<const Positions> poses, MutablePositions out) const
{
    const Frame frame(*this, poses);
    Seams seams = cheapestSeams(frame.costs());
    std::vector<double> solution;
    m_work->poisson.solve(frame.edges(seams), solution);
    frame.place(solution, out);
    return seams;
}

Stitching::Seams Stitching::bestSeams(std::span<const Positions> parts, const Progress& progress) const
{
    const std::int64_t frameCount = frameCountOf(m_parts, parts);
    std::vector<EdgeCosts> costs(static_cast<std::size_t>(frameCount));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::int64_t{0}, frameCount, [&](std::int64_t f) {
        costs[static_cast<std::size_t>(f)] = Frame(*this, frameOf(m_parts, parts, f)).costs();
        progress.report(++done, frameCount);
    });
    // Summed in their order, so that threads do not matter.
    for (std::size_t f = 1; f < costs.size(); ++f) {
        for (std::size_t p = 1; p < m_parts.parts.size(); ++p)
            std::ranges::transform(costs[0][p], costs[f][p], costs[0][p].begin(), std::plus{});
    }
    return costs.empty() ? Seams{} : cheapestSeams(costs.front());
}

std::vector<Vec3f> stitchFrames(const Stitching& stitching, std::span<const Positions> parts,
                                const Progress& progress)
{
    const std::int64_t frameCount = frameCountOf(stitching.parts(), parts);
    const std::size_t vertexCount = stitching.topology().vertexCount();
    const Stitching::Seams seams = stitching.bestSeams(parts, progress.part(0, 0.2));
    std::vector<Vec3f> out(static_cast<std::size_t>(frameCount) * vertexCount);
    const Progress rest = progress.part(0.2, 1);
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::int64_t{0}, frameCount, [&](std::int64_t f) {
        stitching.stitch(
            frameOf(stitching.parts(), parts, f), seams,
            MutablePositions(out).subspan(static_cast<std::size_t>(f) * vertexCount, vertexCount));
        rest.report(++done, frameCount);
    });
    return out;
}

} // namespace quadrille
