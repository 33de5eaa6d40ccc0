// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/halfedges.h"
#include "resources/sample/maker/bodymesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

struct RemeshTraits : OpenMesh::DefaultTraits
{
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<RemeshTraits>;

Vec3d pointOf(const Mesh& mesh, Mesh::VertexHandle v)
{
    const auto& p = mesh.point(v);
    return {p[0], p[1], p[2]};
}

void setPoint(Mesh& mesh, Mesh::VertexHandle v, const Vec3d& p)
{
    mesh.set_point(v, {p.x(), p.y(), p.z()});
}

Vec3d areaVector(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    return 0.5 * (b - a).cross(c - a);
}

/// The nearest place on the surface by a few Newton steps; points of the boundary stay in x = 0.
Vec3d projected(const Body& body, Vec3d p, bool inPlane)
{
    for (int i = 0; i < 3; ++i) {
        constexpr double step = 5e-4;
        Vec3d gradient;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3d offset = step * Vec3d::Unit(axis);
            gradient[axis] = (body.distance(p + offset) - body.distance(p - offset)) / (2 * step);
        }
        const double size = std::max(gradient.squaredNorm(), 0.25);
        const Vec3d move = -body.distance(p) / size * gradient;
        p += std::min(1.0, 0.01 / std::max(move.norm(), 1e-12)) * move;
        p.x() = inPlane ? 0.0 : std::max(p.x(), 0.0);
    }
    return p;
}

class Remesher
{
public:
    Remesher(const SurfaceMesh& half, const Body& body, const EdgeLength& length)
        : m_body(body), m_length(length)
    {
        for (const Vec3d& p : half.points)
            m_mesh.add_vertex({p.x(), p.y(), p.z()});
        for (const Triangle& t : half.triangles)
            m_mesh.add_face(Mesh::VertexHandle(static_cast<int>(t[0].value)),
                            Mesh::VertexHandle(static_cast<int>(t[1].value)),
                            Mesh::VertexHandle(static_cast<int>(t[2].value)));
    }

    void pass()
    {
        splitLongEdges();
        collapseShortEdges();
        flipEdges();
        relax();
        m_mesh.garbage_collection();
    }

    SurfaceMesh result() const
    {
        SurfaceMesh out;
        for (const auto v : m_mesh.vertices())
            out.points.push_back(pointOf(m_mesh, v));
        for (const auto f : m_mesh.faces()) {
            Triangle t;
            std::size_t corner = 0;
            for (const auto v : m_mesh.fv_range(f))
                t[corner++] = VertexIndex(v.idx());
            out.triangles.push_back(t);
        }
        return out;
    }

private:
    double wished(Mesh::EdgeHandle e) const
    {
        const auto h = m_mesh.halfedge_handle(e, 0);
        return m_length(0.5 * (pointOf(m_mesh, m_mesh.from_vertex_handle(h)) +
                               pointOf(m_mesh, m_mesh.to_vertex_handle(h))));
    }

    double edgeLength(Mesh::EdgeHandle e) const { return m_mesh.calc_edge_length(e); }

    void splitLongEdges()
    {
        const auto count = static_cast<int>(m_mesh.n_edges());
        for (int i = 0; i < count; ++i) {
            const Mesh::EdgeHandle e(i);
            if (m_mesh.status(e).deleted() || edgeLength(e) <= 4.0 / 3.0 * wished(e))
                continue;
            const bool boundary = m_mesh.is_boundary(e);
            const auto h = m_mesh.halfedge_handle(e, 0);
            const Vec3d middle = 0.5 * (pointOf(m_mesh, m_mesh.from_vertex_handle(h)) +
                                        pointOf(m_mesh, m_mesh.to_vertex_handle(h)));
            const Vec3d p = projected(m_body, middle, boundary);
            m_mesh.split(e, {p.x(), p.y(), p.z()});
        }
    }

    void collapseShortEdges()
    {
        const auto count = static_cast<int>(m_mesh.n_edges());
        for (int i = 0; i < count; ++i) {
            const Mesh::EdgeHandle e(i);
            if (m_mesh.status(e).deleted() || edgeLength(e) >= 0.8 * wished(e))
                continue;
            Mesh::HalfedgeHandle h = m_mesh.halfedge_handle(e, 0);
            const bool fromBoundary = m_mesh.is_boundary(m_mesh.from_vertex_handle(h));
            const bool toBoundary = m_mesh.is_boundary(m_mesh.to_vertex_handle(h));
            if (fromBoundary && toBoundary && !m_mesh.is_boundary(e))
                continue;
            if (fromBoundary && !toBoundary)
                h = m_mesh.opposite_halfedge_handle(h);
            if (m_mesh.is_collapse_ok(h))
                collapse(h, fromBoundary == toBoundary);
        }
    }

    void collapse(Mesh::HalfedgeHandle h, bool toMiddle)
    {
        const auto from = m_mesh.from_vertex_handle(h);
        const auto to = m_mesh.to_vertex_handle(h);
        const Vec3d kept = pointOf(m_mesh, to);
        const Vec3d target = toMiddle ? Vec3d(0.5 * (pointOf(m_mesh, from) + kept)) : kept;
        const double longest = 4.0 / 3.0 * m_length(target);
        for (const auto v : {from, to})
            for (const auto f : m_mesh.vf_range(v)) {
                std::array<Vec3d, 3> before;
                std::array<Vec3d, 3> after;
                std::size_t n = 0;
                int moved = 0;
                for (const auto corner : m_mesh.fv_range(f)) {
                    const bool isMoved = corner == from || corner == to;
                    before[n] = pointOf(m_mesh, corner);
                    after[n] = isMoved ? target : before[n];
                    moved += isMoved;
                    if (!isMoved && (before[n] - target).norm() > longest)
                        return;
                    ++n;
                }
                const Vec3d old = areaVector(before[0], before[1], before[2]);
                const Vec3d now = areaVector(after[0], after[1], after[2]);
                if (moved == 1 && old.dot(now) < 0.3 * old.norm() * now.norm())
                    return;
            }
        m_mesh.collapse(h);
        setPoint(m_mesh, to, target);
    }

    void flipEdges()
    {
        const auto excess = [this](Mesh::VertexHandle v, int change) {
            const int wishedValence = m_mesh.is_boundary(v) ? 4 : 6;
            const int d = static_cast<int>(m_mesh.valence(v)) + change - wishedValence;
            return d * d;
        };
        const auto count = static_cast<int>(m_mesh.n_edges());
        for (int i = 0; i < count; ++i) {
            const Mesh::EdgeHandle e(i);
            if (m_mesh.status(e).deleted() || m_mesh.is_boundary(e) || !m_mesh.is_flip_ok(e))
                continue;
            const auto h = m_mesh.halfedge_handle(e, 0);
            const auto o = m_mesh.halfedge_handle(e, 1);
            const auto a = m_mesh.from_vertex_handle(h);
            const auto b = m_mesh.to_vertex_handle(h);
            const auto c = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h));
            const auto d = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(o));
            if (m_mesh.is_boundary(c) && m_mesh.is_boundary(d))
                continue;
            const int before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
            const int after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
            if (after >= before)
                continue;
            const Vec3d pa = pointOf(m_mesh, a);
            const Vec3d pb = pointOf(m_mesh, b);
            const Vec3d pc = pointOf(m_mesh, c);
            const Vec3d pd = pointOf(m_mesh, d);
            const Vec3d surface = areaVector(pa, pb, pc) + areaVector(pb, pa, pd);
            const Vec3d one = areaVector(pc, pa, pd);
            const Vec3d two = areaVector(pd, pb, pc);
            const double size = surface.norm();
            if (one.dot(surface) > 0.5 * one.norm() * size && two.dot(surface) > 0.5 * two.norm() * size &&
                one.dot(two) > 0.6 * one.norm() * two.norm())
                m_mesh.flip(e);
        }
    }

    /// Moves every vertex towards the centre of its neighbourhood, within the surface.
    void relax()
    {
        std::vector<Vec3d> moved(m_mesh.n_vertices());
        tbb::parallel_for(0, static_cast<int>(m_mesh.n_vertices()), [&](int i) {
            const Mesh::VertexHandle v(i);
            if (m_mesh.status(v).deleted())
                return;
            const bool boundary = m_mesh.is_boundary(v);
            const Vec3d p = pointOf(m_mesh, v);
            Vec3d sum = Vec3d::Zero();
            double weights = 0;
            for (const auto n : m_mesh.vv_range(v)) {
                if (boundary && !m_mesh.is_boundary(n))
                    continue;
                const Vec3d q = pointOf(m_mesh, n);
                const double weight = 1.0 / m_length(q);
                sum += weight * q;
                weights += weight;
            }
            Vec3d target = weights > 0 ? Vec3d(sum / weights) : p;
            const Vec3d normal = m_body.normal(p);
            target -= (target - p).dot(normal) * normal;
            if (boundary)
                target.x() = 0;
            moved[static_cast<std::size_t>(i)] = projected(m_body, p + 0.8 * (target - p), boundary);
        });
        for (const auto v : m_mesh.vertices())
            if (!m_mesh.status(v).deleted())
                setPoint(m_mesh, v, moved[static_cast<std::size_t>(v.idx())]);
    }

    const Body& m_body;
    const EdgeLength& m_length;
    Mesh m_mesh;
};

} // namespace

SurfaceMesh remeshHalf(const SurfaceMesh& half, const Body& body, const EdgeLength& length)
{
    constexpr int passes = 10;
    Remesher remesher(half, body, length);
    for (int i = 0; i < passes; ++i)
        remesher.pass();
    return remesher.result();
}

SurfaceMesh mirrorHalf(const SurfaceMesh& half)
{
    SurfaceMesh mesh = half;
    std::vector<VertexIndex> mirror(half.points.size());
    for (std::size_t v = 0; v < half.points.size(); ++v) {
        mirror[v] = VertexIndex(v);
        const Vec3d& p = half.points[v];
        if (p.x() == 0)
            continue;
        mirror[v] = VertexIndex(mesh.points.size());
        mesh.points.emplace_back(-p.x(), p.y(), p.z());
    }
    for (const Triangle& t : half.triangles)
        mesh.triangles.push_back({mirror[t[0].value], mirror[t[2].value], mirror[t[1].value]});
    return mesh;
}

} // namespace quadrille
