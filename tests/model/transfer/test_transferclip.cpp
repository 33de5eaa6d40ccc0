// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/transfer/livetransfer.h"
#include "tests/model/codeof.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>
#include <limits>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int frames = 12;

/// A bar that bends more and more, and one of other proportions that takes it over.
class TransferClip : public testing::Test
{
protected:
    TransferClip()
        : m_bar(makeBar(9, 3, 1.0F, 0.2F))
        , m_clip(makeSequence("bending", m_bar.topology,
                              std::make_shared<MemoryFrames>(bending(), m_bar.topology->vertexCount()), 25))
        , m_reference{m_bar.topology, m_bar.positions}
        , m_target{m_bar.topology, moved(m_bar.positions, [](const Vec3d& p) -> Vec3d {
                       return {1.5 * p.x(), 1.2 * p.y(), 1.2 * p.z()};
                   })}
    {
        for (std::size_t t = 0; t < m_bar.topology->triangles().size(); t += 20)
            m_pairs.push_back({TriangleIndex(t), TriangleIndex(t)});
    }

    std::vector<Vec3f> bending() const
    {
        std::vector<Vec3f> positions;
        for (int f = 0; f < frames; ++f) {
            const std::vector<Vec3f> pose = bent(m_bar.positions, 1, 0.1 * (f + 1));
            positions.insert(positions.end(), pose.begin(), pose.end());
        }
        return positions;
    }
    Transferred transfer(const TransferSettings& settings = {}, const Progress& progress = {}) const
    {
        return transferClip(m_clip, m_reference, m_target, m_pairs, settings, progress);
    }
    ErrorCode refused() const
    {
        return codeOf([this] { transfer(); });
    }
    Positions frameOf(const Transferred& result, std::size_t frame) const
    {
        return Positions(result.positions)
            .subspan(frame * m_target.positions.size(), m_target.positions.size());
    }

    Bar m_bar;
    MeshSequence m_clip;
    PosedMesh m_reference;
    PosedMesh m_target;
    std::vector<TrianglePair> m_pairs;
};

} // namespace

TEST_F(TransferClip, OntoItselfStaysNear)
{
    m_target = m_reference;
    const Transferred result = transfer();
    EXPECT_DOUBLE_EQ(result.scale, 1);
    EXPECT_NEAR(result.turn, 0, 1e-9);
    ASSERT_EQ(result.markErrors.size(), static_cast<std::size_t>(frames));
    for (std::size_t f = 0; f < frames; ++f) {
        EXPECT_LT(largestDistance(frameOf(result, f), m_clip.frame(FrameIndex(f)).positions()), 0.04);
        EXPECT_NEAR(result.volume[f], 1, 0.03);
        EXPECT_LT(result.markErrors[f], 3 * degree);
    }
}

/// The template becomes longer and thinner; so does a target that lies across.
TEST_F(TransferClip, CarriesStretchInTheTargetsOwnDirections)
{
    std::vector<Vec3f> pose =
        moved(m_bar.positions, [](const Vec3d& p) -> Vec3d { return p.cwiseProduct(Vec3d(1.2, 0.9, 0.9)); });
    m_clip = makeSequence("longer", m_bar.topology,
                          std::make_shared<MemoryFrames>(std::move(pose), m_bar.topology->vertexCount()), 25);
    m_target.positions = moved(m_target.positions, [](const Vec3d& p) -> Vec3d {
        return Eigen::AngleAxisd(2.5, Vec3d::UnitY()) * p;
    });
    const Vec3d carried = boundsOf(frameOf(transfer(), 0)).size();
    const Vec3d turnedOnly = boundsOf(frameOf(transfer({.carriesStretch = false}), 0)).size();
    EXPECT_LT((turnedOnly - Vec3d(1.5, 0.24, 0.24)).norm(), 0.02);
    EXPECT_NEAR(carried.x(), 1.2 * turnedOnly.x(), 0.05);
    EXPECT_LT(carried.y(), 0.97 * turnedOnly.y());
}

TEST_F(TransferClip, TurnsTheTargetAsTheTemplate)
{
    m_target.positions = moved(m_reference.positions, [](const Vec3d& p) -> Vec3d {
        return Eigen::AngleAxisd(2.5, Vec3d::UnitY()) * p + Vec3d(7, 0, -2);
    });
    const Transferred result = transfer();
    EXPECT_NEAR(result.turn, -2.5, 1e-6);
    EXPECT_LT(largestDistance(frameOf(result, 5), m_clip.frame(FrameIndex(5)).positions()), 0.02);
}

TEST_F(TransferClip, MirroredPairsMirrorThePerformance)
{
    const std::vector<Vec3f> mirrored = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d {
        return {p.x(), -p.y(), p.z()};
    });
    TopologyData data{.vertexCount = m_bar.topology->vertexCount()};
    for (const Triangle& t : m_bar.topology->triangles())
        data.triangles.push_back({t[1], t[0], t[2]});
    m_target = {std::make_shared<const Topology>(std::move(data)), mirrored};
    const Transferred result = transfer();
    for (std::size_t f = 0; f < frames; ++f) {
        const Frame frame = m_clip.frame(FrameIndex(f));
        const std::vector<Vec3f> expected =
            moved({frame.positions().begin(), frame.positions().end()}, [](const Vec3d& p) -> Vec3d {
                return {p.x(), -p.y(), p.z()};
            });
        EXPECT_LT(largestDistance(frameOf(result, f), expected), 0.04) << f;
    }
}

TEST_F(TransferClip, IsTheSameForAnyNumberOfThreads)
{
    const Transferred many = transfer();
    Transferred one;
    tbb::task_arena(1).execute([&] { one = transfer(); });
    EXPECT_EQ(many.positions, one.positions);
    EXPECT_EQ(many.markErrors, one.markErrors);
    EXPECT_EQ(many.volume, one.volume);
}

TEST_F(TransferClip, PosesThatAreLookedAtAreThoseOfTheResult)
{
    for (const FieldKind field : {FieldKind::Quaternions, FieldKind::Logarithms}) {
        const TransferSettings settings{.field = field, .scale = 1.1};
        const Transferred result = transfer(settings);
        const auto solid = std::make_shared<const TransferTarget>(*m_target.topology, m_target.positions);
        const LiveTransfer live(PreparedTransfer(m_clip, m_reference, m_target, solid, m_pairs, settings),
                                settings, 100);
        ASSERT_EQ(live.frameCount(), frames);
        ASSERT_EQ(live.vertexCount(), m_target.positions.size());
        std::vector<Vec3f> pose(m_target.positions.size());
        for (std::size_t f = 0; f < frames; ++f) {
            live.read(FrameIndex(static_cast<std::int64_t>(f)), pose);
            const std::vector<Vec3f> metres = moved(pose, [](const Vec3d& p) -> Vec3d { return p / 100; });
            EXPECT_LT(largestDistance(metres, frameOf(result, f)), 1e-5);
            const Vec3d apart = centroid(metres) - centroid(frameOf(result, f));
            EXPECT_LT(std::hypot(apart.x(), apart.z()), 1e-5);
            EXPECT_LT(std::abs(apart.y()), 0.05); // heights are not evened
        }
    }
}

TEST_F(TransferClip, TakesTheScaleThatIsGiven)
{
    const Transferred own = transfer();
    EXPECT_NEAR(own.scale, 1.2, 1e-5); // as high as the target is
    EXPECT_DOUBLE_EQ(transfer({.scale = 0.7}).scale, 0.7);
}

TEST_F(TransferClip, SizesOfFlatMeshesAreThoseOfTheirDiagonals)
{
    for (Vec3f& p : m_reference.positions)
        p.y() = 0;
    EXPECT_NEAR(transfer().scale, 1.5, 0.1);
}

TEST_F(TransferClip, TellsPosesApart)
{
    const auto difference = [&](const std::vector<Vec3f>& pose) {
        return poseDifference(*m_bar.topology, pose, m_reference, m_pairs, UpAxis::Y);
    };
    EXPECT_NEAR(difference(m_bar.positions), 0, 1e-6);
    const double little = difference(bent(m_bar.positions, 1, 0.3));
    const double much = difference(bent(m_bar.positions, 1, 1.2));
    EXPECT_GT(little, 0.01);
    EXPECT_GT(much, little);
    EXPECT_LT(much, 1);
    // Neither size nor place nor heading counts.
    const std::vector<Vec3f> elsewhere = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d {
        return 3 * (Eigen::AngleAxisd(1, Vec3d::UnitY()) * p) + Vec3d(1, 2, 3);
    });
    EXPECT_NEAR(difference(elsewhere), 0, 1e-3);
}

TEST_F(TransferClip, RefusesPairsThatMeanNothing)
{
    const std::vector<TrianglePair> pairs = m_pairs;
    m_pairs.clear();
    EXPECT_EQ(refused(), ErrorCode::TransferNoPairs);
    m_pairs = pairs;
    m_pairs[2].onTemplate = TriangleIndex(1'000'000);
    EXPECT_EQ(refused(), ErrorCode::TransferTriangleOfTemplate);
    m_pairs = pairs;
    m_pairs[2].onTarget = TriangleIndex(1'000'000);
    EXPECT_EQ(refused(), ErrorCode::TransferTriangleOfTarget);
    m_pairs = pairs;
    m_pairs[2].onTarget = m_pairs[0].onTarget;
    EXPECT_EQ(refused(), ErrorCode::TransferTriangleTwice);
    m_pairs = pairs;
    const Triangle& triangle = m_target.topology->triangles()[m_pairs[1].onTarget.value];
    m_target.positions[triangle[0].value] = m_target.positions[triangle[1].value];
    EXPECT_EQ(refused(), ErrorCode::TransferTriangleFlat);
    m_target.positions[0].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refused(), ErrorCode::NonFiniteCoordinate);
}

TEST_F(TransferClip, StopsWhenItIsCancelled)
{
    CancelToken token;
    const Progress progress(token, [&token](double done) {
        if (done > 0.3)
            token.cancel();
    });
    EXPECT_EQ(codeOf([&] { transfer({}, progress); }), ErrorCode::Cancelled);
}
