// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelineprivate.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

Qt::CursorShape cursorFor(TimelineDrag::Kind kind)
{
    switch (kind) {
    case TimelineDrag::Kind::RangeStart:
    case TimelineDrag::Kind::RangeEnd:
    case TimelineDrag::Kind::SpanStart:
    case TimelineDrag::Kind::SpanEnd:
    case TimelineDrag::Kind::LoopStart:
    case TimelineDrag::Kind::LoopEnd:
        return Qt::SizeHorCursor;
    default:
        return Qt::ArrowCursor;
    }
}

bool isRange(TimelineDrag::Kind kind)
{
    return kind == TimelineDrag::Kind::RangeStart || kind == TimelineDrag::Kind::RangeEnd;
}

bool isLoop(TimelineDrag::Kind kind)
{
    return kind == TimelineDrag::Kind::LoopStart || kind == TimelineDrag::Kind::LoopEnd ||
           kind == TimelineDrag::Kind::LoopNew;
}

bool isSpan(TimelineDrag::Kind kind)
{
    return kind == TimelineDrag::Kind::Move || kind == TimelineDrag::Kind::SpanStart ||
           kind == TimelineDrag::Kind::SpanEnd;
}

} // namespace

void Timeline::scrub(int frame)
{
    const int before = d->current;
    setCurrentFrame(frame);
    if (d->current != before)
        emit frameScrubbed(d->current);
}

void Timeline::select(const std::optional<SpanRef>& span)
{
    if (span == d->selected)
        return;
    d->selected = span;
    update();
    emit selectionChanged(span);
}

void Timeline::hover(const std::optional<SpanRef>& span)
{
    if (span == d->hovered)
        return;
    d->hovered = span;
    emit spanHovered(span);
}

void Timeline::leaveEvent(QEvent* event)
{
    hover(std::nullopt);
    QWidget::leaveEvent(event);
}

void Timeline::mousePressEvent(QMouseEvent* event)
{
    if (d->drag.kind != TimelineDrag::Kind::None)
        return;
    if (event->button() == Qt::MiddleButton) {
        d->drag = {};
        d->drag.kind = TimelineDrag::Kind::Scroll;
        d->drag.pressedAt = event->position();
        d->drag.scrollFirst = d->scale.firstVisible();
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (pressTitle(event->position()))
        return;
    d->drag = d->dragAt(event->position());
    if (event->modifiers().testFlag(Qt::ShiftModifier) && event->position().y() < Private::rulerHeight &&
        event->position().x() >= d->headerWidth) {
        d->drag.kind = TimelineDrag::Kind::LoopNew;
        d->drag.first = d->drag.last = d->drag.grabbed;
    }
    if (event->position().y() >= Private::rulerHeight)
        select(d->spanAt(event->position()));
    if (isSpan(d->drag.kind) || d->drag.kind == TimelineDrag::Kind::MoveKey)
        select(d->drag.span);
    if (d->drag.kind == TimelineDrag::Kind::Playhead) {
        emit scrubbingChanged(true);
        scrub(d->drag.grabbed);
    }
}

void Timeline::mouseMoveEvent(QMouseEvent* event)
{
    TimelineDrag& drag = d->drag;
    if (drag.kind == TimelineDrag::Kind::None) {
        bool isEdge = false;
        d->titleAt(event->position(), &isEdge);
        setCursor(isEdge ? Qt::SizeVerCursor : cursorFor(d->dragAt(event->position()).kind));
        hover(d->spanAt(event->position()));
        return;
    }
    if (drag.kind == TimelineDrag::Kind::Playhead) {
        scrub(d->scale.nearestFrame(event->position().x() - d->headerWidth));
        return;
    }
    if (drag.kind == TimelineDrag::Kind::RowSize) {
        drag.moved = true;
        const int height = drag.oldFirst + qRound(event->position().y() - drag.pressedAt.y());
        d->editRow({.track = drag.span.track, .height = std::clamp(height, 1, Private::tallestRow)});
        updateGeometry();
        update();
        return;
    }
    if (drag.kind == TimelineDrag::Kind::Scroll) {
        d->scale.scrollTo(drag.scrollFirst -
                          (event->position().x() - drag.pressedAt.x()) / d->scale.pixelsPerFrame());
        scaleChanged();
        return;
    }
    if (!drag.moved && (event->position() - drag.pressedAt).manhattanLength() < 3.0)
        return;
    const bool started = !drag.moved;
    drag.moved = true;
    if (drag.kind == TimelineDrag::Kind::MoveKey)
        growUnder(event->position());
    if (!d->dragTo(event->position(), !event->modifiers().testFlag(Qt::AltModifier)) && !started)
        return;
    update();
    if (isRange(drag.kind))
        emit rangeEdited(drag.first, drag.last, false);
    else if (isLoop(drag.kind))
        emit loopEdited(drag.first, drag.last, false);
    else if (isSpan(drag.kind))
        emit spanEdited(drag.span, drag.first, drag.last, false);
    else if (drag.kind == TimelineDrag::Kind::MoveKey)
        emit keyMoved(drag.span, drag.first, false);
}

void Timeline::mouseReleaseEvent(QMouseEvent* event)
{
    const bool scrolling = d->drag.kind == TimelineDrag::Kind::Scroll;
    if (event->button() == (scrolling ? Qt::MiddleButton : Qt::LeftButton))
        finishDrag(true);
}

void Timeline::finishDrag(bool commit)
{
    const TimelineDrag drag = std::exchange(d->drag, {});
    update();
    const int first = commit ? drag.first : drag.oldFirst;
    const int last = commit ? drag.last : drag.oldLast;
    d->growing.stop();
    if (!commit)
        stopGrowing();
    if (drag.kind == TimelineDrag::Kind::Playhead)
        emit scrubbingChanged(false);
    else if (drag.kind == TimelineDrag::Kind::RowSize && drag.moved)
        emit rowsEdited();
    else if (drag.kind == TimelineDrag::Kind::LoopNew && (!drag.moved || !commit))
        emit loopRemovalRequested();
    else if (drag.kind == TimelineDrag::Kind::Create && !drag.moved && commit)
        scrub(drag.grabbed);
    else if (!drag.moved)
        return;
    else if (drag.kind == TimelineDrag::Kind::Create && commit)
        emit spanCreated(drag.span.track, first, last);
    else if (isRange(drag.kind))
        emit rangeEdited(first, last, true);
    else if (isLoop(drag.kind))
        emit loopEdited(first, last, true);
    else if (isSpan(drag.kind))
        emit spanEdited(drag.span, first, last, true);
    else if (drag.kind == TimelineDrag::Kind::MoveKey)
        emit keyMoved(drag.span, first, true);
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event)
{
    bool isEdge = false;
    if (const TimelineTrack* owner = d->titleAt(event->position(), &isEdge)) {
        if (isEdge) {
            d->editRow({.track = owner->id});
            updateGeometry();
            update();
            emit rowsEdited();
        }
        return;
    }
    const TimelineTrack* track = d->trackAt(event->position());
    const bool isLeft = event->button() == Qt::LeftButton;
    if (const auto span = d->spanAt(event->position()); span && isLeft)
        emit spanActivated(*span);
    else if (isLeft && track != nullptr && track->editable &&
             (track->kind == TimelineTrack::Kind::Keys || track->kind == TimelineTrack::Kind::Notes) &&
             event->position().x() >= d->headerWidth) {
        const int frame = d->scale.nearestFrame(event->position().x() - d->headerWidth);
        emit spanCreated(track->id, frame, frame);
    } else
        mousePressEvent(event);
}

void Timeline::wheelEvent(QWheelEvent* event)
{
    const double x = event->position().x() - d->headerWidth;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        d->scale.zoom(std::pow(1.0015, event->angleDelta().y()), x);
    } else {
        const QPoint delta = event->pixelDelta().isNull() ? event->angleDelta() / 2 : event->pixelDelta();
        const int pixels = std::abs(delta.x()) > std::abs(delta.y()) ? delta.x() : delta.y();
        d->scale.scrollTo(d->scale.firstVisible() - pixels / d->scale.pixelsPerFrame());
    }
    scaleChanged();
    event->accept();
}

void Timeline::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const auto span = byKey ? d->selected : d->spanAt(event->pos());
    const TimelineTrack* track = byKey && span ? d->track(span->track) : d->trackAt(event->pos());
    if (span)
        select(span);
    const int frame = byKey ? d->current : d->scale.nearestFrame(event->pos().x() - d->headerWidth);
    const QPoint place = byKey && span ? mapToGlobal(spanRect(*span).center()) : event->globalPos();
    emit contextMenuRequested(track == nullptr ? QString() : track->id, span, frame, place);
}

void Timeline::selectNeighbour(int step)
{
    std::vector<SpanRef> all;
    for (const TimelineTrack& track : d->tracks) {
        const auto begin = static_cast<std::ptrdiff_t>(all.size());
        for (const TimelineSpan& span : track.spans)
            all.push_back({track.id, span.id});
        for (const TimelineKey& key : track.keys)
            all.push_back({track.id, key.id});
        std::ranges::stable_sort(all.begin() + begin, all.end(), {},
                                 [this](const SpanRef& ref) { return d->startOf(ref); });
    }
    if (all.empty())
        return;
    const auto found = d->selected ? std::find(all.begin(), all.end(), *d->selected) : all.end();
    const auto count = static_cast<int>(all.size());
    const int next = found == all.end() ? (step > 0 ? 0 : count - 1)
                                        : (static_cast<int>(found - all.begin()) + step + count) % count;
    select(all[static_cast<std::size_t>(next)]);
    d->scale.reveal(d->startOf(*d->selected));
    scaleChanged();
}

bool Timeline::editSelectedByKey(int key, Qt::KeyboardModifiers modifiers)
{
    if (!d->selected || !d->exists(*d->selected))
        return false;
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2) {
        emit spanActivated(*d->selected);
        return true;
    }
    if (!d->track(d->selected->track)->editable)
        return false;
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
        emit spanDeletionRequested(*d->selected);
        return true;
    }
    const int step = key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : 0;
    return step != 0 && moveSelectedByKey(step, modifiers);
}

bool Timeline::moveSelectedByKey(int step, Qt::KeyboardModifiers modifiers)
{
    if (!(modifiers & (Qt::ControlModifier | Qt::ShiftModifier)))
        return false;
    const int end = d->scale.frameCount() - 1;
    const int start = d->startOf(*d->selected);
    if (d->key(*d->selected) != nullptr) {
        constexpr int manyFrames = 10;
        const int frames = modifiers.testFlag(Qt::ShiftModifier) ? step * manyFrames : step;
        const int frame = std::clamp(start + frames, 0, end);
        if (modifiers.testFlag(Qt::ControlModifier) && frame != start)
            emit keyMoved(*d->selected, frame, true);
        return true;
    }
    const bool isNote = d->track(d->selected->track)->kind == TimelineTrack::Kind::Notes;
    const int first = modifiers.testFlag(Qt::ControlModifier) || isNote ? start + step : start;
    const int last = d->span(*d->selected)->last + step;
    if (first >= 0 && last >= first && last <= end)
        emit spanEdited(*d->selected, first, last, true);
    return true;
}

void Timeline::keyPressEvent(QKeyEvent* event)
{
    const int end = d->scale.frameCount() - 1;
    const auto [in, out] = d->effectiveRange();
    if (editSelectedByKey(event->key(), event->modifiers()))
        return;
    switch (event->key()) {
    case Qt::Key_Left:
        scrub(d->current - 1);
        break;
    case Qt::Key_Right:
        scrub(d->current + 1);
        break;
    case Qt::Key_Home:
        scrub(in);
        break;
    case Qt::Key_End:
        scrub(out);
        break;
    case Qt::Key_Up:
        selectNeighbour(-1);
        break;
    case Qt::Key_Down:
        selectNeighbour(1);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(1.25);
        break;
    case Qt::Key_Minus:
        zoomBy(0.8);
        break;
    case Qt::Key_0:
        zoomToFit();
        break;
    case Qt::Key_I:
    case Qt::Key_O:
        if (!d->isRangeEditable)
            editLoopByKey(event->key() == Qt::Key_I);
        else if (event->key() == Qt::Key_I)
            emit rangeEdited(d->current, std::max(d->current, out), true);
        else
            emit rangeEdited(std::min(in, d->current), d->current, true);
        break;
    case Qt::Key_Insert: {
        const auto editable = [&](const TimelineTrack& t) {
            return t.editable && (!d->selected || d->selected->track == t.id);
        };
        const auto track = std::find_if(d->tracks.begin(), d->tracks.end(), editable);
        constexpr int newSpanFrames = 10;
        if (track != d->tracks.end() &&
            (track->kind == TimelineTrack::Kind::Keys || track->kind == TimelineTrack::Kind::Notes))
            emit spanCreated(track->id, d->current, d->current);
        else if (track != d->tracks.end())
            emit spanCreated(track->id, d->current, std::min(end, d->current + newSpanFrames - 1));
        break;
    }
    case Qt::Key_Escape:
        if (d->drag.kind != TimelineDrag::Kind::None)
            finishDrag(false);
        else if (d->selected)
            select(std::nullopt);
        else
            QWidget::keyPressEvent(event);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace quadrille::widgets
