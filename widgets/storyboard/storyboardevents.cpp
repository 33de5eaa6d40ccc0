// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/storyboard/storyboard.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QScrollBar>
#include <algorithm>
#include <utility>

namespace quadrille::widgets {

bool Storyboard::event(QEvent* event)
{
    // Keys that act on cards come before shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride && count() > 0) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool copies = key.key() == Qt::Key_D && key.modifiers() == Qt::ControlModifier;
        const bool acts = key.key() == Qt::Key_Left || key.key() == Qt::Key_Right ||
                          key.key() == Qt::Key_Home || key.key() == Qt::Key_End ||
                          key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace ||
                          key.key() == Qt::Key_F2;
        if (acts || copies) {
            event->accept();
            return true;
        }
    }
    return QAbstractScrollArea::event(event);
}

void Storyboard::setInsertion(int before)
{
    m_insertion = before;
    viewport()->update();
}

void Storyboard::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_drag.card >= 0)
        return;
    const QPoint position = event->position().toPoint();
    choose(cardAt(position));
    m_drag = {.card = m_current, .pressedAt = position, .at = position};
}

void Storyboard::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint position = event->position().toPoint();
    if (m_drag.card < 0)
        return;
    if (!m_drag.moved && (position - m_drag.pressedAt).manhattanLength() < QApplication::startDragDistance())
        return;
    m_drag.moved = true;
    m_drag.at = position;
    m_drag.copies = event->modifiers().testFlag(Qt::ControlModifier);
    scrollNear(position);
    setInsertion(insertionAt(position));
}

void Storyboard::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const Drag drag = std::exchange(m_drag, {});
    setInsertion(-1);
    if (!drag.moved)
        return;
    const int before = insertionAt(event->position().toPoint());
    if (event->modifiers().testFlag(Qt::ControlModifier))
        emit copyRequested(drag.card, before);
    else if (isMove(drag.card, before))
        emit moveRequested(drag.card, before);
}

void Storyboard::mouseDoubleClickEvent(QMouseEvent* event)
{
    const int card = cardAt(event->position().toPoint());
    if (card >= 0 && event->button() == Qt::LeftButton)
        emit activated(card);
}

void Storyboard::wheelEvent(QWheelEvent* event)
{
    const QPoint delta = event->pixelDelta().isNull() ? event->angleDelta() / 2 : event->pixelDelta();
    const int pixels = std::abs(delta.x()) > std::abs(delta.y()) ? delta.x() : delta.y();
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - pixels);
    event->accept();
}

void Storyboard::keyPressEvent(QKeyEvent* event)
{
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    const bool chosen = m_current >= 0;
    const int key = event->key();
    if (key == Qt::Key_Escape && m_drag.card >= 0) {
        m_drag = {};
        setInsertion(-1);
    } else if (key == Qt::Key_Left && control && m_current > 0) {
        emit moveRequested(m_current, m_current - 1);
    } else if (key == Qt::Key_Right && control && chosen && m_current + 1 < count()) {
        emit moveRequested(m_current, m_current + 2);
    } else if (key == Qt::Key_D && control && chosen) {
        emit copyRequested(m_current, m_current + 1);
    } else if ((key == Qt::Key_Delete || key == Qt::Key_Backspace) && chosen) {
        emit deletionRequested(m_current);
    } else if ((key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2) && chosen) {
        emit activated(m_current);
    } else if (key == Qt::Key_Left && !control && count() > 0) {
        choose(std::max(0, m_current - 1));
    } else if (key == Qt::Key_Right && !control && count() > 0) {
        choose(std::min(count() - 1, m_current + 1));
    } else if (key == Qt::Key_Home && count() > 0) {
        choose(0);
    } else if (key == Qt::Key_End && count() > 0) {
        choose(count() - 1);
    } else {
        QAbstractScrollArea::keyPressEvent(event);
    }
}

void Storyboard::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const int card = byKey ? m_current : cardAt(event->pos());
    if (card >= 0)
        choose(card);
    const QPoint place =
        byKey && card >= 0 ? viewport()->mapToGlobal(cardRect(card).center()) : event->globalPos();
    emit menuRequested(card, place);
}

void Storyboard::dragEnterEvent(QDragEnterEvent* event)
{
    if (!draggedFrames(*event->mimeData()).empty())
        event->acceptProposedAction();
}

void Storyboard::dragMoveEvent(QDragMoveEvent* event)
{
    const QPoint position = event->position().toPoint();
    scrollNear(position);
    setInsertion(insertionAt(position));
    event->acceptProposedAction();
}

void Storyboard::dragLeaveEvent(QDragLeaveEvent* /*event*/)
{
    setInsertion(-1);
}

void Storyboard::dropEvent(QDropEvent* event)
{
    setInsertion(-1);
    const auto frames = draggedFrames(*event->mimeData());
    if (frames.empty())
        return;
    event->acceptProposedAction();
    emit framesDropped(insertionAt(event->position().toPoint()), frames);
}

} // namespace quadrille::widgets
