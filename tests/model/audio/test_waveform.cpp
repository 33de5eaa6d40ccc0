// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/waveform.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"

#include <algorithm>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

Sound noise(std::size_t frames, int channels)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-1, 1);
    Sound sound{.rate = 1600, .channels = channels, .samples = std::vector<float>(frames * channels)};
    for (float& sample : sound.samples)
        sample = value(random);
    return sound;
}

/// The same by looking at every sample.
SoundPeak plainPeak(const Sound& sound, std::int64_t firstStretch, std::int64_t endStretch)
{
    const auto begin = sound.samples.begin() + firstStretch * Waveform::finest * sound.channels;
    const auto end = sound.samples.begin() + std::min(endStretch * Waveform::finest * sound.channels,
                                                      static_cast<std::int64_t>(sound.samples.size()));
    const auto [low, high] = std::minmax_element(begin, end);
    return {*low, *high};
}

} // namespace

TEST(Waveform, SeesTheSamePeaksAsLookingAtEverySample)
{
    for (const std::size_t frames : {16UL, 17UL, 1000UL, 4096UL, 5003UL}) {
        const Sound sound = noise(frames, 2);
        const Waveform waveform(sound);
        const auto stretches = static_cast<std::int64_t>((frames + 15) / 16);
        for (std::int64_t first = 0; first < stretches; first += 3) {
            for (std::int64_t end = first + 1; end <= stretches; end += 2)
                // 100 stretches a second
                EXPECT_EQ(waveform.peak(static_cast<double>(first) / 100 + 1e-6,
                                        static_cast<double>(end) / 100 - 1e-6),
                          plainPeak(sound, first, end))
                    << frames << " " << first << " " << end;
        }
    }
}

TEST(Waveform, IsSilentOutsideOfTheSound)
{
    const Waveform waveform(noise(1600, 1));
    EXPECT_DOUBLE_EQ(waveform.seconds(), 1);
    EXPECT_EQ(waveform.peak(-2, -1), SoundPeak());
    EXPECT_EQ(waveform.peak(1, 2), SoundPeak());
    EXPECT_EQ(waveform.peak(-2, 3), waveform.peak(0, 1));
    EXPECT_EQ(Waveform().peak(0, 1), SoundPeak());
    EXPECT_TRUE(Waveform().isEmpty());
}

TEST(Waveform, GivesOnePeakForEachColumn)
{
    Sound sound{.rate = 1600, .channels = 1, .samples = std::vector<float>(1600)};
    sound.samples[800] = 0.75F;
    const auto peaks = Waveform(sound).peaks(-0.5, 0.25, 8);
    for (std::size_t i = 0; i < peaks.size(); ++i)
        EXPECT_EQ(peaks[i].high, i == 4 ? 0.75F : 0) << i;
}

TEST(Waveform, StopsWhenItIsCancelled)
{
    const Sound sound{.rate = 48000, .channels = 1, .samples = std::vector<float>(3000000)};
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { Waveform(sound, Progress(token)); }), ErrorCode::Cancelled);
}
