// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/surroundings.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>
#include <numeric>
#include <set>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A bar as a surface; its mesh has no vertices at one place, so that both have the same triangles.
class SurroundingsOfMarks : public testing::Test
{
protected:
    static constexpr float reach = 0.06F * 0.9381F; // the root of the bar's area is 0.9381 m

    std::vector<std::size_t> marksAt(std::initializer_list<double> places) const
    {
        std::vector<std::size_t> marks;
        for (const double place : places) {
            const auto& triangles = m_bar.topology->triangles();
            const auto nearest = std::ranges::min_element(triangles, {}, [&](const Triangle& t) {
                return (middleOf(t, m_bar.positions) - Vec3d(place, 0, 0.1)).norm();
            });
            marks.push_back(static_cast<std::size_t>(nearest - triangles.begin()));
        }
        return marks;
    }
    double placeOf(std::uint32_t vertex) const { return static_cast<double>(m_bar.positions[vertex].x()); }

    Bar m_bar = makeBar(101, 20, 1.0F, 0.2F);
    SurfaceGraph m_graph{m_bar.topology, m_bar.positions};
};

/// A bar bent at its middle, and how well it is bent by two marks on each side of that.
double bendMissed(int fineness, bool holdsSurroundings)
{
    const Bar bar = makeBar(20 * fineness + 1, 2 * fineness, 2.0F, 0.2F);
    const Vec3d hinge(1, 0, 0);
    const auto pose = moved(bar.positions, [&](const Vec3d& p) -> Vec3d {
        return p.x() > 1 ? Vec3d(hinge + Eigen::AngleAxisd(60 * degree, Vec3d::UnitY()) * (p - hinge)) : p;
    });
    std::vector<TriangleIndex> marks;
    for (const double place : {0.5, 0.8, 1.2, 1.5}) {
        const auto& triangles = bar.topology->triangles();
        const auto nearest = std::ranges::min_element(triangles, {}, [&](const Triangle& t) {
            return (middleOf(t, bar.positions) - Vec3d(place, 0, 0.1)).norm();
        });
        marks.emplace_back(static_cast<std::size_t>(nearest - triangles.begin()));
    }
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    const TransferSolver solver(std::make_shared<const TransferTarget>(*bar.topology, bar.positions), marks,
                                FieldKind::Quaternions, holdsSurroundings);
    std::vector<Vec3f> out(bar.positions.size());
    TransferSolver::Scratch scratch;
    solver.pose(tracker.next(pose), out, scratch);
    return largestDistance(out, pose);
}

} // namespace

TEST_F(SurroundingsOfMarks, ReachAsFarAsSkinMovesAlike)
{
    const std::vector<std::size_t> marks = marksAt({0.5});
    const Surroundings surroundings(m_graph, marks);
    const std::vector<std::uint32_t> vertices = surroundings.vertices(0);
    double farthest = 0;
    for (const std::uint32_t v : vertices)
        farthest = std::max(farthest, std::abs(placeOf(v) - 0.5));
    EXPECT_LT(farthest, reach + 0.01F);
    EXPECT_GT(farthest, reach - 0.02F);
    const auto triangles = surroundings.triangles(0);
    EXPECT_EQ(triangles.front().triangle, marks[0]);
    EXPECT_GT(triangles.size(), 20U);
    double sum = 0;
    for (const Surroundings::Near& near : triangles) {
        EXPECT_LT(std::abs(middleOf(m_bar.topology->triangles()[near.triangle], m_bar.positions).x() - 0.5),
                  reach + 0.01F);
        sum += near.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
}

TEST_F(SurroundingsOfMarks, NoVertexIsAboutTwoMarks)
{
    const std::vector<std::size_t> marks = marksAt({0.47, 0.5, 0.56, 0.9});
    const Surroundings surroundings(m_graph, marks);
    std::set<std::uint32_t> seen;
    for (const std::size_t mark : marks) {
        for (const VertexIndex v : m_bar.topology->triangles()[mark])
            EXPECT_TRUE(seen.insert(v.value).second);
    }
    for (std::size_t m = 0; m < marks.size(); ++m) {
        const std::vector<std::uint32_t> vertices = surroundings.vertices(m);
        for (const std::uint32_t v : vertices)
            EXPECT_TRUE(seen.insert(v).second) << v << " at mark " << m;
    }
    EXPECT_GT(surroundings.vertices(3).size(), 4 * surroundings.vertices(0).size());
    // Whatever else is marked.
    const Surroundings whole(m_graph, marks, PatchReach::Whole);
    EXPECT_GT(whole.triangles(0).size(), 2 * surroundings.triangles(0).size());
}

TEST_F(SurroundingsOfMarks, AreNothingWhereMarksShareCorners)
{
    std::vector<std::size_t> all(m_bar.topology->triangles().size());
    std::iota(all.begin(), all.end(), 0U);
    const Surroundings surroundings(m_graph, all);
    for (std::size_t m = 0; m < all.size(); m += 31) {
        EXPECT_TRUE(surroundings.vertices(m).empty());
        ASSERT_EQ(surroundings.triangles(m).size(), 1U);
        EXPECT_EQ(surroundings.triangles(m)[0].triangle, m);
    }
}

TEST_F(SurroundingsOfMarks, DoNotDependOnTheOrderOfMarks)
{
    const std::vector<std::size_t> marks = marksAt({0.47, 0.5, 0.56});
    const std::vector<std::size_t> reversed(marks.rbegin(), marks.rend());
    for (std::size_t m = 0; m < marks.size(); ++m)
        EXPECT_EQ(Surroundings(m_graph, marks).vertices(m), Surroundings(m_graph, reversed).vertices(2 - m));
}

/// The finer a mesh, the less single triangles of it hold.
TEST(TransferByMarks, BendsAsWellHoweverFineTheTargetIs)
{
    EXPECT_GT(bendMissed(6, false), 1.15 * bendMissed(2, false));
    EXPECT_LT(bendMissed(6, true), 1.05 * bendMissed(2, true));
    EXPECT_LT(bendMissed(6, true), 0.8 * bendMissed(6, false));
}

TEST(MarkTracker, TakesTheMeanOfAPatch)
{
    const Bar bar = makeBar(21, 5, 1.0F, 0.2F);
    const std::vector<TrianglePair> pairs{{TriangleIndex(200), TriangleIndex(200)}};
    const PosedMesh reference{bar.topology, bar.positions};
    // One corner of the mark is pulled out: the patch hardly turns.
    std::vector<Vec3f> pose = bar.positions;
    pose[bar.topology->triangles()[200][0].value] += Vec3f(0, 0.03F, 0.03F);
    const auto turnBy = [&](MarkPatches patches) {
        return MarkTracker(std::move(patches), bar.positions)
            .next(pose)
            .rotations[0]
            .angularDistance(Eigen::Quaterniond::Identity());
    };
    const double alone = turnBy(singleTriangles({bar.topology->triangles()[200]}));
    EXPECT_GT(alone, 10 * degree);
    EXPECT_LT(turnBy(patchesAbout(PosedSurface(reference), pairs, PatchReach::NextMark)), alone / 2);
}
