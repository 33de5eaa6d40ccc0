// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sample/sample.h"
#include "model/sequence/contacts.h"
#include "model/sequence/feet.h"
#include "tests/model/sequence/realtakes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>

namespace quadrille {
namespace {

const SampleCharacter& sample()
{
    static const SampleCharacter character = makeSampleCharacter({.textureSize = 64});
    return character;
}

const MeshSequence& takeNamed(const std::string& name)
{
    for (const SampleTake& take : sample().takes)
        if (take.sequence.name == name)
            return take.sequence;
    throw std::out_of_range(name);
}

std::vector<bool> framesOf(const std::vector<ContactSpan>& spans, const std::string& foot, std::int64_t count)
{
    std::vector<bool> stands(static_cast<std::size_t>(count));
    for (const ContactSpan& span : spans)
        if (span.foot == foot)
            for (std::int64_t f = span.frames.first.value; f <= span.frames.last.value; ++f)
                stands.at(static_cast<std::size_t>(f)) = true;
    return stands;
}

/// The sequence with every position changed.
MeshSequence moved(const MeshSequence& sequence, const Eigen::Affine3f& map)
{
    std::vector<Vec3f> positions = loadFrames(sequence);
    for (Vec3f& p : positions)
        p = map * p;
    MeshSequence result = sequence;
    result.source = std::make_shared<MemoryFrames>(std::move(positions), sequence.topology->vertexCount());
    return result;
}

/// Two flat feet with a shin each, facing +z; the left one (at +x) is lifted in frames 10 … 19.
MeshSequence stepping()
{
    TopologyData data;
    std::vector<Vec3f> rest;
    for (const float side : {-0.2F, 0.2F}) {
        const auto first = static_cast<std::uint32_t>(rest.size());
        for (const float z : {0.0F, 0.1F, 0.2F}) {
            rest.emplace_back(side - 0.05F, 0.0F, z);
            rest.emplace_back(side + 0.05F, 0.0F, z);
        }
        rest.emplace_back(side, 0.16F, 0.0F);
        rest.emplace_back(side, 1.7F, 0.0F);
        const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            data.triangles.push_back(
                {VertexIndex(first + a), VertexIndex(first + b), VertexIndex(first + c)});
        };
        triangle(0, 1, 2);
        triangle(2, 1, 3);
        triangle(2, 3, 4);
        triangle(4, 3, 5);
        triangle(0, 6, 1);
        triangle(0, 7, 6);
    }
    data.vertexCount = static_cast<std::uint32_t>(rest.size());
    std::vector<Vec3f> positions;
    for (int f = 0; f < 30; ++f) {
        for (std::size_t v = 0; v < rest.size(); ++v) {
            const bool lifted = f >= 10 && f < 20 && v >= rest.size() / 2;
            positions.push_back(rest[v] + Vec3f(0, lifted ? 0.2F : 0.0F, 0));
        }
    }
    return makeSequence(
        "step", std::make_shared<const Topology>(std::move(data)),
        std::make_shared<MemoryFrames>(std::move(positions), static_cast<std::uint32_t>(rest.size())), 25);
}

TEST(Contacts, ofAFootThatIsLiftedEndAndBeginWithIt)
{
    const std::vector<ContactSpan> expected = {{"right", {FrameIndex(0), FrameIndex(29)}},
                                               {"left", {FrameIndex(0), FrameIndex(9)}},
                                               {"left", {FrameIndex(20), FrameIndex(29)}}};
    EXPECT_THAT(detectContacts(stepping()), ::testing::UnorderedElementsAreArray(expected));
}

TEST(Contacts, areFoundWhereTheFigureIsTallestOnOneLeg)
{
    // While the left foot is kicked higher than the other knee, the head is a little higher.
    const MeshSequence steps = stepping();
    std::vector<Vec3f> positions = loadFrames(steps);
    const std::size_t count = steps.topology->vertexCount();
    for (std::size_t f = 10; f < 20; ++f) {
        const std::span<Vec3f> pose = std::span(positions).subspan(f * count, count);
        for (std::size_t v = count / 2; v + 1 < count; ++v)
            pose[v].y() += 0.3F;
        for (const std::size_t top : {count / 2 - 1, count - 1})
            pose[top].y() = 1.73F;
    }
    MeshSequence kick = steps;
    kick.source = std::make_shared<MemoryFrames>(std::move(positions), steps.topology->vertexCount());
    const std::vector<ContactSpan> found = detectContacts(kick);
    EXPECT_EQ(framesOf(found, "right", 30), std::vector(30, true));
    std::vector<bool> left(30, true);
    std::fill(left.begin() + 10, left.begin() + 20, false);
    EXPECT_EQ(framesOf(found, "left", 30), left);
}

TEST(Contacts, followGroundThatDrifts)
{
    const MeshSequence steps = stepping();
    const std::uint32_t vertices = steps.topology->vertexCount();
    std::vector<Vec3f> positions;
    for (int f = 0; f < 70; ++f) {
        const float drift = 0.1F * std::clamp(static_cast<float>(f - 20) / 30, 0.0F, 1.0F);
        for (const Vec3f& position : steps.frame(FrameIndex(std::clamp(f - 20, 0, 29))).positions())
            positions.push_back(position + Vec3f(0, drift, 0));
    }
    const MeshSequence drifting = makeSequence(
        "drift", steps.topology, std::make_shared<MemoryFrames>(std::move(positions), vertices), steps.fps);
    const std::vector<ContactSpan> expected = {{"right", {FrameIndex(0), FrameIndex(69)}},
                                               {"left", {FrameIndex(0), FrameIndex(29)}},
                                               {"left", {FrameIndex(40), FrameIndex(69)}}};
    EXPECT_THAT(detectContacts(drifting), ::testing::UnorderedElementsAreArray(expected));
}

TEST(Contacts, agreeWithTheGroundTruthOfTheSample)
{
    double hits = 0;
    double found = 0;
    double there = 0;
    for (const SampleTake& take : sample().takes) {
        const std::int64_t count = take.sequence.frameCount();
        const auto spans = detectContacts(take.sequence);
        double takeHits = 0;
        double takeFound = 0;
        double takeThere = 0;
        for (const char* foot : {"left", "right"}) {
            const auto truth = framesOf(take.sequence.contacts, foot, count);
            const auto guess = framesOf(spans, foot, count);
            for (std::size_t f = 0; f < truth.size(); ++f) {
                takeHits += truth[f] && guess[f];
                takeFound += guess[f];
                takeThere += truth[f];
            }
        }
        // Feet land and leave between frames: one frame more or less at each end of a contact, and contacts
        // of a jog last only eight frames.
        EXPECT_GT(takeHits / takeFound, 0.80) << take.sequence.name << ": precision";
        EXPECT_GT(takeHits / takeThere, 0.85) << take.sequence.name << ": recall";
        hits += takeHits;
        found += takeFound;
        there += takeThere;
    }
    EXPECT_GT(hits / found, 0.95);
    EXPECT_GT(hits / there, 0.96);
    RecordProperty("precision", std::to_string(hits / found));
    RecordProperty("recall", std::to_string(hits / there));
}

TEST(Contacts, doNotDependOnPlaceHeadingOrGroundLevel)
{
    const MeshSequence& walk = takeNamed("walk 1");
    Eigen::Affine3f map = Eigen::Affine3f::Identity();
    map.translate(Vec3f(3, 0.5F, -7)).rotate(Eigen::AngleAxisf(2.1F, Vec3f::UnitY()));
    EXPECT_EQ(detectContacts(moved(walk, map)), detectContacts(walk));
}

TEST(Contacts, followTheUpAxis)
{
    const MeshSequence& walk = takeNamed("walk 1");
    const Eigen::Matrix3f turn = conversionMatrix({.up = UpAxis::Y}, {.up = UpAxis::Z});
    EXPECT_EQ(detectContacts(transformed(walk, turn), {.up = UpAxis::Z}), detectContacts(walk));
}

TEST(Contacts, doNotDependOnTheUnit)
{
    const MeshSequence& walk = takeNamed("walk 1");
    EXPECT_EQ(detectContacts(moved(walk, Eigen::Affine3f(Eigen::Scaling(1024.0F)))), detectContacts(walk));
}

TEST(Contacts, mirroringSwapsLeftAndRight)
{
    const MeshSequence& kick = takeNamed("kick 1");
    Eigen::Affine3f mirror = Eigen::Affine3f::Identity();
    mirror.scale(Vec3f(-1, 1, 1));
    const auto spans = detectContacts(kick);
    const auto mirrored = detectContacts(moved(kick, mirror));
    const std::int64_t count = kick.frameCount();
    EXPECT_EQ(framesOf(spans, "left", count), framesOf(mirrored, "right", count));
    EXPECT_EQ(framesOf(spans, "right", count), framesOf(mirrored, "left", count));
}

/// Each step swings the other foot up behind, so that it lies behind its ankle, and both together do.
TEST(Contacts, callTheFeetOfARunnerByWhereHeGoes)
{
    const MeshSequence steps = stepping();
    const std::uint32_t vertices = steps.topology->vertexCount();
    const std::vector<Vec3f> standing = loadFrames(steps);
    std::vector<Vec3f> positions(standing.begin(), standing.begin() + vertices);
    for (int f = 0; f < 40; ++f) {
        for (std::uint32_t v = 0; v < vertices; ++v) {
            Vec3f p = standing[v];
            const bool swings = (v >= vertices / 2) == (f / 10 % 2 == 0) && p.y() < 1;
            if (swings) // turned by a quarter, toes down, the sole behind
                p = Vec3f(p.x(), 0.5F - p.z(), -0.4F + p.y());
            positions.push_back(p + Vec3f(0, 0, 0.15F * static_cast<float>(f)));
        }
    }
    const auto nameOfTheOneAt = [&](float side, double fps) {
        const MeshSequence run =
            makeSequence("run", steps.topology, std::make_shared<MemoryFrames>(positions, vertices), fps);
        const Figure figure =
            findFigure(*run.topology, loadUpright(run, UpAxis::Y, {}), ContactOptions().footShare);
        for (const Foot& foot : figure.feet)
            if (side * standing[foot.vertices.front()].x() > 0)
                return foot.name;
        return std::string("none");
    };
    EXPECT_EQ(nameOfTheOneAt(1, 25), "left");
    EXPECT_EQ(nameOfTheOneAt(-1, 25), "right");
    // As slow as somebody may go backwards, the feet decide.
    EXPECT_EQ(nameOfTheOneAt(1, 5), "right");
}

TEST(Contacts, nameTheFeetOfACharacterAlikeInAllItsTakes)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_f01";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no real takes";
    std::map<std::string, std::vector<std::uint32_t>> first;
    for (const char* name : {"walk_1", "run_1", "jump_long", "reach_high"}) {
        const MeshSequence take =
            openSequences(folder / (std::string(name) + ".pc2"), {.mesh = folder / "mesh.obj", .fps = 30})
                .sequences.front();
        const Figure figure =
            findFigure(*take.topology, loadUpright(take, UpAxis::Y, {}), ContactOptions().footShare);
        ASSERT_EQ(figure.feet.size(), 2U);
        for (const Foot& foot : figure.feet) {
            const auto [known, isNew] = first.try_emplace(foot.name, foot.vertices);
            std::vector<std::uint32_t> shared;
            std::ranges::set_intersection(known->second, foot.vertices, std::back_inserter(shared));
            EXPECT_FALSE(shared.empty()) << name << ": " << foot.name;
        }
    }
}

TEST(Contacts, thereAreNoneInASingleFrame)
{
    const MeshSequence frame = takeNamed("walk 1").cutTo({FrameIndex(0), FrameIndex(0)});
    EXPECT_TRUE(detectContacts(frame).empty());
}

TEST(Contacts, aFigureThatFliesOrHasNoLegsHasNone)
{
    // Rising at two metres a second all the time.
    const MeshSequence& stand = takeNamed("idle 1");
    std::vector<Vec3f> positions = loadFrames(stand);
    const std::size_t vertices = stand.topology->vertexCount();
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i].y() += 0.08F * static_cast<float>(i / vertices);
    MeshSequence rising = stand;
    rising.source = std::make_shared<MemoryFrames>(std::move(positions), stand.topology->vertexCount());
    EXPECT_TRUE(detectContacts(rising).empty());

    TopologyData data;
    data.vertexCount = 4;
    data.triangles = {{VertexIndex(0), VertexIndex(2), VertexIndex(1)},
                      {VertexIndex(0), VertexIndex(1), VertexIndex(3)},
                      {VertexIndex(1), VertexIndex(2), VertexIndex(3)},
                      {VertexIndex(2), VertexIndex(0), VertexIndex(3)}};
    const std::vector<Vec3f> corners = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    std::vector<Vec3f> two = corners;
    two.insert(two.end(), corners.begin(), corners.end());
    const MeshSequence pyramid = makeSequence("pyramid", std::make_shared<const Topology>(data),
                                              std::make_shared<MemoryFrames>(two, 4), 25);
    EXPECT_TRUE(detectContacts(pyramid).empty());
}

TEST(Contacts, refuseLimitsThatMakeNoSense)
{
    const MeshSequence& walk = takeNamed("walk 1");
    for (const ContactOptions& options :
         {ContactOptions{.landHeight = 0}, ContactOptions{.leaveHeight = 0.001},
          ContactOptions{.landSpeed = -1}, ContactOptions{.footShare = 0.9}}) {
        try {
            detectContacts(walk, options);
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        }
    }
}

TEST(Contacts, canBeCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_THROW(detectContacts(takeNamed("walk 1"), {}, Progress(token)), Error);
}

TEST(Contacts, ofRealWalksAlternateBetweenTheFeet)
{
    if (!test::realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    for (const char* take : {"walk_1", "walk_slow", "walk_fast"}) {
        const MeshSequence sequence = *test::realTake(take);
        const auto spans = detectContacts(sequence);
        ASSERT_GE(spans.size(), 3U) << take;
        for (std::size_t i = 1; i < spans.size(); ++i)
            EXPECT_NE(spans[i].foot, spans[i - 1].foot) << take << ", contact " << i;
        // Somebody who walks always stands on one foot at least; landing and leaving are soft in captures.
        const std::int64_t count = sequence.frameCount();
        const auto left = framesOf(spans, "left", count);
        const auto right = framesOf(spans, "right", count);
        int standing = 0;
        for (std::size_t f = 0; f < left.size(); ++f)
            standing += left[f] || right[f];
        EXPECT_GT(standing, count * 8 / 10) << take;
    }
}

} // namespace
} // namespace quadrille
