// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/soundtrack.h"
#include "tests/model/audio/tone.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::FloatNear;

namespace {

Sound ramp()
{
    return {.rate = 10, .channels = 1, .samples = {0.1F, 0.2F, 0.3F, 0.4F}};
}

} // namespace

TEST(SoundTrack, IsSilentBeforeAndAfter)
{
    const Sound clip = soundOfClip(ramp(), {.offset = 0.2}, 0.8);
    EXPECT_THAT(clip.samples, ElementsAre(0, 0, 0.1F, 0.2F, 0.3F, 0.4F, 0, 0));
    EXPECT_EQ(clip.rate, 10);
}

TEST(SoundTrack, IsCutAtBothEnds)
{
    EXPECT_THAT(soundOfClip(ramp(), {.offset = -0.1}, 0.2).samples, ElementsAre(0.2F, 0.3F));
    EXPECT_THAT(soundOfClip(ramp(), {.offset = -5}, 0.2).samples, ElementsAre(0, 0));
    EXPECT_THAT(soundOfClip(ramp(), {.offset = 5}, 0.2).samples, ElementsAre(0, 0));
    EXPECT_TRUE(soundOfClip(ramp(), {}, 0).samples.empty());
}

TEST(SoundTrack, IsLouderOrSofterButNeverBeyondFullScale)
{
    const Sound soft = soundOfClip(ramp(), {.gain = -20}, 0.4);
    EXPECT_NEAR(soft.samples[3], 0.04F, 1e-6);
    const Sound loud = soundOfClip(ramp(), {.gain = 20}, 0.4);
    EXPECT_THAT(loud.samples, ElementsAre(FloatNear(1, 1e-6F), 1, 1, 1));
}

TEST(SoundTrack, MixesManyChannelsToTwo)
{
    const Sound many{.rate = 10, .channels = 4, .samples = {0.1F, 0.2F, 0.3F, 0.6F}};
    const Sound clip = soundOfClip(many, {}, 0.1);
    EXPECT_EQ(clip.channels, 2);
    EXPECT_THAT(clip.samples, ElementsAre(FloatNear(0.2F, 1e-6F), FloatNear(0.4F, 1e-6F)));
}
