// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurveroute.h"

#include "editor/workspaces/variations/partedits.h"
#include "model/geometry/curveedits.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

CurveSettings settingsFor(const PartCurveContent& content, bool snaps)
{
    CurveSettings settings;
    if (!snaps || !content.drawing.snaps)
        settings.creases = 0;
    return settings;
}

/// The vertices of all other curves.
std::vector<VertexIndex> takenBesides(const std::string& curve, const PartCurveContent& content)
{
    std::vector<VertexIndex> vertices;
    for (const PartCurveEntry& entry : content.body.curves)
        if (entry.curve.name != curve)
            for (const VertexIndex vertex : entry.curve.vertices)
                if (vertex.value < content.graph->vertexCount())
                    vertices.push_back(vertex);
    return vertices;
}

} // namespace

PartCurveRoute::PartCurveRoute(const PartCurveContent& content, const PartCurveEntry* entry, bool snaps)
    : m_content(content)
    , m_name(entry != nullptr ? entry->curve.name : std::string())
    , m_curve(content.graph, settingsFor(content, snaps))
    , m_before(content.body)
    , m_taken(takenBesides(m_name, content))
{
    m_curve.setObstacles(m_taken);
    if (entry == nullptr)
        return;
    std::vector<VertexIndex> points = entry->points;
    if (points.empty())
        points = guidesOf(content.graph, entry->curve.vertices);
    m_curve.restore(std::move(points), entry->curve.vertices);
}

VertexIndex PartCurveRoute::vertexAt(const widgets::SurfacePlace& place) const
{
    const SurfaceGraph& graph = *m_content.graph;
    const auto& weights = place.pick.barycentric;
    const VertexIndex nearest =
        nearestVertex(graph, TriangleIndex(place.pick.triangle), {weights[0], weights[1], weights[2]});
    if (!m_content.drawing.snaps || !place.snaps)
        return nearest;
    const VertexIndex crease = nearestCrease(graph, nearest, m_content.drawing.snapRadius).value_or(nearest);
    const auto isIn = [crease](const std::vector<VertexIndex>& vertices) {
        return std::find(vertices.begin(), vertices.end(), crease) != vertices.end();
    };
    // Where something is already, it stays where it was put.
    return isIn(m_taken) || isIn(m_curve.points()) ? nearest : crease;
}

void PartCurveRoute::insert(std::size_t before, const widgets::SurfacePlace& place)
{
    m_curve.insert(before, vertexAt(place));
}

bool PartCurveRoute::move(std::size_t index, const widgets::SurfacePlace& place)
{
    const VertexIndex vertex = vertexAt(place);
    if (vertex == m_last || vertex == m_curve.points()[index])
        return false;
    m_last = vertex;
    m_curve.move(index, vertex);
    return true;
}

void PartCurveRoute::leadTo(const widgets::SurfacePlace& place)
{
    const VertexIndex vertex = vertexAt(place);
    if (!m_last)
        m_curve.insert(m_curve.points().size(), vertex);
    else if (vertex != m_last)
        m_curve.move(m_curve.points().size() - 1, vertex);
    m_last = vertex;
}

std::vector<std::uint32_t> PartCurveRoute::lastPieces() const
{
    const std::vector<std::size_t> places = m_curve.places();
    const std::size_t from = places.size() > 1 ? places[places.size() - 2] : 0;
    std::vector<std::uint32_t> vertices;
    for (std::size_t i = from; i < m_curve.vertices().size(); ++i)
        vertices.push_back(m_curve.vertices()[i].value);
    if (!m_curve.vertices().empty())
        vertices.push_back(m_curve.vertices().front().value);
    return vertices;
}

void PartCurveRoute::putInto(BodyPartsEntry& body) const
{
    PartCurveEntry* entry = findCurve(body, m_name);
    if (entry == nullptr) {
        entry = &body.curves.emplace_back();
        entry->curve.name = m_name;
    }
    entry->points = m_curve.points();
    entry->curve.vertices = m_curve.vertices();
}

} // namespace quadrille
