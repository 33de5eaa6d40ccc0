// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/core/npy.h"
#include "model/geometry/pointtree.h"
#include "model/geometry/symmetry.h"
#include "model/sample/sample.h"
#include "model/sequence/io/registry.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/transition/bars.h"

#include <gtest/gtest.h>
#include <random>

namespace quadrille {
namespace {

using test::errorCodeOf;

Triangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    return {VertexIndex(a), VertexIndex(b), VertexIndex(c)};
}

std::vector<std::uint32_t> indices(const Symmetry& symmetry)
{
    std::vector<std::uint32_t> found;
    for (const VertexIndex v : symmetry.opposite)
        found.push_back(v.value);
    return found;
}

const Topology& kite()
{
    static const Topology topology({.vertexCount = 4, .triangles = {triangle(0, 2, 1), triangle(0, 1, 3)}});
    return topology;
}

const SampleCharacter& sample()
{
    static const SampleCharacter character = makeSampleCharacter({.textureSize = 64});
    return character;
}

/// A bar wound up to a spiral staircase, which no plane reflects, with some triangles missing.
Bar spiral()
{
    Bar bar = makeBar(60, 2, 6, 0.3F);
    TopologyData data = bar.topology->data();
    for (const std::ptrdiff_t index : {500, 205, 204, 31})
        data.triangles.erase(data.triangles.begin() + index);
    bar.topology = std::make_shared<const Topology>(std::move(data));
    bar.positions = moved(bar.positions, [](const Vec3d& p) -> Vec3d {
        const double angle = 2 * p.x();
        return {(1 + p.y()) * std::cos(angle), (1 + p.y()) * std::sin(angle), p.z() + 0.5 * p.x()};
    });
    return bar;
}

TEST(Symmetry, OfTwoTrianglesKeepsTheirEdges)
{
    // Two maps turn the faces round: the one across the common edge and the one along it.
    const std::vector<Vec3f> upright{{0, 0, 0}, {0, 3, 0}, {1, 1, 0}, {-1, 1, 0}};
    EXPECT_EQ(indices(findSymmetry(kite(), upright)), (std::vector<std::uint32_t>{0, 1, 3, 2}));
    const std::vector<Vec3f> lying{{-1, 1, 0}, {1, 1, 0}, {0, 3, 0}, {0, 0, 0}};
    EXPECT_EQ(indices(findSymmetry(kite(), lying)), (std::vector<std::uint32_t>{1, 0, 2, 3}));
}

TEST(Symmetry, DoesNotMindHowQuadsWereCut)
{
    const Topology quads(
        {.vertexCount = 6,
         .triangles = {triangle(0, 1, 4), triangle(0, 4, 3), triangle(1, 2, 5), triangle(1, 5, 4)}});
    const std::vector<Vec3f> pose{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-0.6F, 3, 0}, {0, 3, 0}, {0.6F, 3, 0}};
    const Symmetry symmetry = findSymmetry(quads, pose);
    EXPECT_EQ(indices(symmetry), (std::vector<std::uint32_t>{2, 1, 0, 5, 4, 3}));
    EXPECT_EQ(indices(checkedSymmetry(quads, symmetry.opposite)), indices(symmetry));
}

TEST(Symmetry, OfTheSampleDoesNotDependOnThePose)
{
    const SampleCharacter& character = sample();
    const Topology& topology = *character.body.topology;
    const Symmetry atRest = findSymmetry(topology, character.body.rest);
    ASSERT_TRUE(atRest.isExact());
    for (std::size_t v = 0; v < character.body.rest.size(); ++v) {
        const Vec3f& p = character.body.rest[v];
        const Vec3f& other = character.body.rest[atRest.opposite[v].value];
        EXPECT_LT((Vec3f(-p.x(), p.y(), p.z()) - other).norm(), 1e-5F) << v;
    }
    for (const SampleTake& take : character.takes) {
        const Frame frame = take.sequence.frame(FrameIndex(take.sequence.frameCount() / 2));
        EXPECT_EQ(indices(findSymmetry(topology, frame.positions())), indices(atRest)) << take.sequence.name;
    }
    EXPECT_EQ(indices(checkedSymmetry(topology, atRest.opposite)), indices(atRest));
}

TEST(Symmetry, OfComponentsThatAreAlikeFollowsTheirPlaces)
{
    // Three bars beside each other, bent: the outer ones are each other's counterparts.
    Bar bars = makeBar(6, 2, 2, 0.3F, true, 3);
    bars.positions = moved(bars.positions,
                           [](const Vec3d& p) { return Vec3d(p.x(), p.y(), p.z() + 0.3 * p.x() * p.x()); });
    const std::size_t each = bars.positions.size() / 3;
    const Symmetry symmetry = findSymmetry(*bars.topology, bars.positions);
    ASSERT_TRUE(symmetry.isExact());
    const ReflectionPlane plane = reflectionPlane(bars.positions, counterparts(symmetry, bars.positions));
    for (std::size_t v = 0; v < bars.positions.size(); ++v) {
        const std::size_t other = symmetry.opposite[v].value;
        const Vec3d reflected = plane.reflected(bars.positions[v].cast<double>());
        EXPECT_LT((reflected - bars.positions[other].cast<double>()).norm(), 1e-5);
        EXPECT_EQ(other / each, 2 - v / each) << v;
    }
}

TEST(Symmetry, OfShapeOnlyGivesThePoseItself)
{
    Bar bar = makeBar(20, 4, 2, 0.5F);
    TopologyData data = bar.topology->data();
    // Turn one edge, so that the connectivity has no symmetry any more.
    const Triangle a = data.triangles[40];
    const Triangle b = data.triangles[41];
    ASSERT_EQ(a[0], b[0]);
    ASSERT_EQ(a[2], b[1]);
    data.triangles[40] = {a[1], b[1], b[2]};
    data.triangles[41] = {a[1], b[2], a[0]};
    data.triangles.erase(data.triangles.begin());
    const Topology topology(std::move(data));
    const std::vector<Vec3f> pose = moved(shaken(bar.positions, 0.002, 3),
                                          [](const Vec3d& p) { return Vec3d(p.x(), p.y() + p.x(), p.z()); });
    const Symmetry symmetry = findSymmetry(topology, pose);
    ASSERT_FALSE(symmetry.isExact());
    EXPECT_GT(symmetry.share, 0.99);
    const std::vector<Vec3f> places = counterparts(symmetry, pose);
    const ReflectionPlane plane = reflectionPlane(pose, places);
    for (std::size_t v = 0; v < pose.size(); ++v)
        EXPECT_LT((plane.reflected(places[v].cast<double>()) - pose[v].cast<double>()).norm(), 1e-4);
}

TEST(Symmetry, IsRefusedWhereThereIsNone)
{
    const Bar bar = spiral();
    EXPECT_EQ(errorCodeOf([&] { findSymmetry(*bar.topology, bar.positions); }), ErrorCode::NoSymmetry);
    const std::vector<Vec3f> tooFew(3, Vec3f::Zero());
    EXPECT_EQ(errorCodeOf([&] { findSymmetry(*bar.topology, tooFew); }), ErrorCode::VertexCountMismatch);
}

TEST(Symmetry, GivenIsChecked)
{
    const auto code = [](const std::vector<std::uint32_t>& map) {
        std::vector<VertexIndex> opposite;
        for (const std::uint32_t v : map)
            opposite.emplace_back(v);
        return errorCodeOf([&] { checkedSymmetry(kite(), opposite); });
    };
    EXPECT_FALSE(code({0, 1, 3, 2}));
    EXPECT_FALSE(code({1, 0, 2, 3}));
    EXPECT_EQ(code({0, 1, 3}), ErrorCode::SymmetryMapWrong);    // too few
    EXPECT_EQ(code({0, 1, 3, 4}), ErrorCode::SymmetryMapWrong); // out of range
    EXPECT_EQ(code({1, 2, 0, 3}), ErrorCode::SymmetryMapWrong); // no involution
    EXPECT_EQ(code({0, 1, 2, 3}), ErrorCode::SymmetryMapWrong); // nothing moves
    EXPECT_EQ(code({2, 1, 0, 3}), ErrorCode::SymmetryMapWrong); // faces are torn
    EXPECT_EQ(code({1, 0, 3, 2}), ErrorCode::SymmetryMapWrong); // faces keep their orientation
}

TEST(Symmetry, IsReadFromTextAndArrays)
{
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "symmetry";
    const auto reading = [&](const std::string& name, const std::string& content) {
        writeAtomically(folder / name, content);
        return indices(readSymmetry(kite(), folder / name));
    };
    const std::vector<std::uint32_t> expected{0, 1, 3, 2};
    EXPECT_EQ(reading("lines.txt", "# left and right\n0\n1\n3\n2\n"), expected);
    EXPECT_EQ(reading("row.csv", "0, 1, 3, 2\r\n"), expected);
    EXPECT_EQ(reading("pairs.csv", "2;3\n"), expected);
    EXPECT_EQ(reading("pairs.txt", "3 2\n0 0 # middle"), expected);
    const std::vector<std::int64_t> one{4};
    const std::vector<std::int64_t> rows{1, 2};
    const auto bytes = [](const auto& values) {
        return std::string(reinterpret_cast<const char*>(values.data()), sizeof values);
    };
    EXPECT_EQ(reading("a.npy", npyHeader("'<i8'", one) + bytes(std::array<std::int64_t, 4>{0, 1, 3, 2})),
              expected);
    EXPECT_EQ(reading("b.npy", npyHeader("'<u2'", rows) + bytes(std::array<std::uint16_t, 2>{3, 2})),
              expected);
    const auto code = [&](const std::string& name, const std::string& content) {
        return errorCodeOf([&] { reading(name, content); });
    };
    EXPECT_EQ(code("word.txt", "0\nleft\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(code("real.txt", "0 1 3 2.5"), ErrorCode::FileSyntax);
    EXPECT_EQ(code("minus.txt", "0 1 -3 2"), ErrorCode::SymmetryMapWrong);
    EXPECT_EQ(code("few.txt", "0 1 3"), ErrorCode::SymmetryMapWrong);
    EXPECT_EQ(code("far.txt", "0 1 3 99999999999"), ErrorCode::SymmetryMapWrong);
    EXPECT_EQ(code("float.npy", npyHeader("'<f4'", one) + bytes(std::array<float, 4>{0, 1, 3, 2})),
              ErrorCode::FileSyntax);
    EXPECT_EQ(code("short.npy", npyHeader("'<i8'", one) + bytes(std::array<std::int64_t, 3>{0, 1, 3})),
              ErrorCode::FileTruncated);
    EXPECT_EQ(errorCodeOf([&] { readSymmetry(kite(), folder / "none.txt"); }), ErrorCode::FileNotFound);
}

TEST(Symmetry, SearchStopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    const Bar bar = spiral();
    EXPECT_EQ(errorCodeOf([&] { findSymmetry(*bar.topology, bar.positions, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(Symmetry, OfRealMeshes)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << folder << " is not there";
    const auto find = [&](const std::string& mesh) {
        const ImportResult result = openSequences(folder / mesh);
        const MeshSequence& sequence = result.sequences.front();
        return findSymmetry(*sequence.topology, sequence.frame(FrameIndex(0)).positions());
    };
    EXPECT_TRUE(find("mh_male/rest_m_avg.obj").isExact());
    for (const char* mesh : {"rb_m04/mesh.obj", "rb_f01/mesh.obj"}) {
        const Symmetry symmetry = find(mesh);
        EXPECT_FALSE(symmetry.isExact()) << mesh;
        EXPECT_GT(symmetry.share, 0.97) << mesh;
    }
    EXPECT_EQ(errorCodeOf([&] { find("liam/mesh.obj"); }), ErrorCode::NoSymmetry);
}

TEST(PointTree, FindsTheNearestPoint)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> real(-1, 1);
    std::vector<Vec3f> points;
    for (int i = 0; i < 500; ++i)
        points.emplace_back(real(random), real(random), 0.1F * real(random));
    const PointTree tree(points);
    for (int i = 0; i < 200; ++i) {
        const Vec3f p(real(random), real(random), real(random));
        float least = std::numeric_limits<float>::max();
        for (const Vec3f& other : points)
            least = std::min(least, (other - p).squaredNorm());
        EXPECT_EQ((points[tree.nearest(p)] - p).squaredNorm(), least);
    }
}

} // namespace
} // namespace quadrille
