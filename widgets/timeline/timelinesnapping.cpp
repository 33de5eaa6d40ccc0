// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinesnapping.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// Keeps the nearest of what it is offered, the first among equals.
class NearestMark
{
public:
    NearestMark(const TimelineScale& scale, int wanted) : m_wanted(wanted), m_best(wanted)
    {
        constexpr double reach = 6.0;
        m_distance = reach / scale.pixelsPerFrame() + 1e-9;
    }
    void offer(int mark)
    {
        const double distance = std::abs(mark - m_wanted);
        if (distance < m_distance) {
            m_distance = distance;
            m_best = mark;
        }
    }
    int best() const { return m_best; }

private:
    int m_wanted;
    int m_best;
    double m_distance;
};

} // namespace

int snappedBoundary(const TimelineLayout& layout, int boundary, const std::optional<SpanRef>& except,
                    bool loop)
{
    const TimelineContent& content = layout.content();
    NearestMark nearest(layout.scale(), boundary);
    const auto offer = [&](int first, int last) {
        nearest.offer(first);
        nearest.offer(last + 1);
    };
    for (const TimelineTrack& owner : content.tracks)
        for (const TimelineSpan& span : owner.spans)
            if (except != SpanRef{owner.id, span.id})
                offer(span.first, span.last);
    offer(layout.range().first, layout.range().second);
    if (loop && content.loop)
        offer(content.loop->first, content.loop->second);
    offer(content.current, content.current);
    return nearest.best();
}

int keyFrameAt(const TimelineLayout& layout, double x, bool snap, const std::optional<SpanRef>& except)
{
    const int frame = layout.frameAt(x);
    if (!snap)
        return frame;
    NearestMark nearest(layout.scale(), frame);
    for (const TimelineTrack& owner : layout.content().tracks) {
        for (const TimelineSpan& span : owner.spans) {
            nearest.offer(span.first);
            nearest.offer(span.last);
        }
        for (const TimelineKey& key : owner.keys) {
            if (except == SpanRef{owner.id, key.id})
                continue;
            nearest.offer(static_cast<int>(std::lround(key.frame)));
            if (key.obtained)
                nearest.offer(static_cast<int>(std::lround(*key.obtained)));
        }
    }
    nearest.offer(layout.content().current);
    return std::clamp(nearest.best(), 0, layout.lastFrame());
}

} // namespace quadrille::widgets
