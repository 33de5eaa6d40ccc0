// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinerows.h"

#include <algorithm>

namespace quadrille::widgets {

int TimelineRows::usualHeight(const TimelineTrack& track)
{
    constexpr int usual = 24;
    switch (track.kind) {
    case TimelineTrack::Kind::Contacts:
        return 14;
    case TimelineTrack::Kind::Keys:
        return track.keys.empty() ? usual : keyMarkHeight + keyPicture + 2;
    default:
        return usual;
    }
}

void TimelineRows::edit(const TimelineRow& row)
{
    std::erase_if(m_rows, [&](const TimelineRow& other) { return other.track == row.track; });
    if (row.height > 0 || row.isFolded)
        m_rows.push_back(row);
}

TimelineRow TimelineRows::of(const QString& track) const
{
    const auto found = std::ranges::find(m_rows, track, &TimelineRow::track);
    return found == m_rows.end() ? TimelineRow{.track = track} : *found;
}

int TimelineRows::heightOf(const TimelineTrack& track) const
{
    const TimelineRow row = of(track.id);
    if (row.isFolded)
        return foldedHeight;
    if (row.height <= 0)
        return usualHeight(track);
    const bool hasPictures = track.kind == TimelineTrack::Kind::Keys && !track.keys.empty();
    return std::clamp(row.height, hasPictures ? keyMarkHeight + 18 : 14, tallest);
}

} // namespace quadrille::widgets
