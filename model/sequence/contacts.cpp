// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/contacts.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/feet.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Captured soles rarely lie at one level, so each foot rests where its own lowest part does in a good share
/// of the frames, within a little of the common ground.
void setToOwnGround(std::vector<float>& heights, float most)
{
    std::vector<float> sorted = heights;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 6);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const float own = std::clamp(*middle, -most, most);
    for (float& height : heights)
        height -= own;
}

/// Height above the ground and speed of a foot's lowest part, per frame; body heights, per second.
struct FootTrack
{
    std::vector<float> heights;
    std::vector<float> speeds;
};

/// The most extreme value within a reach of each one.
template <typename Extreme>
std::vector<float> extremesAround(const std::vector<float>& values, std::size_t reach, const Extreme& extreme)
{
    std::vector<float> result;
    result.reserve(values.size());
    for (std::size_t f = 0; f < values.size(); ++f) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(f - std::min(f, reach));
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(f + reach + 1, values.size()));
        result.push_back(*extreme(first, end));
    }
    return result;
}

/// Captures drift: what a figure stands on rises and sinks by some centimetres in the course of a take. The
/// ground follows the lowest foot, but not for as long as somebody is in the air (a morphological opening).
void setToDriftingGround(std::vector<FootTrack>& tracks, double fps)
{
    constexpr double longestFlight = 1; // seconds
    constexpr float mostDrift = 0.06F;
    if (tracks.empty())
        return;
    std::vector<float> lowest = tracks.front().heights;
    for (const FootTrack& track : tracks)
        std::ranges::transform(lowest, track.heights, lowest.begin(),
                               [](float a, float b) { return std::min(a, b); });
    const auto reach = static_cast<std::size_t>(std::lround(longestFlight / 2 * fps));
    using Place = std::vector<float>::const_iterator;
    const auto least = [](Place first, Place end) { return std::min_element(first, end); };
    const auto greatest = [](Place first, Place end) { return std::max_element(first, end); };
    const std::vector<float> ground = extremesAround(extremesAround(lowest, reach, least), reach, greatest);
    for (FootTrack& track : tracks)
        for (std::size_t f = 0; f < ground.size(); ++f)
            track.heights[f] -= std::clamp(ground[f], -mostDrift, mostDrift);
}

FootTrack trackFoot(const UprightFrames& frames, const std::vector<std::uint32_t>& foot, float ground,
                    float bodyHeight, double fps)
{
    const std::size_t count = frames.count();
    FootTrack track;
    for (std::size_t f = 0; f < count; ++f) {
        const Positions now = frames.at(f);
        std::vector<std::uint32_t> order = foot;
        const auto kept = static_cast<std::ptrdiff_t>(std::max<std::size_t>(3, foot.size() / 6));
        std::nth_element(order.begin(), order.begin() + kept - 1, order.end(), [&now](auto a, auto b) {
            return std::pair(now[a].y(), a) < std::pair(now[b].y(), b);
        });
        order.resize(static_cast<std::size_t>(kept));
        track.heights.push_back((meanOf(now, order).y() - ground) / bodyHeight);
        const Positions before = frames.at(f == 0 ? 0 : f - 1);
        const Positions after = frames.at(std::min(f + 1, count - 1));
        // The slower of before and after: the first and last frame of a contact count as standing.
        const float back = (meanOf(now, order) - meanOf(before, order)).norm();
        const float ahead = (meanOf(after, order) - meanOf(now, order)).norm();
        const float step = f == 0 ? ahead : f + 1 == count ? back : std::min(back, ahead);
        track.speeds.push_back(step * static_cast<float>(fps) / bodyHeight);
    }
    return track;
}

std::vector<FrameRange> standingSpans(const FootTrack& track, const ContactOptions& options, double fps)
{
    std::vector<FrameRange> spans;
    bool stands = false;
    const auto count = static_cast<std::int64_t>(track.heights.size());
    for (std::int64_t f = 0; f < count; ++f) {
        const double height = track.heights[static_cast<std::size_t>(f)];
        const double speed = track.speeds[static_cast<std::size_t>(f)];
        const bool continues = stands && height < options.leaveHeight && speed < options.leaveSpeed;
        const bool begins = height < options.landHeight && speed < options.landSpeed;
        const bool now = continues || begins;
        if (now && !stands) {
            const bool joins = !spans.empty() && static_cast<double>(f - spans.back().last.value - 1) <=
                                                     options.longestGap * fps;
            if (!joins)
                spans.push_back({FrameIndex(f), FrameIndex(f)});
        }
        stands = now;
        if (now)
            spans.back().last = FrameIndex(f);
    }
    std::erase_if(spans, [&](const FrameRange& span) {
        return static_cast<double>(span.count()) < options.shortest * fps;
    });
    return spans;
}

void checkOptions(const ContactOptions& o)
{
    const bool isGood = o.landHeight > 0 && o.landSpeed > 0 && o.leaveHeight >= o.landHeight &&
                        o.leaveSpeed >= o.landSpeed && o.shortest >= 0 && o.longestGap >= 0 &&
                        o.footShare > 0 && o.footShare < 0.2;
    if (!isGood)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("Limits of foot contacts must be positive, those for "
                                                   "leaving not below those for landing")},
                      {"remedy", QUADRILLE_MESSAGE("Correct the limits.")}}});
}

} // namespace

std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options,
                                        const Progress& progress)
{
    checkOptions(options);
    progress.report(0.0);
    if (sequence.frameCount() < 2)
        return {};
    const UprightFrames frames = loadUpright(sequence, options.up, progress.part(0, 0.6));
    const Figure figure = findFigure(*sequence.topology, frames, options.footShare);
    const std::vector<Foot>& feet = figure.feet;
    std::vector<ContactSpan> spans;
    std::vector<FootTrack> tracks;
    for (const Foot& foot : feet) {
        progress.report(0.7 + 0.3 * static_cast<double>(tracks.size()) / static_cast<double>(feet.size()));
        tracks.push_back(trackFoot(frames, foot.vertices, figure.ground, figure.height, sequence.fps));
    }
    setToDriftingGround(tracks, sequence.fps);
    for (std::size_t i = 0; i < feet.size(); ++i) {
        setToOwnGround(tracks[i].heights, 0.017F);
        for (const FrameRange& range : standingSpans(tracks[i], options, sequence.fps))
            spans.push_back({feet[i].name, range});
    }
    std::stable_sort(spans.begin(), spans.end(), [](const ContactSpan& a, const ContactSpan& b) {
        return a.frames.first < b.frames.first;
    });
    progress.report(1.0);
    return spans;
}

} // namespace quadrille
