// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinecontent.h"

#include "widgets/timeline/timelinescale.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

const TimelineTrack* TimelineContent::track(const QString& id) const
{
    const auto found = std::ranges::find(tracks, id, &TimelineTrack::id);
    return found == tracks.end() ? nullptr : &*found;
}

const TimelineSpan* TimelineContent::span(const SpanRef& ref) const
{
    const TimelineTrack* owner = track(ref.track);
    if (owner == nullptr)
        return nullptr;
    const auto found = std::ranges::find(owner->spans, ref.span, &TimelineSpan::id);
    return found == owner->spans.end() ? nullptr : &*found;
}

const TimelineKey* TimelineContent::key(const SpanRef& ref) const
{
    const TimelineTrack* owner = track(ref.track);
    if (owner == nullptr)
        return nullptr;
    const auto found = std::ranges::find(owner->keys, ref.span, &TimelineKey::id);
    return found == owner->keys.end() ? nullptr : &*found;
}

int TimelineContent::startOf(const SpanRef& ref) const
{
    if (const TimelineKey* found = key(ref))
        return static_cast<int>(std::lround(found->frame));
    const TimelineSpan* found = span(ref);
    return found == nullptr ? 0 : found->first;
}

QString TimelineContent::frameText(double frame) const
{
    return inSeconds ? timeText(frame / fps) : QString::number(std::lround(frame));
}

} // namespace quadrille::widgets
