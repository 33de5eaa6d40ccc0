// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/takelist.h"

#include "widgets/timeline/draggedframes.h"

#include <QDropEvent>

namespace quadrille {

TakeList::TakeList(QWidget* parent) : QTreeWidget(parent)
{
    setAcceptDrops(true);
}

void TakeList::dragEnterEvent(QDragEnterEvent* event)
{
    if (!widgets::draggedTakes(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void TakeList::dragMoveEvent(QDragMoveEvent* event)
{
    event->acceptProposedAction();
}

void TakeList::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    emit takesDropped(widgets::draggedTakes(*event->mimeData()));
}

} // namespace quadrille

#include "moc_takelist.cpp"
