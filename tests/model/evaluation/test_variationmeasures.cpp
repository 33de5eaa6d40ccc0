// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/variationmeasures.h"
#include "tests/model/variation/swayingtakes.h"

#include <functional>
#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A take, its movement, and clips of its frames that were changed.
struct VariedTake
{
    CharacterFrames character;
    Movement movement;
    Stances stances;

    VariedTake()
        : character(std::vector{swayingTake(
              "take", 40, [](int f) { return 0.3 * f; }, strideAt)})
        , movement(learned())
        , stances(givenStances(character))
    {
    }
    Clip clip(const std::function<Vec3d(int frame, const Vec3d& place)>& change) const
    {
        Clip clip{.topology = swayingTopology(), .fps = 25};
        for (NodeIndex f = 0; f < 40; ++f) {
            clip.origins.push_back({.source = f, .destination = f});
            const Frame frame = character.frame(f);
            for (const Vec3f& place : frame.positions())
                clip.positions.push_back(change(f, place.cast<double>()).cast<float>());
        }
        return clip;
    }
    VariationComparison compare(const std::function<Vec3d(int frame, const Vec3d& place)>& change) const
    {
        const Clip varied = clip(change);
        const FollowedTake followed = followedTake(varied, character);
        return compared(measureMoved(varied, movement, stances, UpAxis::Y),
                        measureMoved(followed.clip, movement, stances, UpAxis::Y), followed.frames,
                        UpAxis::Y);
    }

private:
    Movement learned() const
    {
        const MeshSequence& take = character.sequences().front();
        const BodyParts whole = cutIntoParts(*take.topology, take.frame(FrameIndex(0)).positions(), {}, {});
        const std::vector<TrainingTake> takes{{take, std::nullopt}};
        return makeMovement(takes, 0, whole, {}, {.alignment = {.up = UpAxis::Y, .cycles = false}});
    }
};

} // namespace

TEST(VariationMeasures, OfTheTakeItselfAreItsOwn)
{
    const VariationComparison same = VariedTake().compare([](int, const Vec3d& place) { return place; });
    EXPECT_DOUBLE_EQ(same.acceleration, 1);
    EXPECT_DOUBLE_EQ(same.centreAcceleration, 1);
    EXPECT_EQ(same.sink, 0);
    EXPECT_EQ(same.hover, 0);
    EXPECT_NEAR(same.heading, 0, 1e-6);
    EXPECT_EQ(same.closing, 0);
    EXPECT_FALSE(same.slide.has_value());
}

TEST(VariationMeasures, SeeWhatSinksHoversTurnsAndShakes)
{
    const VariedTake take;
    const VariationComparison sunk =
        take.compare([](int, const Vec3d& place) { return Vec3d(place - 0.14 * Vec3d::UnitY()); });
    EXPECT_NEAR(sunk.sink, 0.14, 1e-5);
    EXPECT_NEAR(sunk.acceleration, 1, 1e-3);
    const VariationComparison floating =
        take.compare([](int, const Vec3d& place) { return Vec3d(place + 0.1 * Vec3d::UnitY()); });
    EXPECT_NEAR(floating.hover, 0.1, 1e-5);
    EXPECT_EQ(floating.sink, 0);
    const Eigen::AngleAxisd turn(2.2, Vec3d::UnitY());
    const VariationComparison turned =
        take.compare([&](int, const Vec3d& place) { return Vec3d(turn * place); });
    EXPECT_NEAR(turned.heading, 2.2, 1e-3);
    const VariationComparison shaken = take.compare(
        [](int f, const Vec3d& place) { return Vec3d(place + (f % 2 == 0 ? 0.02 : 0.0) * Vec3d::UnitX()); });
    EXPECT_GT(shaken.acceleration, 1.5);
    EXPECT_GT(shaken.centreAcceleration, 1.5);
    const VariationComparison open = take.compare(
        [](int f, const Vec3d& place) { return Vec3d(place + 0.01 * f * place.y() * Vec3d::UnitX()); });
    EXPECT_GT(std::abs(open.closing), 0.005);
}
