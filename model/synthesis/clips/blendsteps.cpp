// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/blendsteps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace quadrille {

namespace {

constexpr double longestStep = 0.4; // seconds
constexpr double shortestStep = 0.2;

/// Frames of the clip: of a blend, or of a foot that stands in it.
struct BlendStretch
{
    std::size_t first;
    std::size_t last;

    std::size_t count() const { return last + 1 - first; }
};

std::vector<BlendStretch> blendsOf(const std::vector<FrameProvenance>& origins)
{
    std::vector<BlendStretch> blends;
    for (std::size_t f = 0; f < origins.size(); ++f) {
        if (origins[f].isSingle())
            continue;
        if (f == 0 || origins[f - 1].isSingle())
            blends.push_back({f, f});
        blends.back().last = f;
    }
    return blends;
}

/// A foot that stands for some frames of a blend, and how far it is carried meanwhile.
struct CarriedFoot
{
    std::uint32_t bit;
    BlendStretch frames;
    double way;
};

/// Those that are carried far, farthest first.
std::vector<CarriedFoot> carriedFeet(const std::vector<std::uint32_t>& standing, const BlendStretch& blend,
                                     const Clip& clip, const Stances& stances)
{
    std::vector<CarriedFoot> feet;
    for (std::size_t foot = 0; foot < stances.feet.size(); ++foot) {
        const std::uint32_t bit = 1U << foot;
        for (std::size_t first = blend.first; first <= blend.last; ++first) {
            std::size_t end = first;
            while (end <= blend.last && (standing[end] & bit) != 0)
                ++end;
            if (end == first)
                continue;
            const double way = carriedWay(clip, stances, foot, first, end - 1);
            if (way > longestCarry)
                feet.push_back({bit, {first, end - 1}, way});
            first = end;
        }
    }
    std::ranges::stable_sort(feet, std::greater(), &CarriedFoot::way);
    return feet;
}

/// Lets feet step one after the other in the middle of frames in which all of them stand.
class FootSteps
{
public:
    FootSteps(std::vector<std::uint32_t>& standing, double fps)
        : m_standing(standing)
        , m_longest(static_cast<std::size_t>(std::lround(longestStep * fps)))
        , m_shortest(static_cast<std::size_t>(std::ceil(shortestStep * fps)))
    {
    }

    /// \return whether there is time for all.
    bool add(std::span<const CarriedFoot> feet)
    {
        BlendStretch common = feet.front().frames;
        for (const CarriedFoot& foot : feet)
            common = {std::max(common.first, foot.frames.first), std::min(common.last, foot.frames.last)};
        // Before, between and behind steps all feet stand for a frame.
        if (common.last < common.first + feet.size() * (m_shortest + 1))
            return false;
        const std::size_t length = std::min((common.count() - 1) / feet.size() - 1, m_longest);
        std::size_t begin = common.first + (common.count() - feet.size() * (length + 1) + 1) / 2;
        for (const CarriedFoot& foot : feet) {
            lift(foot.bit, std::span(m_standing).subspan(begin, length));
            begin += length + 1;
        }
        return true;
    }

private:
    /// Unless it is the only one that stands.
    static void lift(std::uint32_t foot, std::span<std::uint32_t> swing)
    {
        if (std::ranges::all_of(swing, [foot](std::uint32_t on) { return (on & ~foot) != 0; })) {
            for (std::uint32_t& on : swing)
                on &= ~foot;
        }
    }

    std::vector<std::uint32_t>& m_standing;
    std::size_t m_longest;
    std::size_t m_shortest;
};

} // namespace

void addSteps(std::vector<std::uint32_t>& standing, const Clip& clip, const Stances& stances)
{
    FootSteps steps(standing, clip.fps);
    for (const BlendStretch& blend : blendsOf(clip.origins)) {
        const std::vector<CarriedFoot> feet = carriedFeet(standing, blend, clip, stances);
        if (feet.empty())
            continue;
        const std::span farthest(feet.begin(), std::min<std::size_t>(feet.size(), 2));
        if (!steps.add(farthest) && farthest.size() > 1)
            steps.add(farthest.first(1));
    }
}

} // namespace quadrille
