// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What clicks and drags in the view do to the points of curves.
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurveroute.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/geometry/curveedits.h"

#include <algorithm>

namespace quadrille {

using widgets::SurfaceCurveEditor;
using widgets::SurfaceCurvePart;
using widgets::SurfacePlace;

void PartCurveTool::connectEditor()
{
    connect(m_editor, &SurfaceCurveEditor::pointAdded, this, &PartCurveTool::addPoint);
    connect(m_editor, &SurfaceCurveEditor::lastPointRemovalRequested, this, &PartCurveTool::removeLastPoint);
    connect(m_editor, &SurfaceCurveEditor::pointerMoved, this, &PartCurveTool::preview);
    connect(m_editor, &SurfaceCurveEditor::pointMoved, this, &PartCurveTool::movePoint);
    connect(m_editor, &SurfaceCurveEditor::moveCancelled, this, &PartCurveTool::cancelMove);
    connect(m_editor, &SurfaceCurveEditor::pointInserted, this, &PartCurveTool::insertPoint);
    connect(m_editor, &SurfaceCurveEditor::pointRemovalRequested, this, &PartCurveTool::removePoint);
    connect(m_editor, &SurfaceCurveEditor::curveRemovalRequested, this, [this](int curve) {
        if (const PartCurveEntry* entry = curveAt(curve)) {
            select({PartSelection::Kind::Curve, entry->curve.name});
            removeSelected();
        }
    });
    connect(m_editor, &SurfaceCurveEditor::modeChanged, this, [this](SurfaceCurveEditor::Mode mode) {
        if (mode == SurfaceCurveEditor::Mode::Edit)
            finishDrawing();
        refreshActions();
        emit changed();
    });
    connect(m_editor, &SurfaceCurveEditor::selectionChanged, this, &PartCurveTool::followSelection);
    connect(m_editor, &SurfaceCurveEditor::contextMenuRequested, this, &PartCurveTool::showMenu);
}

void PartCurveTool::refuse(const Error& error)
{
    m_editor->setRefusal(sentence(error));
}

std::vector<VertexIndex> PartCurveTool::obstaclesFor(const std::string& curve) const
{
    std::vector<VertexIndex> vertices;
    for (const PartCurveEntry& entry : m_body.curves)
        if (entry.curve.name != curve)
            for (const VertexIndex vertex : entry.curve.vertices)
                if (vertex.value < m_shownGraph->vertexCount())
                    vertices.push_back(vertex);
    return vertices;
}

std::unique_ptr<PartCurveTool::Route> PartCurveTool::routeOf(const PartCurveEntry* entry, bool snaps) const
{
    CurveSettings settings;
    if (!snaps || !m_drawing.snaps)
        settings.creases = 0;
    const std::string name = entry != nullptr ? entry->curve.name : std::string();
    auto route = std::make_unique<Route>(
        Route{name, SurfaceCurve(m_shownGraph, settings), m_body, obstaclesFor(name), std::nullopt});
    route->curve.setObstacles(route->taken);
    if (entry == nullptr)
        return route;
    std::vector<VertexIndex> points = entry->points;
    if (points.empty())
        points = guidesOf(m_shownGraph, entry->curve.vertices);
    route->curve.restore(std::move(points), entry->curve.vertices);
    return route;
}

VertexIndex PartCurveTool::vertexAt(const SurfacePlace& place, const Route& route) const
{
    const auto& weights = place.pick.barycentric;
    const VertexIndex nearest = nearestVertex(*m_shownGraph, TriangleIndex(place.pick.triangle),
                                              {weights[0], weights[1], weights[2]});
    if (!m_drawing.snaps || !place.snaps)
        return nearest;
    const VertexIndex crease = nearestCrease(*m_shownGraph, nearest, m_drawing.snapRadius).value_or(nearest);
    const auto isIn = [crease](const std::vector<VertexIndex>& vertices) {
        return std::find(vertices.begin(), vertices.end(), crease) != vertices.end();
    };
    // Where something is already, it stays where it was put.
    return isIn(route.taken) || isIn(route.curve.points()) ? nearest : crease;
}

void PartCurveTool::take(const Route& route, const QString& text, const QString& property, EditPhase phase)
{
    m_editor->setRefusal({});
    edit(
        text, property,
        [&route](BodyPartsEntry& body) {
            PartCurveEntry* entry = findCurve(body, route.name);
            if (entry == nullptr) {
                entry = &body.curves.emplace_back();
                entry->curve.name = route.name;
            }
            entry->points = route.curve.points();
            entry->curve.vertices = route.curve.vertices();
        },
        phase);
}

void PartCurveTool::addPoint(const SurfacePlace& place)
{
    if (!m_shownGraph)
        return;
    try {
        const PartCurveEntry* entry = findCurve(m_body, m_drawn);
        const auto route = routeOf(entry, place.snaps);
        if (entry == nullptr)
            route->name = freeCurveName(m_body, tr("curve").toStdString());
        route->curve.insert(route->curve.points().size(), vertexAt(place, *route));
        m_drawn = route->name;
        take(*route, entry == nullptr ? tr("Draw a curve") : tr("Add a point to a curve"),
             QStringLiteral("curve points"));
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveTool::removeLastPoint()
{
    const PartCurveEntry* entry = findCurve(m_body, m_drawn);
    if (entry != nullptr && !entry->points.empty())
        removePoint(indexOf(m_drawn), static_cast<int>(entry->points.size()) - 1);
}

void PartCurveTool::preview(const std::optional<SurfacePlace>& place)
{
    if (!place || !m_shownGraph) {
        m_editor->setPreview({});
        return;
    }
    try {
        const bool isNew = m_trial == nullptr;
        if (isNew)
            m_trial = routeOf(findCurve(m_body, m_drawn), place->snaps);
        SurfaceCurve& curve = m_trial->curve;
        const VertexIndex vertex = vertexAt(*place, *m_trial);
        if (isNew)
            curve.insert(curve.points().size(), vertex);
        else if (vertex != m_trial->last)
            curve.move(curve.points().size() - 1, vertex);
        m_trial->last = vertex;
        m_editor->setRefusal({});
        // The two pieces at the new point: all from the point before it.
        const std::vector<std::size_t> places = curve.places();
        const std::size_t from = places.size() > 1 ? places[places.size() - 2] : 0;
        std::vector<std::uint32_t> vertices;
        for (std::size_t i = from; i < curve.vertices().size(); ++i)
            vertices.push_back(curve.vertices()[i].value);
        if (!curve.vertices().empty())
            vertices.push_back(curve.vertices().front().value);
        m_editor->setPreview(std::move(vertices));
    } catch (const Error&) {
        // A click there would say why it cannot be.
        m_trial.reset();
        m_editor->setPreview({});
    }
}

void PartCurveTool::movePoint(int curve, int point, const SurfacePlace& place, bool committed)
{
    const PartCurveEntry* entry = curveAt(curve);
    if (entry == nullptr || !m_shownGraph)
        return;
    const QString property = QStringLiteral("curve point %1").arg(point);
    try {
        if (!m_drag || m_drag->name != entry->curve.name)
            m_drag = routeOf(entry, place.snaps);
        const auto index = static_cast<std::size_t>(point);
        const VertexIndex vertex = vertexAt(place, *m_drag);
        if (vertex != m_drag->last && vertex != m_drag->curve.points()[index]) {
            m_drag->last = vertex;
            m_drag->curve.move(index, vertex);
            take(*m_drag, tr("Move a point of a curve"), property,
                 committed ? EditPhase::Final : EditPhase::Dragging);
        } else if (committed && m_drag->last) {
            take(*m_drag, tr("Move a point of a curve"), property);
        }
    } catch (const Error& error) {
        refuse(error);
        if (committed && m_drag && m_drag->last) // the last place that it could go to
            edit(tr("Move a point of a curve"), property, [](BodyPartsEntry&) {});
    }
    if (committed)
        m_drag.reset();
}

void PartCurveTool::cancelMove(int /*curve*/)
{
    if (!m_drag)
        return;
    const auto drag = std::move(m_drag);
    const int point = m_editor->selected().point;
    m_editor->setRefusal({});
    edit(tr("Move a point of a curve"), QStringLiteral("curve point %1").arg(point),
         [&drag](BodyPartsEntry& body) { body = drag->before; });
}

void PartCurveTool::insertPoint(int curve, int after, const SurfacePlace& place)
{
    const PartCurveEntry* entry = curveAt(curve);
    if (entry == nullptr || !m_shownGraph)
        return;
    try {
        const auto route = routeOf(entry, place.snaps);
        route->curve.insert(static_cast<std::size_t>(after) + 1, vertexAt(place, *route));
        take(*route, tr("Insert a point into a curve"), QStringLiteral("curve points"));
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveTool::removePoint(int curve, int point)
{
    const PartCurveEntry* entry = curveAt(curve);
    if (entry == nullptr || !m_shownGraph)
        return;
    try {
        const auto route = routeOf(entry, true);
        if (route->curve.points().size() < 2) {
            edit(tr("Delete a curve"), QStringLiteral("curves"),
                 [name = entry->curve.name](BodyPartsEntry& body) { removeCurve(body, name); });
            return;
        }
        route->curve.remove(static_cast<std::size_t>(point));
        take(*route, tr("Delete a point of a curve"), QStringLiteral("curve points"));
        if (m_editor->mode() == SurfaceCurveEditor::Mode::Edit)
            m_editor->setSelected({SurfaceCurvePart::Kind::Point, curve, std::max(point - 1, 0)});
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveTool::finishDrawing()
{
    m_trial.reset();
    if (m_drawn.empty())
        return;
    const int curve = indexOf(m_drawn);
    m_drawn.clear();
    m_editor->setDrawn(-1);
    if (curve >= 0)
        m_editor->setSelected({SurfaceCurvePart::Kind::Curve, curve, 0});
}

} // namespace quadrille
