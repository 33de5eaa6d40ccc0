// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/blendtiming.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace quadrille {

namespace {

/// Frames from each cell to the next, drawn gently into each other and into the one frame at a time before
/// and behind, over half of the transition to either side: an uneven pace shows more than poses that are a
/// frame apart, but feet that stand slide where windows go past each other.
std::vector<double> gentleSpeeds(std::span<const double> speeds)
{
    const auto count = static_cast<std::ptrdiff_t>(speeds.size());
    const std::ptrdiff_t reach = std::max<std::ptrdiff_t>(count / 2, 3);
    std::vector<double> kernel;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
        const double wave =
            std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * (reach + 1)));
        kernel.push_back(wave * wave);
    }
    const double total = std::accumulate(kernel.begin(), kernel.end(), 0.0);
    std::vector<double> gentle;
    for (std::ptrdiff_t step = 0; step < count; ++step) {
        double sum = 0;
        for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
            const std::ptrdiff_t other = step + k;
            const bool isInside = 0 <= other && other < count;
            sum += kernel[static_cast<std::size_t>(k + reach)] *
                   (isInside ? speeds[static_cast<std::size_t>(other)] : 1);
        }
        gentle.push_back(sum / total);
    }
    return gentle;
}

/// Lets the sequence go on from its shown end at the speed of one frame at a time and come to the speeds of
/// the path within some frames.
void leaveAtFullSpeed(std::vector<double>& speeds)
{
    const std::size_t ramp = std::clamp<std::size_t>(speeds.size() / 8, 2, 5);
    for (std::size_t step = 0; step < std::min(ramp, speeds.size()); ++step) {
        const double way = static_cast<double>(step) / static_cast<double>(ramp);
        const double share = way * way * (3 - 2 * way);
        speeds[step] = 1 + share * (speeds[step] - 1);
    }
}

/// Slows the steps, the later the more, where all of them lead further than the window reaches: there the
/// sequence hardly shows any more.
void stayInside(std::vector<double>& speeds, double reach)
{
    double sum = 0;
    double late = 0;
    const auto lateness = [&speeds](std::size_t step) {
        return static_cast<double>(step) / static_cast<double>(speeds.size());
    };
    for (std::size_t step = 0; step < speeds.size(); ++step) {
        sum += speeds[step];
        late += speeds[step] * lateness(step);
    }
    if (sum <= reach)
        return;
    const double slower = std::min((sum - reach) / late, 1.0);
    for (std::size_t step = 0; step < speeds.size(); ++step)
        speeds[step] *= 1 - slower * lateness(step);
}

/// How far from its shown end a sequence is at each cell, frames. \param speeds  from that end on.
std::vector<double> gentleOffsets(std::vector<double> speeds)
{
    const double reach = std::accumulate(speeds.begin(), speeds.end(), 0.0);
    speeds = gentleSpeeds(speeds);
    leaveAtFullSpeed(speeds);
    stayInside(speeds, reach);
    std::vector<double> offsets{0};
    for (const double speed : speeds)
        offsets.push_back(std::min(offsets.back() + speed, reach));
    return offsets;
}

FrameTime timeAt(NodeIndex first, double offset)
{
    // A sum of speeds that should be whole is not left a rounding error below.
    const double rounded = std::round(offset * 0x1p30) / 0x1p30;
    const double whole = std::floor(rounded);
    return {.frame = first + static_cast<NodeIndex>(whole), .part = rounded - whole};
}

} // namespace

std::vector<BlendTimes> blendTimes(const Transition& transition, BlendTiming timing)
{
    const std::vector<FramePair>& path = transition.path;
    std::vector<BlendTimes> times;
    if (timing == BlendTiming::Cells) {
        for (const FramePair& cell : path)
            times.push_back({.source = {.frame = cell.source}, .destination = {.frame = cell.destination}});
        return times;
    }
    std::vector<double> sourceSpeeds;
    std::vector<double> destinationSpeeds;
    for (std::size_t t = 1; t < path.size(); ++t) {
        sourceSpeeds.push_back(path[t].source - path[t - 1].source);
        const std::size_t back = path.size() - t;
        destinationSpeeds.push_back(path[back].destination - path[back - 1].destination);
    }
    const std::vector<double> fromSource = gentleOffsets(std::move(sourceSpeeds));
    const std::vector<double> toDestination = gentleOffsets(std::move(destinationSpeeds));
    for (std::size_t t = 0; t < path.size(); ++t) {
        times.push_back(
            {.source = timeAt(path.front().source, fromSource[t]),
             .destination = timeAt(path.back().destination, -toDestination[path.size() - 1 - t])});
    }
    return times;
}

} // namespace quadrille
