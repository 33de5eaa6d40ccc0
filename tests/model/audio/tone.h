// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/sound.h"

#include <cmath>
#include <numbers>
#include <string>

namespace quadrille::test {

/// A WAV file of 16 bits.
inline std::string wavOf(const Sound& sound)
{
    std::string data;
    const auto add = [](std::string& to, std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            to += static_cast<char>(value >> (8U * static_cast<unsigned>(i)));
    };
    for (const float sample : sound.samples)
        add(data, static_cast<std::uint32_t>(std::lround(sample * 32767)), 2);
    const auto channels = static_cast<std::uint32_t>(sound.channels);
    const auto rate = static_cast<std::uint32_t>(sound.rate);
    std::string text = "RIFF";
    add(text, static_cast<std::uint32_t>(36 + data.size()), 4);
    text += "WAVEfmt ";
    add(text, 16, 4);
    add(text, 1, 2);
    add(text, channels, 2);
    add(text, rate, 4);
    add(text, rate * channels * 2, 4);
    add(text, channels * 2, 2);
    add(text, 16, 2);
    text += "data";
    add(text, static_cast<std::uint32_t>(data.size()), 4);
    return text + data;
}

/// A tone of 1 kHz at half of full scale in every channel.
inline Sound tone(double seconds, int rate = 48000, int channels = 1)
{
    Sound sound{.rate = rate, .channels = channels, .samples = {}};
    const auto count = static_cast<std::int64_t>(std::llround(seconds * rate));
    for (std::int64_t f = 0; f < count; ++f) {
        for (int c = 0; c < channels; ++c)
            sound.samples.push_back(static_cast<float>(
                0.5 * std::sin(2 * std::numbers::pi * 1000 * static_cast<double>(f) / rate)));
    }
    return sound;
}

} // namespace quadrille::test
