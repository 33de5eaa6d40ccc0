// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/chartscale.h"
#include "widgets/graph/matrixviewprivate.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr int largeStep = 10; // cells for one press of an arrow with Shift

bool isZoomKey(int key)
{
    return key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus || key == Qt::Key_0;
}

bool isMoveKey(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
           key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Home || key == Qt::Key_End;
}

} // namespace

bool MatrixView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !d->isEmpty()) {
        // These keys mean something else in the window: here they are for the table.
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == 0;
        if (isPlain && (isZoomKey(key->key()) || isMoveKey(key->key()))) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            zoomAbout(gesture->position(), 1 + gesture->value());
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto cell = cellAt(help->pos());
        QToolTip::showText(help->globalPos(), cell ? cellText(*cell) : QString(), this);
        return true;
    }
    return QWidget::event(event);
}

void MatrixView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    d->paint(painter, *this);
}

void MatrixView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    d->layOut(*this);
    viewChanged();
}

void MatrixView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) {
        d->layOut(*this);
        updateAccessibleText();
        viewChanged();
    }
}

void MatrixView::wheelEvent(QWheelEvent* event)
{
    if (d->isEmpty()) {
        event->ignore();
        return;
    }
    zoomAbout(event->position(), std::pow(chartWheelZoom, event->angleDelta().y() / wheelNotch));
    hover(cellAt(event->position()));
    event->accept();
}

void MatrixView::mousePressEvent(QMouseEvent* event)
{
    const bool moves = event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton;
    if (d->isEmpty() || !moves) {
        event->ignore();
        return;
    }
    d->isPressed = true;
    d->isDragging = event->button() == Qt::MiddleButton;
    d->pressedAt = d->pointer = event->position();
}

void MatrixView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = std::exchange(d->pointer, event->position());
    if (d->isPressed && !d->isDragging &&
        (d->pointer - d->pressedAt).manhattanLength() >= QApplication::startDragDistance()) {
        d->isDragging = true;
        setCursor(Qt::ClosedHandCursor);
        moveBy(d->pointer - d->pressedAt);
    } else if (d->isDragging) {
        moveBy(d->pointer - before);
    }
    hover(cellAt(d->pointer));
}

void MatrixView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool wasClick = std::exchange(d->isPressed, false) && !std::exchange(d->isDragging, false);
    unsetCursor();
    if (!wasClick || event->button() != Qt::LeftButton)
        return;
    if (const auto cell = cellAt(event->position())) {
        choose(*cell);
        emit cellActivated(cell->row, cell->column);
    }
}

void MatrixView::mouseDoubleClickEvent(QMouseEvent* event)
{
    // The second press of a double click is a click like the first.
    mousePressEvent(event);
}

void MatrixView::contextMenuEvent(QContextMenuEvent* event)
{
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    const auto cell = isByKey ? d->current : cellAt(event->pos());
    if (!cell)
        return;
    choose(*cell);
    const QPoint place = d->rect(*cell).center().toPoint();
    emit menuRequested(cell->row, cell->column, isByKey ? mapToGlobal(place) : event->globalPos());
}

void MatrixView::leaveEvent(QEvent* /*event*/)
{
    hover({});
}

void MatrixView::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    const bool isShifted = (event->modifiers() & Qt::ShiftModifier) != 0;
    const QPointF middle = d->current ? d->rect(*d->current).center() : QRectF(d->area).center();
    if (d->isEmpty()) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (key == Qt::Key_Plus || key == Qt::Key_Equal)
        zoomAbout(middle, chartKeyZoom);
    else if (key == Qt::Key_Minus)
        zoomAbout(middle, 1 / chartKeyZoom);
    else if (key == Qt::Key_0)
        fit();
    else if ((key == Qt::Key_Return || key == Qt::Key_Enter) && d->current)
        emit cellActivated(d->current->row, d->current->column);
    else if (!moveByKey(key, isShifted))
        QWidget::keyPressEvent(event);
}

bool MatrixView::moveByKey(int key, bool byTen)
{
    if (!isMoveKey(key))
        return false;
    MatrixCell cell = d->current.value_or(MatrixCell{});
    const int step = byTen ? largeStep : 1;
    const auto nextBlock = [this](int index, bool forward) {
        const int block = d->blockOf(index);
        if (block < 0)
            return index;
        const int other = std::clamp(block + (forward ? 1 : -1), 0, static_cast<int>(d->blocks.size()) - 1);
        return d->blockStarts[static_cast<std::size_t>(other)];
    };
    if (d->current) {
        switch (key) {
        case Qt::Key_Left:
        case Qt::Key_Right:
            cell.column += key == Qt::Key_Left ? -step : step;
            break;
        case Qt::Key_Up:
        case Qt::Key_Down:
            cell.row += key == Qt::Key_Up ? -step : step;
            break;
        case Qt::Key_Home:
        case Qt::Key_End:
            cell.column = key == Qt::Key_Home ? 0 : d->side() - 1;
            break;
        default: {
            int& index = byTen ? cell.column : cell.row;
            index = nextBlock(index, key == Qt::Key_PageDown);
        }
        }
    }
    cell.row = std::clamp(cell.row, 0, d->side() - 1);
    cell.column = std::clamp(cell.column, 0, d->side() - 1);
    choose(cell);
    reveal(cell);
    return true;
}

} // namespace quadrille::widgets
