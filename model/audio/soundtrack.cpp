// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/soundtrack.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// The mean of the channels that go to one side.
float mixed(const Sound& sound, std::int64_t frame, int side, int sides)
{
    float sum = 0;
    int count = 0;
    for (int channel = side; channel < sound.channels; channel += sides) {
        sum += sound.samples[static_cast<std::size_t>(frame * sound.channels + channel)];
        ++count;
    }
    return sum / static_cast<float>(count);
}

} // namespace

Sound soundOfClip(const Sound& sound, const SoundTrack& track, double seconds)
{
    const int sides = std::min(sound.channels, 2);
    const auto length = static_cast<std::int64_t>(std::llround(std::max(seconds, 0.0) * sound.rate));
    const auto offset = static_cast<std::int64_t>(std::llround(track.offset * sound.rate));
    const auto factor = static_cast<float>(std::pow(10, track.gain / 20));
    Sound clip{.rate = sound.rate, .channels = sides, .samples = {}};
    clip.samples.assign(static_cast<std::size_t>(length * sides), 0.0F);
    const std::int64_t first = std::max<std::int64_t>(offset, 0);
    const std::int64_t end = std::min(length, offset + sound.frameCount());
    for (std::int64_t frame = first; frame < end; ++frame) {
        for (int side = 0; side < sides; ++side)
            clip.samples[static_cast<std::size_t>(frame * sides + side)] =
                std::clamp(factor * mixed(sound, frame - offset, side, sides), -1.0F, 1.0F);
    }
    return clip;
}

} // namespace quadrille
