// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvetool.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurveroute.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/geometry/curveedits.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <algorithm>
#include <utility>

namespace quadrille {

using widgets::ShownCurve;
using widgets::SurfaceCurveEditor;
using widgets::SurfaceCurvePart;

namespace {

std::vector<std::uint32_t> numbersOf(std::span<const VertexIndex> vertices)
{
    std::vector<std::uint32_t> numbers;
    numbers.reserve(vertices.size());
    for (const VertexIndex vertex : vertices)
        numbers.push_back(vertex.value);
    return numbers;
}

bool isWholeCurve(const SurfaceGraph& graph, std::span<const VertexIndex> vertices)
{
    const std::size_t count = vertices.size();
    if (count < 3)
        return false;
    for (std::size_t i = 0; i < count; ++i)
        if (vertices[i].value >= graph.vertexCount() ||
            vertices[(i + 1) % count].value >= graph.vertexCount() ||
            !graph.haveEdge(vertices[i], vertices[(i + 1) % count]))
            return false;
    return true;
}

} // namespace

PartCurveTool::PartCurveTool(CurrentVariation& variation, QObject* parent)
    : QObject(parent)
    , m_variation(variation)
    , m_surface(new BodySurface(variation, this))
    , m_editor(new SurfaceCurveEditor(variation.view().viewport(), this))
    , m_drawing(variation.context().settings.curveDrawing())
{
    m_editor->setActive(false);
    makeActions();
    connectEditor();
    connect(&variation, &CurrentVariation::bodyChanged, this, &PartCurveTool::refresh);
    connect(m_surface, &BodySurface::changed, this, &PartCurveTool::refresh);
    connect(&variation.view().scene(), &ClipScene::changed, this, [this] {
        refreshFigure();
        refreshColors();
    });
    connect(&variation.view().viewport(), &widgets::Viewport::figureChanged, this,
            &PartCurveTool::frameFigure);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &PartCurveTool::refresh);
    retranslates(&variation.view(), [this] { refresh(); });
}

PartCurveTool::~PartCurveTool() = default;

QString PartCurveTool::sentence(const Error& error)
{
    return describe(error).sentence;
}

void PartCurveTool::setActive(bool active)
{
    if (active == m_isActive)
        return;
    m_isActive = active;
    widgets::Viewport& viewport = m_variation.view().viewport();
    m_editor->setActive(active);
    if (active)
        viewport.setViewTool(m_editor);
    else if (viewport.viewTool() == m_editor)
        viewport.setViewTool(nullptr);
    m_variation.view().setColoredByTool(active);
    refresh();
}

void PartCurveTool::setSnaps(bool snaps)
{
    m_drawing.snaps = snaps;
    m_variation.context().actions.action(QStringLiteral("variations.curve.snap"))->setChecked(snaps);
    keepDrawing();
}

void PartCurveTool::setSnapRadius(double metres)
{
    m_drawing.snapRadius = metres;
    keepDrawing();
}

void PartCurveTool::setOverlap(double metres)
{
    m_drawing.overlap = metres;
    keepDrawing();
}

void PartCurveTool::keepDrawing()
{
    m_variation.context().settings.setCurveDrawing(m_drawing);
    emit changed();
}

void PartCurveTool::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    emit told({});
    m_variation.view().scene().keepCamera(); // who draws has chosen the view
    m_variation.editBody(text, property, edit, phase);
}

std::vector<std::string> PartCurveTool::looseCurves() const
{
    return unusedCurves(curvesOf(m_body), partsOf(m_body));
}

double PartCurveTool::lengthOfCurve(const std::string& name) const
{
    const PartCurveEntry* entry = findCurve(m_body, name);
    const auto graph = m_surface->graph();
    return graph && entry != nullptr && isWholeCurve(*graph, entry->curve.vertices)
               ? lengthOf(*graph, entry->curve.vertices)
               : 0.0;
}

void PartCurveTool::refresh()
{
    m_body = m_variation.body();
    m_trial.reset();
    const auto graph = m_surface->graph();
    if (graph != m_shownGraph) {
        m_shownGraph = graph;
        m_shown.clear();
        m_symmetry.reset();
        m_drag.reset();
    }
    m_cut = graph ? cutBody(*graph, m_body) : PartCut();
    m_variation.context().bodies.set(
        m_variation.character(),
        m_cut.problems.empty() ? QString() : describe(m_cut.problems.front().error).oneLine());
    const bool isGone =
        (m_selected.kind == PartSelection::Kind::Curve && findCurve(m_body, m_selected.name) == nullptr) ||
        (m_selected.kind == PartSelection::Kind::Part && findPart(m_body, m_selected.name) == nullptr);
    if (isGone)
        m_selected = {};
    refreshFigure();
    refreshCurves();
    refreshColors();
    refreshActions();
    if (isGone)
        emit selectionChanged();
    emit changed();
}

void PartCurveTool::refreshFigure()
{
    const widgets::Viewport& viewport = m_variation.view().viewport();
    const ClipScene& scene = m_variation.view().scene();
    int figure = -1;
    for (const QString& name : scene.shown()) {
        const auto shape = viewport.figureShape(scene.figureOf(name));
        if (figure < 0 && shape && m_shownGraph && shape->mesh.vertexCount == m_shownGraph->vertexCount() &&
            shape->mesh.triangles.size() == m_shownGraph->topology().triangles().size())
            figure = scene.figureOf(name);
    }
    m_editor->setFigure(figure);
    frameFigure();
}

/// The body instead of all its way, the first time that its parts are worked on.
void PartCurveTool::frameFigure()
{
    widgets::Viewport& viewport = m_variation.view().viewport();
    const auto shape = viewport.figureShape(m_editor->figure());
    if (!m_isActive || m_framed == m_editor->figure() || !shape || shape->positions.empty())
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
    m_framed = m_editor->figure();
    m_variation.view().scene().keepCamera();
    widgets::Turntable camera = viewport.camera();
    camera.frame(lower, upper, viewport.size());
    viewport.setCamera(camera);
}

ShownCurve PartCurveTool::shown(const PartCurveEntry& entry) const
{
    ShownCurve curve;
    curve.name = QString::fromStdString(entry.curve.name);
    curve.color = widgets::Theme::color(widgets::ColorRole::ViewportText);
    const auto& vertices = entry.curve.vertices;
    if (m_shownGraph && isWholeCurve(*m_shownGraph, vertices)) {
        try {
            SurfaceCurve route(m_shownGraph);
            route.restore(entry.points.empty() ? guidesOf(m_shownGraph, vertices) : entry.points, vertices);
            curve.vertices = numbersOf(route.vertices());
            curve.points = route.places();
            return curve;
        } catch (const Error&) {
            // It is shown as it is, below; what is wrong with it is said beside it.
            curve.points.clear();
        }
    }
    curve.isClosed = false;
    for (const VertexIndex vertex : vertices.empty() ? entry.points : vertices)
        if (m_shownGraph && vertex.value < m_shownGraph->vertexCount())
            curve.vertices.push_back(vertex.value);
    for (std::size_t i = 0; vertices.empty() && i < curve.vertices.size(); ++i)
        curve.points.push_back(i);
    return curve;
}

void PartCurveTool::refreshCurves()
{
    std::map<std::string, std::pair<PartCurveEntry, ShownCurve>> now;
    std::vector<ShownCurve> curves;
    for (const PartCurveEntry& entry : m_body.curves) {
        const auto before = m_shown.find(entry.curve.name);
        ShownCurve curve =
            before != m_shown.end() && before->second.first == entry ? before->second.second : shown(entry);
        now[entry.curve.name] = {entry, curve};
        curve.color = widgets::Theme::color(widgets::ColorRole::ViewportText);
        if (const PartProblem* problem = m_cut.problemOfCurve(entry.curve.name))
            curve.problem = sentence(problem->error);
        curves.push_back(std::move(curve));
    }
    m_shown = std::move(now);
    m_editor->setCurves(std::move(curves));
    m_editor->setDrawn(indexOf(m_drawn));
    // Undo may put another curve in the place of the selected one.
    if (selectedCurve() != nullptr && m_editor->selected().curve != indexOf(m_selected.name))
        m_editor->setSelected({SurfaceCurvePart::Kind::Curve, indexOf(m_selected.name), 0});
}

void PartCurveTool::refreshColors()
{
    widgets::Viewport& viewport = m_variation.view().viewport();
    const auto shape = viewport.figureShape(m_editor->figure());
    if (!shape)
        return;
    PartColors colors;
    if (m_isActive)
        colors = partColors(m_cut, m_body, shape->mesh.triangles.size(), tr("Body parts"),
                            tr("shared by two, lighter"));
    viewport.setTriangleColors(m_editor->figure(), colors.triangles, colors.key);
}

const PartCurveEntry* PartCurveTool::curveAt(int index) const
{
    return index >= 0 && index < static_cast<int>(m_body.curves.size())
               ? &m_body.curves[static_cast<std::size_t>(index)]
               : nullptr;
}

int PartCurveTool::indexOf(const std::string& curve) const
{
    const auto found = std::find_if(m_body.curves.begin(), m_body.curves.end(),
                                    [&](const PartCurveEntry& entry) { return entry.curve.name == curve; });
    return found == m_body.curves.end() ? -1 : static_cast<int>(found - m_body.curves.begin());
}

const PartCurveEntry* PartCurveTool::selectedCurve() const
{
    return m_selected.kind == PartSelection::Kind::Curve ? findCurve(m_body, m_selected.name) : nullptr;
}

void PartCurveTool::select(const PartSelection& selection)
{
    if (selection == m_selected)
        return;
    m_selected = selection;
    if (selection.kind == PartSelection::Kind::Curve) {
        const SurfaceCurvePart part{SurfaceCurvePart::Kind::Curve, indexOf(selection.name), 0};
        if (m_editor->selected().kind == SurfaceCurvePart::Kind::None ||
            m_editor->selected().curve != part.curve)
            m_editor->setSelected(part);
    } else {
        m_editor->setSelected({});
    }
    refreshActions();
    emit selectionChanged();
}

void PartCurveTool::followSelection()
{
    const SurfaceCurvePart& part = m_editor->selected();
    if (part.kind != SurfaceCurvePart::Kind::None) {
        if (const PartCurveEntry* entry = curveAt(part.curve))
            select({PartSelection::Kind::Curve, entry->curve.name});
    } else if (m_selected.kind == PartSelection::Kind::Curve) {
        select({});
    }
    describeSelection();
}

/// For those who cannot see the handles.
void PartCurveTool::describeSelection()
{
    const SurfaceCurvePart& part = m_editor->selected();
    const PartCurveEntry* entry = curveAt(part.curve);
    QString text;
    if (entry != nullptr && part.kind == SurfaceCurvePart::Kind::Point)
        text = tr("Point %1 of the curve “%2”")
                   .arg(part.point + 1)
                   .arg(QString::fromStdString(entry->curve.name));
    else if (entry != nullptr && part.kind == SurfaceCurvePart::Kind::Curve)
        text = tr("Curve “%1”").arg(QString::fromStdString(entry->curve.name));
    if (const PartProblem* problem = text.isEmpty() ? nullptr : m_cut.problemOfCurve(entry->curve.name))
        text += QStringLiteral(". ") + sentence(problem->error);
    if (widgets::VtkView* view = m_variation.view().viewport().view())
        view->setAccessibleDescription(text);
}

} // namespace quadrille
