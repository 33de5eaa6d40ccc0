// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/posedistance.h"
#include "model/variation/quality.h"
#include "tests/model/codeof.h"
#include "tests/model/transition/swayingtube.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;
using quadrille::test::codeOf;

namespace {

constexpr std::uint32_t around = 8;
constexpr std::uint32_t rings = 10;
constexpr std::uint32_t vertexCount = around * rings;
constexpr int frameCount = 9;

/// A straight tube of 1.8 m, z up, open at both ends: it stands for five frames, then goes on by 0.1 m a
/// frame. Contacts are said to last from frame 2 to 6. So it stands in frames 2, 3 and 4.
std::vector<Vec3f> standing()
{
    std::vector<Vec3f> positions;
    for (int f = 0; f < frameCount; ++f) {
        const float x = 0.1F * static_cast<float>(std::max(f - 4, 0));
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            for (std::uint32_t k = 0; k < around; ++k) {
                const double angle = 2 * std::numbers::pi * k / around;
                positions.emplace_back(x + static_cast<float>(0.1 * std::cos(angle)),
                                       static_cast<float>(0.1 * std::sin(angle)),
                                       0.2F * static_cast<float>(ring));
            }
        }
    }
    return positions;
}

MeshSequence takeOf(const std::vector<Vec3f>& positions)
{
    MeshSequence sequence = makeSequence("take", tubeTopology(around, rings),
                                         std::make_shared<MemoryFrames>(positions, vertexCount), 25);
    sequence.contacts = {{"left", {FrameIndex(2), FrameIndex(6)}}};
    return sequence;
}

/// A character with two takes: the second is the varied one.
struct Subject
{
    std::vector<Vec3f> poses;
    CharacterFrames character;
    std::vector<AlignedTake> training;
    std::array<int, 1> varied{1};
    VariationMeter meter;

    explicit Subject(const std::vector<Vec3f>& take = standing())
        : poses(take)
        , character(std::array{takeOf(standing()), takeOf(take)})
        , training{{.name = "take", .warp = {}, .poses = poses, .placements = {}}}
        , meter(character, varied, training, UpAxis::Z)
    {
    }
    Clip clip(std::vector<Vec3f> positions) const
    {
        Clip clip{.topology = character.sequences()[1].topology,
                  .fps = 25,
                  .positions = std::move(positions),
                  .origins = {}};
        for (int f = 0; f < frameCount; ++f)
            clip.origins.push_back({frameCount + f, frameCount + f, 0, false});
        return clip;
    }
    /// The take with every vertex changed.
    template <typename Change>
    VariationQuality measured(Change change) const
    {
        std::vector<Vec3f> positions = poses;
        for (std::size_t i = 0; i < positions.size(); ++i)
            positions[i] = change(positions[i], i / vertexCount, i % vertexCount);
        return meter.measure(clip(positions));
    }
};

/// Into the opposite wall and out of it, between its vertices.
Vec3f piercing(const Vec3f& p, std::size_t vertex)
{
    return vertex == 5 * around + 2 ? Vec3f(p.x() + 0.013F, p.y() - 0.3F, p.z() + 0.07F) : p;
}

} // namespace

TEST(VariationQuality, OfTheTakeItselfIsGood)
{
    const Subject subject;
    const VariationQuality quality = subject.meter.measure(subject.clip(subject.poses));
    ASSERT_EQ(quality.frames.size(), 9U);
    EXPECT_NEAR(quality.size, std::sqrt(1.8 * 1.8 + 0.08), 1e-6);
    EXPECT_EQ(quality.triangles, 2 * 8 * 9);
    EXPECT_LT(quality.worstPoseDistance, 1e-6);
    EXPECT_NEAR(quality.skate.value(), 0, 1e-9);
    EXPECT_EQ(quality.takeSkate, 0);
    EXPECT_EQ(quality.intersections, 0);
    EXPECT_NEAR(quality.volumeChange.value(), 0, 1e-6);
    for (std::size_t f = 0; f < 9; ++f)
        EXPECT_EQ(quality.frames[f].skate.has_value(), f == 2 || f == 3) << f;
    EXPECT_TRUE(judge(quality).empty());
}

TEST(VariationQuality, FindsFeetThatSlide)
{
    const Subject subject;
    const VariationQuality quality =
        subject.measured([](const Vec3f& p, std::size_t frame, std::size_t) -> Vec3f {
            return p + Vec3f(0.012F, 0.016F, 0.05F) * static_cast<float>(frame);
        });
    // 2 cm a frame; what rises does not count.
    EXPECT_NEAR(quality.frames[3].skate.value(), 0.5, 1e-5);
    EXPECT_NEAR(quality.skate.value(), 0.5, 1e-5);
    EXPECT_EQ(judge(quality), std::vector{VariationFault::FootSkate});
    EXPECT_TRUE(judge(quality, {.skate = 0.4}).empty());
}

TEST(VariationQuality, ComparesSlidingWithTheTakes)
{
    // The take slides at 0.25 m/s, slow enough to stand.
    std::vector<Vec3f> sliding = standing();
    for (std::size_t i = 0; i < sliding.size(); ++i)
        sliding[i].y() += 0.01F * static_cast<float>(i / vertexCount);
    const Subject subject(sliding);
    const VariationQuality quality =
        subject.measured([](const Vec3f& p, std::size_t frame, std::size_t) -> Vec3f {
            return p + Vec3f(0, 0.006F * static_cast<float>(frame), 0);
        });
    EXPECT_NEAR(quality.takeSkate, 0.25, 1e-5);
    EXPECT_NEAR(quality.skate.value(), 0.4, 1e-5);
    EXPECT_TRUE(judge(quality).empty());
}

TEST(VariationQuality, FindsSurfacesThatGoThroughThemselves)
{
    const Subject subject;
    const auto pierce = [](const Vec3f& p, std::size_t frame, std::size_t vertex) {
        return frame == 3 ? piercing(p, vertex) : p;
    };
    const VariationQuality quality = subject.measured(pierce);
    EXPECT_GE(quality.intersections, 2);
    EXPECT_EQ(quality.intersections, quality.frames[3].intersections);
    EXPECT_EQ(quality.frames[2].intersections, 0);
    EXPECT_EQ(judge(quality, {.poseDistance = 1, .volumeChange = 1, .collapse = 1}),
              std::vector{VariationFault::Intersections});
    // Where the take does so in some frame, the variation may in another.
    std::vector<Vec3f> pierced = standing();
    for (std::size_t i = 7 * vertexCount; i < 8 * vertexCount; ++i)
        pierced[i] = piercing(pierced[i], i % vertexCount);
    const Subject likewise(pierced);
    const VariationQuality allowed = likewise.measured(pierce);
    EXPECT_EQ(allowed.intersections, quality.intersections);
    EXPECT_EQ(allowed.takeIntersections, quality.intersections);
    EXPECT_TRUE(judge(allowed, {.poseDistance = 1, .volumeChange = 1, .collapse = 1}).empty());
}

TEST(VariationQuality, FindsBodiesThatSwellOrShrink)
{
    const Subject subject;
    const auto scaled = [&](float factor) {
        return subject.measured([factor](const Vec3f& p, std::size_t frame, std::size_t) -> Vec3f {
            return frame == 6 ? Vec3f(factor * p) : p;
        });
    };
    const VariationQuality larger = scaled(1.1F);
    EXPECT_NEAR(larger.volumeChange.value(), 0.331, 1e-5);
    const VariationLimits anyPose{.poseDistance = 1};
    EXPECT_EQ(judge(larger, anyPose), std::vector{VariationFault::Volume});
    const VariationQuality smaller = scaled(0.95F);
    EXPECT_NEAR(smaller.volumeChange.value(), 0.95 * 0.95 * 0.95 - 1, 1e-5);
    EXPECT_EQ(judge(smaller, anyPose), std::vector{VariationFault::Volume});
    EXPECT_TRUE(judge(scaled(1.005F)).empty());
}

TEST(VariationQuality, DoesNotJudgeVolumesOfSurfacesWithoutInside)
{
    TopologyData data = tubeTopology(around, rings)->data();
    data.triangles.push_back({VertexIndex(around), VertexIndex(around + 1), VertexIndex(vertexCount - 1)});
    MeshSequence take = takeOf(standing());
    take.topology = std::make_shared<const Topology>(data);
    const CharacterFrames character(std::span(&take, 1));
    const std::vector<AlignedTake> training{
        {.name = "take", .warp = {}, .poses = standing(), .placements = {}}};
    const VariationMeter meter(character, std::array{0}, training, UpAxis::Z);
    Clip clip{.topology = take.topology, .fps = 25, .positions = {}, .origins = {{0, 0, 0, false}}};
    for (std::uint32_t v = 0; v < vertexCount; ++v)
        clip.positions.push_back(2 * standing()[v]);
    const VariationQuality quality = meter.measure(clip);
    EXPECT_FALSE(quality.volumeChange.has_value());
    EXPECT_FALSE(quality.skate.has_value());
    EXPECT_TRUE(judge(quality, {.poseDistance = 10}).empty());
}

TEST(VariationQuality, FindsPosesLikeNoneThatWasLearned)
{
    const Subject subject;
    const VariationQuality quality =
        subject.measured([](const Vec3f& p, std::size_t frame, std::size_t) -> Vec3f {
            return frame == 1 ? Vec3f(p.x(), p.y() + 0.4F * p.z() * p.z(), p.z())
                              : Vec3f(-p.y() + 3, p.x(), p.z());
        });
    std::vector<Vec3f> strange;
    for (std::size_t v = 0; v < vertexCount; ++v)
        strange.push_back({subject.poses[v].x(),
                           subject.poses[v].y() + 0.4F * subject.poses[v].z() * subject.poses[v].z(),
                           subject.poses[v].z()});
    const double expected = euclideanDistance(strange, Positions(subject.poses).first(vertexCount));
    EXPECT_NEAR(quality.worstPoseDistance, expected, 1e-6);
    EXPECT_NEAR(quality.frames[1].nearest.distance, expected, 1e-6);
    EXPECT_NEAR(quality.meanPoseDistance, expected / 9, 1e-6);
    EXPECT_EQ(judge(quality, {.poseDistance = 0.9 * expected / quality.size,
                              .skate = 9,
                              .intersections = 9,
                              .volumeChange = 9}),
              std::vector{VariationFault::PoseDistance});
    EXPECT_TRUE(judge(quality, {.poseDistance = 1.1 * expected / quality.size,
                                .skate = 9,
                                .intersections = 9,
                                .volumeChange = 9})
                    .empty());
}

TEST(VariationQuality, AllowsPosesAsFarAsTakesAreFromEachOther)
{
    const Subject subject;
    const auto judgedWith = [&](double reach, const VariationLimits& limits = {}) {
        const VariationMeter meter(subject.character, subject.varied, subject.training, UpAxis::Z, {},
                                   std::array{reach});
        std::vector<Vec3f> positions = subject.poses;
        for (std::uint32_t v = 0; v < vertexCount; ++v) // of the first frame alone
            positions[v].y() += 0.2F * positions[v].z() * positions[v].z();
        const VariationQuality quality = meter.measure(subject.clip(positions));
        EXPECT_EQ(quality.takeDistance, reach);
        return std::pair(quality, judge(quality, limits));
    };
    const double distance = judgedWith(0).first.worstPoseDistance;
    ASSERT_GT(distance, 2 * leastPoseDistance * judgedWith(0).first.size);
    const std::vector tooFar{VariationFault::PoseDistance};
    EXPECT_EQ(judgedWith(0).second, tooFar);
    EXPECT_EQ(judgedWith(0.95 * distance).second, tooFar);
    EXPECT_TRUE(judgedWith(1.05 * distance).second.empty());
    // A limit of one's own counts alone, in sizes of the figure.
    const double size = judgedWith(0).first.size;
    EXPECT_TRUE(judgedWith(0, {.poseDistance = 1.05 * distance / size}).second.empty());
    EXPECT_EQ(judgedWith(1, {.poseDistance = 0.95 * distance / size}).second, tooFar);
}

TEST(VariationQuality, OfBlendsTakesWhatStandsInBoth)
{
    std::vector<Vec3f> other = standing();
    const std::array<MeshSequence, 2> takes{takeOf(standing()), takeOf(other)};
    const CharacterFrames character(takes);
    const std::vector<AlignedTake> training{{.name = "take", .warp = {}, .poses = other, .placements = {}}};
    const VariationMeter meter(character, std::array{0, 1}, training, UpAxis::Z);
    Clip clip{.topology = takes[0].topology, .fps = 25, .positions = other, .origins = {}};
    // The second take is a frame ahead: both stand in frames 2 and 3.
    for (int f = 0; f < frameCount; ++f)
        clip.origins.push_back({f, frameCount + std::min(f + 1, frameCount - 1), 0.5, false});
    const VariationQuality quality = meter.measure(clip);
    for (std::size_t f = 0; f < 9; ++f)
        EXPECT_EQ(quality.frames[f].skate.has_value(), f == 2) << f;
}

TEST(VariationQuality, NamesWhatIsWrong)
{
    EXPECT_EQ(toString(VariationFault::PoseDistance), "pose-distance");
    EXPECT_EQ(toString(VariationFault::FootSkate), "foot-skate");
    EXPECT_EQ(toString(VariationFault::Intersections), "intersections");
    EXPECT_EQ(toString(VariationFault::Volume), "volume");
}

TEST(VariationQuality, StopsWhenCancelled)
{
    const Subject subject;
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { (void)subject.meter.measure(subject.clip(subject.poses), Progress(token)); }),
              ErrorCode::Cancelled);
    EXPECT_EQ(codeOf([&] {
                  VariationMeter(subject.character, subject.varied, subject.training, UpAxis::Z, {}, {},
                                 Progress(token));
              }),
              ErrorCode::Cancelled);
}
