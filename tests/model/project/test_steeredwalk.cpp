// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/project/stripproject.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// A walk written by hand.
class SteeredWalk : public test::StripProject
{
protected:
    SteeredWalk() { project.graphs.resize(1); }
};

} // namespace

TEST_F(SteeredWalk, FollowsItsPathAsItIsNow)
{
    AnimationEntry dance;
    dance.name = "dance";
    dance.walk = WalkEntry{
        .spans = {{"slow", {FrameIndex(0), FrameIndex(5)}}, {"quick", {FrameIndex(4), FrameIndex(8)}}}};
    project.animations = {dance};
    AnimationEntry& animation = project.animations.front();
    computed(run("animations"));
    const auto endOf = [&] {
        return Vec2d(column<double>("animations/dance/frames", "centre-x").back(),
                     column<double>("animations/dance/frames", "centre-z").back());
    };
    const Vec2d captured = endOf();
    const auto along = [&](double x) {
        animation.constraints = {PathEntry{.points = {{0, 0, 0}, {x, 0, 3}, {2 * x, 0, 6}}}};
        computed(run("animations"));
        return endOf();
    };
    animation.search.steering = 90;
    const Vec2d one = along(1);
    EXPECT_GT((one - captured).norm(), 1e-3);
    EXPECT_GT((along(-4) - one).norm(), 1e-3) << "the path as it is now";
    EXPECT_EQ(along(1), one);
    animation.search.steering = 0;
    computed(run("animations"));
    EXPECT_NEAR((endOf() - captured).norm(), 0, 1e-6);
    animation.search = {.isPaper = true};
    computed(run("animations"));
    EXPECT_NEAR((endOf() - captured).norm(), 0, 1e-6);
}
