// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacepaireditor.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/surfacepairpaint.h"
#include "widgets/tools/toolpaint.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

namespace quadrille::widgets {

SurfacePairEditor::SurfacePairEditor(Viewport& viewport, QObject* parent)
    : HandleTool(parent), m_viewport(viewport)
{
    connect(&Theme::instance(), &Theme::changed, this, &SurfacePairEditor::repaintRequested);
    connect(&viewport, &Viewport::figureChanged, this, [this](int figure) {
        if (std::ranges::find(m_figures, figure) == m_figures.end())
            return;
        m_seen.reset();
        emit repaintRequested();
    });
}

std::optional<SurfacePairLayout> SurfacePairEditor::layout() const
{
    const auto first = m_viewport.figureShape(m_figures[0]);
    const auto second = m_viewport.figureShape(m_figures[1]);
    if (!first || !second || first->positions.empty() || second->positions.empty())
        return std::nullopt;
    return SurfacePairLayout(m_content,
                             {SurfaceView{m_figures[0], *first, camera(), viewSize()},
                              SurfaceView{m_figures[1], *second, camera(), viewSize()}},
                             m_seen);
}

void SurfacePairEditor::setFigures(int first, int second)
{
    if (m_figures == std::array{first, second})
        return;
    m_figures = {first, second};
    m_seen.reset();
    m_hovered = {};
    m_drag.reset();
    giveUpBegun();
    emit repaintRequested();
}

void SurfacePairEditor::setPairs(std::vector<SurfacePair> pairs)
{
    if (pairs == m_content.pairs)
        return;
    m_content.pairs = std::move(pairs);
    m_seen.reset();
    m_hovered = {};
    const auto count = static_cast<int>(m_content.pairs.size());
    if (m_drag && m_drag->end.pair >= count)
        m_drag.reset(); // undone under the pointer
    if (m_content.selected >= count)
        setSelected(-1);
    emit repaintRequested();
}

void SurfacePairEditor::setActive(bool active)
{
    if (active == m_active)
        return;
    if (!active) {
        endDrag(false);
        giveUpBegun();
    }
    m_active = active;
    emit repaintRequested();
}

void SurfacePairEditor::setSelected(int pair)
{
    const int selected = pair < static_cast<int>(m_content.pairs.size()) ? std::max(pair, -1) : -1;
    if (selected == m_content.selected)
        return;
    m_content.selected = selected;
    emit selectionChanged(selected);
    emit repaintRequested();
}

void SurfacePairEditor::giveUpBegun()
{
    if (!m_content.begun)
        return;
    m_content.begun.reset();
    emit begunChanged();
    emit repaintRequested();
}

void SurfacePairEditor::setHint(const QString& text)
{
    if (std::exchange(m_hint, text) != text)
        emit repaintRequested();
}

std::optional<QPointF> SurfacePairEditor::pixelOf(const PairEnd& end) const
{
    const auto shown = layout();
    if (!shown || end.isNone() || end.pair >= static_cast<int>(m_content.pairs.size()) || !shown->isSeen(end))
        return std::nullopt;
    return shown->pixelOf(end);
}

void SurfacePairEditor::paint(QPainter& painter) const
{
    const auto shown = layout();
    if (!m_active || !shown)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintSurfacePairs(painter, *shown, m_hovered);
    if (m_content.begun)
        paintBegunPair(painter, *shown, m_pointer);
    if (!m_hint.isEmpty())
        paintToolHint(painter, viewSize(), m_hint);
}

bool SurfacePairEditor::press(const QMouseEvent& event)
{
    m_pressedAt.reset();
    if (isDragging())
        return true;
    if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ControlModifier))
        return event.button() == Qt::RightButton && !layout()->endAt(event.position()).isNone();
    const PairEnd end = layout()->endAt(event.position());
    if (end.isNone() || isDrawing()) {
        m_pressedAt = event.position();
        return false;
    }
    setSelected(end.pair);
    m_side = end.side;
    const SurfacePair& pair = m_content.pairs[static_cast<std::size_t>(end.pair)];
    m_drag = Drag{end, pair.triangles[static_cast<std::size_t>(end.side)], event.position()};
    return true;
}

bool SurfacePairEditor::move(const QMouseEvent& event)
{
    m_pointer = event.position();
    const auto shown = layout();
    if (isDragging()) {
        m_drag->isMoved = m_drag->isMoved || isDrag(m_drag->pressedAt, event.position());
        const auto place = shown->placeAt(event.position());
        if (m_drag->isMoved && place && place->side == m_drag->end.side)
            emit moveRequested(m_drag->end.pair, m_drag->end.side, place->triangle, false);
        return true;
    }
    if (event.buttons() != Qt::NoButton)
        return false;
    const PairEnd hovered = isDrawing() ? PairEnd() : shown->endAt(event.position());
    if (std::exchange(m_hovered, hovered) != hovered)
        emit cursorRequested(hovered.isNone() ? Qt::ArrowCursor : Qt::OpenHandCursor);
    emit repaintRequested();
    return false;
}

bool SurfacePairEditor::release(const QMouseEvent& event)
{
    if (isDragging()) {
        endDrag(true);
        return true;
    }
    const PairEnd end = layout()->endAt(event.position());
    if (event.button() == Qt::RightButton && !end.isNone()) {
        setSelected(end.pair);
        emit contextMenuRequested(end.pair, event.globalPosition().toPoint());
        return true;
    }
    const auto pressedAt = std::exchange(m_pressedAt, std::nullopt);
    if (event.button() == Qt::LeftButton && pressedAt && !isDrag(*pressedAt, event.position())) {
        if (const auto place = layout()->placeAt(event.position()))
            click(*place);
        else
            setSelected(-1);
    }
    return false; // the camera took the press, and is to have the release
}

void SurfacePairEditor::click(const PairPlace& place)
{
    if (!m_content.begun || m_content.begun->side == place.side) {
        setSelected(-1);
        m_content.begun = place;
        emit begunChanged();
        emit repaintRequested();
        return;
    }
    const PairPlace first = *std::exchange(m_content.begun, std::nullopt);
    emit begunChanged();
    emit pairRequested(place.side == 1 ? first.triangle : place.triangle,
                       place.side == 1 ? place.triangle : first.triangle);
}

void SurfacePairEditor::endDrag(bool commit)
{
    if (!isDragging())
        return;
    const Drag drag = *std::exchange(m_drag, std::nullopt);
    if (!drag.isMoved)
        return;
    const SurfacePair& pair = m_content.pairs[static_cast<std::size_t>(drag.end.pair)];
    emit moveRequested(drag.end.pair, drag.end.side,
                       commit ? pair.triangles[static_cast<std::size_t>(drag.end.side)] : drag.before, true);
}

bool SurfacePairEditor::wantsKey(const QKeyEvent& event) const
{
    switch (event.key()) {
    case Qt::Key_Escape:
        return isDragging() || isDrawing() || m_content.selected >= 0;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return isDrawing();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Menu:
        return m_content.selected >= 0;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return !m_content.pairs.empty();
    default:
        return false;
    }
}

void SurfacePairEditor::confirm()
{
    if (isDrawing())
        emit counterpartRequested();
}

void SurfacePairEditor::askMenuByKey()
{
    const auto at = pixelOf({m_content.selected, m_side});
    emit contextMenuRequested(m_content.selected, m_viewport.mapToGlobal(at.value_or(QPointF())).toPoint());
}

bool SurfacePairEditor::removeByKey()
{
    if (m_content.selected < 0)
        return false;
    emit removalRequested(m_content.selected);
    return true;
}

bool SurfacePairEditor::selectNext(int step)
{
    const auto count = static_cast<int>(m_content.pairs.size());
    const int next = m_content.selected < 0 ? (step > 0 ? 0 : count - 1) : m_content.selected + step;
    if (next < 0 || next >= count)
        return false;
    setSelected(next);
    return true;
}

bool SurfacePairEditor::pressOther(const QKeyEvent& event)
{
    const auto shown = layout();
    const auto side = static_cast<std::size_t>(m_side);
    const SurfaceView& view = shown->views()[side];
    const SurfacePair& pair = m_content.pairs[static_cast<std::size_t>(m_content.selected)];
    const std::uint32_t triangle = pair.triangles[side];
    if (triangle >= view.shape.mesh.triangles.size())
        return false;
    const std::uint32_t from = view.shape.mesh.triangles[triangle][0];
    const std::uint32_t towards = view.vertexTowards(from, event.key(), event.modifiers());
    const auto place = view.placeAt(towards, Qt::NoModifier);
    if (towards != from && place)
        emit moveRequested(m_content.selected, m_side, place->pick.triangle, true);
    return true;
}

} // namespace quadrille::widgets

#include "moc_surfacepaireditor.cpp"
