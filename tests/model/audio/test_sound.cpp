// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/sound.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"
#include "tests/model/project/testproject.h"

using namespace quadrille;
using namespace quadrille::test;

TEST(Sound, OfAWavFileComesOutAsItWentIn)
{
    const TemporaryFolder folder;
    const Sound sound{.rate = 22050, .channels = 2, .samples = {0, 0.5F, -0.5F, 0.25F, 1, -1}};
    const Sound read = readSound(folder.write("a.wav", wavOf(sound)));
    EXPECT_EQ(read.rate, 22050);
    EXPECT_EQ(read.channels, 2);
    ASSERT_EQ(read.samples.size(), sound.samples.size());
    for (std::size_t i = 0; i < read.samples.size(); ++i)
        EXPECT_NEAR(read.samples[i], sound.samples[i], 1.0 / 32767); // 16 bits
    EXPECT_EQ(read.frameCount(), 3);
    EXPECT_DOUBLE_EQ(read.seconds(), 3 / 22050.0);
}

TEST(Sound, ThatIsNoneIsRefused)
{
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { readSound(folder / "none.wav"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { readSound(folder.write("a.wav", "")); }), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOf([&] { readSound(folder.write("a.wav", "not a sound at all")); }),
              ErrorCode::FormatRefused);
    // A header without samples, and one that promises more than the file has.
    const std::string whole = wavOf(tone(0.1));
    EXPECT_EQ(codeOf([&] { readSound(folder.write("a.wav", whole.substr(0, 44))); }),
              ErrorCode::FormatRefused);
    EXPECT_EQ(readSound(folder.write("a.wav", whole.substr(0, 44 + 200))).frameCount(), 100);
}

TEST(Sound, StopsReadingWhenItIsCancelled)
{
    const TemporaryFolder folder;
    const auto file = folder.write("a.wav", wavOf(tone(1)));
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { readSound(file, Progress(token)); }), ErrorCode::Cancelled);
}
