// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/alignment.h"
#include "model/variation/playback.h"
#include "tests/model/codeof.h"
#include "tests/model/largestdistance.h"
#include "tests/model/variation/swayingtakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::strideAt;
using test::swayingTake;
using ::testing::HasSubstr;

constexpr int frames = 40;

/// Out and back: no locomotion.
double reach(double frame)
{
    return 2.6 * std::sin(std::numbers::pi * frame / (frames - 1)) + 0.02 * frame;
}

MeshSequence reachingTake(const std::string& name = "reach")
{
    return swayingTake(
        name, frames, [](int f) { return reach(f); }, strideAt);
}

/// Goes on and on; `period` frames a cycle.
MeshSequence cyclingTake(const std::string& name, int count, double period, double start = 0, double size = 1)
{
    return swayingTake(
        name, count, [=](int f) { return 2 * std::numbers::pi * (f / period + start); }, strideAt, size);
}

Alignment align(const std::vector<MeshSequence>& sequences, const AlignmentSettings& settings = {},
                Positions templatePose = {})
{
    std::vector<TrainingTake> takes;
    for (const MeshSequence& sequence : sequences)
        takes.push_back({sequence, {}});
    return alignTakes(takes, 0, settings, templatePose);
}

TEST(Alignment, WarpsAWarpedCopyAsItWasWarped)
{
    // Slow at first, fast later, 55 frames for 40.
    const auto warped = [](int f) {
        const double t = f / 54.0;
        return (frames - 1) * (0.6 * t + 0.4 * t * t);
    };
    const MeshSequence copy = swayingTake("copy", 55, [&](int f) { return reach(warped(f)); });
    const Alignment alignment = align({reachingTake(), copy});
    const TakeWarp& warp = alignment.takes[1].warp;
    EXPECT_EQ(alignment.reports[1].use, TakeUse::Whole);
    EXPECT_EQ(warp.frames, FrameRange::all(55));
    ASSERT_EQ(warp.playback.size(), 55U);
    for (int f = 0; f < 55; ++f)
        EXPECT_NEAR(warp.playback[static_cast<std::size_t>(f)], warped(f), 1) << f;
    for (std::size_t f = 0; f < alignment.takes[1].placements.size(); ++f)
        EXPECT_LT(test::largestDistance(alignment.takes[0].pose(f), alignment.takes[1].pose(f)), 0.12);
}

TEST(Alignment, OfIdenticalTakesIsTheIdentity)
{
    const Alignment alignment = align({reachingTake(), reachingTake("again")});
    EXPECT_EQ(alignment.takes[0].warp, alignment.takes[1].warp);
    EXPECT_EQ(alignment.takes[0].poses, alignment.takes[1].poses);
    for (int f = 0; f < frames; ++f)
        EXPECT_NEAR(alignment.takes[1].warp.positions[static_cast<std::size_t>(f)], f, 1e-9);
    EXPECT_NEAR(alignment.reports[1].phases[39], 1, 1e-12);
    EXPECT_EQ(alignment.reports[1].path.size(), 40U);
}

TEST(Alignment, MovingATakeChangesNothingButItsPlacements)
{
    const RigidMotion move{Eigen::Quaterniond(Eigen::AngleAxisd(2, Vec3d::UnitY())), {4, 0, -7}};
    const auto phase = [](int f) { return reach(0.8 * f + 2); };
    const MeshSequence take = swayingTake("take", 44, phase, strideAt);
    const MeshSequence elsewhere = swayingTake("take", 44, phase, [&](int f) {
        const RigidMotion there = strideAt(f);
        return RigidMotion{move.rotation * there.rotation, move(there.translation)};
    });
    const Alignment a = align({reachingTake(), take});
    const Alignment b = align({reachingTake(), elsewhere});
    EXPECT_EQ(a.reports[1].path, b.reports[1].path);
    EXPECT_LT(test::largestDistance(a.takes[1].poses, b.takes[1].poses), 1e-5);
    for (std::size_t f = 0; f < a.takes[1].placements.size(); ++f) {
        const RigidMotion& p = a.takes[1].placements[f];
        const RigidMotion& q = b.takes[1].placements[f];
        EXPECT_LT((move(p.translation) - q.translation).norm(), 1e-5);
        EXPECT_LT((move.rotation * p.rotation).angularDistance(q.rotation), 1e-5);
    }
}

TEST(Alignment, PlacementsPutPosesBackWhereTheyWereCaptured)
{
    const MeshSequence take = reachingTake();
    const Alignment alignment = align({take});
    EXPECT_LT(centroid(alignment.templatePose).norm(), 1e-6);
    const AlignedTake& aligned = alignment.takes[0];
    const std::vector<Vec3f> again = played(aligned.poses, aligned.placements, aligned.warp);
    EXPECT_LT(test::largestDistance(again, loadFrames(take)), 1e-5);
}

TEST(Alignment, LaysFramesOntoTheTemplateThatIsGiven)
{
    const std::vector<Vec3f> pose = test::swayedTube(0.7);
    const Alignment alignment = align({reachingTake()}, {}, pose);
    ASSERT_EQ(alignment.templatePose.size(), pose.size());
    for (std::size_t f = 0; f < alignment.takes[0].placements.size(); ++f) {
        const RigidMotion rest = rigidProcrustes(alignment.takes[0].pose(f), alignment.templatePose);
        EXPECT_LT(rest.translation.norm(), 1e-5);
        EXPECT_LT(rest.rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-5);
    }
    const std::vector<Vec3f> other(7);
    EXPECT_EQ(test::codeOf([&] { align({reachingTake()}, {}, other); }), ErrorCode::VertexCountMismatch);
}

TEST(Alignment, LaysFramesByTheirAnchor)
{
    // A body that only turns and goes, with a limb that swings far.
    std::vector<VertexIndex> anchor;
    for (unsigned v = 0; v < 24; ++v)
        anchor.emplace_back(v);
    std::vector<Vec3f> positions;
    for (int f = 0; f < 12; ++f) {
        const std::vector<Vec3f> swung = test::swayedTube(0.5 * f, 2);
        std::vector<Vec3f> pose = test::swayedTube(0);
        std::copy(swung.begin() + 24, swung.end(), pose.begin() + 24);
        for (const Vec3f& p : pose)
            positions.push_back(strideAt(f)(p.cast<double>()).cast<float>());
    }
    const MeshSequence take = makeSequence("limb", test::swayingTopology(),
                                           std::make_shared<MemoryFrames>(std::move(positions), 56), 25);
    const std::vector<TrainingTake> takes = {{take, {}}};
    const AlignedTake byAnchor = alignTakes(takes, 0, {.anchor = anchor}).takes[0];
    const AlignedTake byAll = alignTakes(takes, 0).takes[0];
    double greatestByAll = 0;
    for (int f = 1; f < 12; ++f) {
        const auto turnOf = [f](const AlignedTake& aligned) {
            const Eigen::Quaterniond turned = aligned.placements[static_cast<std::size_t>(f)].rotation *
                                              aligned.placements[0].rotation.conjugate();
            return turned.angularDistance(strideAt(f).rotation * strideAt(0).rotation.conjugate());
        };
        EXPECT_LT(turnOf(byAnchor), 1e-5);
        greatestByAll = std::max(greatestByAll, turnOf(byAll));
    }
    EXPECT_GT(greatestByAll, 0.1);
    EXPECT_EQ(test::codeOf([&] { alignTakes(takes, 0, {.anchor = {VertexIndex(56)}}); }),
              ErrorCode::IndexOutOfRange);
}

TEST(Alignment, AnchorIsWhatTheRootSharesWithNoOtherPart)
{
    const auto vertices = [](std::initializer_list<unsigned> numbers) {
        std::vector<VertexIndex> result;
        for (const unsigned number : numbers)
            result.emplace_back(number);
        return result;
    };
    BodyParts parts{{{.name = "torso", .vertices = vertices({1, 2, 3, 5, 8, 13})}}};
    EXPECT_TRUE(anchorVertices(parts).empty());
    parts.parts.push_back({.name = "arm", .parent = 0, .overlap = vertices({2, 8})});
    parts.parts.push_back({.name = "leg", .parent = 0, .overlap = vertices({3})});
    EXPECT_EQ(anchorVertices(parts), vertices({1, 5, 13}));
    parts.parts.push_back({.name = "head", .parent = 0, .overlap = vertices({1})});
    EXPECT_TRUE(anchorVertices(parts).empty());
}

TEST(Alignment, CutsLocomotionToCyclesFromOnePhaseOn)
{
    // Different tempo, different start, different size.
    const std::vector<MeshSequence> takes = {cyclingTake("walk", 60, 25, 0.1),
                                             cyclingTake("jog", 45, 18, 0.45, 1.2),
                                             cyclingTake("slow", 50, 33, 0.8, 0.8)};
    const Alignment alignment = align(takes);
    ASSERT_EQ(alignment.cycle, 25);
    const std::array<double, 3> periods = {25, 18, 33};
    const std::array<double, 3> starts = {0.1, 0.45, 0.8};
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const AlignedTake& take = alignment.takes[t];
        EXPECT_EQ(alignment.reports[t].use, TakeUse::Cycle);
        EXPECT_EQ(take.warp.frames.count(), static_cast<std::int64_t>(periods[t]));
        ASSERT_EQ(take.placements.size(), 25U);
        for (std::size_t f = 0; f < 25; ++f) {
            const double phase = take.warp.positions[f] / periods[t] + starts[t];
            const double reference = alignment.takes[0].warp.positions[f] / periods[0] + starts[0];
            const double difference = phase - reference - std::round(phase - reference);
            EXPECT_NEAR(difference, 0, 0.05) << take.name << ' ' << f;
        }
    }
}

TEST(Alignment, UsesTakesWithoutACycleAsAWholeAndSaysWhy)
{
    const Alignment alignment =
        align({cyclingTake("walk", 60, 25), reachingTake(), cyclingTake("short", 12, 25)});
    EXPECT_EQ(alignment.reports[1].use, TakeUse::NoCycle);
    EXPECT_EQ(alignment.takes[1].warp.frames, FrameRange::all(frames));
    EXPECT_EQ(alignment.reports[2].use, TakeUse::TooShort);
    EXPECT_EQ(alignment.takes[2].warp.frames, FrameRange::all(12));
    EXPECT_EQ(alignment.takes[2].placements.size(), 25U);
    const Alignment whole = align({reachingTake(), cyclingTake("walk", 60, 25)});
    EXPECT_FALSE(whole.cycle);
    EXPECT_EQ(whole.reports[1].use, TakeUse::Whole);
    EXPECT_EQ(whole.takes[1].warp.frames, FrameRange::all(60));
}

TEST(Alignment, LeavesCyclesAloneWhereTheyAreNotWanted)
{
    const Alignment alignment =
        align({cyclingTake("walk", 60, 25), cyclingTake("jog", 45, 18)}, {.cycles = false});
    EXPECT_FALSE(alignment.cycle);
    EXPECT_EQ(alignment.frameCount(), 60);
    EXPECT_EQ(alignment.takes[1].warp.frames, FrameRange::all(45));
}

TEST(Alignment, UsesExactlyTheRangesThatAreGiven)
{
    const FrameRange ofWalk{FrameIndex(10), FrameIndex(34)};
    const FrameRange ofJog{FrameIndex(3), FrameIndex(30)};
    const std::vector<TrainingTake> takes = {{cyclingTake("walk", 60, 25), ofWalk},
                                             {cyclingTake("jog", 45, 18), ofJog},
                                             {cyclingTake("other", 50, 20, 0.3), {}}};
    const Alignment alignment = alignTakes(takes, 0);
    EXPECT_EQ(alignment.reports[0].use, TakeUse::Given);
    EXPECT_EQ(alignment.takes[0].warp.frames, ofWalk);
    EXPECT_EQ(alignment.takes[0].warp.positions.front(), 10);
    EXPECT_EQ(alignment.reports[1].use, TakeUse::Given);
    EXPECT_EQ(alignment.takes[1].warp.frames, ofJog);
    EXPECT_EQ(alignment.reports[1].firstColumn, FrameIndex(3));
    EXPECT_EQ(alignment.reports[1].costs.cols(), 28);
    // The reference's range is a cycle, so one is cut from the take that has no range: 10/25 = 2/20 + 0.3.
    EXPECT_EQ(alignment.reports[2].use, TakeUse::Cycle);
    EXPECT_NEAR(static_cast<double>(alignment.takes[2].warp.frames.first.value % 20), 2, 1);
}

TEST(Alignment, ContactsGuideTheWarp)
{
    // A hardly moving middle: only contacts tell where its end is.
    const auto hold = [](int f) { return f < 10 ? 0.1 * f : f < 30 ? 1.0 : 1 + 0.1 * (f - 29); };
    MeshSequence a = swayingTake("a", 40, hold);
    MeshSequence b = swayingTake("b", 40, hold);
    a.contacts = {{"left", {FrameIndex(0), FrameIndex(14)}}};
    b.contacts = {{"left", {FrameIndex(0), FrameIndex(24)}}};
    const auto at = [&](double weight) {
        return align({a, b}, {.contactWeight = weight, .smoothing = 0}).takes[1].warp.positions[15];
    };
    EXPECT_NEAR(at(0), 15, 0.5);
    EXPECT_GT(at(5), 23);
}

TEST(Alignment, ShrinksCostsOfLongTakes)
{
    const Alignment alignment =
        align({cyclingTake("long", 600, 590), swayingTake("short", 20, [](int f) { return 0.3 * f; })},
              {.cycles = false, .contactWeight = 0});
    EXPECT_EQ(alignment.reports[1].rowsPerCell, 2);
    EXPECT_EQ(alignment.reports[1].columnsPerCell, 1);
    EXPECT_EQ(alignment.reports[1].costs.rows(), 300);
    EXPECT_EQ(alignment.reports[1].costs.cols(), 20);
}

TEST(Alignment, RefusesTakesThatAreTooShort)
{
    for (const int count : {1, 3}) {
        try {
            align({reachingTake(), swayingTake("blink", count, [](int f) { return 0.1 * f; })});
            ADD_FAILURE() << "no error was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::TakeTooShort);
            EXPECT_THAT(error.what(), HasSubstr("“blink” has " + std::to_string(count)));
        }
    }
    const std::vector<TrainingTake> cut = {{reachingTake(), FrameRange{FrameIndex(3), FrameIndex(4)}}};
    EXPECT_EQ(test::codeOf([&] { alignTakes(cut, 0); }), ErrorCode::TakeTooShort);
}

TEST(Alignment, RefusesBadArguments)
{
    const std::vector<TrainingTake> outside = {{reachingTake(), FrameRange{FrameIndex(3), FrameIndex(40)}}};
    EXPECT_EQ(test::codeOf([&] { alignTakes(outside, 0); }), ErrorCode::RangeOutside);
    EXPECT_EQ(test::codeOf([] { alignTakes({}, 0); }), ErrorCode::BadArgument);
    EXPECT_EQ(test::codeOf([] { align({reachingTake()}, {.postureShare = 2}); }), ErrorCode::BadArgument);
    EXPECT_EQ(test::codeOf([] { align({reachingTake()}, {.contactWeight = -1}); }), ErrorCode::BadArgument);
    const MeshSequence other =
        makeSequence("other", test::tubeTopology(5, 4),
                     std::make_shared<MemoryFrames>(std::vector<Vec3f>(200, Vec3f::Zero()), 20), 25);
    EXPECT_EQ(test::codeOf([&] { align({reachingTake(), other}); }), ErrorCode::CharacterTopologyMismatch);
}

TEST(Alignment, CanBeCancelled)
{
    const std::vector<TrainingTake> takes = {{reachingTake(), {}}, {reachingTake(), {}}};
    for (const double at : {0.0, 0.1, 0.4, 0.85}) {
        CancelToken token;
        const Progress progress(token, [&](double done) {
            if (done >= at)
                token.cancel();
        });
        EXPECT_EQ(test::codeOf([&] { alignTakes(takes, 0, {}, {}, progress); }), ErrorCode::Cancelled);
    }
}

} // namespace
} // namespace quadrille
