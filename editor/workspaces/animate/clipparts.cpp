// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/clipparts.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace quadrille {

namespace {

using OriginKey = std::tuple<NodeIndex, NodeIndex, double, std::int32_t, std::int32_t>;

OriginKey originKeyOf(const FrameProvenance& origin)
{
    return {origin.source, origin.destination, origin.lambda, origin.sourceVariation,
            origin.destinationVariation};
}

/// Which part of the walk a planned frame belongs to. A transition without frames of its own has the first
/// frame behind it, so that it can be seen.
ClipPart partOf(const ClipPlan& plan, std::int64_t frame)
{
    const auto behind =
        std::ranges::lower_bound(plan.junctions, frame, {}, [](const auto& each) { return each.last; });
    if (behind != plan.junctions.end()) {
        const auto& junction = *behind;
        const bool hasFrames = junction.last - junction.first > 1;
        if (hasFrames ? junction.first < frame && frame < junction.last : frame == junction.last)
            return {true, static_cast<int>(behind - plan.junctions.begin()), {}};
    }
    const auto next = std::ranges::upper_bound(plan.spanStarts, frame);
    return {false, static_cast<int>(next - plan.spanStarts.begin()) - 1, {}};
}

} // namespace

std::vector<std::int64_t> plannedFrames(const AnimationResult& result)
{
    std::map<OriginKey, std::vector<std::int64_t>> places;
    for (std::int64_t k = 0; k < result.plan.frameCount(); ++k)
        places[originKeyOf(result.plan.frames[static_cast<std::size_t>(k)].origin)].push_back(k);
    std::vector<std::int64_t> planned;
    planned.reserve(result.origins.size());
    // A frame that the walk comes to several times is the next of them after what was shown before.
    std::int64_t last = 0;
    bool isFirst = true;
    for (const FrameProvenance& origin : result.origins) {
        const auto found = places.find(originKeyOf(origin));
        if (found == places.end()) {
            planned.push_back(-1);
            continue;
        }
        const auto& candidates = found->second;
        const bool repeats = !planned.empty() && planned.back() == last && !isFirst &&
                             result.origins[planned.size() - 1] == origin;
        const auto next = std::ranges::lower_bound(candidates, isFirst || repeats ? last : last + 1);
        last = next == candidates.end() ? candidates.front() : *next;
        isFirst = false;
        planned.push_back(last);
    }
    return planned;
}

std::vector<ClipPart> clipParts(const AnimationResult& result, const std::vector<std::int64_t>& planned)
{
    std::vector<ClipPart> parts;
    for (std::int64_t f = 0; f < static_cast<std::int64_t>(planned.size()); ++f) {
        const std::int64_t frame = planned[static_cast<std::size_t>(f)];
        ClipPart part = frame < 0 ? ClipPart{true, -1, {}} : partOf(result.plan, frame);
        const bool goesOn = !parts.empty() && parts.back().isJunction == part.isJunction &&
                            parts.back().index == part.index &&
                            (f == 0 || frame < 0 || frame >= planned[static_cast<std::size_t>(f - 1)]);
        if (goesOn) {
            parts.back().frames.last = FrameIndex(f);
        } else {
            part.frames = {FrameIndex(f), FrameIndex(f)};
            parts.push_back(part);
        }
    }
    return parts;
}

std::optional<FrameRange> shownRange(const std::vector<std::int64_t>& planned, FrameRange range)
{
    const auto isInside = [&](std::int64_t frame) {
        return frame >= range.first.value && frame <= range.last.value;
    };
    const auto first = std::ranges::find_if(planned, isInside);
    if (first == planned.end())
        return std::nullopt;
    const auto end = std::find_if_not(first, planned.end(), isInside);
    return FrameRange{FrameIndex(first - planned.begin()), FrameIndex(end - planned.begin() - 1)};
}

} // namespace quadrille
