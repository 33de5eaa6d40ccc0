// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/patheditor.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/pathedits.h"
#include "widgets/tools/pathmarks.h"
#include "widgets/tools/pathpaint.h"
#include "widgets/viewport/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <utility>

namespace quadrille::widgets {

using Part = PathPart::Kind;

PathEditor::PathEditor(Viewport& viewport, QObject* parent)
    : HandleTool(parent)
    , m_viewport(viewport)
    , m_sampler([](PathKind, const std::vector<QVector3D>& points) { return points; })
{
    connect(&Theme::instance(), &Theme::changed, this, &PathEditor::refreshMarks);
}

PathLayout PathEditor::layout() const
{
    return {m_content, {camera(), viewSize(), m_viewport.groundHeight(), m_viewport.ruler()}};
}

void PathEditor::setShape(const PathShape& shape)
{
    if (m_drag && (shape.points.size() != m_drag->before().points.size() ||
                   shape.stretches.size() != m_drag->before().stretches.size() ||
                   shape.obstacles.size() != m_drag->before().obstacles.size()))
        m_drag.reset(); // undone under the pointer
    m_content.shape = shape;
    m_content.curve =
        SampledCurve(shape.points.empty() ? std::vector<QVector3D>() : m_sampler(shape.kind, shape.points));
    if (!shape.points.empty())
        m_drawing.forgetFirstPoint();
    if (!layout().placeOf(selected()))
        setSelected({});
    m_hovered = {};
    refreshMarks();
}

void PathEditor::setActive(bool active)
{
    if (active == m_active)
        return;
    if (!active) {
        m_drag.reset();
        m_drawing.dropGesture();
        setMode(Mode::Edit);
        setSelected({});
    }
    m_active = active;
    refreshMarks();
}

void PathEditor::setMode(Mode mode)
{
    if (mode == this->mode())
        return;
    m_drawing.setMode(mode);
    m_hovered = {};
    if (mode != Mode::Edit)
        setSelected({});
    emit cursorRequested(mode != Mode::Edit ? Qt::CrossCursor : Qt::ArrowCursor);
    emit modeChanged(mode);
    emit repaintRequested();
}

void PathEditor::setSelected(const PathPart& part)
{
    if (part == selected())
        return;
    m_content.selected = part;
    emit selectionChanged(part);
    emit repaintRequested();
}

void PathEditor::refreshMarks()
{
    m_viewport.setMarks(QStringLiteral("path"), m_active ? pathMarks(layout()) : SceneMarks());
    emit repaintRequested();
}

void PathEditor::paint(QPainter& painter) const
{
    if (!m_active)
        return;
    paintPath(painter, layout(), m_hovered);
    if (isDrawing())
        paintPathDrawing(painter, layout(), m_drawing, m_sampler);
}

void PathEditor::leave()
{
    m_drawing.leave();
    m_hovered = {};
}

bool PathEditor::press(const QMouseEvent& event)
{
    m_clickOnNothing.reset();
    if (isDragging())
        return true;
    if (event.button() == Qt::RightButton && isDrawing()) {
        finishMode();
        return true;
    }
    if (event.button() == Qt::RightButton) {
        m_isMenuPress = partAt(event.position()).kind != Part::None;
        return m_isMenuPress;
    }
    if (event.button() != Qt::LeftButton)
        return false;
    if (!isDrawing())
        return pressPart(event);
    if (m_drawing.press(layout(), event.position(), event.modifiers()))
        finishMode();
    emit repaintRequested();
    return true;
}

bool PathEditor::pressPart(const QMouseEvent& event)
{
    const PathPart part = partAt(event.position());
    if (part.kind == Part::None || part.kind == Part::Curve) {
        m_clickOnNothing = event.position();
        return false;
    }
    m_drag.emplace(layout(), part, event.position(), event.modifiers());
    setSelected(part.owner());
    emit repaintRequested();
    return true;
}

bool PathEditor::move(const QMouseEvent& event)
{
    if (!isDragging()) {
        if (event.buttons() == Qt::NoButton)
            hover(event);
        return false;
    }
    if (!m_drag) {
        m_drawing.move(layout(), event.position());
        emit repaintRequested();
    } else if (const auto shape = m_drag->moveTo(layout(), event.position(), event.modifiers())) {
        emitEdit(m_drag->part(), *shape, false);
    }
    return true;
}

void PathEditor::hover(const QMouseEvent& event)
{
    if (isDrawing()) {
        m_drawing.hover(layout(), event.position(), event.modifiers());
        emit repaintRequested();
        return;
    }
    const PathPart part = partAt(event.position());
    if (std::exchange(m_hovered, part) == part)
        return;
    emit cursorRequested(cursorFor(part));
    emit repaintRequested();
}

bool PathEditor::release(const QMouseEvent& event)
{
    if (event.button() == Qt::RightButton && std::exchange(m_isMenuPress, false)) {
        if (const PathPart part = partAt(event.position()); part.kind != Part::None)
            askMenu(part, event.position(), event.globalPosition().toPoint());
        return true;
    }
    if (!isDragging()) {
        if (m_clickOnNothing && !isDrag(*m_clickOnNothing, event.position()))
            setSelected({});
        m_clickOnNothing.reset();
        return false;
    }
    if (event.button() == Qt::LeftButton)
        endDrag(true);
    return true;
}

void PathEditor::endDrag(bool commit)
{
    if (!m_drag) {
        const PathDrawing::Outcome outcome = m_drawing.release(layout(), commit);
        emit repaintRequested();
        take(outcome);
        return;
    }
    const PathDrag drag = *std::exchange(m_drag, std::nullopt);
    emit repaintRequested();
    if (drag.hasMoved())
        emitEdit(drag.part(), commit ? shape() : drag.before(), true);
}

void PathEditor::emitEdit(const PathPart& part, const PathShape& shape, bool committed)
{
    if (part.isPoint()) {
        emit pointsEdited(shape.points, PathEdit::Move, committed);
    } else if (part.isStretchEnd()) {
        const PathStretch& stretch = shape.stretches[part.at()];
        emit stretchEdited(part.index, stretch.from, stretch.to, committed);
    } else {
        emit obstacleEdited(part.index, shape.obstacles[part.at()], committed);
    }
}

void PathEditor::take(const PathDrawing::Outcome& outcome)
{
    if (!outcome.points.empty())
        emit pointsEdited(outcome.points, outcome.edit, true);
    else
        emit repaintRequested();
    if (outcome.isDone)
        setMode(Mode::Edit);
    if (outcome.obstacle)
        emit obstacleAdded(*outcome.obstacle);
}

bool PathEditor::finishMode()
{
    if (!isDrawing())
        return false;
    take({.points = {}, .obstacle = m_drawing.polygon(), .isDone = true});
    return true;
}

bool PathEditor::doubleClick(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (finishMode())
        return true;
    const PathPart part = partAt(event.position());
    if (part.kind == Part::None)
        return false;
    if (part.kind == Part::Curve) {
        insertPoint(layout().lengthAt(event.position()).value_or(0.0));
    } else if (part.kind == Part::Point && shape().kind == PathKind::Bezier) {
        setSelected(part);
        smoothSelected();
    } else {
        emit activated(part);
    }
    return true;
}

void PathEditor::askMenu(const PathPart& part, const QPointF& position, const QPoint& globalPosition)
{
    if (part.kind != Part::Curve)
        setSelected(part);
    emit contextMenuRequested(part, layout().lengthAt(position).value_or(0.0), globalPosition);
}

void PathEditor::selectPoint(std::size_t point)
{
    setSelected({Part::Point, static_cast<int>(point), 0});
}

void PathEditor::insertPoint(double length)
{
    if (curve().isEmpty())
        return;
    const PathKind kind = shape().kind;
    const std::size_t anchor = anchorBefore(layout(), length);
    const QVector3D place = curve().at(length);
    const float t = kind == PathKind::Bezier ? nearestParameter(shape().points, anchor, place) : 0.5F;
    emit pointsEdited(insertedPoint(kind, shape().points, anchor, t, place), PathEdit::Insert, true);
    selectPoint(anchorIndex(shape().kind, anchor + 1));
}

void PathEditor::smoothSelected()
{
    const PathShape& path = shape();
    if (selected().kind == Part::Point && path.kind == PathKind::Bezier)
        emit pointsEdited(smoothedAnchor(path.points, anchorOf(path.kind, selected().at())), PathEdit::Move,
                          true);
}

bool PathEditor::deleteSelected()
{
    const PathPart part = selected();
    if (!layout().placeOf(part))
        return false;
    if (part.isPoint()) {
        const std::size_t anchor = anchorOf(shape().kind, part.at());
        emit pointsEdited(removedAnchor(shape().kind, shape().points, anchor), PathEdit::Delete, true);
        if (!shape().points.empty())
            selectPoint(anchorIndex(shape().kind, anchor > 0 ? anchor - 1 : 0));
    } else if (part.isStretchEnd()) {
        emit stretchDeletionRequested(part.index);
    } else if (PathObstacle obstacle = shape().obstacles[part.at()];
               part.kind == Part::ObstacleCorner && obstacle.corners.size() > 3) {
        obstacle.corners.erase(obstacle.corners.begin() + part.corner);
        emit obstacleEdited(part.index, obstacle, true);
    } else {
        emit obstacleDeletionRequested(part.index);
    }
    return true;
}

bool PathEditor::wantsKey(const QKeyEvent& event) const
{
    const bool hasSelection = layout().placeOf(selected()).has_value();
    switch (event.key()) {
    case Qt::Key_Escape:
        return isDragging() || hasSelection || isDrawing();
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return isDrawing() || hasSelection;
    case Qt::Key_Insert:
        return isDrawing() || !shape().points.empty();
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return !layout().parts().empty();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return hasSelection || (isDrawing() && !m_drawing.drawnPoints(shape()).empty());
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
        return selected().kind == Part::Obstacle;
    case Qt::Key_Menu:
        return hasSelection;
    default: // arrows, Page Up and Page Down
        return event.key() >= Qt::Key_Left && event.key() <= Qt::Key_PageDown && hasSelection;
    }
}

void PathEditor::confirm()
{
    if (!finishMode())
        emit activated(selected());
}

void PathEditor::askMenuByKey()
{
    if (const auto pixel = pixelOf(selected()))
        askMenu(selected(), *pixel, m_viewport.mapToGlobal(pixel->toPoint()));
}

void PathEditor::insertByKey()
{
    const GroundView view = layout().view();
    const QVector3D target = view.onGround(camera().target);
    const std::vector<QVector3D> points = m_drawing.drawnPoints(shape());
    if (mode() == Mode::Disc || mode() == Mode::Polygon) {
        take({.points = {}, .obstacle = usualObstacle(mode(), target, view), .isDone = true});
    } else if (selected().kind == Part::Point && selected().at() + 1 < points.size()) {
        insertPoint(lengthAfter(layout(), selected().at()));
    } else {
        const QVector3D first = shape().inSpace ? target + m_drawing.usualHeight() * view.up() : target;
        take(m_drawing.added(layout(), points.empty() ? first : nextPlace(points, view)));
        if (!shape().points.empty())
            selectPoint(shape().points.size() - 1);
    }
}

bool PathEditor::removeByKey()
{
    if (mode() != Mode::Draw || isDragging())
        return deleteSelected();
    // Takes back the last point, as drawing programs do.
    const std::size_t anchors = anchorCount(shape().kind, shape().points.size());
    m_drawing.forgetFirstPoint();
    if (anchors > 0)
        emit pointsEdited(removedAnchor(shape().kind, shape().points, anchors - 1), PathEdit::Delete, true);
    emit repaintRequested();
    return true;
}

bool PathEditor::selectNext(int step)
{
    setSelected(partAfter(layout().parts(), selected(), step));
    return selected().kind != Part::None;
}

bool PathEditor::pressOther(const QKeyEvent& event)
{
    const float radiusStep = m_viewport.ruler().of(0.05F);
    const bool grows = event.key() == Qt::Key_Plus || event.key() == Qt::Key_Equal;
    const auto edited = grows || event.key() == Qt::Key_Minus
                            ? resizedSelection(layout(), grows ? radiusStep : -radiusStep)
                            : nudgedSelection(layout(), event.key(), event.modifiers());
    if (edited)
        emitEdit(selected(), *edited, true);
    return edited.has_value();
}

} // namespace quadrille::widgets

#include "moc_patheditor.cpp"
