// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/mp3.h"
#include "model/audio/mp4sound.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"
#include "tests/model/project/testproject.h"

#include <fstream>

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

TEST(Mp3, HoldsTheWholeSoundBehindItsDelay)
{
    for (const int channels : {1, 2}) {
        const Mp3Stream stream = encodeMp3(tone(0.5, 48000, channels));
        EXPECT_EQ(stream.rate, 48000);
        EXPECT_EQ(stream.channels, channels);
        EXPECT_EQ(stream.length, 24000);
        EXPECT_GE(static_cast<std::int64_t>(stream.frames.size()) * stream.samplesPerFrame,
                  stream.delay + stream.length);
        EXPECT_EQ(decoded(stream).channels, channels);
    }
}

TEST(Mp3, KeepsTheTimeAtWhichASoundBegins)
{
    Sound sound{.rate = 44100, .channels = 1, .samples = std::vector<float>(22050)};
    const Sound beep = tone(0.25, 44100);
    sound.samples.insert(sound.samples.end(), beep.samples.begin(), beep.samples.end());
    const Mp3Stream stream = encodeMp3(sound);
    const Sound back = decoded(stream);
    // The decoder here leaves out its own part of the delay, or none: it begins within that of 0.5 s.
    std::int64_t begin = 0;
    while (begin < back.frameCount() && std::abs(back.samples[static_cast<std::size_t>(begin)]) < 0.1F)
        ++begin;
    EXPECT_NEAR(static_cast<double>(begin), 22050 + stream.delay, 1200);
    EXPECT_NEAR(loudness(back, begin + 2000, begin + 8000), 0.5 / std::numbers::sqrt2, 0.02);
    EXPECT_LT(loudness(back, 2000, begin - 1500), 0.001);
}

TEST(Mp3, ResamplesRatesThatItDoesNotKnow)
{
    for (const int rate : {8000, 22050, 96000}) {
        const Mp3Stream stream = encodeMp3(tone(0.5, rate));
        EXPECT_EQ(stream.rate, rate == 96000 ? 48000 : 32000);
        EXPECT_EQ(stream.length, stream.rate / 2);
        EXPECT_GE(static_cast<std::int64_t>(stream.frames.size()) * 1152, stream.length);
    }
}

TEST(Mp3, IsTheSameEveryTimeAndStopsWhenItIsCancelled)
{
    EXPECT_EQ(encodeMp3(tone(0.3)).frames, encodeMp3(tone(0.3)).frames);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { encodeMp3(tone(0.3), Progress(token)); }), ErrorCode::Cancelled);
}

TEST(Mp4Sound, RefusesFilesThatAreNoMovies)
{
    const TemporaryFolder folder;
    const Mp3Stream stream = encodeMp3(tone(0.1));
    for (const std::string text : {"", "no", "this is no movie at all", "\0\0\0\x08moov"}) {
        std::ofstream(folder / "a.mp4") << text;
        EXPECT_EQ(codeOf([&] { addSound(folder / "a.mp4", stream); }), ErrorCode::FileSyntax) << text;
    }
    EXPECT_EQ(codeOf([&] { addSound(folder / "none.mp4", stream); }), ErrorCode::ReadFailed);
}
