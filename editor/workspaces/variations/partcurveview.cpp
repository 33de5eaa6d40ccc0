// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurveview.h"

#include "editor/errors/errortext.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/geometry/curveedits.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkview.h"

#include <algorithm>
#include <utility>

namespace quadrille {

using widgets::ShownCurve;
using widgets::SurfaceCurvePart;

ShownCurve shownCurve(const std::shared_ptr<const SurfaceGraph>& graph, const PartCurveEntry& entry)
{
    ShownCurve curve;
    curve.name = QString::fromStdString(entry.curve.name);
    const auto& vertices = entry.curve.vertices;
    if (graph && isWholeCurve(*graph, vertices)) {
        try {
            SurfaceCurve route(graph);
            route.restore(entry.points.empty() ? guidesOf(graph, vertices) : entry.points, vertices);
            for (const VertexIndex vertex : route.vertices())
                curve.vertices.push_back(vertex.value);
            curve.points = route.places();
            return curve;
        } catch (const Error&) {
            // It is shown as it is, below; what is wrong with it is said beside it.
            curve.points.clear();
        }
    }
    curve.isClosed = false;
    for (const VertexIndex vertex : vertices.empty() ? entry.points : vertices)
        if (graph && vertex.value < graph->vertexCount())
            curve.vertices.push_back(vertex.value);
    for (std::size_t i = 0; vertices.empty() && i < curve.vertices.size(); ++i)
        curve.points.push_back(i);
    return curve;
}

void PartCurveView::setActive(bool active)
{
    m_isActive = active;
    widgets::Viewport& viewport = m_view.viewport();
    m_editor.setActive(active);
    if (active)
        viewport.setViewTool(&m_editor);
    else if (viewport.viewTool() == &m_editor)
        viewport.setViewTool(nullptr);
    m_view.setColoredByTool(active);
}

void PartCurveView::refreshFigure()
{
    const widgets::Viewport& viewport = m_view.viewport();
    const ClipScene& scene = m_view.scene();
    const auto& graph = m_content.graph;
    int figure = -1;
    for (const QString& name : scene.shown()) {
        const auto shape = viewport.figureShape(scene.figureOf(name));
        if (figure < 0 && shape && graph && shape->mesh.vertexCount == graph->vertexCount() &&
            shape->mesh.triangles.size() == graph->topology().triangles().size())
            figure = scene.figureOf(name);
    }
    m_editor.setFigure(figure);
    frameFigure();
}

void PartCurveView::frameFigure()
{
    widgets::Viewport& viewport = m_view.viewport();
    const auto shape = viewport.figureShape(m_editor.figure());
    if (!m_isActive || m_framed == m_editor.figure() || !shape || shape->positions.empty())
        return;
    QVector3D lower = shape->place(0);
    QVector3D upper = lower;
    for (std::uint32_t vertex = 1; vertex < shape->mesh.vertexCount; ++vertex) {
        const QVector3D place = shape->place(vertex);
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] = std::min(lower[axis], place[axis]);
            upper[axis] = std::max(upper[axis], place[axis]);
        }
    }
    if (lower == upper) // nothing was loaded yet
        return;
    m_framed = m_editor.figure();
    m_view.scene().keepCamera();
    widgets::Turntable camera = viewport.camera();
    camera.frame(lower, upper, viewport.size());
    viewport.setCamera(camera);
}

void PartCurveView::refreshCurves(const std::string& drawn)
{
    std::map<std::string, std::pair<PartCurveEntry, ShownCurve>> now;
    std::vector<ShownCurve> curves;
    for (const PartCurveEntry& entry : m_content.body.curves) {
        const auto before = m_shown.find(entry.curve.name);
        ShownCurve curve = before != m_shown.end() && before->second.first == entry
                               ? before->second.second
                               : shownCurve(m_content.graph, entry);
        now[entry.curve.name] = {entry, curve};
        curve.color = widgets::Theme::color(widgets::ColorRole::ViewportText);
        if (const PartProblem* problem = m_content.cut.problemOfCurve(entry.curve.name))
            curve.problem = describe(problem->error).sentence;
        curves.push_back(std::move(curve));
    }
    m_shown = std::move(now);
    m_editor.setCurves(std::move(curves));
    m_editor.setDrawn(m_content.indexOf(drawn));
    // Undo may put another curve in the place of the selected one.
    const int selected = m_content.indexOf(m_content.selected.name);
    if (m_content.selectedCurve() != nullptr && m_editor.selected().curve != selected)
        m_editor.setSelected({SurfaceCurvePart::Kind::Curve, selected, 0});
}

void PartCurveView::refreshColors()
{
    widgets::Viewport& viewport = m_view.viewport();
    const auto shape = viewport.figureShape(m_editor.figure());
    if (!shape)
        return;
    PartColors colors;
    if (m_isActive)
        colors = partColors(m_content.cut, m_content.body, shape->mesh.triangles.size(),
                            PartCurveTool::tr("Body parts"), PartCurveTool::tr("shared by two, lighter"));
    viewport.setTriangleColors(m_editor.figure(), colors.triangles, colors.key);
}

void PartCurveView::describeSelection()
{
    const SurfaceCurvePart& part = m_editor.selected();
    const PartCurveEntry* entry = m_content.curveAt(part.curve);
    QString text;
    if (entry != nullptr && part.kind == SurfaceCurvePart::Kind::Point)
        text = PartCurveTool::tr("Point %1 of the curve “%2”")
                   .arg(part.point + 1)
                   .arg(QString::fromStdString(entry->curve.name));
    else if (entry != nullptr && part.kind == SurfaceCurvePart::Kind::Curve)
        text = PartCurveTool::tr("Curve “%1”").arg(QString::fromStdString(entry->curve.name));
    if (const PartProblem* problem =
            text.isEmpty() ? nullptr : m_content.cut.problemOfCurve(entry->curve.name))
        text += QStringLiteral(". ") + describe(problem->error).sentence;
    if (widgets::VtkView* view = m_view.viewport().view())
        view->setAccessibleDescription(text);
}

} // namespace quadrille
