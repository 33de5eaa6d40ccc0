// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinetrack.h"

#include <QString>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::widgets {

/// What a timeline shows, as it was given. Ranges have both ends included.
struct TimelineContent
{
    bool isEmpty = true; ///< there is no clip
    double fps = 25.0;
    bool inSeconds = false; ///< how frames are called
    int current = 0;
    std::optional<std::pair<int, int>> range; ///< none: all frames
    bool isRangeEditable = true;
    std::optional<std::pair<int, int>> loop;
    std::vector<TimelineTrack> tracks;
    std::optional<SpanRef> selected;
    QString dropTrack;            ///< empty for none
    std::optional<int> dropFrame; ///< while something is held over the timeline

    /// Null where there is no such; cost: linear.
    const TimelineTrack* track(const QString& id) const;
    const TimelineSpan* span(const SpanRef& ref) const;
    const TimelineKey* key(const SpanRef& ref) const;
    bool exists(const SpanRef& ref) const { return span(ref) != nullptr || key(ref) != nullptr; }
    /// The first frame of a span, the nearest one to a key; 0 where there is no such. Cost: linear.
    int startOf(const SpanRef& ref) const;
    /// "12", or "0:03.48".
    QString frameText(double frame) const;
};

} // namespace quadrille::widgets
