// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/transfersolver.h"

#include "model/core/error.h"
#include "model/transfer/surroundings.h"

#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

std::vector<std::size_t> marksOnSurface(const SolidTarget& surface, std::span<const TriangleIndex> marks)
{
    std::vector<std::size_t> found;
    found.reserve(marks.size());
    for (const TriangleIndex mark : marks) {
        const auto triangle = surface.triangleOf(mark);
        if (!triangle)
            throw Error(ErrorCode::TransferTriangleFlat,
                        {.values = {{"triangle", std::to_string(mark.value)}}});
        found.push_back(*triangle);
    }
    return found;
}

std::vector<std::vector<std::uint32_t>> verticesAbout(const SurfaceGraph& graph,
                                                      std::span<const std::size_t> marks)
{
    const Surroundings surroundings(graph, marks);
    std::vector<std::vector<std::uint32_t>> vertices(marks.size());
    tbb::parallel_for(std::size_t{0}, marks.size(),
                      [&](std::size_t m) { vertices[m] = surroundings.vertices(m); });
    return vertices;
}

} // namespace

TransferTarget::TransferTarget(const Topology& mesh, Positions positions)
    : m_surface(mesh, positions)
    , m_graph(m_surface.topology(), m_surface.positions())
    , m_system(m_surface.topology())
    , m_poisson(m_system, poseFrames(m_surface.topology()->triangles(), m_surface.positions()))
    , m_harmonic(m_surface, m_poisson.weights())
{
    m_edges.reserve(m_system.triangleCount());
    const Positions pose = m_surface.positions();
    for (const Triangle& t : m_surface.topology()->triangles()) {
        const Vec3d third = pose[t[2].value].cast<double>();
        TriangleEdges edges{};
        Vec3d::Map(edges.first.data()) = pose[t[0].value].cast<double>() - third;
        Vec3d::Map(edges.second.data()) = pose[t[1].value].cast<double>() - third;
        m_edges.push_back(edges);
    }
}

TransferSolver::TransferSolver(std::shared_ptr<const TransferTarget> target,
                               std::span<const TriangleIndex> marks, FieldKind kind, bool holdsSurroundings)
    : m_target(std::move(target))
    , m_marks(marksOnSurface(m_target->surface(), marks))
    , m_field(m_target->harmonic(), m_marks, kind,
              holdsSurroundings ? verticesAbout(m_target->graph(), m_marks)
                                : std::vector<std::vector<std::uint32_t>>())
{
}

void TransferSolver::pose(const MarkDeformations& deformations, MutablePositions out, Scratch& scratch) const
{
    const SolidTarget& surface = m_target->surface();
    scratch.edges.resize(m_target->edges().size());
    scratch.width = DeformationField::width(deformations);
    m_field.solve(deformations, scratch.field);
    m_field.deform(deformations, scratch.field, m_target->edges(), scratch.edges);
    m_target->poisson().solve(scratch.edges, scratch.solution);
    place(scratch);
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = scratch.surface[surface.vertices()[v]];
    for (const SolidTarget::Offset& loose : surface.offsets()) {
        const std::uint32_t with = surface.vertices()[loose.vertex];
        out[loose.vertex] += (rotationAt(with, scratch) * loose.offset.cast<double>()).cast<float>();
    }
}

Eigen::Quaterniond TransferSolver::rotationAt(std::uint32_t vertex, const Scratch& scratch) const
{
    const double* const q =
        scratch.field.data() + scratch.width * static_cast<std::size_t>(m_target->harmonic().rowOf(vertex));
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
}

void TransferSolver::place(Scratch& scratch) const
{
    const SolidTarget& surface = m_target->surface();
    const PoissonSystem& system = m_target->system();
    const std::vector<std::int32_t>& components = surface.topology()->components();
    const auto solved = [&](std::uint32_t v) -> Vec3d {
        return Vec3d::Map(scratch.solution.data() +
                          HarmonicField::lanes * static_cast<std::size_t>(system.rows()[v]));
    };
    std::vector<Vec3d> shifts;
    shifts.reserve(surface.bridges().size());
    for (const SolidTarget::Bridge& bridge : surface.bridges()) {
        const Vec3d rest =
            (surface.positions()[bridge.vertex] - surface.positions()[bridge.onto]).cast<double>();
        // The largest component's bridge leads from a vertex to itself.
        const bool isLargest = bridge.vertex == bridge.onto;
        shifts.emplace_back(isLargest ? Vec3d::Zero()
                                      : Vec3d(solved(bridge.onto) + rotationAt(bridge.onto, scratch) * rest -
                                              solved(bridge.vertex)));
    }
    const auto placed = [&](std::uint32_t v) -> Vec3d {
        return solved(v) + shifts[static_cast<std::size_t>(components[v])];
    };
    Vec3d middle = Vec3d::Zero();
    for (const std::size_t mark : m_marks) {
        for (const VertexIndex v : surface.topology()->triangles()[mark])
            middle += placed(v.value) / (3 * static_cast<double>(m_marks.size()));
    }
    scratch.surface.resize(components.size());
    for (std::uint32_t v = 0; v < components.size(); ++v)
        scratch.surface[v] = (placed(v) - middle).cast<float>();
}

} // namespace quadrille
