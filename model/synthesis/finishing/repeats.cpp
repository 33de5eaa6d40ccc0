// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/repeats.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

/// The spans of a plan with the frames that they show.
std::vector<SpanDraw> spansOf(const ClipPlan& plan)
{
    std::vector<SpanDraw> spans(plan.junctions.size() + 1);
    for (std::int64_t f = 0; f < plan.frameCount(); ++f) {
        if (isBetweenSpans(plan, f))
            continue;
        SpanDraw& span = spans[spanAt(plan, f)];
        const NodeIndex node = plan.frames[static_cast<std::size_t>(f)].times.source.frame;
        if (!span.frames) {
            span.frames = WalkSpan{node, node};
            span.start = f;
        }
        span.frames->last = node;
    }
    return spans;
}

/// Variations of one take, one after the other.
struct Supply
{
    std::vector<std::size_t> variations;
    std::size_t next = 0;
};

/// Frames that were shown.
class Shown
{
public:
    explicit Shown(NodeIndex frameCount) : m_shown(static_cast<std::size_t>(frameCount), false) {}
    bool any(NodeIndex first, NodeIndex last) const
    {
        return first <= last && std::find(at(first), at(last) + 1, true) != at(last) + 1;
    }
    void add(const WalkSpan& span)
    {
        for (NodeIndex node = span.first; node <= span.last; ++node)
            m_shown[static_cast<std::size_t>(node)] = true;
    }

private:
    std::vector<bool>::const_iterator at(NodeIndex node) const { return m_shown.begin() + node; }
    std::vector<bool> m_shown;
};

} // namespace

std::size_t spanAt(const ClipPlan& plan, std::int64_t frame)
{
    // A transition of one frame shows only the pose that it leaves.
    const auto isOver = [frame](const ClipPlan::Junction& junction) {
        return junction.last < frame || (junction.last == frame && junction.first < frame);
    };
    return static_cast<std::size_t>(std::ranges::partition_point(plan.junctions, isOver) -
                                    plan.junctions.begin());
}

bool isBetweenSpans(const ClipPlan& plan, std::int64_t frame)
{
    const std::size_t span = spanAt(plan, frame);
    return span < plan.junctions.size() && plan.junctions[span].first < frame &&
           frame < plan.junctions[span].last;
}

std::vector<SpanDraw> drawRepeats(const ClipPlan& plan, const FrameLayout& layout,
                                  std::span<const TakeVariation> variations, int playings)
{
    std::map<int, Supply> supplies; // by sequence
    for (std::size_t v = 0; v < variations.size(); ++v)
        supplies[layout.sequenceOf(variations[v].first)].variations.push_back(v);
    Shown shown(layout.frameCount());
    const std::vector<SpanDraw> once = spansOf(plan);
    std::vector<SpanDraw> spans;
    for (int playing = 0; playing < playings; ++playing) {
        for (const SpanDraw& span : once)
            spans.emplace_back(span).playing = playing;
    }
    for (SpanDraw& span : spans) {
        if (!span.frames)
            continue;
        const auto [first, last] = *span.frames;
        span.isRepeat = shown.any(first, last);
        Supply& supply = supplies[layout.sequenceOf(first)];
        const std::size_t count = supply.variations.size();
        for (std::size_t tried = 0; tried < count && !span.variation; ++tried) {
            const std::size_t at = (supply.next + tried) % count;
            const TakeVariation& each = variations[supply.variations[at]];
            if (shown.any(std::max(first, each.first), std::min(last, each.last))) {
                span.variation = supply.variations[at];
                supply.next = at + 1;
            }
        }
        shown.add(*span.frames);
    }
    return spans;
}

} // namespace quadrille
