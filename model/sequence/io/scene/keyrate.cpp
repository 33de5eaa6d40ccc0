// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/keyrate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace quadrille {

namespace {

constexpr double sameTime = 1e-5; ///< seconds: times are stored as float
constexpr double onFrame = 0.02;  ///< frames that a key may be off
constexpr std::size_t fewest = 3; ///< keys at different times
constexpr double lowestRate = 5;  ///< keys farther apart are not frames
constexpr double highestRate = 1e4;
constexpr double television = 1000.0 / 1001.0;

/// When there are keys, from the first one on, seconds.
std::vector<double> timesOf(const SceneClip& clip)
{
    std::vector<double> times;
    for (const NodeTracks& tracks : clip.tracks) {
        for (const KeyTrack* track :
             {&tracks.translation, &tracks.rotation, &tracks.scale, &tracks.morphWeights})
            times.insert(times.end(), track->times.begin(), track->times.end());
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < sameTime; }),
                times.end());
    for (std::size_t k = times.size(); k-- > 0;)
        times[k] -= times.front();
    return times;
}

/// Whether all times are frames of a rate, and not all of them frames of one that is so many times lower.
bool fits(const std::vector<double>& times, double rate)
{
    std::int64_t common = 0;
    for (const double time : times) {
        const double frame = std::round(time * rate);
        if (std::abs(time * rate - frame) > onFrame)
            return false;
        common = std::gcd(common, static_cast<std::int64_t>(frame));
    }
    return common == 1;
}

} // namespace

std::optional<double> keyRate(const SceneClip& clip)
{
    const std::vector<double> times = timesOf(clip);
    if (times.size() < fewest)
        return {};
    double shortest = times.back();
    for (std::size_t k = 1; k < times.size(); ++k)
        shortest = std::min(shortest, times[k] - times[k - 1]);
    const double rate = std::round(times.back() / shortest) / times.back();
    const bool isFrames = rate >= lowestRate && rate <= highestRate && fits(times, rate);
    const auto isRate = [&](double exact) {
        return (!isFrames || std::abs(exact - rate) * times.back() < onFrame) && fits(times, exact);
    };
    // Frames may be left out where nothing moves, so that no two keys are next to each other.
    static constexpr std::array usual{24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 90.0, 100.0, 120.0, 240.0};
    std::vector<double> candidates;
    if (isFrames)
        candidates = {std::round(rate), std::round(rate / television) * television};
    else
        for (const double whole : usual)
            candidates.insert(candidates.end(), {whole, whole * television});
    if (const auto exact = std::ranges::find_if(candidates, isRate); exact != candidates.end())
        return *exact;
    return isFrames ? std::optional(rate) : std::nullopt;
}

std::vector<std::optional<double>> keyRates(const std::vector<SceneClip>& clips)
{
    std::vector<std::optional<double>> rates;
    std::optional<double> common;
    bool agree = true;
    for (const SceneClip& clip : clips) {
        rates.push_back(keyRate(clip));
        agree = agree && (!common || !rates.back() || common == rates.back());
        common = common ? common : rates.back();
    }
    if (agree)
        for (std::optional<double>& rate : rates)
            rate = rate ? rate : common;
    return rates;
}

} // namespace quadrille
