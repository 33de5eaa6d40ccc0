// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "sampletest.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <tbb/global_control.h>

namespace quadrille {
namespace {

double minimalQuality(const Topology& topology, Positions p)
{
    double worst = 1;
    for (const Triangle& t : topology.triangles()) {
        const Vec3d a = p[t[0].value].cast<double>();
        const Vec3d b = p[t[1].value].cast<double>();
        const Vec3d c = p[t[2].value].cast<double>();
        const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        worst = std::min(worst, 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / edges);
    }
    return worst;
}

TEST(SampleTakes, thereAreSeveralOfEachKind)
{
    std::map<std::string, int> kinds;
    std::set<std::string> names;
    for (const SampleTake& take : smallSample().takes) {
        ++kinds[take.kind];
        names.insert(take.sequence.name);
        EXPECT_GE(take.sequence.frameCount(), 30) << take.sequence.name;
        EXPECT_LE(take.sequence.frameCount(), 90) << take.sequence.name;
        EXPECT_DOUBLE_EQ(take.sequence.fps, 25.0);
        EXPECT_EQ(static_cast<std::int64_t>(take.poses.size()), take.sequence.frameCount());
    }
    EXPECT_EQ(names.size(), smallSample().takes.size());
    EXPECT_EQ(kinds.size(), 13U);
    for (const auto& [kind, count] : kinds)
        EXPECT_GE(count, 2) << kind;
}

TEST(SampleTakes, noTriangleDegeneratesAndVolumeIsKept)
{
    const Topology& topology = *smallSample().body.topology;
    const double rest = signedVolume(topology, smallSample().body.rest);
    for (const SampleTake& take : smallSample().takes)
        for (std::int64_t f = 0; f < take.sequence.frameCount(); f += 3) {
            const Frame frame = take.sequence.frame(FrameIndex(f));
            EXPECT_GT(minimalQuality(topology, frame.positions()), 0.01)
                << take.sequence.name << " frame " << f;
            // Deep bends press the surface together; arms overhead swell the shoulders (dual quaternions).
            EXPECT_NEAR(signedVolume(topology, frame.positions()) / rest, 1.0, 0.10)
                << take.sequence.name << " frame " << f;
        }
}

TEST(SampleTakes, labelsAndContactsLieInTheTake)
{
    for (const SampleTake& take : smallSample().takes) {
        const FrameRange all = FrameRange::all(take.sequence.frameCount());
        ASSERT_FALSE(take.sequence.labels.empty());
        for (const LabelSpan& span : take.sequence.labels)
            EXPECT_TRUE(all.contains(span.frames.first) && all.contains(span.frames.last));
        std::set<std::string> feet;
        for (const ContactSpan& span : take.sequence.contacts) {
            EXPECT_TRUE(all.contains(span.frames.first) && all.contains(span.frames.last));
            EXPECT_GE(span.frames.count(), 2);
            feet.insert(span.foot);
        }
        EXPECT_EQ(feet, (std::set<std::string>{"left", "right"})) << take.sequence.name;
    }
}

TEST(SampleTakes, standingFeetDoNotSlide)
{
    // The lowest tenth of the shoe's vertices; its way along the ground while the foot stands. A sole that
    // rolls from heel to toe bends the skin by a few millimetres, so not zero.
    const SampleCharacter& character = smallSample();
    for (const SampleTake& take : character.takes) {
        double way = 0;
        double seconds = 0;
        for (const ContactSpan& span : take.sequence.contacts) {
            const std::size_t foot = character.skeleton.index(span.foot + "Foot");
            for (std::int64_t f = span.frames.first.value; f < span.frames.last.value; ++f) {
                const Frame now = take.sequence.frame(FrameIndex(f));
                const Frame next = take.sequence.frame(FrameIndex(f + 1));
                std::vector<std::size_t> sole;
                for (std::size_t v = 0; v < character.weights.size(); ++v)
                    if (character.weights[v].joints[0] == foot || character.weights[v].joints[0] == foot + 1)
                        sole.push_back(v);
                std::sort(sole.begin(), sole.end(), [&](std::size_t a, std::size_t b) {
                    return now.positions()[a].y() < now.positions()[b].y();
                });
                sole.resize(sole.size() / 10);
                double step = 0;
                for (const std::size_t v : sole) {
                    const Vec3f d = next.positions()[v] - now.positions()[v];
                    step += static_cast<double>(std::hypot(d.x(), d.z())) / static_cast<double>(sole.size());
                }
                way += step;
                seconds += 1.0 / take.sequence.fps;
            }
        }
        EXPECT_LT(way / seconds, 0.10) << take.sequence.name << ": metres per second";
    }
}

TEST(SampleTakes, nothingSinksIntoTheGround)
{
    for (const SampleTake& take : smallSample().takes)
        for (std::int64_t f = 0; f < take.sequence.frameCount(); f += 2) {
            const Frame frame = take.sequence.frame(FrameIndex(f));
            float low = 1;
            for (const Vec3f& p : frame.positions())
                low = std::min(low, p.y());
            EXPECT_GT(low, -0.03F) << take.sequence.name << " frame " << f;
        }
}

TEST(SampleTakes, jumpsFlyOnParabolas)
{
    const SampleCharacter& character = smallSample();
    int jumps = 0;
    for (const SampleTake& take : character.takes) {
        if (take.flight.count() == 0)
            continue;
        ++jumps;
        std::vector<Vec3d> mass;
        for (std::int64_t f = take.flight.first.value; f <= take.flight.last.value; ++f)
            mass.push_back(
                centreOfMass(character.skeleton,
                             worldJoints(character.skeleton, take.poses[static_cast<std::size_t>(f)])));
        ASSERT_GE(mass.size(), 5U) << take.sequence.name;
        // Second differences over the whole flight; the upper body's small wandering is on top.
        const std::size_t half = (mass.size() - 1) / 2;
        const double time = static_cast<double>(half) / take.sequence.fps;
        const Vec3d acceleration = (mass[2 * half] - 2 * mass[half] + mass[0]) / (time * time);
        EXPECT_NEAR(acceleration.y(), -9.81, 0.4) << take.sequence.name;
        EXPECT_NEAR(acceleration.z(), 0.0, 0.4) << take.sequence.name;
        for (const ContactSpan& span : take.sequence.contacts)
            EXPECT_TRUE(span.frames.last < take.flight.first || take.flight.last < span.frames.first)
                << take.sequence.name;
    }
    EXPECT_EQ(jumps, 8);
}

TEST(SampleTakes, takesOfAKindDiffer)
{
    const auto& takes = smallSample().takes;
    for (std::size_t i = 0; i + 1 < takes.size(); ++i) {
        if (takes[i].kind != takes[i + 1].kind)
            continue;
        double difference = 0;
        for (const std::int64_t f : {10, 15, 20, 25}) {
            const Frame a = takes[i].sequence.frame(FrameIndex(f));
            const Frame b = takes[i + 1].sequence.frame(FrameIndex(f));
            for (std::size_t v = 0; v < a.positions().size(); v += 10)
                difference =
                    std::max(difference, static_cast<double>((a.positions()[v] - b.positions()[v]).norm()));
        }
        EXPECT_GT(difference, 0.03) << takes[i + 1].sequence.name;
    }
}

TEST(SampleTakes, surfaceMovesBeyondTheSkeleton)
{
    // Soft tissue, breath and cloth: the skinned rest pose alone does not give the frames.
    const SampleCharacter& character = smallSample();
    std::vector<Vec3d> rest;
    for (const Vec3f& p : character.body.rest)
        rest.push_back(p.cast<double>());
    const auto it = std::find_if(character.takes.begin(), character.takes.end(),
                                 [](const SampleTake& take) { return take.kind == "jog"; });
    std::vector<Vec3d> rigid;
    skin(rest, character.weights, character.skeleton, worldJoints(character.skeleton, it->poses[12]), rigid);
    const Frame frame = it->sequence.frame(FrameIndex(12));
    double most = 0;
    for (std::size_t v = 0; v < rest.size(); ++v)
        most = std::max(most, (frame.positions()[v].cast<double>() - rigid[v]).norm());
    EXPECT_GT(most, 0.004);
    EXPECT_LT(most, 0.04);
}

TEST(SampleTakes, areTheSameOnEveryRunAndNumberOfThreads)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const SampleCharacter again = makeSampleCharacter({.textureSize = 128});
    const SampleCharacter& first = smallSample();
    EXPECT_EQ(*again.body.texture, *first.body.texture);
    EXPECT_EQ(again.body.topology->data(), first.body.topology->data());
    EXPECT_EQ(again.target.rest, first.target.rest);
    ASSERT_EQ(again.takes.size(), first.takes.size());
    for (std::size_t t = 0; t < first.takes.size(); ++t)
        EXPECT_EQ(loadFrames(again.takes[t].sequence), loadFrames(first.takes[t].sequence))
            << first.takes[t].sequence.name;
}

TEST(SampleTakes, anotherSeedGivesOtherTakesOnTheSameBody)
{
    const SampleCharacter other = makeSampleCharacter({.seed = 2, .textureSize = 128, .takesPerKind = 1});
    EXPECT_EQ(other.body.rest, smallSample().body.rest);
    EXPECT_NE(loadFrames(other.takes[0].sequence), loadFrames(smallSample().takes[0].sequence));
}

} // namespace
} // namespace quadrille
