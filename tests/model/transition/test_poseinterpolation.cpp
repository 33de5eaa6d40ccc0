// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/poseinterpolation.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/transition/bars.h"
#include "tests/model/transition/plaininterpolation.h"

#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array methods{InterpolationMethod::Poisson, InterpolationMethod::Slerp,
                             InterpolationMethod::Linear};
constexpr float barLength = 2.0F;

using Pose = std::vector<Vec3f>;

Bar simpleBar()
{
    return makeBar(21, 3, barLength, 0.3F);
}

PoseInterpolation between(const std::shared_ptr<const Topology>& topology, const Pose& source,
                          const Pose& target)
{
    const auto system = std::make_shared<const PoissonSystem>(topology);
    return {std::make_shared<const PreparedPose>(system, source),
            std::make_shared<const PreparedPose>(system, target)};
}

Pose at(const PoseInterpolation& interpolation, double lambda, std::size_t vertexCount,
        InterpolationMethod method = InterpolationMethod::Poisson)
{
    Pose out(vertexCount);
    interpolation.at(lambda, out, method);
    return out;
}

using quadrille::largestDistance;

double largestDistance(const Pose& a, const Pose& b)
{
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        largest = std::max(largest, (a[v] - b[v]).cast<double>().norm());
    return largest;
}

Vec3d meanOf(Positions positions)
{
    return centroid(positions);
}

Pose movedBy(const Pose& pose, const RigidMotion& motion)
{
    return moved(pose, [&](const Vec3d& p) { return motion(p); });
}

/// Largest relative difference of an edge's length from the mean of its lengths in two other poses.
double largestLengthError(const Topology& topology, const Pose& pose, const Pose& a, const Pose& b)
{
    double largest = 0;
    for (const Triangle& triangle : topology.triangles()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = triangle[c].value;
            const std::uint32_t w = triangle[(c + 1) % 3].value;
            const float wanted = 0.5F * ((a[v] - a[w]).norm() + (b[v] - b[w]).norm());
            largest =
                std::max(largest, std::abs(static_cast<double>((pose[v] - pose[w]).norm() / wanted) - 1));
        }
    }
    return largest;
}

const RigidMotion someMotion{Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Vec3d(1, 2, -0.5).normalized())),
                             Vec3d(3, -1, 0.4)};
const RigidMotion otherMotion{Eigen::Quaterniond(Eigen::AngleAxisd(2.2, Vec3d(-1, 0.3, 2).normalized())),
                              Vec3d(-2, 0.1, 5)};

TEST(PoseInterpolation, EndsExactlyInTheGivenPoses)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = movedBy(bent(bar.positions, barLength, 1.5), someMotion);
    const PoseInterpolation poses = between(bar.topology, source, target);
    for (const InterpolationMethod method : methods) {
        EXPECT_EQ(at(poses, 0, source.size(), method), source);
        EXPECT_EQ(at(poses, 1, source.size(), method), target);
    }
}

// The Poisson system reproduces gradients that belong to a surface; single precision of the result.
TEST(PoseInterpolation, OneSidedDeformationReachesTheOtherPose)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = movedBy(shaken(bent(bar.positions, barLength, 2.0), 0.02, 2), someMotion);
    const PoseInterpolation poses = between(bar.topology, source, target);
    Pose out(source.size());
    for (const InterpolationMethod method : {InterpolationMethod::Poisson, InterpolationMethod::Slerp}) {
        poses.oneSided(PoseInterpolation::Side::Source, 1, out, method);
        EXPECT_LT(largestDistance(out, target), 1e-6);
        poses.oneSided(PoseInterpolation::Side::Source, 0, out, method);
        EXPECT_LT(largestDistance(out, source), 1e-6);
        poses.oneSided(PoseInterpolation::Side::Target, 0, out, method);
        EXPECT_LT(largestDistance(out, source), 1e-6);
    }
}

TEST(PoseInterpolation, OfARigidMotionIsARigidMotion)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = movedBy(source, someMotion);
    const PoseInterpolation poses = between(bar.topology, source, target);
    for (const double lambda : {0.25, 0.5, 0.9}) {
        // The rotation in part, about the centre that moves straight on.
        const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(lambda, someMotion.rotation);
        const Vec3d centre = (1 - lambda) * meanOf(source) + lambda * meanOf(target);
        const Pose expected = movedBy(source, RigidMotion{part, centre - part * meanOf(source)});
        for (const InterpolationMethod method : {InterpolationMethod::Poisson, InterpolationMethod::Slerp})
            EXPECT_LT(largestDistance(at(poses, lambda, source.size(), method), expected), 2e-6) << lambda;
    }
}

TEST(PoseInterpolation, TurnsAlongWithItsInput)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = bent(source, barLength, 2.0);
    const Pose expected = movedBy(at(between(bar.topology, source, target), 0.3, source.size()), someMotion);
    const Pose out = at(between(bar.topology, movedBy(source, someMotion), movedBy(target, someMotion)), 0.3,
                        source.size());
    EXPECT_LT(largestDistance(out, expected), 3e-6);
}

TEST(PoseInterpolation, PlacesPosesBeforehandOnRequest)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = bent(source, barLength, 2.0);
    const PoseInterpolation poses = between(bar.topology, source, target);
    for (const InterpolationMethod method : methods) {
        const Pose expected =
            at(between(bar.topology, movedBy(source, someMotion), movedBy(target, otherMotion)), 0.3,
               source.size(), method);
        Pose out(source.size());
        poses.at(0.3, out, method, someMotion, otherMotion);
        EXPECT_LT(largestDistance(out, expected), 4e-6);
        poses.at(1, out, method, someMotion, otherMotion);
        EXPECT_LT(largestDistance(out, movedBy(target, otherMotion)), 1e-6);
    }
}

TEST(PoseInterpolation, OfABentBarKeepsItsLengthsWhereLinearShrinks)
{
    const Bar bar = makeBar(41, 3, barLength, 0.2F);
    const Pose target = bent(bar.positions, barLength, 2.4);
    const PoseInterpolation poses = between(bar.topology, bar.positions, target);
    const auto error = [&](InterpolationMethod method) {
        return largestLengthError(*bar.topology, at(poses, 0.5, target.size(), method), bar.positions,
                                  target);
    };
    EXPECT_LT(error(InterpolationMethod::Poisson), 0.01);
    EXPECT_LT(error(InterpolationMethod::Slerp), 0.01);
    EXPECT_GT(error(InterpolationMethod::Linear), 0.1);
}

TEST(PoseInterpolation, IsTheSameFromEitherEnd)
{
    const Bar bar = simpleBar();
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = movedBy(shaken(bent(bar.positions, barLength, 2.0), 0.02, 2), someMotion);
    const PoseInterpolation there = between(bar.topology, source, target);
    const PoseInterpolation back = between(bar.topology, target, source);
    for (const InterpolationMethod method : methods) {
        EXPECT_LT(
            largestDistance(at(there, 0.3, source.size(), method), at(back, 0.7, source.size(), method)),
            1e-6);
    }
}

TEST(PoseInterpolation, DoesNotDependOnTheOrderOfVertices)
{
    const Bar bar = simpleBar();
    const std::size_t count = bar.positions.size();
    std::vector<std::uint32_t> newOf(count);
    std::iota(newOf.begin(), newOf.end(), 0);
    std::shuffle(newOf.begin(), newOf.end(), std::mt19937(5));
    TopologyData data = bar.topology->data();
    for (Triangle& triangle : data.triangles) {
        for (VertexIndex& v : triangle)
            v = VertexIndex(newOf[v.value]);
    }
    const auto renumber = [&](const Pose& pose) {
        Pose out(count);
        for (std::size_t v = 0; v < count; ++v)
            out[newOf[v]] = pose[v];
        return out;
    };
    const Pose source = shaken(bar.positions, 0.02, 1);
    const Pose target = bent(source, barLength, 2.0);
    const Pose expected = renumber(at(between(bar.topology, source, target), 0.4, count));
    const Pose out =
        at(between(std::make_shared<const Topology>(data), renumber(source), renumber(target)), 0.4, count);
    EXPECT_LT(largestDistance(out, expected), 1e-6);
}

// Most of the bar stays; its end is wound up to an angle, in the middle to half of it.
TEST(PoseInterpolation, TurnsPartsBeyondHalfATurnOneWay)
{
    const Bar bar = makeBar(161, 2, 8.0F, 0.3F);
    const auto woundBy = [&](double degrees) {
        return moved(bar.positions, [&](const Vec3d& p) -> Vec3d {
            const double phi = degrees * pi / 180 * std::clamp((p.x() - 5.5) / 2.0, 0.0, 1.0);
            return {p.x(), std::cos(phi) * p.y() - std::sin(phi) * p.z(),
                    std::sin(phi) * p.y() + std::cos(phi) * p.z()};
        });
    };
    for (const double degrees : {170.0, 190.0, 250.0, 320.0, -250.0}) {
        const Pose target = woundBy(degrees);
        const Pose half = at(between(bar.topology, bar.positions, target), 0.5, target.size());
        // Wound the wrong way corners are 0.3 to 0.4 off; a tight winding waists a little.
        EXPECT_LT(largestDistance(half, woundBy(0.5 * degrees)), 0.1) << degrees;
    }
}

TEST(PoseInterpolation, PlacesEveryComponent)
{
    const Bar bars = makeBar(11, 2, 1.0F, 0.2F, true, 3);
    const Pose source = bars.positions;
    // Each bar moves by itself, so that the centres go straight on between them after alignment.
    Pose target = bent(source, 1.0, 1.0);
    const std::vector<std::int32_t>& components = bars.topology->components();
    for (std::size_t v = 0; v < target.size(); ++v)
        target[v] += Vec3f(0.1F, 0, 0.5F) * static_cast<float>(components[v]);
    const Pose out = at(between(bars.topology, source, target), 0.5, source.size());
    EXPECT_LT(largestDistance(
                  out, interpolatePlainly(*bars.topology, source, target, 0.5, InterpolationMethod::Poisson)),
              1e-5);
}

TEST(PoseInterpolation, AgreesWithThePlainReference)
{
    for (const bool closed : {true, false}) {
        const Bar bar = makeBar(15, 3, barLength, 0.4F, closed, 2);
        const Pose source = shaken(bar.positions, 0.03, 3);
        const Pose target = movedBy(shaken(bent(bar.positions, barLength, 2.0), 0.03, 4), someMotion);
        const PoseInterpolation poses = between(bar.topology, source, target);
        for (const InterpolationMethod method : {InterpolationMethod::Poisson, InterpolationMethod::Slerp}) {
            for (const double lambda : {0.1, 0.5, 0.8}) {
                EXPECT_LT(largestDistance(at(poses, lambda, source.size(), method),
                                          interpolatePlainly(*bar.topology, source, target, lambda, method)),
                          1e-5);
            }
        }
    }
}

TEST(PoseInterpolation, BearsTrianglesWithoutArea)
{
    const Bar bar = simpleBar();
    TopologyData data = bar.topology->data();
    // A triangle with one vertex twice, one between others, and a vertex that collapses onto its neighbour.
    data.triangles.push_back({VertexIndex(0U), VertexIndex(0U), VertexIndex(1U)});
    data.triangles.push_back({VertexIndex(5U), VertexIndex(17U), VertexIndex(29U)});
    const auto topology = std::make_shared<const Topology>(data);
    Pose source = bar.positions;
    source[40] = source[41];
    Pose target = bent(bar.positions, barLength, 1.5);
    target[100] = target[101];
    const PoseInterpolation poses = between(topology, source, target);
    EXPECT_EQ(at(poses, 1, source.size()), target);
    Pose out(source.size());
    poses.oneSided(PoseInterpolation::Side::Source, 1, out);
    EXPECT_LT(largestDistance(out, target), 2e-6);
    // A vertex that moves beside its neighbour shows only there.
    const Pose smooth =
        at(between(bar.topology, bar.positions, bent(bar.positions, barLength, 1.5)), 0.5, source.size());
    EXPECT_LT(largestDistance(at(poses, 0.5, source.size()), smooth), 0.08);
}

// A spike without area at the end of a bar that is wound up by 150 degrees.
TEST(PoseInterpolation, TurnsTrianglesWithoutAreaWithTheirNeighbours)
{
    const Bar bar = makeBar(161, 2, 8.0F, 0.3F);
    TopologyData data = bar.topology->data();
    const std::uint32_t foot = 160 * 8;
    const std::uint32_t tip = data.vertexCount++;
    data.triangles.push_back({VertexIndex(foot), VertexIndex(foot + 1), VertexIndex(tip)});
    Pose source = bar.positions;
    source.push_back(4.0F * source[foot] - 3.0F * source[foot + 1]);
    const Pose target = moved(source, [](const Vec3d& p) -> Vec3d {
        const Eigen::AngleAxisd turn(150 * pi / 180 * std::clamp((p.x() - 5.5) / 2.0, 0.0, 1.0),
                                     Vec3d::UnitX());
        return turn * p;
    });
    const Pose half = at(between(std::make_shared<const Topology>(data), source, target), 0.5, source.size());
    EXPECT_NEAR((half[tip] - half[foot]).norm(), (source[tip] - source[foot]).norm(), 0.02);
}

TEST(PoseInterpolation, OfOnePointIsThatPoint)
{
    const Bar bar = makeBar(5, 1, 1.0F, 0.2F);
    const Pose source(bar.positions.size(), Vec3f(1, 2, 3));
    const Pose target(bar.positions.size(), Vec3f(2, 2, 3));
    const Pose out = at(between(bar.topology, source, target), 0.5, source.size());
    EXPECT_LT(largestDistance(out, Pose(source.size(), Vec3f(1.5F, 2, 3))), 1e-6);
}

TEST(PoseInterpolation, MovesUnusedVerticesAlong)
{
    const Bar bar = simpleBar();
    TopologyData data = bar.topology->data();
    ++data.vertexCount;
    Pose source = bar.positions;
    source.emplace_back(5, 5, 5);
    const Pose target = movedBy(source, someMotion);
    const Pose out = at(between(std::make_shared<const Topology>(data), source, target), 0.5, source.size());
    const RigidMotion motion =
        rigidProcrustes(Positions(source).first(source.size() - 1), Positions(out).first(source.size() - 1));
    EXPECT_LT((motion(source.back().cast<double>()) - out.back().cast<double>()).norm(), 1e-5);
}

TEST(PoseInterpolation, RefusesPosesOfOtherMeshes)
{
    const Bar bar = simpleBar();
    try {
        interpolatePoses(bar.topology, bar.positions, Positions(bar.positions).first(3), 0.5);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::VertexCountMismatch);
    }
}

TEST(PoseInterpolation, AgreesWithThePlainReferenceOnRealTakes)
{
    if (!test::realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    const MeshSequence walk = *test::realTake("walk_1");
    const MeshSequence jump = *test::realTake("jump_long");
    const auto system = std::make_shared<const PoissonSystem>(walk.topology);
    for (const auto& [first, second] : {std::pair{10, 30}, {25, 12}}) {
        const auto source =
            std::make_shared<const PreparedPose>(system, walk.frame(FrameIndex(first)).positions());
        const auto target =
            std::make_shared<const PreparedPose>(system, jump.frame(FrameIndex(second)).positions());
        const PoseInterpolation poses(source, target);
        // The few triangles that turn more than 180 degrees with their neighbours do so in the reference.
        TriangleLogs logs = triangleLogs(source->frames(), target->frames(), poses.rotation());
        std::vector<int> wholeTurns(logs.size(), 0);
        chooseBranches(*system, logs);
        std::ranges::transform(logs.halfAngle, wholeTurns.begin(),
                               [](double angle) { return angle < 0 ? -1 : 0; });
        EXPECT_LT(std::ranges::count(wholeTurns, -1), 20);
        Pose out(source->positions().size());
        for (const InterpolationMethod method : {InterpolationMethod::Poisson, InterpolationMethod::Slerp}) {
            poses.at(0.4, out, method);
            EXPECT_LT(largestDistance(out, interpolatePlainly(*walk.topology, source->positions(),
                                                              target->positions(), 0.4, method, wholeTurns)),
                      1e-5)
                << first << ", " << second;
        }
    }
}

} // namespace
} // namespace quadrille
