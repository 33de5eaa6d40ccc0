// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/bodyparts.h"

#include "model/geometry/pointtree.h"
#include "model/variation/parts/curveregions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <optional>

namespace quadrille {

namespace {

constexpr int none = CurveRegions::none;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

std::vector<double> areasOf(const Topology& topology, Positions pose, const CurveRegions& regions)
{
    std::vector<double> areas(at(regions.count));
    for (std::size_t t = 0; t < topology.triangles().size(); ++t) {
        const Triangle& triangle = topology.triangles()[t];
        const Vec3f& a = pose[triangle[0].value];
        const float area = (pose[triangle[1].value] - a).cross(pose[triangle[2].value] - a).norm() / 2;
        if (regions.ofTriangle[t] != none)
            areas[at(regions.ofTriangle[t])] += static_cast<double>(area);
    }
    return areas;
}

/// Parts before those that hang on them, otherwise as described.
std::vector<std::size_t> fromTheRoot(std::span<const PartDescription> descriptions)
{
    std::vector<std::size_t> order;
    const auto isPlaced = [&](const std::string& name) {
        return std::ranges::any_of(order, [&](std::size_t p) { return descriptions[p].name == name; });
    };
    while (order.size() < descriptions.size()) {
        for (std::size_t p = 0; p < descriptions.size(); ++p) {
            const PartDescription& part = descriptions[p];
            if (!isPlaced(part.name) && (part.parent.empty() || isPlaced(part.parent)))
                order.push_back(p);
        }
    }
    return order;
}

/// Collects vertices and triangles of parts.
class Assembly
{
public:
    Assembly(const Topology& topology, std::size_t parts) : m_topology(topology), m_parts(parts) {}

    void add(std::size_t part, std::uint32_t triangle, bool isOverlap)
    {
        m_parts[part].triangles.emplace_back(triangle);
        if (isOverlap)
            m_parts[part].overlapTriangles.emplace_back(triangle);
        for (const VertexIndex v : m_topology.triangles()[triangle]) {
            m_parts[part].vertices.push_back(v);
            if (isOverlap)
                m_parts[part].overlap.push_back(v);
        }
    }
    void addVertex(std::size_t part, VertexIndex v) { m_parts[part].vertices.push_back(v); }
    BodyPart& part(std::size_t part) { return m_parts[part]; }

    /// Everything ascending, once.
    BodyParts tidied()
    {
        for (BodyPart& part : m_parts) {
            tidy(part.vertices);
            tidy(part.overlap);
            std::ranges::sort(part.triangles);
            std::ranges::sort(part.overlapTriangles);
        }
        return {m_parts};
    }

private:
    static void tidy(std::vector<VertexIndex>& vertices)
    {
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }

    const Topology& m_topology;
    std::vector<BodyPart> m_parts;
};

/// Triangles that hang together and that no curve reaches, and vertices without triangles.
struct LoosePiece
{
    std::vector<VertexIndex> vertices;
    std::vector<std::uint32_t> triangles;
};

std::vector<LoosePiece> loosePieces(const Topology& topology, const CurveRegions& regions)
{
    std::vector<bool> isCut(static_cast<std::size_t>(topology.statistics().components));
    const auto componentOf = [&](std::size_t t) {
        return at(topology.components()[topology.triangles()[t][0].value]);
    };
    for (std::size_t t = 0; t < regions.ofTriangle.size(); ++t) {
        if (regions.ofTriangle[t] != none)
            isCut[componentOf(t)] = true;
    }
    std::map<std::size_t, LoosePiece> components;
    std::vector<LoosePiece> pieces;
    for (std::uint32_t t = 0; t < regions.ofTriangle.size(); ++t) {
        if (regions.ofTriangle[t] != none)
            continue;
        // Beside curves a triangle may hang on by a corner alone.
        LoosePiece& piece = isCut[componentOf(t)] ? pieces.emplace_back() : components[componentOf(t)];
        piece.triangles.push_back(t);
        const Triangle& triangle = topology.triangles()[t];
        piece.vertices.insert(piece.vertices.end(), triangle.begin(), triangle.end());
    }
    for (auto& [component, piece] : components)
        pieces.push_back(std::move(piece));
    for (std::uint32_t v = 0; v < topology.vertexCount(); ++v) {
        if (topology.components()[v] < 0)
            pieces.push_back({{VertexIndex(v)}, {}});
    }
    return pieces;
}

/// Gives each piece to the part with the vertex nearest to it; to the first one where there are no others.
void addLoosePieces(const std::vector<LoosePiece>& pieces, Positions pose, Assembly& assembly,
                    const std::vector<VertexPart>& partOf)
{
    std::vector<Vec3f> points;
    std::vector<int> parts;
    for (std::size_t v = 0; v < partOf.size(); ++v) {
        if (partOf[v].part < 0)
            continue;
        points.push_back(pose[v]);
        parts.push_back(partOf[v].part);
    }
    std::optional<PointTree> tree;
    if (!points.empty())
        tree.emplace(points);
    for (const LoosePiece& piece : pieces) {
        int part = 0;
        float least = std::numeric_limits<float>::infinity();
        for (const VertexIndex v : piece.vertices) {
            if (!tree)
                break;
            const std::uint32_t nearest = tree->nearest(pose[v.value]);
            const float distance = (points[nearest] - pose[v.value]).squaredNorm();
            if (distance < least) {
                least = distance;
                part = parts[nearest];
            }
        }
        for (const std::uint32_t t : piece.triangles)
            assembly.add(at(part), t, false);
        for (const VertexIndex v : piece.vertices)
            assembly.addVertex(at(part), v);
    }
}

} // namespace

std::size_t BodyParts::indexOf(std::string_view name) const
{
    const auto found = std::ranges::find(parts, name, &BodyPart::name);
    assert(found != parts.end());
    return static_cast<std::size_t>(found - parts.begin());
}

BodyParts cutIntoParts(const Topology& topology, Positions pose, std::span<const PartCurve> curves,
                       std::span<const PartDescription> descriptions)
{
    static const std::vector<PartDescription> whole{{.name = "body", .parent = {}, .curves = {}}};
    if (descriptions.empty())
        return cutIntoParts(topology, pose, {}, whole);
    const std::vector<PartCurve> used = usedCurves(curves, descriptions);
    const std::vector<PartProblem> problems = partProblems(topology, used, descriptions);
    if (!problems.empty())
        throw problems.front().error;
    const CurveRegions regions = curveRegions(topology, VertexTriangles(topology), used);
    const PartRegions where = partRegions(regions, used, descriptions, areasOf(topology, pose, regions));
    const std::vector<std::size_t> order = fromTheRoot(descriptions);
    std::vector<std::size_t> placeOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        placeOf[order[i]] = i;
    Assembly assembly(topology, order.size());
    for (std::size_t p = 0; p < descriptions.size(); ++p) {
        BodyPart& part = assembly.part(placeOf[p]);
        part.name = descriptions[p].name;
        if (descriptions[p].parent.empty())
            continue;
        part.parent = static_cast<int>(placeOf[*indexOf(descriptions, descriptions[p].parent)]);
        part.end = used[where.curves[p][0]].vertices;
        part.parentEnd = used[where.curves[p][1]].vertices;
    }
    for (std::uint32_t t = 0; t < regions.ofTriangle.size(); ++t) {
        const int region = regions.ofTriangle[t];
        if (region == none)
            continue;
        const auto p = at(where.partOf[at(region)]);
        const bool isOverlap = where.overlaps[p] == region;
        assembly.add(placeOf[p], t, isOverlap);
        if (isOverlap)
            assembly.add(at(assembly.part(placeOf[p]).parent), t, false);
    }
    addLoosePieces(loosePieces(topology, regions), pose, assembly,
                   partOfVertex(assembly.tidied(), topology.vertexCount()));
    return assembly.tidied();
}

std::vector<VertexPart> partOfVertex(const BodyParts& parts, std::uint32_t vertexCount)
{
    std::vector<VertexPart> found(vertexCount);
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
        for (const VertexIndex v : parts.parts[p].vertices) {
            // Children come later, and have what they share with their parents.
            found[v.value].part = static_cast<int>(p);
        }
    }
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
        for (const VertexIndex v : parts.parts[p].overlap)
            found[v.value] = {static_cast<int>(p), static_cast<int>(p)};
    }
    return found;
}

} // namespace quadrille
