// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/sound.h"

#include <span>

namespace quadrille {

/// The lowest and the highest sample of a stretch of sound, over all channels.
struct SoundPeak
{
    float low = 0;
    float high = 0;

    bool operator==(const SoundPeak&) const = default;
};

/// The outline of a sound, for drawing it at any zoom: peaks of ever longer stretches, each level of two of
/// the level below.
class Waveform
{
public:
    /// Sample frames in a stretch of the lowest level: drawing does not look closer.
    static constexpr std::int64_t finest = 16;

    Waveform() = default;
    /// \throws Error Cancelled.
    explicit Waveform(const Sound& sound, const Progress& progress = {});

    double seconds() const { return m_seconds; }
    bool isEmpty() const { return m_levels.empty(); }
    /// The peak between two times, seconds; silence outside of the sound. Exact to the ends of the finest
    /// stretches. Cost: O(log of the stretches).
    SoundPeak peak(double from, double to) const;
    /// The peaks of `count` stretches one after the other, each `seconds` long.
    std::vector<SoundPeak> peaks(double from, double seconds, int count) const;

private:
    double m_rate = 0; ///< finest stretches per second
    double m_seconds = 0;
    std::vector<std::vector<SoundPeak>> m_levels;
};

} // namespace quadrille
