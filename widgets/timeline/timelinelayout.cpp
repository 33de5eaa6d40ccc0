// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelineprivate.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

int Timeline::Private::x(double frame) const
{
    return headerWidth + static_cast<int>(std::lround(scale.xOf(frame)));
}

QRect Timeline::Private::rect(const QRect& row, int first, int last) const
{
    const int left = x(first);
    return {left, row.top(), std::max(2, x(last + 1) - left), row.height()};
}

const TimelineTrack* Timeline::Private::track(const QString& id) const
{
    const auto it = std::find_if(tracks.begin(), tracks.end(), [&](const auto& t) { return t.id == id; });
    return it == tracks.end() ? nullptr : &*it;
}

const TimelineSpan* Timeline::Private::span(const SpanRef& ref) const
{
    const TimelineTrack* owner = track(ref.track);
    if (owner == nullptr)
        return nullptr;
    const auto it = std::find_if(owner->spans.begin(), owner->spans.end(),
                                 [&](const auto& s) { return s.id == ref.span; });
    return it == owner->spans.end() ? nullptr : &*it;
}

const TimelineTrack* Timeline::Private::trackAt(const QPointF& position) const
{
    for (std::size_t i = 0; i < tracks.size(); ++i)
        if (row(i).adjusted(0, -gap / 2, 0, gap / 2).contains(position.toPoint()))
            return &tracks[i];
    return nullptr;
}

std::optional<SpanRef> Timeline::Private::spanAt(const QPointF& position) const
{
    const TimelineTrack* owner = trackAt(position);
    if (owner == nullptr)
        return std::nullopt;
    if (owner->kind == TimelineTrack::Kind::Keys)
        return keyAt(*owner, position);
    if (owner->kind == TimelineTrack::Kind::Notes)
        return noteAt(*owner, position);
    const QRect place = row(static_cast<std::size_t>(owner - tracks.data()));
    // Later spans lie above earlier ones; slim ones are taken hold of beside them too.
    for (auto span = owner->spans.rbegin(); span != owner->spans.rend(); ++span) {
        const QRect box = rect(place, span->first, span->last);
        const int beside = std::max(0, (slimmest - box.width() + 1) / 2);
        if (box.adjusted(-beside, 0, beside, 0).contains(position.toPoint()))
            return SpanRef{owner->id, span->id};
    }
    return std::nullopt;
}

std::pair<int, int> Timeline::Private::effectiveRange() const
{
    return range.value_or(std::pair{0, scale.frameCount() - 1});
}

TimelineDrag Timeline::Private::dragAt(const QPointF& position) const
{
    using Kind = TimelineDrag::Kind;
    TimelineDrag result;
    result.pressedAt = position;
    result.grabbed = scale.nearestFrame(position.x() - headerWidth);
    if (position.x() < headerWidth)
        return result;
    const auto near = [&](int edge) { return std::abs(position.x() - edge) <= edgeReach; };
    const auto [in, out] = effectiveRange();
    if (position.y() < rulerHeight) {
        result.first = result.oldFirst = in;
        result.last = result.oldLast = out;
        const bool lowerHalf = isRangeEditable && position.y() > rulerHeight / 2.0;
        const bool atLoop = loop && position.y() <= loopHeight + 2;
        if (lowerHalf && near(x(out + 1)))
            result.kind = Kind::RangeEnd;
        else if (lowerHalf && near(x(in)))
            result.kind = Kind::RangeStart;
        else if (atLoop && near(x(loop->second + 1)))
            result.kind = Kind::LoopEnd;
        else if (atLoop && near(x(loop->first)))
            result.kind = Kind::LoopStart;
        else
            result.kind = Kind::Playhead;
        if (result.kind == Kind::LoopStart || result.kind == Kind::LoopEnd) {
            result.first = result.oldFirst = loop->first;
            result.last = result.oldLast = loop->second;
        }
        return result;
    }
    const TimelineTrack* owner = trackAt(position);
    if (owner == nullptr || !owner->editable) {
        result.kind = Kind::Playhead;
        return result;
    }
    if (owner->kind == TimelineTrack::Kind::Keys) {
        const auto ref = keyAt(*owner, position);
        result.kind = ref ? Kind::MoveKey : Kind::Playhead;
        result.span = ref.value_or(SpanRef{});
        result.first = result.oldFirst = ref ? startOf(*ref) : result.grabbed;
        return result;
    }
    result.span.track = owner->id;
    if (owner->kind == TimelineTrack::Kind::Notes) {
        const auto ref = noteAt(*owner, position);
        result.kind = ref ? Kind::Move : Kind::Playhead;
        result.span = ref.value_or(SpanRef{});
        result.first = result.oldFirst = result.last = result.oldLast = ref ? startOf(*ref) : result.grabbed;
        return result;
    }
    const QRect place = row(static_cast<std::size_t>(owner - tracks.data()));
    for (std::size_t i = owner->spans.size(); i-- > 0;) {
        const TimelineSpan& candidate = owner->spans[i];
        const QRect box = rect(place, candidate.first, candidate.last);
        if (!box.adjusted(-edgeReach, 0, edgeReach, 0).contains(position.toPoint()))
            continue;
        result.span.span = candidate.id;
        result.first = result.oldFirst = candidate.first;
        result.last = result.oldLast = candidate.last;
        // A span too narrow for three zones keeps its ends reachable from outside.
        const bool narrow = box.width() < 3 * edgeReach;
        const bool inside = box.contains(position.toPoint());
        if (near(box.right() + 1) && !(narrow && inside))
            result.kind = Kind::SpanEnd;
        else if (near(box.left()) && !(narrow && inside))
            result.kind = Kind::SpanStart;
        else if (inside)
            result.kind = Kind::Move;
        else
            continue;
        return result;
    }
    result.kind = Kind::Create;
    result.first = result.last = result.grabbed;
    return result;
}

TimelineSpan Timeline::Private::shown(const QString& owner, const TimelineSpan& span) const
{
    using Kind = TimelineDrag::Kind;
    TimelineSpan result = span;
    const bool dragged =
        drag.moved && drag.span == SpanRef{owner, span.id} &&
        (drag.kind == Kind::Move || drag.kind == Kind::SpanStart || drag.kind == Kind::SpanEnd);
    if (dragged) {
        result.first = drag.first;
        result.last = drag.last;
    }
    return result;
}

int Timeline::Private::snapped(int boundary, const std::optional<SpanRef>& except) const
{
    constexpr double reach = 6.0;
    int best = boundary;
    double nearest = reach / scale.pixelsPerFrame() + 1e-9;
    const auto consider = [&](int candidate) {
        const double distance = std::abs(candidate - boundary);
        if (distance < nearest) {
            nearest = distance;
            best = candidate;
        }
    };
    for (const TimelineTrack& owner : tracks)
        for (const TimelineSpan& span : owner.spans)
            if (!except || !(*except == SpanRef{owner.id, span.id})) {
                consider(span.first);
                consider(span.last + 1);
            }
    const auto [in, out] = effectiveRange();
    consider(in);
    consider(out + 1);
    if (loop && drag.kind != TimelineDrag::Kind::LoopStart && drag.kind != TimelineDrag::Kind::LoopEnd) {
        consider(loop->first);
        consider(loop->second + 1);
    }
    consider(current);
    consider(current + 1);
    return best;
}

bool Timeline::Private::dragTo(const QPointF& position, bool snap)
{
    using Kind = TimelineDrag::Kind;
    const double place = position.x() - headerWidth;
    const int frame = scale.nearestFrame(place);
    const int before[2] = {drag.first, drag.last};
    const int end = scale.frameCount() - 1;
    const auto boundary = [&](const std::optional<SpanRef>& except) {
        const int nearest = static_cast<int>(std::lround(scale.frameAt(place)));
        return std::clamp(snap ? snapped(nearest, except) : nearest, 0, end + 1);
    };
    switch (drag.kind) {
    case Kind::MoveKey:
        drag.first = frameForKey({position.x() - drag.pressedAt.x() + x(drag.oldFirst + 0.5), position.y()},
                                 snap, drag.span);
        break;
    case Kind::RangeStart:
    case Kind::LoopStart:
        drag.first = std::min(boundary(std::nullopt), drag.last);
        break;
    case Kind::RangeEnd:
    case Kind::LoopEnd:
        drag.last = std::max(boundary(std::nullopt) - 1, drag.first);
        break;
    case Kind::SpanStart:
        drag.first = std::min(boundary(drag.span), drag.last);
        break;
    case Kind::SpanEnd:
        drag.last = std::max(boundary(drag.span) - 1, drag.first);
        break;
    case Kind::Create:
    case Kind::LoopNew:
        drag.first = std::min(drag.grabbed, frame);
        drag.last = std::max(drag.grabbed, frame);
        break;
    case Kind::Move: {
        const int length = drag.oldLast - drag.oldFirst;
        int first = drag.oldFirst + frame - drag.grabbed;
        if (snap) {
            const int atStart = snapped(first, drag.span);
            const int atEnd = snapped(first + length + 1, drag.span) - length - 1;
            first = atStart != first ? atStart : atEnd;
        }
        drag.first = std::clamp(first, 0, std::max(0, end - length));
        drag.last = drag.first + length;
        break;
    }
    case Kind::Playhead:
    case Kind::RowSize:
    case Kind::Scroll:
    case Kind::None:
        return false;
    }
    return drag.first != before[0] || drag.last != before[1];
}

} // namespace quadrille::widgets
