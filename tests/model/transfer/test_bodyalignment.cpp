// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/transfer/bodyalignment.h"
#include "tests/model/codeof.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A clothed body as it stands, its arms down, and the same with its arms held out: which triangle lies where
/// is known. Settings were chosen on it.
class BodyAlignmentOfPoses : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters" / character();
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no real bodies";
        m_out = firstPose(folder / "mesh.obj");
        ImportOptions options;
        options.mesh = folder / "mesh.obj";
        const MeshSequence take = openSequences(folder / "walk_1.pc2", options).sequences.front();
        const Frame frame = take.frame(FrameIndex(0));
        m_down = {m_out.topology, {frame.positions().begin(), frame.positions().end()}};
    }
    virtual std::string character() const { return "rb_m04"; }

    static BodyPlaces placesOf(const PosedMesh& mesh)
    {
        return {mesh, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate};
    }
    /// How far from where they lie triangles are found, shares of the body's height: mean over each side's.
    void expectFound(double most) const
    {
        const BodyPlaces down = placesOf(m_down);
        const BodyPlaces out = placesOf(m_out);
        const BodyAlignment alignment(m_down, down, m_out, out, UpAxis::Y);
        const double height = boundsOf(m_out.positions).size().y();
        const auto distance = [&](const PosedMesh& mesh, TriangleIndex a, TriangleIndex b) {
            const std::vector<Triangle>& triangles = mesh.topology->triangles();
            return (middleOf(triangles[a.value], mesh.positions) -
                    middleOf(triangles[b.value], mesh.positions))
                       .norm() /
                   height;
        };
        double onTarget = 0;
        double onTemplate = 0;
        double byPlaces = 0;
        int count = 0;
        for (std::size_t t = 0; t < down.size(); t += 23) {
            const TriangleIndex triangle(t);
            if (!down.knows(triangle) || !out.knows(triangle))
                continue;
            onTarget += distance(m_out, *alignment.onTarget(triangle), triangle);
            onTemplate += distance(m_down, *alignment.onTemplate(triangle), triangle);
            byPlaces += distance(m_out, nearestByPlaces(down, out, triangle), triangle);
            ++count;
        }
        RecordProperty("onTarget", std::to_string(onTarget / count));
        RecordProperty("byPlaces", std::to_string(byPlaces / count));
        EXPECT_LT(onTarget / count, most);
        EXPECT_LT(onTemplate / count, most);
        EXPECT_LT(onTarget, byPlaces / 5);
    }

    PosedMesh m_down;
    PosedMesh m_out;

private:
    static TriangleIndex nearestByPlaces(const BodyPlaces& of, const BodyPlaces& among,
                                         TriangleIndex triangle)
    {
        TriangleIndex best;
        float least = std::numeric_limits<float>::max();
        for (std::size_t t = 0; t < among.size(); ++t) {
            if (!among.knows(TriangleIndex(t)))
                continue;
            const float difference = (among.values(TriangleIndex(t)) - of.values(triangle)).squaredNorm();
            if (difference < least) {
                least = difference;
                best = TriangleIndex(t);
            }
        }
        return best;
    }
};

/// One on which no setting was chosen.
class BodyAlignmentOfAnother : public BodyAlignmentOfPoses
{
protected:
    std::string character() const override { return "rb_f01"; }
};

} // namespace

TEST_F(BodyAlignmentOfPoses, FindsWhereTrianglesLie)
{
    expectFound(0.005);
}

TEST_F(BodyAlignmentOfAnother, FindsWhereTrianglesLie)
{
    expectFound(0.01);
}

TEST_F(BodyAlignmentOfPoses, NeitherSizeNorHeadingMatters)
{
    const BodyPlaces down = placesOf(m_down);
    const BodyPlaces out = placesOf(m_out);
    const BodyAlignment alignment(m_down, down, m_out, out, UpAxis::Y);
    PosedMesh elsewhere = m_out;
    for (Vec3f& p : elsewhere.positions)
        p = 3 * (Eigen::AngleAxisf(2, Vec3f::UnitY()) * p) + Vec3f(5, 0, -4);
    const BodyPlaces moved = placesOf(elsewhere);
    const BodyAlignment other(m_down, down, elsewhere, moved, UpAxis::Y);
    double likeness = 0;
    int count = 0;
    for (std::size_t t = 0; t < down.size(); t += 97) {
        const TriangleIndex triangle(t);
        if (!down.knows(triangle) || !out.knows(triangle))
            continue;
        likeness += std::abs(alignment.likeness({triangle, triangle}) - other.likeness({triangle, triangle}));
        ++count;
    }
    EXPECT_LT(likeness / count, 0.02);
}

TEST_F(BodyAlignmentOfPoses, KnowsNothingOfTrianglesWithoutAnArea)
{
    std::vector<Triangle> triangles = m_down.topology->triangles();
    triangles.push_back({triangles[0][0], triangles[0][0], triangles[0][1]});
    TopologyData data;
    data.vertexCount = static_cast<std::uint32_t>(m_down.positions.size());
    data.triangles = triangles;
    const PosedMesh more{std::make_shared<const Topology>(std::move(data)), m_down.positions};
    const BodyPlaces down = placesOf(more);
    const BodyPlaces out = placesOf(m_out);
    const BodyAlignment alignment(more, down, m_out, out, UpAxis::Y);
    const TriangleIndex flat(triangles.size() - 1);
    EXPECT_FALSE(alignment.onTarget(flat));
    EXPECT_TRUE(std::isnan(alignment.likeness({flat, TriangleIndex(0)})));
}

TEST_F(BodyAlignmentOfPoses, IsCancelled)
{
    const BodyPlaces down = placesOf(m_down);
    const BodyPlaces out = placesOf(m_out);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(
        codeOf([&] { const BodyAlignment alignment(m_down, down, m_out, out, UpAxis::Y, Progress(token)); }),
        ErrorCode::Cancelled);
}
