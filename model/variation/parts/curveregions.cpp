// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/curveregions.h"

#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

class Groups
{
public:
    explicit Groups(std::size_t count) : m_root(count) { std::iota(m_root.begin(), m_root.end(), 0U); }

    std::uint32_t find(std::uint32_t i)
    {
        while (m_root[i] != i)
            i = m_root[i] = m_root[m_root[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_root[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> m_root;
};

/// Joins the triangles that share an edge which is no curve's.
Groups groupedTriangles(const Topology& topology, const VertexTriangles& around,
                        std::span<const PartCurve> curves)
{
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> next(topology.vertexCount(), none);
    for (const PartCurve& curve : curves) {
        for (std::size_t i = 0; i < curve.vertices.size(); ++i)
            next[curve.vertices[i].value] = curve.vertices[(i + 1) % curve.vertices.size()].value;
    }
    Groups groups(topology.triangles().size());
    for (std::uint32_t t = 0; t < topology.triangles().size(); ++t) {
        const Triangle& triangle = topology.triangles()[t];
        for (std::size_t c = 0; c < 3; ++c) {
            const VertexIndex a = triangle[c];
            const VertexIndex b = triangle[(c + 1) % 3];
            if (next[a.value] == b.value || next[b.value] == a.value)
                continue;
            around.forEachBeside(t, c, [&](std::uint32_t neighbour) { groups.join(t, neighbour); });
        }
    }
    return groups;
}

} // namespace

CurveRegions curveRegions(const Topology& topology, const VertexTriangles& around,
                          std::span<const PartCurve> curves)
{
    const std::size_t triangles = topology.triangles().size();
    Groups groups = groupedTriangles(topology, around, curves);
    struct Bank
    {
        std::size_t curve;
        std::size_t side;
        std::uint32_t triangle;
    };
    std::vector<Bank> banks;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const std::vector<VertexIndex>& curve = curves[c].vertices;
        std::array<std::optional<std::uint32_t>, 2> first;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const VertexIndex to = curve[(i + 1) % curve.size()];
            for (const std::uint32_t t : around.of(curve[i])) {
                if (!hasCorner(topology.triangles()[t], to))
                    continue;
                const std::size_t side = hasDirectedEdge(topology.triangles()[t], curve[i], to) ? 0 : 1;
                if (!first[side])
                    banks.push_back({c, side, *(first[side] = t)});
                groups.join(t, *first[side]);
            }
        }
    }
    CurveRegions regions;
    std::vector<int> numbers(triangles, CurveRegions::none);
    regions.beside.resize(curves.size());
    for (const Bank& bank : banks) {
        int& number = numbers[groups.find(bank.triangle)];
        if (number == CurveRegions::none)
            number = regions.count++;
        regions.beside[bank.curve][bank.side] = number;
    }
    for (std::uint32_t t = 0; t < triangles; ++t)
        regions.ofTriangle.push_back(numbers[groups.find(t)]);
    return regions;
}

namespace {

/// What joins two regions of parts: the overlap of a child with its parent.
struct Joint
{
    std::size_t child;
    std::size_t parent;
    std::array<std::size_t, 2> curves;
    std::array<int, 2> ends; ///< the regions beyond the curves
};

class Labelling
{
public:
    Labelling(std::vector<Joint> joints, std::size_t regions) : m_joints(std::move(joints)), m_parts(regions)
    {
        m_parts.assign(regions, CurveRegions::none);
    }

    /// Names the regions around joints until all are named; returns the child whose place is wrong.
    std::optional<std::size_t> run(std::span<const double> areas)
    {
        for (const Joint& joint : m_joints) {
            if (m_parts[at(joint.ends[0])] != CurveRegions::none)
                continue;
            const bool firstIsChild = areas[at(joint.ends[0])] < areas[at(joint.ends[1])];
            const auto likely = firstIsChild ? joint.child : joint.parent;
            const auto otherwise = firstIsChild ? joint.parent : joint.child;
            const std::vector<int> before = m_parts;
            if (!spread(joint.ends[0], likely))
                continue;
            m_parts = before;
            if (const auto wrong = spread(joint.ends[0], otherwise))
                return wrong;
        }
        return std::nullopt;
    }

    const std::vector<Joint>& joints() const { return m_joints; }
    std::vector<int>& parts() { return m_parts; }

private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }

    std::optional<std::size_t> spread(int region, std::size_t part)
    {
        m_parts[at(region)] = static_cast<int>(part);
        std::vector<int> left{region};
        while (!left.empty()) {
            const int here = left.back();
            left.pop_back();
            for (const Joint& joint : m_joints) {
                if (joint.ends[0] != here && joint.ends[1] != here)
                    continue;
                const int there = joint.ends[0] == here ? joint.ends[1] : joint.ends[0];
                const auto name = static_cast<std::size_t>(m_parts[at(here)]);
                if (name != joint.child && name != joint.parent)
                    return joint.child;
                const auto beyond = static_cast<int>(name == joint.child ? joint.parent : joint.child);
                if (m_parts[at(there)] == CurveRegions::none) {
                    m_parts[at(there)] = beyond;
                    left.push_back(there);
                } else if (m_parts[at(there)] != beyond) {
                    return joint.child;
                }
            }
        }
        return std::nullopt;
    }

    std::vector<Joint> m_joints;
    std::vector<int> m_parts; ///< per region
};

/// The region that both curves bound and no other does; `none` where there is none.
int ringBetween(const CurveRegions& regions, std::size_t one, std::size_t other)
{
    for (const int region : regions.beside[one]) {
        if (std::ranges::find(regions.beside[other], region) == regions.beside[other].end())
            continue;
        const auto bounds = std::ranges::count_if(regions.beside, [&](const std::array<int, 2>& beside) {
            return std::ranges::find(beside, region) != beside.end();
        });
        if (bounds == 2)
            return region;
    }
    return CurveRegions::none;
}

} // namespace

PartRegions partRegions(const CurveRegions& regions, std::span<const PartCurve> curves,
                        std::span<const PartDescription> descriptions, std::span<const double> areas)
{
    PartRegions found;
    found.overlaps.assign(descriptions.size(), CurveRegions::none);
    found.curves.resize(descriptions.size());
    std::vector<Joint> joints;
    for (std::size_t p = 0; p < descriptions.size(); ++p) {
        const PartDescription& part = descriptions[p];
        if (part.parent.empty())
            continue;
        const std::array<std::size_t, 2> pair{*indexOf(curves, part.curves[0]),
                                              *indexOf(curves, part.curves[1])};
        const int ring = ringBetween(regions, pair[0], pair[1]);
        if (ring == CurveRegions::none) {
            found.faults.push_back({ErrorCode::PartCurvesApart, p});
            continue;
        }
        found.overlaps[p] = ring;
        const auto beyond = [&](std::size_t curve) {
            const auto& beside = regions.beside[curve];
            return beside[0] == ring ? beside[1] : beside[0];
        };
        joints.push_back({p, *indexOf(descriptions, part.parent), pair, {beyond(pair[0]), beyond(pair[1])}});
    }
    if (!found.faults.empty())
        return found;
    Labelling labelling(std::move(joints), static_cast<std::size_t>(regions.count));
    if (const auto wrong = labelling.run(areas)) {
        found.faults.push_back({ErrorCode::PartMisplaced, *wrong});
        return found;
    }
    found.partOf = std::move(labelling.parts());
    for (const Joint& joint : labelling.joints()) {
        found.partOf[static_cast<std::size_t>(found.overlaps[joint.child])] = static_cast<int>(joint.child);
        const bool firstIsParents =
            found.partOf[static_cast<std::size_t>(joint.ends[0])] == static_cast<int>(joint.parent);
        found.curves[joint.child] =
            firstIsParents ? joint.curves : std::array{joint.curves[1], joint.curves[0]};
    }
    return found;
}

std::vector<std::size_t> emptyParts(const Topology& topology, const CurveRegions& regions,
                                    const PartRegions& parts)
{
    std::vector<bool> isShared(topology.vertexCount());
    const auto isOverlap = [&](int region) {
        return std::ranges::find(parts.overlaps, region) != parts.overlaps.end();
    };
    const auto regionOf = [&](std::size_t t) { return regions.ofTriangle[t]; };
    for (std::size_t t = 0; t < topology.triangles().size(); ++t) {
        for (const VertexIndex v : topology.triangles()[t]) {
            if (regionOf(t) != CurveRegions::none && isOverlap(regionOf(t)))
                isShared[v.value] = true;
        }
    }
    std::vector<bool> hasOwn(parts.overlaps.size(), regions.count == 0);
    for (std::size_t t = 0; t < topology.triangles().size(); ++t) {
        for (const VertexIndex v : topology.triangles()[t]) {
            if (regionOf(t) != CurveRegions::none && !isShared[v.value])
                hasOwn[static_cast<std::size_t>(parts.partOf[static_cast<std::size_t>(regionOf(t))])] = true;
        }
    }
    std::vector<std::size_t> empty;
    for (std::size_t p = 0; p < hasOwn.size(); ++p) {
        if (!hasOwn[p])
            empty.push_back(p);
    }
    return empty;
}

} // namespace quadrille
