// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinelayout.h"

#include <QFont>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

TimelineLayout::TimelineLayout(const TimelineContent& content) : m_content(content), m_metrics(QFont()) {}

void TimelineLayout::setSize(const QSize& size)
{
    m_size = size;
    m_scale.setWidth(size.width() - m_headerWidth);
}

void TimelineLayout::fitHeader()
{
    int widest = 0;
    for (const TimelineTrack& track : m_content.tracks)
        widest = std::max(widest, m_metrics.horizontalAdvance(track.title));
    constexpr int widestHeader = 150;
    constexpr int leastHeader = 76; // lanes below have titles, too
    constexpr int besideTitle = 32; // the sign that folds, and some room
    m_headerWidth =
        m_content.tracks.empty() ? 8 : std::clamp(widest + besideTitle, leastHeader, widestHeader);
    m_scale.setWidth(m_size.width() - m_headerWidth);
}

std::pair<int, int> TimelineLayout::range() const
{
    return m_content.range.value_or(std::pair{0, lastFrame()});
}

std::pair<int, int> TimelineLayout::playedRange() const
{
    const auto [in, out] = range();
    const auto& loop = m_content.loop;
    if (!loop || loop->first > out || loop->second < in)
        return {in, out};
    return {std::max(in, loop->first), std::min(out, loop->second)};
}

int TimelineLayout::x(double frame) const
{
    return m_headerWidth + static_cast<int>(std::lround(m_scale.xOf(frame)));
}

int TimelineLayout::contentHeight() const
{
    int height = tracksTop;
    for (const TimelineTrack& track : m_content.tracks)
        height += m_rows.heightOf(track) + gap;
    return height;
}

QRect TimelineLayout::row(std::size_t index) const
{
    int top = tracksTop;
    for (std::size_t i = 0; i < index; ++i)
        top += m_rows.heightOf(m_content.tracks[i]) + gap;
    return {m_headerWidth, top, std::max(1, m_size.width() - m_headerWidth),
            m_rows.heightOf(m_content.tracks[index])};
}

QRect TimelineLayout::row(const TimelineTrack& track) const
{
    return row(static_cast<std::size_t>(&track - m_content.tracks.data()));
}

QRect TimelineLayout::trackRect(const QString& id) const
{
    const TimelineTrack* track = m_content.track(id);
    return track == nullptr ? QRect() : row(*track);
}

QRect TimelineLayout::titleRect(const QString& id) const
{
    const QRect place = trackRect(id);
    return place.isNull() ? QRect() : QRect(0, place.top(), m_headerWidth, place.height());
}

QRect TimelineLayout::framesRect(const QRect& row, int first, int last) const
{
    const int left = x(first);
    return {left, row.top(), std::max(2, x(last + 1) - left), row.height()};
}

QRect TimelineLayout::keyMarkRect(const QRect& row, double frame) const
{
    const int reach = static_cast<int>(keyReach) + 1;
    return {x(frame + 0.5) - reach, row.top(), 2 * reach,
            std::min(TimelineRows::keyMarkHeight, row.height())};
}

QRect TimelineLayout::keyPictureRect(const QRect& row, double frame) const
{
    // Pictures are as high as their row lets them be; a folded one has none.
    const int side = std::max(0, row.height() - TimelineRows::keyMarkHeight - 2);
    const int middle = x(frame + 0.5);
    int left = middle - side / 2;
    // A picture stays whole while its mark shows.
    if (middle >= row.left() && middle <= row.right())
        left = std::clamp(left, row.left() + 1, std::max(row.left() + 1, row.right() - side));
    return {left, row.top() + TimelineRows::keyMarkHeight, side, side};
}

QRect TimelineLayout::noteRect(const TimelineTrack& owner, const QRect& row, const TimelineSpan& note) const
{
    constexpr int mostWords = 220;
    const int left = x(note.first + 0.5) - noteReach;
    int room = mostWords;
    for (const TimelineSpan& other : owner.spans)
        if (const int toOther = x(other.first + 0.5) - noteReach - left; other.id != note.id && toOther > 0)
            room = std::min(room, toOther);
    const int words = m_metrics.horizontalAdvance(note.text) + 2 * noteReach + 8;
    return {left, row.top(), std::max(2 * noteReach, std::min(room, words)), row.height()};
}

QRect TimelineLayout::spanRect(const SpanRef& ref) const
{
    const TimelineTrack* owner = m_content.track(ref.track);
    if (owner == nullptr)
        return {};
    if (const TimelineKey* key = m_content.key(ref))
        return keyMarkRect(row(*owner), key->frame).united(keyPictureRect(row(*owner), key->frame));
    const TimelineSpan* span = m_content.span(ref);
    if (span == nullptr)
        return {};
    return owner->kind == TimelineTrack::Kind::Notes ? noteRect(*owner, row(*owner), *span)
                                                     : framesRect(row(*owner), span->first, span->last);
}

QRectF TimelineLayout::playheadFlag(int frame) const
{
    const double place = std::floor(m_headerWidth + m_scale.xOf(frame + 0.5)) + 0.5;
    const double width = std::max(24.0, m_metrics.horizontalAdvance(m_content.frameText(frame)) + 12.0);
    // The flag stays whole at both ends.
    const double left = std::clamp(place - width / 2.0, m_headerWidth + 1.0,
                                   std::max(m_headerWidth + 1.0, m_size.width() - width - 1.0));
    return {left, 2.0, width, rulerHeight - 10.0};
}

QRect TimelineLayout::playheadRect(int frame) const
{
    const double place = m_headerWidth + m_scale.xOf(frame + 0.5);
    const QRectF cell(x(frame), 0, x(frame + 1) - x(frame), m_size.height());
    const QRectF line(place - 6, 0, 12, m_size.height());
    // Two more pixels take what is smoothed into the pixels beside it where a point is no whole number of
    // them.
    return playheadFlag(frame).united(cell).united(line).toAlignedRect().adjusted(-2, -2, 2, 2);
}

const TimelineTrack* TimelineLayout::trackAt(const QPointF& position) const
{
    for (const TimelineTrack& track : m_content.tracks)
        if (row(track).adjusted(0, -gap / 2, 0, gap / 2).contains(position.toPoint()))
            return &track;
    return nullptr;
}

std::optional<SpanRef> TimelineLayout::spanAt(const QPointF& position) const
{
    constexpr int slimmest = 6; // pixels that take hold of a span
    const TimelineTrack* owner = trackAt(position);
    if (owner == nullptr)
        return std::nullopt;
    if (owner->kind == TimelineTrack::Kind::Keys)
        return keyAt(*owner, position.toPoint());
    if (owner->kind == TimelineTrack::Kind::Notes)
        return noteAt(*owner, position.toPoint());
    const QRect place = row(*owner);
    // Later spans lie above earlier ones; slim ones are taken hold of beside them too.
    for (auto span = owner->spans.rbegin(); span != owner->spans.rend(); ++span) {
        const QRect box = framesRect(place, span->first, span->last);
        const int beside = std::max(0, (slimmest - box.width() + 1) / 2);
        if (box.adjusted(-beside, 0, beside, 0).contains(position.toPoint()))
            return SpanRef{owner->id, span->id};
    }
    return std::nullopt;
}

std::optional<SpanRef> TimelineLayout::keyAt(const TimelineTrack& owner, const QPoint& point) const
{
    const QRect place = row(owner);
    const auto isOnMark = [&](const TimelineKey& key) {
        return keyMarkRect(place, key.frame).contains(point);
    };
    const auto isOnPicture = [&](const TimelineKey& key) {
        return keyPictureRect(place, key.frame).contains(point);
    };
    // The selected key lies above all, marks above pictures, later keys above earlier ones.
    if (m_content.selected && m_content.selected->track == owner.id)
        if (const TimelineKey* top = m_content.key(*m_content.selected);
            top != nullptr && (isOnMark(*top) || isOnPicture(*top)))
            return m_content.selected;
    for (auto key = owner.keys.rbegin(); key != owner.keys.rend(); ++key)
        if (isOnMark(*key))
            return SpanRef{owner.id, key->id};
    for (auto key = owner.keys.rbegin(); key != owner.keys.rend(); ++key)
        if (isOnPicture(*key))
            return SpanRef{owner.id, key->id};
    return std::nullopt;
}

std::optional<SpanRef> TimelineLayout::noteAt(const TimelineTrack& owner, const QPoint& point) const
{
    const QRect place = row(owner);
    for (auto note = owner.spans.rbegin(); note != owner.spans.rend(); ++note)
        if (noteRect(owner, place, *note).contains(point))
            return SpanRef{owner.id, note->id};
    return std::nullopt;
}

TimelineGrip TimelineLayout::gripAt(const QPointF& position) const
{
    using Kind = TimelineGrip::Kind;
    if (position.x() < m_headerWidth)
        return titleGripAt(position);
    if (position.y() < rulerHeight)
        return rulerGripAt(position);
    const TimelineTrack* owner = trackAt(position);
    if (owner == nullptr || !owner->editable)
        return {.kind = Kind::Playhead};
    if (owner->kind != TimelineTrack::Kind::Keys && owner->kind != TimelineTrack::Kind::Notes)
        return spanGripAt(*owner, position);
    const auto ref = spanAt(position);
    if (!ref)
        return {.kind = Kind::Playhead};
    const int frame = m_content.startOf(*ref);
    return {owner->kind == TimelineTrack::Kind::Keys ? Kind::Key : Kind::Span, *ref, frame, frame};
}

TimelineGrip TimelineLayout::titleGripAt(const QPointF& position) const
{
    constexpr double reach = 3.0;
    for (const TimelineTrack& track : m_content.tracks) {
        const QRect place = row(track);
        const double bottom = place.bottom() + 1.0 + gap / 2.0;
        if (std::abs(position.y() - bottom) <= reach)
            return {TimelineGrip::Kind::RowEdge, {track.id, 0}, place.height(), 0};
        if (position.y() >= place.top() && position.y() < bottom)
            return {.kind = TimelineGrip::Kind::Title, .span = {track.id, 0}};
    }
    return {};
}

TimelineGrip TimelineLayout::rulerGripAt(const QPointF& position) const
{
    using Kind = TimelineGrip::Kind;
    const auto near = [&](int frame) { return std::abs(position.x() - x(frame)) <= edgeReach; };
    const auto [in, out] = range();
    if (m_content.isRangeEditable && position.y() > rulerHeight / 2.0) {
        if (near(out + 1))
            return {Kind::RangeEnd, {}, in, out};
        if (near(in))
            return {Kind::RangeStart, {}, in, out};
    }
    if (m_content.loop && position.y() <= loopHeight + 2) {
        const auto [first, last] = *m_content.loop;
        if (near(last + 1))
            return {Kind::LoopEnd, {}, first, last};
        if (near(first))
            return {Kind::LoopStart, {}, first, last};
    }
    return {.kind = Kind::Playhead};
}

TimelineGrip TimelineLayout::spanGripAt(const TimelineTrack& owner, const QPointF& position) const
{
    using Kind = TimelineGrip::Kind;
    const QRect place = row(owner);
    const auto near = [&](int edge) { return std::abs(position.x() - edge) <= edgeReach; };
    for (auto span = owner.spans.rbegin(); span != owner.spans.rend(); ++span) {
        const QRect box = framesRect(place, span->first, span->last);
        if (!box.adjusted(-edgeReach, 0, edgeReach, 0).contains(position.toPoint()))
            continue;
        // A span too narrow for three zones keeps its ends reachable from outside.
        const bool inside = box.contains(position.toPoint());
        const bool hasEnds = box.width() >= 3 * edgeReach || !inside;
        const Kind kind = hasEnds && near(box.right() + 1) ? Kind::SpanEnd
                          : hasEnds && near(box.left())    ? Kind::SpanStart
                          : inside                         ? Kind::Span
                                                           : Kind::None;
        if (kind != Kind::None)
            return {kind, {owner.id, span->id}, span->first, span->last};
    }
    const int frame = frameAt(position.x());
    return {Kind::NewSpan, {owner.id, 0}, frame, frame};
}

} // namespace quadrille::widgets
