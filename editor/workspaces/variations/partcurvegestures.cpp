// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvegestures.h"

#include "editor/errors/errortext.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"

#include <algorithm>
#include <utility>

namespace quadrille {

using widgets::SurfaceCurveEditor;
using widgets::SurfaceCurvePart;
using widgets::SurfacePlace;

PartCurveGestures::PartCurveGestures(const PartCurveContent& content, SurfaceCurveEditor& editor,
                                     QObject* parent)
    : QObject(parent), m_content(content), m_editor(editor)
{
    connect(&editor, &SurfaceCurveEditor::pointAdded, this, &PartCurveGestures::addPoint);
    connect(&editor, &SurfaceCurveEditor::lastPointRemovalRequested, this,
            &PartCurveGestures::removeLastPoint);
    connect(&editor, &SurfaceCurveEditor::pointerMoved, this, &PartCurveGestures::preview);
    connect(&editor, &SurfaceCurveEditor::pointMoved, this, &PartCurveGestures::movePoint);
    connect(&editor, &SurfaceCurveEditor::moveCancelled, this, &PartCurveGestures::cancelMove);
    connect(&editor, &SurfaceCurveEditor::pointInserted, this, &PartCurveGestures::insertPoint);
    connect(&editor, &SurfaceCurveEditor::pointRemovalRequested, this, &PartCurveGestures::removePoint);
}

void PartCurveGestures::forget(bool surface)
{
    m_trial.reset();
    if (surface)
        m_drag.reset();
}

std::unique_ptr<PartCurveRoute> PartCurveGestures::routeOf(const PartCurveEntry* entry, bool snaps) const
{
    return std::make_unique<PartCurveRoute>(m_content, entry, snaps);
}

void PartCurveGestures::refuse(const Error& error)
{
    m_editor.setRefusal(describe(error).sentence);
}

void PartCurveGestures::take(const PartCurveRoute& route, const QString& text, const QString& property,
                             EditPhase phase)
{
    m_editor.setRefusal({});
    emit edited(
        text, property, [&route](BodyPartsEntry& body) { route.putInto(body); }, phase);
}

void PartCurveGestures::addPoint(const SurfacePlace& place)
{
    if (!m_content.graph)
        return;
    try {
        const PartCurveEntry* entry = findCurve(m_content.body, m_drawn);
        const auto route = routeOf(entry, place.snaps);
        if (entry == nullptr)
            route->setName(freeCurveName(m_content.body, PartCurveTool::tr("curve").toStdString()));
        route->insert(route->curve().points().size(), place);
        m_drawn = route->name();
        take(*route,
             entry == nullptr ? PartCurveTool::tr("Draw a curve")
                              : PartCurveTool::tr("Add a point to a curve"),
             QStringLiteral("curve points"));
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveGestures::removeLastPoint()
{
    const PartCurveEntry* entry = findCurve(m_content.body, m_drawn);
    if (entry != nullptr && !entry->points.empty())
        removePoint(m_content.indexOf(m_drawn), static_cast<int>(entry->points.size()) - 1);
}

void PartCurveGestures::preview(const std::optional<SurfacePlace>& place)
{
    if (!place || !m_content.graph) {
        m_editor.setPreview({});
        return;
    }
    try {
        if (!m_trial)
            m_trial = routeOf(findCurve(m_content.body, m_drawn), place->snaps);
        m_trial->leadTo(*place);
        m_editor.setRefusal({});
        m_editor.setPreview(m_trial->lastPieces());
    } catch (const Error&) {
        // A click there would say why it cannot be.
        m_trial.reset();
        m_editor.setPreview({});
    }
}

void PartCurveGestures::movePoint(int curve, int point, const SurfacePlace& place, bool committed)
{
    const PartCurveEntry* entry = m_content.curveAt(curve);
    if (entry == nullptr || !m_content.graph)
        return;
    const QString text = PartCurveTool::tr("Move a point of a curve");
    const QString property = QStringLiteral("curve point %1").arg(point);
    try {
        if (!m_drag || m_drag->name() != entry->curve.name)
            m_drag = routeOf(entry, place.snaps);
        if (m_drag->move(static_cast<std::size_t>(point), place))
            take(*m_drag, text, property, committed ? EditPhase::Final : EditPhase::Dragging);
        else if (committed && m_drag->hasMoved())
            take(*m_drag, text, property);
    } catch (const Error& error) {
        refuse(error);
        if (committed && m_drag && m_drag->hasMoved()) // the last place that it could go to
            emit edited(
                text, property, [](BodyPartsEntry&) {}, EditPhase::Final);
    }
    if (committed)
        m_drag.reset();
}

void PartCurveGestures::cancelMove()
{
    if (!m_drag)
        return;
    const auto drag = std::move(m_drag);
    const int point = m_editor.selected().point;
    m_editor.setRefusal({});
    emit edited(
        PartCurveTool::tr("Move a point of a curve"), QStringLiteral("curve point %1").arg(point),
        [&drag](BodyPartsEntry& body) { body = drag->before(); }, EditPhase::Final);
}

void PartCurveGestures::insertPoint(int curve, int after, const SurfacePlace& place)
{
    const PartCurveEntry* entry = m_content.curveAt(curve);
    if (entry == nullptr || !m_content.graph)
        return;
    try {
        const auto route = routeOf(entry, place.snaps);
        route->insert(static_cast<std::size_t>(after) + 1, place);
        take(*route, PartCurveTool::tr("Insert a point into a curve"), QStringLiteral("curve points"));
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveGestures::removePoint(int curve, int point)
{
    const PartCurveEntry* entry = m_content.curveAt(curve);
    if (entry == nullptr || !m_content.graph)
        return;
    try {
        const auto route = routeOf(entry, true);
        if (route->curve().points().size() < 2) {
            emit edited(
                PartCurveTool::tr("Delete a curve"), QStringLiteral("curves"),
                [name = entry->curve.name](BodyPartsEntry& body) { removeCurve(body, name); },
                EditPhase::Final);
            return;
        }
        route->remove(static_cast<std::size_t>(point));
        take(*route, PartCurveTool::tr("Delete a point of a curve"), QStringLiteral("curve points"));
        if (m_editor.mode() == SurfaceCurveEditor::Mode::Edit)
            m_editor.setSelected({SurfaceCurvePart::Kind::Point, curve, std::max(point - 1, 0)});
    } catch (const Error& error) {
        refuse(error);
    }
}

void PartCurveGestures::finishDrawing()
{
    m_trial.reset();
    if (m_drawn.empty())
        return;
    const int curve = m_content.indexOf(m_drawn);
    m_drawn.clear();
    m_editor.setDrawn(-1);
    if (curve >= 0)
        m_editor.setSelected({SurfaceCurvePart::Kind::Curve, curve, 0});
}

} // namespace quadrille

#include "moc_partcurvegestures.cpp"
