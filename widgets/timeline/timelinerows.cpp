// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The rows of the tracks: how high they are, and what the user makes of that.
#include "widgets/theme/icons.h"
#include "widgets/timeline/timelineprivate.h"

#include <QPainter>
#include <algorithm>

namespace quadrille::widgets {

int Timeline::Private::usualHeight(const TimelineTrack& track)
{
    constexpr int usual = 24;
    switch (track.kind) {
    case TimelineTrack::Kind::Contacts:
        return 14;
    case TimelineTrack::Kind::Keys:
        return track.keys.empty() ? usual : keyRowHeight;
    default:
        return usual;
    }
}

int Timeline::Private::leastHeight(const TimelineTrack& track)
{
    constexpr int least = 14;
    return track.kind == TimelineTrack::Kind::Keys && !track.keys.empty() ? keyMarkHeight + 18 : least;
}

const TimelineRow* Timeline::Private::ownRow(const QString& id) const
{
    const auto found = std::ranges::find(rows, id, &TimelineRow::track);
    return found == rows.end() ? nullptr : &*found;
}

void Timeline::Private::editRow(const TimelineRow& row)
{
    std::erase_if(rows, [&](const TimelineRow& other) { return other.track == row.track; });
    if (row.height > 0 || row.isFolded)
        rows.push_back(row);
}

int Timeline::Private::rowHeight(const TimelineTrack& track) const
{
    const TimelineRow* own = ownRow(track.id);
    if (own == nullptr)
        return usualHeight(track);
    if (own->isFolded)
        return foldedHeight;
    return own->height > 0 ? std::clamp(own->height, leastHeight(track), tallestRow) : usualHeight(track);
}

int Timeline::Private::contentHeight() const
{
    int height = tracksTop;
    for (const TimelineTrack& track : tracks)
        height += rowHeight(track) + gap;
    return height;
}

QRect Timeline::Private::row(std::size_t index) const
{
    int top = tracksTop;
    for (std::size_t i = 0; i < index; ++i)
        top += rowHeight(tracks[i]) + gap;
    return {headerWidth, top, std::max(1, size.width() - headerWidth), rowHeight(tracks[index])};
}

const TimelineTrack* Timeline::Private::titleAt(const QPointF& position, bool* isEdge) const
{
    constexpr double edgeReachOfRow = 3.0;
    if (position.x() >= headerWidth)
        return nullptr;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const QRect place = row(i);
        const double bottom = place.bottom() + 1.0 + gap / 2.0;
        *isEdge = std::abs(position.y() - bottom) <= edgeReachOfRow;
        if (*isEdge || (position.y() >= place.top() && position.y() < bottom))
            return &tracks[i];
    }
    return nullptr;
}

void Timeline::Private::paintTitle(QPainter& painter, const TimelineTrack& owner, const QRect& place) const
{
    constexpr int sign = 12;
    const TimelineRow* own = ownRow(owner.id);
    const bool isFolded = own != nullptr && own->isFolded;
    const QString icon = isFolded ? QStringLiteral("chevronright") : QStringLiteral("chevrondown");
    // High rows carry their titles at the top, beside what they begin with.
    const int height = std::min(place.height(), usualHeight(owner));
    painter.drawPixmap(
        QRect(4, place.top() + (height - sign) / 2, sign, sign),
        icons::pixmap(icon, sign, Theme::color(ColorRole::TextMuted), painter.device()->devicePixelRatioF()));
    const QRect title(8 + sign, place.top(), headerWidth - sign - 12, height);
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.save();
    if (isFolded) {
        QFont small = painter.font();
        small.setPointSizeF(small.pointSizeF() * 0.8);
        painter.setFont(small);
    }
    painter.drawText(title, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextDontClip,
                     painter.fontMetrics().elidedText(owner.title, Qt::ElideRight, title.width()));
    painter.restore();
}

QRect Timeline::titleRect(const QString& id) const
{
    const QRect place = trackRect(id);
    return place.isNull() ? QRect() : QRect(0, place.top(), d->headerWidth, place.height());
}

void Timeline::setRows(std::vector<TimelineRow> rows)
{
    if (rows == d->rows)
        return;
    d->rows = std::move(rows);
    updateGeometry();
    update();
}

const std::vector<TimelineRow>& Timeline::rows() const
{
    return d->rows;
}

bool Timeline::isFolded(const QString& track) const
{
    const TimelineRow* own = d->ownRow(track);
    return own != nullptr && own->isFolded;
}

void Timeline::setFolded(const QString& track, bool folded)
{
    if (folded == isFolded(track))
        return;
    TimelineRow row = d->ownRow(track) == nullptr ? TimelineRow{.track = track} : *d->ownRow(track);
    row.isFolded = folded;
    d->editRow(row);
    updateGeometry();
    update();
    emit rowsEdited();
}

/// \return whether there is a title.
bool Timeline::pressTitle(const QPointF& position)
{
    bool isEdge = false;
    const TimelineTrack* owner = d->titleAt(position, &isEdge);
    if (owner == nullptr)
        return false;
    const QString id = owner->id;
    if (!isEdge) {
        setFolded(id, !isFolded(id));
        return true;
    }
    d->drag = {};
    d->drag.kind = TimelineDrag::Kind::RowSize;
    d->drag.span.track = id;
    d->drag.pressedAt = position;
    d->drag.oldFirst = d->rowHeight(*owner);
    return true;
}

} // namespace quadrille::widgets
