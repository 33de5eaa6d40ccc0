// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/handletool.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace quadrille::widgets {

bool HandleTool::isDrag(const QPointF& pressedAt, const QPointF& position)
{
    constexpr double dragDistance = 3.0; // pixels
    return (position - pressedAt).manhattanLength() >= dragDistance;
}

bool HandleTool::handle(QEvent& event)
{
    if (!isReady())
        return false;
    switch (event.type()) {
    case QEvent::MouseButtonPress:
        return press(static_cast<QMouseEvent&>(event));
    case QEvent::MouseMove:
        return move(static_cast<QMouseEvent&>(event));
    case QEvent::MouseButtonRelease:
        return release(static_cast<QMouseEvent&>(event));
    case QEvent::MouseButtonDblClick:
        return doubleClick(static_cast<QMouseEvent&>(event));
    case QEvent::ShortcutOverride:
        if (!wantsKey(static_cast<QKeyEvent&>(event)))
            return false;
        event.accept();
        return true;
    case QEvent::KeyPress:
        return wantsKey(static_cast<QKeyEvent&>(event)) && pressKey(static_cast<QKeyEvent&>(event));
    case QEvent::Leave:
        leave();
        emit repaintRequested();
        return false;
    default:
        return false;
    }
}

bool HandleTool::pressKey(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Escape:
        if (isDragging())
            endDrag(false);
        else if (isDrawing())
            leaveDrawing();
        else
            clearSelection();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        confirm();
        return true;
    case Qt::Key_Insert:
        insertByKey();
        return true;
    case Qt::Key_Menu:
        askMenuByKey();
        return true;
    case Qt::Key_Tab:
        return selectNext(1);
    case Qt::Key_Backtab:
        return selectNext(-1);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeByKey();
    default:
        return pressOther(event);
    }
}

} // namespace quadrille::widgets

#include "moc_handletool.cpp"
