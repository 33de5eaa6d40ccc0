// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurveeditor.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/surfacecurvepaint.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <utility>

namespace quadrille::widgets {

using CurvePart = SurfaceCurvePart;

SurfaceCurveEditor::SurfaceCurveEditor(Viewport& viewport, QObject* parent)
    : HandleTool(parent), m_viewport(viewport)
{
    connect(&Theme::instance(), &Theme::changed, this, &SurfaceCurveEditor::repaintRequested);
    connect(&viewport, &Viewport::figureChanged, this, [this](int figure) {
        if (figure != m_figure)
            return;
        m_seen.reset();
        emit repaintRequested();
    });
}

std::optional<SurfaceCurveLayout> SurfaceCurveEditor::layout() const
{
    const auto shape = m_viewport.figureShape(m_figure);
    if (!shape || shape->positions.empty())
        return std::nullopt;
    return SurfaceCurveLayout(m_content, {m_figure, *shape, camera(), viewSize()}, m_seen);
}

SurfaceCurveLook SurfaceCurveEditor::look() const
{
    return {.isDrawing = isDrawing(), .hovered = m_hovered, .refusal = m_refusal, .occupied = occupied()};
}

void SurfaceCurveEditor::setFigure(int figure)
{
    if (figure == m_figure)
        return;
    m_figure = figure;
    m_content.preview.clear();
    m_seen.reset();
    m_drawing = {};
    m_drag.reset();
    emit repaintRequested();
}

void SurfaceCurveEditor::setCurves(std::vector<ShownCurve> curves)
{
    m_content.curves = std::move(curves);
    m_seen.reset();
    m_hovered = {};
    if (m_drag && !m_content.has(m_drag->point()))
        m_drag.reset(); // undone under the pointer
    if (!m_content.has(selected()))
        setSelected({});
    emit repaintRequested();
}

void SurfaceCurveEditor::setActive(bool active)
{
    if (active == m_active)
        return;
    if (!active) {
        endDrag(false);
        setMode(Mode::Edit);
        setSelected({});
    }
    m_active = active;
    emit repaintRequested();
}

void SurfaceCurveEditor::setMode(Mode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    m_refusal.clear();
    m_content.preview.clear();
    m_drawing = {};
    m_hovered = {};
    if (mode == Mode::Draw)
        setSelected({});
    emit cursorRequested(mode == Mode::Draw ? Qt::CrossCursor : Qt::ArrowCursor);
    emit modeChanged(mode);
    emit repaintRequested();
}

void SurfaceCurveEditor::setSelected(const CurvePart& part)
{
    if (part == selected())
        return;
    m_content.selected = part;
    emit selectionChanged(part);
    emit repaintRequested();
}

SurfaceCurvePart SurfaceCurveEditor::partAt(const QPointF& position) const
{
    const auto shown = layout();
    return shown ? shown->partAt(position) : CurvePart();
}

void SurfaceCurveEditor::reveal(const CurvePart& part)
{
    const auto shown = layout();
    if (shown && m_content.has(part) && !shown->isSeen(part))
        m_viewport.setCamera(shown->view().facing(m_content.vertexOf(part)));
}

void SurfaceCurveEditor::paint(QPainter& painter) const
{
    const auto shown = layout();
    if (!m_active || !shown)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintSurfaceCurves(painter, *shown, look());
    if (isDrawing())
        paintSurfaceDrawing(painter, *shown, m_drawing, look());
    paintSurfaceHint(painter, *shown, look());
}

void SurfaceCurveEditor::leave()
{
    m_hovered = {};
    if (m_drawing.leave())
        emit pointerMoved(std::nullopt);
}

bool SurfaceCurveEditor::press(const QMouseEvent& event)
{
    m_pressedAt.reset();
    if (isDragging())
        return true;
    if (isDrawing()) {
        if (event.button() == Qt::LeftButton)
            m_pressedAt = event.position();
        return false;
    }
    if (event.button() == Qt::RightButton) {
        m_isMenuPress = partAt(event.position()).kind != CurvePart::Kind::None;
        return m_isMenuPress;
    }
    return event.button() == Qt::LeftButton && pressPart(event);
}

bool SurfaceCurveEditor::pressPart(const QMouseEvent& event)
{
    const CurvePart part = partAt(event.position());
    if (part.kind == CurvePart::Kind::Curve && event.modifiers().testFlag(Qt::ControlModifier)) {
        insertInto(part.curve, event);
        return true;
    }
    if (part.kind != CurvePart::Kind::Point) {
        m_pressedAt = event.position();
        return false;
    }
    m_drag.emplace(*layout(), part, event.position());
    setSelected(part);
    emit cursorRequested(Qt::ClosedHandCursor);
    emit repaintRequested();
    return true;
}

bool SurfaceCurveEditor::move(const QMouseEvent& event)
{
    if (!isDragging()) {
        if (event.buttons() == Qt::NoButton)
            hover(event);
        return false;
    }
    const CurvePart part = m_drag->point();
    if (const auto place = m_drag->moveTo(layout()->view(), event.position(), event.modifiers()))
        emit pointMoved(part.curve, part.point, *place, false);
    return true;
}

void SurfaceCurveEditor::hover(const QMouseEvent& event)
{
    if (isDrawing()) {
        hoverDrawing(event);
        return;
    }
    const CurvePart part = partAt(event.position());
    if (std::exchange(m_hovered, part) == part)
        return;
    emit cursorRequested(cursorFor(part));
    emit repaintRequested();
}

void SurfaceCurveEditor::hoverDrawing(const QMouseEvent& event)
{
    const bool closes = layout()->closesAt(event.position());
    const CurvePart part = closes ? CurvePart{CurvePart::Kind::Point, drawn(), 0} : CurvePart{};
    if (std::exchange(m_hovered, part) != part)
        emit cursorRequested(closes ? Qt::PointingHandCursor : Qt::CrossCursor);
    m_drawing.hover(*layout(), event.position(), event.modifiers());
    emit pointerMoved(m_drawing.pointer());
    emit repaintRequested();
}

bool SurfaceCurveEditor::release(const QMouseEvent& event)
{
    if (event.button() == Qt::RightButton && std::exchange(m_isMenuPress, false)) {
        if (const CurvePart part = partAt(event.position()); part.kind != CurvePart::Kind::None) {
            setSelected(part);
            emit contextMenuRequested(part, event.globalPosition().toPoint());
        }
        return true;
    }
    if (isDragging()) {
        if (event.button() == Qt::LeftButton)
            endDrag(true);
        return true;
    }
    const auto pressed = std::exchange(m_pressedAt, std::nullopt);
    if (pressed && !isDrag(*pressed, event.position())) {
        if (isDrawing())
            clickWhileDrawing(event);
        else
            setSelected(partAt(event.position()));
    }
    return false; // the camera ends what it began
}

void SurfaceCurveEditor::clickWhileDrawing(const QMouseEvent& event)
{
    const auto outcome = SurfaceCurveDrawing::click(*layout(), event.position(), event.modifiers());
    if (outcome.isDone)
        finishDrawing();
    else if (outcome.point)
        emit pointAdded(*outcome.point);
}

bool SurfaceCurveEditor::doubleClick(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (isDrawing()) {
        finishDrawing();
        return true;
    }
    const CurvePart part = partAt(event.position());
    if (part.kind == CurvePart::Kind::Curve)
        insertInto(part.curve, event);
    return part.kind != CurvePart::Kind::None;
}

void SurfaceCurveEditor::endDrag(bool commit)
{
    if (!m_drag)
        return;
    const SurfaceCurveDrag drag = *std::exchange(m_drag, std::nullopt);
    const CurvePart& part = drag.point();
    emit cursorRequested(Qt::ArrowCursor);
    emit repaintRequested();
    if (!drag.last())
        return;
    if (commit)
        emit pointMoved(part.curve, part.point, *drag.last(), true);
    else
        emit moveCancelled(part.curve);
}

void SurfaceCurveEditor::finishDrawing()
{
    emit drawingFinished();
    setMode(Mode::Edit);
}

void SurfaceCurveEditor::insertInto(int curve, const QMouseEvent& event)
{
    const auto shown = layout();
    if (const auto place = shown->view().placeAt(event.position(), event.modifiers()))
        insertAfter({CurvePart::Kind::Point, curve, shown->pointBefore(curve, event.position())}, *place);
}

void SurfaceCurveEditor::insertAfter(const CurvePart& part, const SurfacePlace& place)
{
    emit pointInserted(part.curve, part.point, place);
    setSelected({CurvePart::Kind::Point, part.curve, part.point + 1});
}

void SurfaceCurveEditor::insertByKey()
{
    const auto shown = layout();
    if (isDrawing()) {
        if (const auto place = m_drawing.placeAtCursor(*shown))
            emit pointAdded(*place);
        return;
    }
    const CurvePart part = selected();
    const auto vertex = m_content.vertexAfter(part);
    if (const auto place = vertex ? shown->view().placeAt(*vertex, Qt::AltModifier) : std::nullopt)
        insertAfter(part, *place);
}

bool SurfaceCurveEditor::selectNext(int step)
{
    const CurvePart next = partAfter(m_content.points(), selected(), step);
    setSelected(next);
    reveal(next);
    return next.kind != CurvePart::Kind::None;
}

void SurfaceCurveEditor::nudge(const QKeyEvent& event)
{
    const CurvePart part = selected();
    const SurfaceView view = layout()->view();
    const std::uint32_t from = m_content.vertexOf(part);
    const std::uint32_t to = view.vertexTowards(from, event.key(), event.modifiers());
    // Snapping would take small steps back.
    if (const auto place = view.placeAt(to, Qt::AltModifier); place && to != from)
        emit pointMoved(part.curve, part.point, *place, true);
    reveal(selected());
}

void SurfaceCurveEditor::removeSelected()
{
    const CurvePart part = selected();
    if (!m_content.has(part))
        return;
    if (part.kind == CurvePart::Kind::Curve)
        emit curveRemovalRequested(part.curve);
    else
        emit pointRemovalRequested(part.curve, part.point);
}

bool SurfaceCurveEditor::wantsKey(const QKeyEvent& event) const
{
    const bool hasSelection = m_content.has(selected());
    const bool hasPoint = hasSelection && selected().kind == CurvePart::Kind::Point;
    switch (event.key()) {
    case Qt::Key_Escape:
        return isDrawing() || isDragging() || hasSelection;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
        return isDrawing() || hasSelection;
    case Qt::Key_Menu:
        return hasSelection;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return !isDrawing() && !m_content.points().empty();
    default: // arrows
        return event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down && (isDrawing() || hasPoint) &&
               !event.modifiers().testFlag(Qt::ControlModifier);
    }
}

void SurfaceCurveEditor::confirm()
{
    if (isDrawing())
        finishDrawing();
    else
        emit activated(selected().curve);
}

void SurfaceCurveEditor::askMenuByKey()
{
    if (const auto pixel = pixelOf(selected()))
        emit contextMenuRequested(selected(), m_viewport.mapToGlobal(pixel->toPoint()));
}

bool SurfaceCurveEditor::removeByKey()
{
    if (isDrawing())
        emit lastPointRemovalRequested();
    else
        removeSelected();
    return true;
}

bool SurfaceCurveEditor::pressOther(const QKeyEvent& event)
{
    if (!isDrawing()) {
        nudge(event);
        return true;
    }
    m_drawing.moveCursor(*layout(), event.key(), event.modifiers());
    emit pointerMoved(m_drawing.pointer());
    emit repaintRequested();
    return true;
}

} // namespace quadrille::widgets

#include "moc_surfacecurveeditor.cpp"
