// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/framelayout.h"

#include <array>
#include <gtest/gtest.h>

using namespace quadrille;

TEST(FrameLayout, KnowsTheSequenceOfEveryFrame)
{
    const FrameLayout layout(std::array<std::int64_t, 3>{2, 1, 3});
    EXPECT_EQ(layout.frameCount(), 6);
    EXPECT_EQ(layout.sequenceCount(), 3);
    const std::array<int, 6> sequences{0, 0, 1, 2, 2, 2};
    for (NodeIndex frame = 0; frame < 6; ++frame)
        EXPECT_EQ(layout.sequenceOf(frame), sequences[static_cast<std::size_t>(frame)]) << frame;
    EXPECT_EQ(layout.firstOf(2), 3);
    EXPECT_EQ(layout.lastOf(2), 5);
    EXPECT_EQ(layout.countOf(1), 1);
}

TEST(FrameLayout, MayBeEmpty)
{
    EXPECT_EQ(FrameLayout().frameCount(), 0);
    EXPECT_EQ(FrameLayout().sequenceCount(), 0);
}
