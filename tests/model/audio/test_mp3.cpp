// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/mp3.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"
#include "tests/model/project/testproject.h"

#include <algorithm>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// What a decoder makes of a stream.
Sound decoded(const Mp3Stream& stream)
{
    const TemporaryFolder folder;
    std::string bytes;
    for (const std::string& frame : stream.frames)
        bytes += frame;
    return readSound(folder.write("a.mp3", bytes));
}

double loudness(const Sound& sound, std::int64_t first, std::int64_t end)
{
    double sum = 0;
    for (std::int64_t f = first; f < end; ++f)
        sum += std::pow(sound.samples[static_cast<std::size_t>(f * sound.channels)], 2);
    return std::sqrt(sum / static_cast<double>(end - first));
}

} // namespace

TEST(Mp3, HoldsTheWholeSound)
{
    for (const int channels : {1, 2}) {
        for (const double seconds : {0.0, 0.001, 0.024, 0.0241, 0.5}) {
            const Mp3Stream stream = encodeMp3(tone(seconds, 48000, channels));
            EXPECT_EQ(stream.rate, 48000);
            EXPECT_EQ(stream.channels, channels);
            EXPECT_EQ(stream.length, std::llround(seconds * 48000));
            EXPECT_EQ(static_cast<std::int64_t>(stream.frames.size()), (stream.length + 1151) / 1152);
            if (stream.length > 2400) {
                EXPECT_EQ(decoded(stream).channels, channels);
            }
        }
    }
}

TEST(Mp3, KeepsTheTimeAtWhichASoundBeginsAndEnds)
{
    for (const int rate : {32000, 44100, 48000}) {
        Sound sound{
            .rate = rate, .channels = 1, .samples = std::vector<float>(static_cast<std::size_t>(rate / 2))};
        const Sound beep = tone(0.25, rate);
        sound.samples.insert(sound.samples.end(), beep.samples.begin(), beep.samples.end());
        sound.samples.resize(static_cast<std::size_t>(rate));
        const Sound back = decoded(encodeMp3(sound));
        const auto isHeard = [](float sample) { return std::abs(sample) > 0.1F; };
        const auto begin = std::ranges::find_if(back.samples, isHeard) - back.samples.begin();
        const auto end =
            std::find_if(back.samples.rbegin(), back.samples.rend(), isHeard).base() - back.samples.begin();
        EXPECT_NEAR(static_cast<double>(begin) / rate, 0.5, 0.0005);
        EXPECT_NEAR(static_cast<double>(end) / rate, 0.75, 0.0005);
        EXPECT_NEAR(loudness(back, begin + 2000, begin + 6000), 0.5 / std::numbers::sqrt2, 0.02);
        EXPECT_LT(loudness(back, 2000, begin - 1500), 0.001);
    }
}

TEST(Mp3, BeginsWithinAHundredthOfASecond)
{
    const Sound back = decoded(encodeMp3(tone(0.5)));
    EXPECT_NEAR(loudness(back, 480, 4800), 0.5 / std::numbers::sqrt2, 0.02);
}

TEST(Mp3, ResamplesRatesThatItDoesNotKnow)
{
    for (const int rate : {8000, 22050, 96000}) {
        const Mp3Stream stream = encodeMp3(tone(0.5, rate));
        EXPECT_EQ(stream.rate, rate == 96000 ? 48000 : 32000);
        EXPECT_EQ(stream.length, stream.rate / 2);
        EXPECT_EQ(static_cast<std::int64_t>(stream.frames.size()), (stream.length + 1151) / 1152);
    }
}

TEST(Mp3, IsTheSameEveryTimeAndStopsWhenItIsCancelled)
{
    EXPECT_EQ(encodeMp3(tone(0.3)).frames, encodeMp3(tone(0.3)).frames);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { encodeMp3(tone(0.3), Progress(token)); }), ErrorCode::Cancelled);
}
