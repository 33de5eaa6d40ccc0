// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/waveform.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

SoundPeak joined(const SoundPeak& a, const SoundPeak& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

} // namespace

Waveform::Waveform(const Sound& sound, const Progress& progress)
    : m_rate(static_cast<double>(sound.rate) / finest), m_seconds(sound.seconds())
{
    if (sound.samples.empty())
        return;
    const std::int64_t stretch = finest * sound.channels;
    const auto count = static_cast<std::int64_t>(sound.samples.size());
    std::vector<SoundPeak>& lowest = m_levels.emplace_back();
    lowest.reserve(static_cast<std::size_t>(count / stretch + 1));
    for (std::int64_t at = 0; at < count; at += stretch) {
        const auto [low, high] = std::minmax_element(sound.samples.begin() + at,
                                                     sound.samples.begin() + std::min(at + stretch, count));
        lowest.push_back({*low, *high});
        if (lowest.size() % 65536 == 0)
            progress.report(at, count);
    }
    while (m_levels.back().size() > 1) {
        std::vector<SoundPeak> next;
        const std::vector<SoundPeak>& below = m_levels.back();
        next.reserve((below.size() + 1) / 2);
        for (std::size_t i = 0; i < below.size(); i += 2)
            next.push_back(joined(below[i], below[std::min(i + 1, below.size() - 1)]));
        m_levels.push_back(std::move(next));
    }
}

SoundPeak Waveform::peak(double from, double to) const
{
    if (m_levels.empty() || !(to > 0) || !(from < m_seconds))
        return {};
    const auto last = static_cast<std::int64_t>(m_levels.front().size()) - 1;
    std::int64_t first =
        std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(from * m_rate)), 0, last);
    std::int64_t end = static_cast<std::int64_t>(std::ceil(std::min(to, m_seconds) * m_rate));
    end = std::clamp(end, first + 1, last + 1);
    // Upwards while stretches are whole; what sticks out on either side is taken from the level where it
    // does.
    SoundPeak result = m_levels.front()[static_cast<std::size_t>(first)];
    for (std::size_t level = 0; first < end; ++level) {
        const std::vector<SoundPeak>& here = m_levels[level];
        if (first % 2 != 0)
            result = joined(result, here[static_cast<std::size_t>(first++)]);
        if (end % 2 != 0 && first < end)
            result = joined(result, here[static_cast<std::size_t>(--end)]);
        first /= 2;
        end /= 2;
    }
    return result;
}

std::vector<SoundPeak> Waveform::peaks(double from, double seconds, int count) const
{
    std::vector<SoundPeak> result(static_cast<std::size_t>(std::max(count, 0)));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] =
            peak(from + seconds * static_cast<double>(i), from + seconds * static_cast<double>(i + 1));
    return result;
}

} // namespace quadrille
