// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinegestures.h"

#include "widgets/timeline/timelinesnapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

using Grip = TimelineGrip::Kind;

std::optional<TimelineTrack> TimelineDrag::applied(const TimelineTrack& track) const
{
    if (!moved || track.id != grip.span.track || !(grip.isSpan() || grip.kind == Grip::Key))
        return std::nullopt;
    TimelineTrack result = track;
    if (grip.kind == Grip::Key) {
        if (const auto key = std::ranges::find(result.keys, grip.span.span, &TimelineKey::id);
            key != result.keys.end())
            key->frame = first;
    } else if (const auto span = std::ranges::find(result.spans, grip.span.span, &TimelineSpan::id);
               span != result.spans.end()) {
        span->first = first;
        span->last = last;
    }
    return result;
}

void TimelineGestures::hover(const std::optional<SpanRef>& span)
{
    if (span == m_hovered)
        return;
    m_hovered = span;
    emit spanHovered(span);
}

Qt::CursorShape TimelineGestures::cursorAt(const QPointF& position) const
{
    switch (m_layout.gripAt(position).kind) {
    case Grip::RowEdge:
        return Qt::SizeVerCursor;
    case Grip::RangeStart:
    case Grip::RangeEnd:
    case Grip::SpanStart:
    case Grip::SpanEnd:
    case Grip::LoopStart:
    case Grip::LoopEnd:
        return Qt::SizeHorCursor;
    default:
        return Qt::ArrowCursor;
    }
}

void TimelineGestures::press(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    if (isDragging() || (button != Qt::LeftButton && button != Qt::MiddleButton))
        return;
    TimelineGrip grip = m_layout.gripAt(position);
    const int frame = m_layout.frameAt(position.x());
    const bool isOnTracks = position.y() >= TimelineLayout::rulerHeight;
    if (button == Qt::MiddleButton)
        grip = {.kind = Grip::View};
    else if (grip.kind == Grip::Title)
        return emit foldRequested(grip.span.track);
    else if (modifiers.testFlag(Qt::ShiftModifier) && !isOnTracks && position.x() >= m_layout.headerWidth())
        grip = {Grip::NewLoop, {}, frame, frame};
    m_drag = {grip, frame, position, m_layout.scale().firstVisible(), grip.first, grip.last};
    if (grip.kind == Grip::View || grip.kind == Grip::RowEdge)
        return;
    // An edge is taken hold of from beside its span, too.
    if (grip.isSpan() || grip.kind == Grip::Key)
        emit selectRequested(grip.span);
    else if (isOnTracks)
        emit selectRequested(m_layout.spanAt(position));
    if (grip.kind == Grip::Playhead) {
        emit scrubbingChanged(true);
        emit scrubRequested(frame);
    }
}

void TimelineGestures::move(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    const QPointF way = position - m_drag.pressedAt;
    switch (m_drag.grip.kind) {
    case Grip::None:
        return hover(m_layout.spanAt(position));
    case Grip::Playhead:
        return emit scrubRequested(m_layout.frameAt(position.x()));
    case Grip::RowEdge:
        m_drag.moved = true;
        m_drag.first = std::clamp(m_drag.grip.first + qRound(way.y()), 1, TimelineRows::tallest);
        return emitEdit(m_drag.grip, m_drag.first, 0, false);
    case Grip::View:
        return emit scrollRequested(m_drag.showed - way.x() / m_layout.scale().pixelsPerFrame());
    default:
        break;
    }
    constexpr double leastWay = 3.0; // pixels
    if (!m_drag.moved && way.manhattanLength() < leastWay)
        return;
    const bool started = !std::exchange(m_drag.moved, true);
    if (m_drag.grip.kind == Grip::Key)
        emit keyHeld(position);
    if (!dragTo(position, !modifiers.testFlag(Qt::AltModifier)) && !started)
        return;
    emit dragChanged();
    emitEdit(m_drag.grip, m_drag.first, m_drag.last, false);
}

void TimelineGestures::holdKey(const QPointF& position)
{
    if (m_drag.grip.kind == Grip::Key && dragTo(position, false))
        emitEdit(m_drag.grip, m_drag.first, m_drag.last, false);
}

/// \return whether something changed.
bool TimelineGestures::dragTo(const QPointF& position, bool snap)
{
    const TimelineGrip& grip = m_drag.grip;
    const std::pair before(m_drag.first, m_drag.last);
    const int frame = m_layout.frameAt(position.x());
    const auto snapped = [&](int boundary) {
        const auto except = grip.isSpan() ? std::optional(grip.span) : std::nullopt;
        return snap ? snappedBoundary(m_layout, boundary, except, !grip.isLoopEnd()) : boundary;
    };
    const auto boundary = [&] {
        const double under = m_layout.scale().frameAt(position.x() - m_layout.headerWidth());
        return std::clamp(snapped(static_cast<int>(std::lround(under))), 0, m_layout.lastFrame() + 1);
    };
    switch (grip.kind) {
    case Grip::Key:
        m_drag.first = keyFrameAt(
            m_layout, position.x() - m_drag.pressedAt.x() + m_layout.x(grip.first + 0.5), snap, grip.span);
        break;
    case Grip::RangeStart:
    case Grip::LoopStart:
    case Grip::SpanStart:
        m_drag.first = std::min(boundary(), m_drag.last);
        break;
    case Grip::RangeEnd:
    case Grip::LoopEnd:
    case Grip::SpanEnd:
        m_drag.last = std::max(boundary() - 1, m_drag.first);
        break;
    case Grip::NewSpan:
    case Grip::NewLoop:
        m_drag.first = std::min(m_drag.grabbed, frame);
        m_drag.last = std::max(m_drag.grabbed, frame);
        break;
    case Grip::Span: {
        const int length = grip.last - grip.first;
        int first = grip.first + frame - m_drag.grabbed;
        const int atStart = snapped(first);
        first = atStart != first ? atStart : snapped(first + length + 1) - length - 1;
        m_drag.first = std::clamp(first, 0, std::max(0, m_layout.lastFrame() - length));
        m_drag.last = m_drag.first + length;
        break;
    }
    default:
        break;
    }
    return before != std::pair(m_drag.first, m_drag.last);
}

void TimelineGestures::emitEdit(const TimelineGrip& grip, int first, int last, bool committed)
{
    const SpanRef span = grip.span; // what follows may end the drag
    if (grip.isRange())
        emit rangeEdited(first, last, committed);
    else if (grip.isLoopEnd() || grip.kind == Grip::NewLoop)
        emit loopEdited(first, last, committed);
    else if (grip.isSpan())
        emit spanEdited(span, first, last, committed);
    else if (grip.kind == Grip::Key)
        emit keyMoved(span, first, committed);
    else if (grip.kind == Grip::RowEdge)
        emit rowEdited({.track = span.track, .height = first}, committed);
}

void TimelineGestures::release(Qt::MouseButton button)
{
    if (button == (m_drag.grip.kind == Grip::View ? Qt::MiddleButton : Qt::LeftButton))
        finish(true);
}

void TimelineGestures::finish(bool commit)
{
    const TimelineDrag drag = std::exchange(m_drag, {});
    const Grip kind = drag.grip.kind;
    emit dragEnded(commit);
    if (kind == Grip::Playhead)
        emit scrubbingChanged(false);
    else if (kind == Grip::NewLoop && (!drag.moved || !commit))
        emit loopRemovalRequested();
    else if (kind == Grip::NewSpan && commit && !drag.moved)
        emit scrubRequested(drag.grabbed);
    else if (kind == Grip::NewSpan && commit)
        emit spanCreated(drag.grip.span.track, drag.first, drag.last);
    else if (drag.moved && (commit || kind == Grip::RowEdge))
        emitEdit(drag.grip, drag.first, drag.last, true);
    else if (drag.moved)
        emitEdit(drag.grip, drag.grip.first, drag.grip.last, true);
}

void TimelineGestures::doubleClick(const QPointF& position, Qt::MouseButton button,
                                   Qt::KeyboardModifiers modifiers)
{
    const TimelineGrip grip = m_layout.gripAt(position);
    if (grip.kind == Grip::RowEdge)
        return emit rowEdited({.track = grip.span.track}, true);
    if (grip.kind == Grip::Title)
        return;
    const bool isLeft = button == Qt::LeftButton;
    const TimelineTrack* track = m_layout.trackAt(position);
    const int frame = m_layout.frameAt(position.x());
    if (const auto span = m_layout.spanAt(position); span && isLeft)
        emit spanActivated(*span);
    else if (isLeft && track != nullptr && track->editable && track->holdsMoments())
        emit spanCreated(track->id, frame, frame);
    else
        press(position, button, modifiers);
}

} // namespace quadrille::widgets

#include "moc_timelinegestures.cpp"
