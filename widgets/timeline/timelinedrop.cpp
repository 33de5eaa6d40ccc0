// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelineprivate.h"

#include <QDragEnterEvent>
#include <QMimeData>

namespace quadrille::widgets {

void Timeline::setDropTrack(const QString& track)
{
    d->dropTrack = track;
    setAcceptDrops(!track.isEmpty());
}

void Timeline::dragEnterEvent(QDragEnterEvent* event)
{
    const auto frames = draggedFrames(*event->mimeData());
    const bool isTake = !frames.empty() && !frames.front().sequence.isEmpty();
    if (isTake && !d->isEmpty && d->track(d->dropTrack) != nullptr)
        event->acceptProposedAction();
}

void Timeline::dragMoveEvent(QDragMoveEvent* event)
{
    const bool isInside = event->position().x() >= d->headerWidth;
    const bool snap = !event->modifiers().testFlag(Qt::AltModifier);
    d->dropFrame =
        isInside ? std::optional(d->frameForKey(event->position(), snap, std::nullopt)) : std::nullopt;
    event->setAccepted(isInside);
    growUnder(event->position());
    update();
}

void Timeline::dragLeaveEvent(QDragLeaveEvent* /*event*/)
{
    d->dropFrame.reset();
    stopGrowing();
    update();
}

void Timeline::dropEvent(QDropEvent* event)
{
    const auto frames = draggedFrames(*event->mimeData());
    d->dropFrame.reset();
    d->growing.stop();
    update();
    if (frames.empty() || event->position().x() < d->headerWidth)
        return;
    event->acceptProposedAction();
    const bool snap = !event->modifiers().testFlag(Qt::AltModifier);
    emit framesDropped(d->dropTrack, d->frameForKey(event->position(), snap, std::nullopt), frames.front());
}

} // namespace quadrille::widgets
