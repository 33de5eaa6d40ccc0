// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathtool.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/project/results/openanimation.h"
#include "widgets/tools/pathgeometry.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <QLocale>
#include <utility>

namespace quadrille {

using widgets::PathEdit;
using widgets::PathEditor;
using widgets::PathPart;

namespace {

EditPhase phaseOf(bool committed)
{
    return committed ? EditPhase::Final : EditPhase::Dragging;
}

} // namespace

PathTool::PathTool(CurrentAnimation& animation, QObject* parent)
    : QObject(parent), m_animation(animation), m_editor(new PathEditor(animation.view().viewport(), this))
{
    makeActions();
    connectEditor();
    animation.view().viewport().setViewTool(m_editor);
    connect(&animation, &CurrentAnimation::changed, this, &PathTool::refresh);
    connect(&animation.view().viewport(), &widgets::Viewport::groundHeightChanged, this, &PathTool::refresh);
    retranslates(&animation.view(), [this] { refresh(); });
}

const PathEntry* PathTool::path() const
{
    const AnimationEntry* entry = m_animation.entry();
    return entry == nullptr ? nullptr : findPath(*entry);
}

double PathTool::length() const
{
    return m_editor->curve().length();
}

void PathTool::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    m_animation.edit(
        text, property,
        [&edit](AnimationEntry& animation) {
            if (PathEntry* path = findPath(animation))
                edit(*path);
        },
        phase);
}

double PathTool::alongPath(double length) const
{
    constexpr int millimetres = 3; // decimals of metres
    return widgets::Ruler(m_space.metresPerUnit).rounded(length, millimetres);
}

double PathTool::usualHeight() const
{
    constexpr double waist = 0.95; // metres, of a grown person
    const ProjectSettings& settings = m_animation.context().document.project().settings;
    if (const auto result = m_animation.result(); result && !result->plan.frames.empty())
        return result->plan.frames.front().centre[static_cast<int>(settings.axes.up)];
    return static_cast<double>(m_space.ground) + waist / settings.axes.metresPerUnit;
}

void PathTool::connectEditor()
{
    connect(m_editor, &PathEditor::pointsEdited, this, &PathTool::takePoints);
    connect(m_editor, &PathEditor::stretchEdited, this,
            [this](int span, double from, double to, bool committed) {
                edit(
                    tr("Move the end of a span"), QStringLiteral("path span %1").arg(span),
                    [&](PathEntry& path) {
                        path.spans[static_cast<std::size_t>(span)].from = alongPath(from);
                        path.spans[static_cast<std::size_t>(span)].to = alongPath(to);
                    },
                    phaseOf(committed));
            });
    connect(m_editor, &PathEditor::stretchDeletionRequested, this, [this](int span) {
        edit(tr("Delete a span of the path"), QStringLiteral("path spans"),
             [&](PathEntry& path) { path.spans.erase(path.spans.begin() + span); });
    });
    connect(m_editor, &PathEditor::obstacleAdded, this, [this](const widgets::PathObstacle& obstacle) {
        edit(tr("Add an obstacle"), QStringLiteral("path obstacles"),
             [&](PathEntry& path) { path.obstacles.push_back(m_space.fromView(obstacle)); });
        if (path() != nullptr)
            m_editor->setSelected(
                {PathPart::Kind::Obstacle, static_cast<int>(path()->obstacles.size()) - 1, 0});
    });
    connect(m_editor, &PathEditor::obstacleEdited, this,
            [this](int obstacle, const widgets::PathObstacle& edited, bool committed) {
                edit(
                    tr("Change an obstacle"), QStringLiteral("path obstacle %1").arg(obstacle),
                    [&](PathEntry& path) {
                        ObstacleEntry& own = path.obstacles[static_cast<std::size_t>(obstacle)];
                        own = m_space.fromView(edited, own);
                    },
                    phaseOf(committed));
            });
    connect(m_editor, &PathEditor::obstacleDeletionRequested, this, [this](int obstacle) {
        edit(tr("Delete an obstacle"), QStringLiteral("path obstacles"),
             [&](PathEntry& path) { path.obstacles.erase(path.obstacles.begin() + obstacle); });
    });
    connect(m_editor, &PathEditor::modeChanged, this, &PathTool::refreshActions);
    connect(m_editor, &PathEditor::selectionChanged, this, &PathTool::describeSelection);
    connect(m_editor, &PathEditor::contextMenuRequested, this, &PathTool::showMenu);
}

void PathTool::takePoints(const std::vector<QVector3D>& points, PathEdit edit, bool committed)
{
    const auto textOf = [edit] {
        switch (edit) {
        case PathEdit::Add:
            return tr("Add a point to the path");
        case PathEdit::Insert:
            return tr("Insert a point into the path");
        case PathEdit::Delete:
            return tr("Delete a point of the path");
        case PathEdit::Draw:
            return tr("Draw a path");
        case PathEdit::Move:
            break;
        }
        return tr("Move a point of the path");
    };
    m_animation.view().scene().keepCamera(); // who draws has chosen the view
    m_animation.edit(
        textOf(), QStringLiteral("path points"),
        [&](AnimationEntry& animation) {
            PathEntry* path = findPath(animation);
            if (points.empty()) {
                removePath(animation);
                return;
            }
            if (path == nullptr)
                path = &std::get<PathEntry>(animation.constraints.emplace_back(m_blank));
            *path = withPoints(*path, m_space.fromView(points, *path), m_space.metresPerUnit);
        },
        phaseOf(committed));
}

void PathTool::refresh()
{
    const EditorContext& context = m_animation.context();
    const CoordinateSystem& axes = context.document.project().settings.axes;
    m_space = {.up = axes.up,
               .ground = m_animation.view().viewport().groundHeight(),
               .metresPerUnit = axes.metresPerUnit};
    m_editor->setSampler(m_space.sampler());
    m_editor->setUsualHeight(static_cast<float>(usualHeight()) - m_space.ground);
    if (const QString before = std::exchange(m_shown, m_animation.name());
        before != m_shown && !before.isEmpty()) {
        m_editor->setMode(PathEditor::Mode::Edit);
        m_editor->setSelected({});
    }
    const PathEntry* entry = path();
    const PathEntry& shown = entry == nullptr ? m_blank : *entry;
    widgets::PathShape shape;
    shape.kind = kindOf(shown.curve);
    shape.inSpace = shown.inSpace;
    shape.points = m_space.toView(shown.points, !shown.inSpace);
    shape.clearance = static_cast<float>(shown.clearance);
    for (const PathSpanEntry& span : shown.spans)
        shape.stretches.push_back({.from = span.from, .to = span.to, .text = spanText(span)});
    for (const ObstacleEntry& obstacle : shown.obstacles) {
        shape.obstacles.push_back(m_space.toView(obstacle));
        if (blocksAnEnd(shown, obstacle, m_space.up))
            shape.obstacles.back().problem = tr("An end of the path is too close");
    }
    m_editor->setShape(shape);
    refreshActions();
    emit changed();
}

/// For those who cannot see the handles.
void PathTool::describeSelection()
{
    const PathPart& part = m_editor->selected();
    const auto kind = m_editor->shape().kind;
    const auto index = static_cast<std::size_t>(part.index);
    QString text;
    switch (part.kind) {
    case PathPart::Kind::Point:
        text = (widgets::isHandle(kind, index) ? tr("Handle of point %1 of the path")
                                               : tr("Point %1 of the path"))
                   .arg(widgets::anchorOf(kind, index) + 1);
        break;
    case PathPart::Kind::StretchStart:
        text = tr("Beginning of span %1").arg(part.index + 1);
        break;
    case PathPart::Kind::StretchEnd:
        text = tr("End of span %1").arg(part.index + 1);
        break;
    case PathPart::Kind::ObstacleCorner:
        text = tr("Corner %1 of obstacle %2").arg(part.corner + 1).arg(part.index + 1);
        break;
    case PathPart::Kind::Obstacle:
        text = tr("Obstacle %1").arg(part.index + 1);
        break;
    default:
        break;
    }
    if (widgets::VtkView* view = m_animation.view().viewport().view())
        view->setAccessibleDescription(text);
}

void PathTool::draw(PathEditor::Mode mode)
{
    m_animation.context().actions.action(QStringLiteral("animate.path.show"))->setChecked(true);
    EditorContext& context = m_animation.context();
    context.actions.action(QStringLiteral("workspace.animate"))->trigger();
    m_editor->setMode(m_editor->mode() == mode ? PathEditor::Mode::Edit : mode);
    m_animation.view().viewport().setTool(widgets::Viewport::Tool::Navigate);
    m_animation.view().viewport().setFocus();
}

void PathTool::addSpan()
{
    const double whole = length();
    double from = 0;
    for (const PathSpanEntry& span : path()->spans)
        from = std::max(from, span.to);
    const double shortest = 0.1 / m_space.metresPerUnit;
    if (from > whole - shortest)
        from = 0;
    const double to = from + (whole - from) / 2;
    edit(tr("Add a span to the path"), QStringLiteral("path spans"),
         [&](PathEntry& path) { path.spans.push_back({.from = alongPath(from), .to = alongPath(to)}); });
    m_editor->setSelected({PathPart::Kind::StretchStart, static_cast<int>(path()->spans.size()) - 1, 0});
}

void PathTool::setCurve(PathCurve curve)
{
    m_blank.curve = curve;
    if (path() != nullptr)
        edit(tr("Change the kind of curve"), QStringLiteral("path curve"),
             [&](PathEntry& path) { path = withCurve(path, curve, m_space.metresPerUnit); });
    else
        refresh();
}

void PathTool::setInSpace(bool inSpace)
{
    m_blank.inSpace = inSpace;
    if (path() != nullptr)
        edit(inSpace ? tr("Lead the path through space") : tr("Lead the path over the ground"),
             QStringLiteral("path space"),
             [&](PathEntry& path) { path = withSpace(path, inSpace, m_space.up, usualHeight()); });
    else
        refresh();
}

QString PathTool::framesText(const FrameChoice& frames) const
{
    if (!frames.label.empty())
        return QString::fromStdString(frames.label);
    QString name = QString::fromStdString(frames.sequence);
    if (!frames.range)
        return name;
    return tr("%1, frames %2 – %3").arg(name).arg(frames.range->first.value).arg(frames.range->last.value);
}

QString PathTool::spanText(const PathSpanEntry& span) const
{
    QStringList parts;
    if (span.frames)
        parts += framesText(*span.frames);
    if (span.duration) {
        const double metres =
            (span.to - span.from) * m_animation.context().document.project().settings.axes.metresPerUnit;
        parts += tr("%1 m/s").arg(QLocale().toString(metres / *span.duration, 'f', 2));
    }
    return parts.isEmpty() ? tr("any frames") : parts.join(QStringLiteral(" · "));
}

} // namespace quadrille

#include "moc_pathtool.cpp"
