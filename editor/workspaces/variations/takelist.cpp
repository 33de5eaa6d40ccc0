// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/takelist.h"

#include "widgets/timeline/draggedframes.h"

#include <QDropEvent>

namespace quadrille {

namespace {

QStringList takesOf(const QMimeData& data)
{
    QStringList takes;
    for (const widgets::DraggedFrames& frames : widgets::draggedFrames(data)) {
        if (!frames.sequence.isEmpty() && !takes.contains(frames.sequence))
            takes += frames.sequence;
    }
    return takes;
}

} // namespace

TakeList::TakeList(QWidget* parent) : QTreeWidget(parent)
{
    setAcceptDrops(true);
}

void TakeList::dragEnterEvent(QDragEnterEvent* event)
{
    if (!takesOf(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void TakeList::dragMoveEvent(QDragMoveEvent* event)
{
    event->acceptProposedAction();
}

void TakeList::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    emit takesDropped(takesOf(*event->mimeData()));
}

} // namespace quadrille

#include "moc_takelist.cpp"
