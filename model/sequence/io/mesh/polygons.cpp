// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/polygons.h"

#include <algorithm>

namespace quadrille {

void PolygonCollector::end(TopologyData& topology)
{
    if (m_vertices.size() > 3)
        ++m_polygonCount;
    for (std::size_t c = 2; c < m_vertices.size(); ++c) {
        const std::uint32_t a = m_vertices[0];
        const std::uint32_t b = m_vertices[c - 1];
        const std::uint32_t d = m_vertices[c];
        if (a == b || b == d || a == d) {
            ++m_leftOutCount;
            continue;
        }
        topology.triangles.push_back({VertexIndex(a), VertexIndex(b), VertexIndex(d)});
        topology.triangleUvs.push_back({m_uvs[0], m_uvs[c - 1], m_uvs[c]});
        topology.triangleMaterials.push_back(m_material);
    }
}

void PolygonCollector::finish(TopologyData& topology, const std::filesystem::path& file,
                              std::vector<Issue>& issues) const
{
    if (topology.triangles.empty())
        throw Error(ErrorCode::NoFaces, {file, {}, {}});
    bool anyUv = false;
    bool anyWithout = false;
    for (const auto& corners : topology.triangleUvs) {
        for (const std::uint32_t uv : corners)
            (uv == noUv ? anyWithout : anyUv) = true;
    }
    if (!anyUv) {
        topology.triangleUvs.clear();
        topology.uvs.clear();
    } else if (anyWithout) {
        const auto origin = static_cast<std::uint32_t>(topology.uvs.size());
        topology.uvs.emplace_back(0, 0);
        for (auto& corners : topology.triangleUvs)
            std::replace(corners.begin(), corners.end(), noUv, origin);
    }
    if (topology.materials.size() < 2)
        topology.triangleMaterials.clear();
    if (topology.materials.size() == 1 && topology.materials.front().empty())
        topology.materials.clear();
    const auto report = [&](Issue::Severity severity, Issue::Code code, std::int64_t count) {
        if (count > 0)
            issues.push_back({severity, code, {file, {}, {{"count", std::to_string(count)}}}});
    };
    report(Issue::Severity::Info, Issue::Code::PolygonsTriangulated, m_polygonCount);
    report(Issue::Severity::Warning, Issue::Code::DuplicateFaces, m_leftOutCount);
}

} // namespace quadrille
