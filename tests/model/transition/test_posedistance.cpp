// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "tests/model/transition/plainposedistance.h"
#include "tests/model/transition/posedistancetest.h"
#include "tests/model/transition/swayingtube.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Checks every distance of a sequence against the plain references, single pairs too.
void expectPlainDistances(const MeshSequence& sequence, double relative)
{
    const CharacterFrames frames = characterOf(sequence);
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const PoseDistanceSettings settings{.metric = metric};
        const Table<float> distances = poseDistances(frames, settings).distances;
        for (NodeIndex i = 0; i < frames.frameCount(); ++i) {
            EXPECT_EQ(distances(i, i), 0);
            for (NodeIndex j = 0; j < i; ++j) {
                const Frame a = frames.frame(i);
                const Frame b = frames.frame(j);
                const double expected =
                    metric == PoseMetric::Surface
                        ? plainSurfaceDistance(a.positions(), b.positions(), frames.triangles(), 0.01)
                        : plainEuclideanDistance(a.positions(), b.positions());
                EXPECT_NEAR(distances(i, j), expected, relative * expected) << i << ", " << j;
                EXPECT_EQ(distances(i, j), distances(j, i));
                const double single = metric == PoseMetric::Surface
                                          ? surfaceDistance(a.positions(), b.positions(), frames.triangles())
                                          : euclideanDistance(a.positions(), b.positions());
                EXPECT_NEAR(single, expected, 1e-9 * expected);
            }
        }
    }
}

} // namespace

TEST(PoseDistance, AgreesWithThePlainReferenceFarAndNear)
{
    const auto topology = tubeTopology(12, 40);
    expectPlainDistances(swayingTube(topology, 12, 14, 0.4), 1e-5);
    // Neighbouring frames: a few thousandths of a radian apart.
    expectPlainDistances(swayingTube(topology, 12, 6, 0.002), 1e-5);
}

TEST(PoseDistance, AgreesForTrianglesThatTurnAllTheWay)
{
    // Triangles without a common vertex, each turned and strained at random: angles up to π, areas times 50.
    std::mt19937 engine(8);
    std::normal_distribution<double> normal;
    std::vector<std::array<int, 3>> faces;
    for (int t = 0; t < 500; ++t)
        faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    std::vector<Pose> poses(5);
    for (Pose& pose : poses) {
        for (int v = 0; v < 1500; ++v)
            pose.emplace_back(Vec3d(normal(engine), normal(engine), normal(engine)).cast<float>());
    }
    expectPlainDistances(sequenceOf(topologyOf(1500, faces), poses), 1e-5);
}

TEST(PoseDistance, AgreesForTrianglesThatNearlyVanish)
{
    // Needles of all directions that just count become wide, and the other way round.
    const std::vector<std::array<int, 3>> faces{{0, 1, 2}, {3, 1, 0}, {2, 4, 0}, {0, 5, 1}, {6, 2, 0}};
    const Pose thin{{0, 0, 0},           {1, 0, 0},      {0, 1, 0},        {0.5F, 1e-11F, 0},
                    {0, 1e-11F, 1e-11F}, {1, 1e-11F, 0}, {1e-11F, 0.3F, 0}};
    const Pose wide{{0, 0, 0},     {1, 0.1F, 0},  {0, 1, 0.2F},       {0.5F, -1, 0.1F},
                    {-1, 0, 0.5F}, {1, -0.5F, 0}, {-0.7F, 0.3F, 0.4F}};
    const auto topology = topologyOf(7, faces);
    const auto& triangles = topology->triangles();
    const double expected = plainSurfaceDistance(thin, wide, triangles, 0.01);
    EXPECT_NEAR(surfaceDistance(thin, wide, triangles), expected, 1e-6 * expected);
    for (const auto& poses : {std::vector<Pose>{thin, wide}, std::vector<Pose>{wide, thin}}) {
        const PoseDistances result = poseDistances(characterOf(sequenceOf(topology, poses)));
        EXPECT_EQ(result.trianglesLeftOut, 0);
        EXPECT_NEAR(result.distances(0, 1), expected, 1e-5 * expected);
    }
}

TEST(PoseDistance, AgreesForEachAmountOfStretch)
{
    // Some slices of triangles hold what is stretched to more than three times its breadth, others do not.
    std::vector<std::array<int, 3>> faces;
    Pose rest;
    Pose stretched;
    for (int t = 0; t < 2048; ++t) {
        faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        const float stretch = std::exp(static_cast<float>(t) / 1000); // to 7.7
        rest.insert(rest.end(), {{0, 0, 0}, {1, 0, 0}, {0.3F, 1, 0}});
        stretched.insert(stretched.end(), {{0, 0, 0}, {stretch, 0, 0}, {0.3F * stretch, 1, 0}});
    }
    const auto topology = topologyOf(static_cast<int>(rest.size()), faces);
    for (const double weight : {0.01, 1.0, 100.0}) {
        const double expected = plainSurfaceDistance(rest, stretched, topology->triangles(), weight);
        const PoseDistances result =
            poseDistances(characterOf(sequenceOf(topology, {rest, stretched})), {.stretchWeight = weight});
        EXPECT_NEAR(result.distances(0, 1), expected, 5e-7 * expected) << weight;
    }
}

TEST(PoseDistance, OfTrianglesHasThatOfThePosesAsItsMean)
{
    const MeshSequence tube = swayingTube(tubeTopology(12, 40), 12, 3, 0.4);
    const auto& triangles = tube.topology->triangles();
    const Frame a = tube.frame(FrameIndex(0));
    const Frame b = tube.frame(FrameIndex(2));
    for (const double weight : {0.01, 1.0}) {
        const std::vector<double> each = triangleDistances(a.positions(), b.positions(), triangles, weight);
        ASSERT_EQ(each.size(), triangles.size());
        const double mean = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
        EXPECT_GT(mean, 0.01);
        EXPECT_DOUBLE_EQ(mean, surfaceDistance(a.positions(), b.positions(), triangles, weight));
        // A rigid motion changes none of them, but for the rounding of the positions.
        const Pose turned = moved({b.positions().begin(), b.positions().end()}, someMotion());
        const std::vector<double> ofTurned = triangleDistances(a.positions(), turned, triangles, weight);
        for (std::size_t t = 0; t < each.size(); ++t)
            EXPECT_NEAR(ofTurned[t], each[t], 1e-4) << t;
    }
}

TEST(PoseDistance, OfTrianglesTellsWhichOneTurned)
{
    // Separate triangles, of which one turns about its normal by a right angle and one loses its area.
    std::vector<std::array<int, 3>> faces;
    Pose before;
    for (int t = 0; t < 40; ++t) {
        const auto x = static_cast<float>(t % 8);
        const auto y = static_cast<float>(t / 8);
        before.insert(before.end(), {{x, y, 0}, {x + 0.1F, y, 0}, {x, y + 0.1F, 0}});
        faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    Pose after = before;
    for (int corner = 0; corner < 3; ++corner) {
        const Vec3f middle = (before[57] + before[58] + before[59]) / 3;
        const Vec3f arm = before[57 + static_cast<std::size_t>(corner)] - middle;
        after[57 + static_cast<std::size_t>(corner)] = middle + Vec3f(-arm.y(), arm.x(), 0);
    }
    after[23] = after[21];
    std::vector<double> turned = triangleDistances(before, after, topologyOf(120, faces)->triangles());
    EXPECT_TRUE(std::isnan(turned[7]));
    turned[7] = 0;
    for (std::size_t t = 0; t < turned.size(); ++t)
        EXPECT_NEAR(turned[t], t == 19 ? std::numbers::pi / 2 : 0, 1e-3) << t;
}

TEST(PoseDistance, OfARigidMotionIsNothing)
{
    const Pose turned = moved(corners, someMotion());
    EXPECT_NEAR(distanceOf(tetrahedron(), corners, turned), 0, 5e-7); // rounding of the positions
    EXPECT_NEAR(distanceOf(tetrahedron(), corners, turned, {.metric = PoseMetric::Euclidean}), 0, 5e-7);
}

TEST(PoseDistance, OfEqualFramesIsExactlyNothing)
{
    const MeshSequence tube = swayingTube(tubeTopology(12, 40), 12, 1, 0.4);
    const Frame frame = tube.frame(FrameIndex(0));
    const Pose pose(frame.positions().begin(), frame.positions().end());
    EXPECT_EQ(distanceOf(tube.topology, pose, pose), 0);
    EXPECT_EQ(distanceOf(tube.topology, pose, pose, {.metric = PoseMetric::Euclidean}), 0);
}

TEST(PoseDistance, OfUniformScaleIsTheLogarithm)
{
    // No rotation; both in-plane stretches are the scale: d = w/√2 · √2·|log scale|.
    for (const double scale : {1.001, 1.2, 0.5, 20.0}) {
        const Pose larger = moved(corners, Eigen::Affine3d(Eigen::Scaling(scale)));
        for (const double weight : {0.01, 1.0}) {
            const double expected = weight * std::abs(std::log(scale));
            const double tolerance = 1e-5 * expected + 1e-7 * weight + 3e-8;
            EXPECT_NEAR(distanceOf(tetrahedron(), corners, larger, {.stretchWeight = weight}), expected,
                        tolerance);
        }
        // Without weight nothing but the angles counts.
        EXPECT_NEAR(distanceOf(tetrahedron(), corners, larger, {.stretchWeight = 0}), 0, 5e-7);
    }
}

TEST(PoseDistance, OfStretchAlongOneAxis)
{
    // A square in a plane, twice as long: σ = 2 and 1, no rotation: d = w/√2 · log 2.
    const auto square = topologyOf(4, {{0, 1, 2}, {0, 2, 3}});
    const Pose pose{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Pose longer{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    EXPECT_NEAR(distanceOf(square, pose, longer), 0.01 / std::numbers::sqrt2 * std::log(2.0), 2e-7);
}

TEST(PoseDistance, OfABentHingeIsHalfItsAngle)
{
    // Two equal wings on an axis, symmetric: bending turns one by +α and one by −α about the axis, and the
    // best alignment turns neither. Flat to 2·α between the wings: each triangle is rotated by α.
    const auto hinge = topologyOf(4, {{0, 1, 2}, {1, 0, 3}});
    for (const double alpha : {1e-3, 0.1, 0.7, 1.2}) {
        const auto c = static_cast<float>(std::cos(alpha));
        const auto s = static_cast<float>(std::sin(alpha));
        const Pose flat{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
        const Pose bent{{0, -1, 0}, {0, 1, 0}, {-c, 0, s}, {c, 0, s}};
        EXPECT_NEAR(distanceOf(hinge, flat, bent), alpha, 1e-5 * alpha + 1e-7);
        const double moves = std::hypot(1 - c, s / 2); // the centroid is s/2 higher
        EXPECT_NEAR(distanceOf(hinge, flat, bent, {.metric = PoseMetric::Euclidean}), (s / 2 + moves) / 2,
                    2e-7);
    }
}

TEST(PoseDistance, DoesNotDependOnRigidMotionOfTheInput)
{
    const auto topology = tubeTopology(12, 40);
    const MeshSequence tube = swayingTube(topology, 12, 5, 0.4);
    std::vector<Pose> turned;
    for (int f = 0; f < 5; ++f) {
        const Frame frame = tube.frame(FrameIndex(f));
        turned.push_back(moved(Pose(frame.positions().begin(), frame.positions().end()),
                               Eigen::AngleAxisd(f, Vec3d::UnitX()) * someMotion()));
    }
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const Table<float> before = poseDistances(characterOf(tube), {.metric = metric}).distances;
        const Table<float> after =
            poseDistances(characterOf(sequenceOf(topology, turned)), {.metric = metric}).distances;
        // The positions are rounded anew: 2e-7 of some metres against edges of some centimetres.
        EXPECT_LT((after - before).abs().maxCoeff(), 1e-5F * before.maxCoeff());
    }
}

TEST(PoseDistance, DoesNotDependOnTheNumberingOfVertices)
{
    const auto topology = tubeTopology(12, 40);
    const MeshSequence tube = swayingTube(topology, 12, 5, 0.4);
    std::vector<std::uint32_t> place(topology->vertexCount());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), std::mt19937(4));
    TopologyData data = topology->data();
    for (Triangle& triangle : data.triangles) {
        for (VertexIndex& v : triangle)
            v = VertexIndex(place[v.value]);
    }
    std::vector<Pose> poses;
    for (int f = 0; f < 5; ++f) {
        const Frame frame = tube.frame(FrameIndex(f));
        Pose pose(place.size());
        for (std::size_t v = 0; v < place.size(); ++v)
            pose[place[v]] = frame.positions()[v];
        poses.push_back(pose);
    }
    const MeshSequence shuffled = sequenceOf(std::make_shared<Topology>(data), poses);
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const Table<float> before = poseDistances(characterOf(tube), {.metric = metric}).distances;
        const Table<float> after = poseDistances(characterOf(shuffled), {.metric = metric}).distances;
        EXPECT_LT((after - before).abs().maxCoeff(), 1e-6F * before.maxCoeff()); // sums in another order
    }
}
