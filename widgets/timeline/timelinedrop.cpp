// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinedrop.h"

#include "widgets/timeline/timelinesnapping.h"

#include <QDropEvent>
#include <QMimeData>

namespace quadrille::widgets {

TimelineDrop::TimelineDrop(TimelineContent& content, const TimelineLayout& layout, TimelineGrowth& growth)
    : m_content(content), m_layout(layout), m_growth(growth)
{
}

bool TimelineDrop::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::DragEnter:
        enter(*static_cast<QDropEvent*>(event));
        return true;
    case QEvent::DragMove:
        move(*static_cast<QDropEvent*>(event));
        return true;
    case QEvent::DragLeave:
        m_content.dropFrame.reset();
        m_growth.takeBack();
        emit changed();
        return true;
    case QEvent::Drop:
        drop(*static_cast<QDropEvent*>(event));
        return true;
    default:
        return QObject::eventFilter(watched, event);
    }
}

int TimelineDrop::frameUnder(const QDropEvent& event) const
{
    const bool snap = !event.modifiers().testFlag(Qt::AltModifier);
    return keyFrameAt(m_layout, event.position().x(), snap, std::nullopt);
}

void TimelineDrop::holdAt(const QPointF& position)
{
    if (m_content.dropFrame)
        m_content.dropFrame = keyFrameAt(m_layout, position.x(), false, std::nullopt);
}

void TimelineDrop::enter(QDropEvent& event) const
{
    const auto frames = draggedFrames(*event.mimeData());
    const bool isTake = !frames.empty() && !frames.front().sequence.isEmpty();
    if (isTake && !m_content.isEmpty && m_content.track(m_content.dropTrack) != nullptr)
        event.acceptProposedAction();
}

void TimelineDrop::move(QDropEvent& event)
{
    const bool isInside = event.position().x() >= m_layout.headerWidth();
    m_content.dropFrame = isInside ? std::optional(frameUnder(event)) : std::nullopt;
    event.setAccepted(isInside);
    m_growth.holdAt(event.position());
    emit changed();
}

void TimelineDrop::drop(QDropEvent& event)
{
    const auto frames = draggedFrames(*event.mimeData());
    m_content.dropFrame.reset();
    m_growth.stop();
    emit changed();
    if (frames.empty() || event.position().x() < m_layout.headerWidth())
        return;
    event.acceptProposedAction();
    emit framesDropped(m_content.dropTrack, frameUnder(event), frames.front());
}

} // namespace quadrille::widgets

#include "moc_timelinedrop.cpp"
