// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/variation/parts/partoverlap.h"
#include "model/variation/parts/stitching.h"
#include "tests/model/codeof.h"
#include "tests/model/transition/bars.h"
#include "tests/model/variation/handmadeparts.h"
#include "tests/model/variation/partedposes.h"
#include "tests/model/variation/plainstitching.h"

#include <gtest/gtest.h>
#include <numbers>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;
using quadrille::test::codeOf;

// A hundredth of what is asked for; positions are stored to 6e-8 of their size.
TEST(Stitching, GivesBackAnUnchangedMesh)
{
    for (const bool closed : {true, false}) {
        const PartedBar parted(61, 4, 2.0F, 0.3F, closed);
        const Pose pose = bent(shaken(parted.bar.positions, 0.004, 1), 2.0, 1.5);
        const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
        EXPECT_LT(largestDistance(stitched(stitching, cutPose(parted.parts, pose)), pose), 2e-6) << closed;
    }
}

TEST(Stitching, TakesChildrenFromAnywhere)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose expected = stitched(stitching, poses);
    poses[1] = movedBy(poses[1], someMotion);
    poses[3] = movedBy(poses[3], otherMotion);
    poses[4] = movedBy(poses[4], otherMotion);
    EXPECT_LT(largestDistance(stitched(stitching, poses), expected), 5e-6);
}

TEST(Stitching, GoesWhereItsRootGoes)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose before = stitched(stitching, poses);
    poses[0] = movedBy(poses[0], someMotion);
    EXPECT_LT(largestDistance(stitched(stitching, poses), movedBy(before, someMotion)), 5e-6);
}

TEST(Stitching, KeepsTheShapeOfPartsAwayFromTheirEnds)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose out = stitched(stitching, poses);
    const std::vector<Pose> back = cutPose(parted.parts, out);
    for (std::size_t p = 0; p < back.size(); ++p) {
        // The middle third of the vertices along the bar lies outside all overlaps.
        const std::size_t from = back[p].size() / 3;
        const Pose given(poses[p].begin() + from, poses[p].end() - from);
        const Pose got(back[p].begin() + from, back[p].end() - from);
        EXPECT_LT(largestDistance(movedBy(given, rigidProcrustes(given, got)), got), 2e-3) << p;
    }
}

TEST(Stitching, AgreesWithThePlainReference)
{
    const PartedBar parted(31, 2);
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    for (const double amount : {0.1, 0.6}) {
        const std::vector<Pose> poses = variousPoses(parted, amount);
        Pose out(parted.bar.positions.size());
        const Stitching::Seams seams = stitching.stitch(viewed(poses), out);
        EXPECT_LT(largestDistance(out, plainStitch(*parted.bar.topology, parted.parts, parted.bar.positions,
                                                   viewed(poses), seams.curves)),
                  5e-6)
            << amount;
    }
}

namespace {

/// The bar with small tetrahedra that float beside it, each one a component, and the parts they belong to.
struct BarWithPebbles
{
    std::shared_ptr<const Topology> topology;
    Pose pose;
    BodyParts parts;
    std::vector<std::uint32_t> pebbles; ///< their first vertices

    explicit BarWithPebbles(const PartedBar& parted) : pose(parted.bar.positions), parts(parted.parts)
    {
        TopologyData data = parted.bar.topology->data();
        for (const auto& [part, x] : {std::pair(0U, 1.0F), std::pair(1U, 0.6F), std::pair(3U, 0.1F)}) {
            const auto first = static_cast<std::uint32_t>(pose.size());
            pebbles.push_back(first);
            for (const Vec3f& corner :
                 {Vec3f(0, 0, 0), Vec3f(0.05F, 0, 0), Vec3f(0, 0.05F, 0), Vec3f(0, 0, 0.05F)}) {
                pose.push_back(corner + Vec3f(x, 0, 0.2F));
                parts.parts[part].vertices.emplace_back(pose.size() - 1);
            }
            for (const auto& [a, b, c] : {std::array{0U, 2U, 1U}, std::array{0U, 1U, 3U},
                                          std::array{0U, 3U, 2U}, std::array{1U, 2U, 3U}}) {
                parts.parts[part].triangles.emplace_back(data.triangles.size());
                data.triangles.push_back(
                    {VertexIndex(first + a), VertexIndex(first + b), VertexIndex(first + c)});
            }
        }
        // One more vertex that no triangle uses.
        pose.emplace_back(0.0F, 0.0F, 0.3F);
        parts.parts[3].vertices.emplace_back(pose.size() - 1);
        data.vertexCount = static_cast<std::uint32_t>(pose.size());
        topology = std::make_shared<const Topology>(data);
    }
};

} // namespace

TEST(Stitching, CarriesOtherComponentsWithTheirParts)
{
    const PartedBar parted;
    const BarWithPebbles with(parted);
    const Stitching stitching(with.topology, with.parts, with.pose);
    EXPECT_LT(largestDistance(stitched(stitching, cutPose(with.parts, with.pose)), with.pose), 2e-6);

    std::vector<Pose> poses;
    for (std::size_t p = 0; p < 5; ++p) {
        const double amount = 0.3 * static_cast<double>(p);
        // Longer by a step near one end of each overlap: merging moves what lies behind.
        const Pose longer = moved(with.pose, [](const Vec3d& v) -> Vec3d {
            return {v.x() - (v.x() < 0.75 ? 0.1 : 0) - (v.x() < 0.35 ? 0.1 : 0), v.y(), v.z()};
        });
        const Pose& pose = p == 0 ? with.pose : longer;
        poses.push_back(cutPose(with.parts, bent(twisted(pose, 2.0, amount), 2.0, 0.5 + amount))[p]);
    }
    const Pose out = stitched(stitching, poses);
    for (std::size_t i = 0; i < with.pebbles.size(); ++i) {
        const std::uint32_t pebble = with.pebbles[i];
        // As far from the nearest vertices of the bar as its part has it.
        const std::size_t p = std::array{0U, 1U, 3U}[i];
        const std::vector<VertexIndex>& vertices = with.parts.parts[p].vertices;
        const auto given = [&](std::uint32_t v) {
            return poses[p][static_cast<std::size_t>(std::ranges::lower_bound(vertices, VertexIndex(v)) -
                                                     vertices.begin())];
        };
        std::uint32_t nearest = vertices.front().value;
        for (const VertexIndex v : vertices) {
            if (v.value < parted.bar.positions.size() && (with.pose[v.value] - with.pose[pebble]).norm() <
                                                             (with.pose[nearest] - with.pose[pebble]).norm())
                nearest = v.value;
        }
        EXPECT_NEAR((out[pebble] - out[nearest]).norm(), (given(pebble) - given(nearest)).norm(), 2e-3) << i;
        EXPECT_NEAR((out[pebble] - out[pebble + 3]).norm(), (given(pebble) - given(pebble + 3)).norm(), 1e-6);
    }
}

TEST(Stitching, OfOnePartIsThePartItself)
{
    const PartedBar parted;
    const BodyParts one =
        handmadeParts(*parted.bar.topology, {{"all", -1, [](std::uint32_t) { return true; }}});
    const Stitching stitching(parted.bar.topology, one, parted.bar.positions);
    const Pose pose = bent(twisted(parted.bar.positions, 2.0, 1.0), 2.0, 1.5);
    EXPECT_LT(largestDistance(stitched(stitching, {pose}), pose), 2e-6);
    const std::vector<Pose> parts{pose};
    EXPECT_LT(largestDistance(stitchFrames(stitching, viewed(parts)), pose), 2e-6);
}

TEST(Stitching, BearsTrianglesWithoutArea)
{
    const PartedBar parted;
    std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const Pose before = stitched(stitching, poses);
    // Vertices of the overlap fall onto their neighbours, in one of the instances or in both.
    const std::vector<VertexIndex>& overlap = parted.parts.parts[1].overlap;
    const auto collapse = [&](std::size_t part, VertexIndex v, VertexIndex onto) {
        const std::vector<VertexIndex>& of = parted.parts.parts[part].vertices;
        const auto at = [&](VertexIndex which) -> Vec3f& {
            return poses[part][static_cast<std::size_t>(std::ranges::lower_bound(of, which) - of.begin())];
        };
        at(v) = at(onto);
    };
    collapse(0, overlap[20], overlap[21]);
    collapse(1, overlap[40], overlap[41]);
    collapse(0, overlap[60], overlap[61]);
    collapse(1, overlap[60], overlap[61]);
    EXPECT_LT(largestDistance(stitched(stitching, poses), before), 0.1);
    Pose flat = parted.bar.positions;
    flat[overlap[30].value] = flat[overlap[31].value];
    const Stitching onFlat(parted.bar.topology, parted.parts, flat);
    EXPECT_LT(largestDistance(stitched(onFlat, poses), before), 0.1);
}

namespace {

/// A body that sways, each part by a rhythm of its own, after the others.
std::vector<Pose> swaying(const PartedBar& parted, int frames)
{
    std::vector<Pose> sequences(parted.parts.parts.size());
    for (int f = 0; f < frames; ++f) {
        for (std::size_t p = 0; p < sequences.size(); ++p) {
            const double t = 0.2 * f + 0.3 * static_cast<double>(p);
            const Pose whole = bent(twisted(parted.bar.positions, 2.0, 0.5 * std::sin(t)), 2.0,
                                    1.0 + 0.5 * std::cos(1.3 * t));
            const Pose part = cutPose(parted.parts, whole)[p];
            sequences[p].insert(sequences[p].end(), part.begin(), part.end());
        }
    }
    return sequences;
}

} // namespace

TEST(Stitching, CutsAllFramesAlongOneCurve)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> sequences = swaying(parted, 12);
    const Stitching::Seams seams = stitching.bestSeams(viewed(sequences));
    const Pose frames = stitchFrames(stitching, viewed(sequences));
    const std::size_t count = parted.bar.positions.size();
    ASSERT_EQ(frames.size(), 12 * count);
    for (std::size_t f = 0; f < 12; ++f) {
        std::vector<Positions> poses;
        for (const Pose& sequence : sequences)
            poses.push_back(Positions(sequence).subspan(f * sequence.size() / 12, sequence.size() / 12));
        Pose out(count);
        stitching.stitch(poses, seams, out);
        EXPECT_EQ(largestDistance(out, Positions(frames).subspan(f * count, count)), 0) << f;
    }
    // One frame by itself is cut as it is best for it alone.
    std::vector<Positions> first;
    for (const Pose& sequence : sequences)
        first.push_back(Positions(sequence).first(sequence.size() / 12));
    Pose out(count);
    EXPECT_EQ(stitching.stitch(first, out), stitching.bestSeams(first));
}

TEST(Stitching, CutsWhereTheInstancesAgreeInAllFrames)
{
    const PartedBar parted(61, 4, 2.0F, 0.3F, true, 12);
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const BodyPart& left = parted.parts.parts[1];
    const auto ringOf = [&](VertexIndex v) {
        return std::lround(parted.bar.positions[v.value].x() * 30) -
               std::lround(parted.bar.positions[left.overlap.front().value].x() * 30);
    };
    // The first frame agrees at rings 4 and 8, the second at 4 and 11, each with their neighbours.
    std::vector<Pose> sequences(5);
    for (const long other : {8L, 11L}) {
        std::vector<Pose> poses = cutPose(parted.parts, parted.bar.positions);
        const Pose noisy = cutPose(parted.parts, shaken(parted.bar.positions, 0.02, 3))[1];
        for (const VertexIndex v : left.overlap) {
            const auto place =
                static_cast<std::size_t>(std::ranges::lower_bound(left.vertices, v) - left.vertices.begin());
            if (std::abs(ringOf(v) - 4) > 1 && std::abs(ringOf(v) - other) > 1)
                poses[1][place] = noisy[place];
        }
        for (std::size_t p = 0; p < sequences.size(); ++p)
            sequences[p].insert(sequences[p].end(), poses[p].begin(), poses[p].end());
    }
    const auto ringsOf = [&](const Stitching::Seams& seams) {
        std::set<long> rings;
        for (const VertexIndex v : seams.curves[1])
            rings.insert(ringOf(v));
        return rings;
    };
    const auto frame = [&](std::size_t f) {
        std::vector<Positions> poses;
        for (const Pose& sequence : sequences)
            poses.push_back(Positions(sequence).subspan(f * sequence.size() / 2, sequence.size() / 2));
        return poses;
    };
    EXPECT_EQ(ringsOf(stitching.bestSeams(frame(0))), std::set{8L});
    EXPECT_EQ(ringsOf(stitching.bestSeams(frame(1))), std::set{4L});
    EXPECT_EQ(ringsOf(stitching.bestSeams(viewed(sequences))), std::set{4L});
}

TEST(Stitching, IsTheSameForAnyNumberOfThreads)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> sequences = swaying(parted, 9);
    const Pose together = stitchFrames(stitching, viewed(sequences));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(stitchFrames(stitching, viewed(sequences)), together);
}

TEST(Stitching, StopsWhenCancelled)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> sequences = swaying(parted, 4);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { stitchFrames(stitching, viewed(sequences), Progress(token)); }),
              ErrorCode::Cancelled);
    EXPECT_EQ(codeOf([&] { (void)stitching.bestSeams(viewed(sequences), Progress(token)); }),
              ErrorCode::Cancelled);
}
