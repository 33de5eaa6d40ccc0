// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/transfer/bodyalignment.h"
#include "model/transfer/bodyplaces.h"
#include "model/transfer/pairproposal.h"
#include "model/transfer/posecorrection.h"
#include "tests/model/codeof.h"
#include "tests/model/transfer/transferfixture.h"

#include <array>
#include <gtest/gtest.h>
#include <set>

using namespace quadrille;
using namespace quadrille::test;

namespace {

Vec3d middleOf(const PosedMesh& mesh, TriangleIndex triangle)
{
    const Triangle& t = mesh.topology->triangles()[triangle.value];
    return (mesh.positions[t[0].value] + mesh.positions[t[1].value] + mesh.positions[t[2].value])
               .cast<double>() /
           3;
}

/// Two bodies whose triangles correspond one by one.
class PairProposal : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/mh_male";
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no real bodies";
        m_average = firstPose(folder / "rest_m_avg.obj");
        m_heavy = firstPose(folder / "rest_m_heavy.obj");
    }

    /// How far proposed triangles are from the true ones, heights of the body.
    double meanError(const std::vector<ProposedPair>& pairs) const
    {
        double sum = 0;
        for (const ProposedPair& proposed : pairs)
            sum += (middleOf(m_heavy, proposed.pair.onTarget) - middleOf(m_heavy, proposed.pair.onTemplate))
                       .norm();
        return sum / static_cast<double>(pairs.size()) / boundsOf(m_heavy.positions).size().y();
    }

    PosedMesh m_average;
    PosedMesh m_heavy;
};

} // namespace

TEST_F(PairProposal, FindsTheTrianglesOfAnotherBody)
{
    const std::vector<ProposedPair> pairs = proposePairs(m_average, m_heavy, UpAxis::Y);
    EXPECT_GT(pairs.size(), usualPairs * 9 / 10);
    EXPECT_LT(meanError(pairs), 0.005);
    std::set<TriangleIndex> onTarget;
    for (const ProposedPair& proposed : pairs) {
        EXPECT_TRUE(onTarget.insert(proposed.pair.onTarget).second);
        EXPECT_GT(proposed.quality, 0.3);
        EXPECT_LE(proposed.quality, 1);
    }
}

TEST_F(PairProposal, NeitherSizeNorHeadingMatters)
{
    for (Vec3f& p : m_heavy.positions)
        p = 30 * (Eigen::AngleAxisf(2, Vec3f::UnitY()) * p) + Vec3f(5, 1, -4);
    EXPECT_LT(meanError(proposePairs(m_average, m_heavy, UpAxis::Y, {}, 30)), 0.005);
}

TEST_F(PairProposal, PairsLieCloserWhereTheTemplateBends)
{
    // The left shin, from the knee down, swings back and forth.
    const double knee = 0.28 * boundsOf(m_average.positions).size().y();
    std::vector<std::vector<Vec3f>> poses;
    for (const double angle : {0.8, 1.6, 2.2}) {
        poses.push_back(moved(m_average.positions, [&](const Vec3d& p) -> Vec3d {
            const Vec3d hinge(0, knee, 0);
            const double share = p.x() > 0.02 ? std::clamp((knee + 0.1 - p.y()) / 0.2, 0.0, 1.0) : 0;
            return hinge + Eigen::AngleAxisd(share * angle, Vec3d::UnitX()) * (p - hinge);
        }));
    }
    const auto nearKnees = [&](std::span<const std::vector<Vec3f>> performed) {
        std::array<int, 2> counts{};
        for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y, performed, 300)) {
            const Vec3d place = middleOf(m_average, proposed.pair.onTemplate);
            if (std::abs(place.y() - knee) < 0.1)
                ++counts[place.x() > 0 ? 0 : 1];
        }
        return counts;
    };
    const auto [left, right] = nearKnees(poses);
    const auto [leftBefore, rightBefore] = nearKnees({});
    EXPECT_GE(left, leftBefore + 2);
    EXPECT_GE(left, right + 2);
}

/// A jacket and a hood lengthen the ways over one body, loose trousers hide where the legs of the other meet.
TEST(PairProposalOnClothes, LegsArePairedAtTheirHeights)
{
    const std::filesystem::path data = QUADRILLE_DATA_DIR;
    if (!std::filesystem::exists(data / "scans/liam_frame112"))
        GTEST_SKIP() << "no real bodies";
    const PosedMesh man = firstPose(data / "characters/rb_m04/mesh.obj");
    const PosedMesh scan = firstPose(data / "scans/liam_frame112/scan.obj");
    const auto shareOfHeight = [](const PosedMesh& body, TriangleIndex triangle) {
        const Bounds bounds = boundsOf(body.positions);
        return (middleOf(body, triangle).y() - bounds.min.y()) / bounds.size().y();
    };
    double sum = 0;
    int count = 0;
    for (const ProposedPair& proposed : proposePairs(man, scan, UpAxis::Y)) {
        const double height = shareOfHeight(man, proposed.pair.onTemplate);
        if (height > 0.4)
            continue; // above the legs
        sum += std::abs(shareOfHeight(scan, proposed.pair.onTarget) - height);
        ++count;
    }
    ASSERT_GT(count, 20);
    EXPECT_LT(sum / count, 0.03);
}

/// The end of a ponytail lies farther from hands and feet than the head.
TEST_F(PairProposal, HeadsAreFoundAboveHair)
{
    const PosedMesh woman =
        firstPose(std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_f01/mesh.obj");
    const auto shareOfHeight = [](const PosedMesh& body, TriangleIndex triangle) {
        const Bounds bounds = boundsOf(body.positions);
        return (middleOf(body, triangle).y() - bounds.min.y()) / bounds.size().y();
    };
    int count = 0;
    for (const ProposedPair& proposed : proposePairs(woman, m_average, UpAxis::Y)) {
        if (shareOfHeight(woman, proposed.pair.onTemplate) < 0.94)
            continue; // not the top of the head
        EXPECT_GT(shareOfHeight(m_average, proposed.pair.onTarget), 0.9);
        ++count;
    }
    EXPECT_GE(count, 3);
}

/// A ponytail has no like on a body with short hair: laid onto the back of its head it would dent that.
TEST_F(PairProposal, WhatHangsFromAHeadDoesNotTurnIt)
{
    const auto folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_f01";
    ImportOptions options;
    options.mesh = folder / "mesh.obj";
    const MeshSequence take = openSequences(folder / "walk_1.pc2", options).sequences.front();
    const Frame frame = take.frame(FrameIndex(5));
    const PosedMesh woman{take.topology, {frame.positions().begin(), frame.positions().end()}};
    std::vector<TrianglePair> pairs;
    for (const ProposedPair& proposed : proposePairs(woman, m_average, UpAxis::Y))
        pairs.push_back(proposed.pair);
    const double turn = turnOntoTemplate(woman, m_average, pairs, UpAxis::Y);
    const std::vector<Eigen::Quaterniond> corrections = poseCorrections(
        PosedSurface(woman), {m_average.topology, turned(m_average.positions, turn, UpAxis::Y)}, pairs);
    const BodyPlaces places(woman, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    int count = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (places.regionOf(pairs[p].onTemplate) != BodyRegion::Head)
            continue;
        EXPECT_LT(corrections[p].angularDistance(Eigen::Quaterniond::Identity()), 45 * degree);
        ++count;
    }
    EXPECT_GE(count, 5);
}

TEST_F(PairProposal, LeftStaysLeft)
{
    for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y)) {
        const double from = middleOf(m_average, proposed.pair.onTemplate).x();
        const double onto = middleOf(m_heavy, proposed.pair.onTarget).x();
        EXPECT_TRUE(std::abs(from) <= 0.1 || from * onto > 0) << from << " and " << onto;
    }
}

TEST_F(PairProposal, PlacesHaveOnesOnTheOtherSide)
{
    const BodyPlaces places(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    double error = 0;
    int count = 0;
    for (std::size_t t = 0; t < places.size(); t += 97) {
        if (!places.knows(TriangleIndex(t)))
            continue;
        const Vec3d own = middleOf(m_average, TriangleIndex(t));
        const auto other = places.mirrored(TriangleIndex(t));
        ASSERT_TRUE(other);
        error += (middleOf(m_average, *other) - Vec3d(-own.x(), own.y(), own.z())).norm();
        ++count;
    }
    ASSERT_GT(count, 20);
    EXPECT_LT(error / count, 0.02 * boundsOf(m_average.positions).size().y());
}

TEST_F(PairProposal, RegionsAreThoseOfBodies)
{
    const BodyPlaces places(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    std::array<Vec3d, bodyRegions> middles;
    std::array<int, bodyRegions> counts{};
    middles.fill(Vec3d::Zero());
    for (std::size_t t = 0; t < places.size(); ++t) {
        if (!places.knows(TriangleIndex(t)))
            continue;
        const auto region = static_cast<std::size_t>(places.regionOf(TriangleIndex(t)));
        middles[region] += middleOf(m_average, TriangleIndex(t));
        ++counts[region];
    }
    for (std::size_t r = 0; r < bodyRegions; ++r) {
        ASSERT_GT(counts[r], 10) << r;
        middles[r] /= counts[r];
    }
    const auto at = [&](BodyRegion region) { return middles[static_cast<std::size_t>(region)]; };
    EXPECT_GT(at(BodyRegion::Head).y(), at(BodyRegion::Trunk).y());
    EXPECT_GT(at(BodyRegion::Trunk).y(), at(BodyRegion::LeftThigh).y());
    EXPECT_GT(at(BodyRegion::LeftThigh).y(), at(BodyRegion::LeftShin).y());
    // Who looks along z has the left hand at positive x.
    EXPECT_GT(at(BodyRegion::LeftLowerArm).x(), at(BodyRegion::LeftUpperArm).x());
    EXPECT_LT(at(BodyRegion::RightLowerArm).x(), at(BodyRegion::RightUpperArm).x());
    EXPECT_GT(at(BodyRegion::LeftShin).x(), 0);
    EXPECT_LT(at(BodyRegion::RightThigh).x(), 0);
}

TEST_F(PairProposal, LikenessTellsPlacesApart)
{
    const BodyPlaces from(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    const BodyPlaces onto(m_heavy, UpAxis::Y, ErrorCode::TransferNoLimbsOfTarget);
    const BodyAlignment alignment(m_average, from, m_heavy, onto, UpAxis::Y);
    int arms = 0;
    for (std::size_t t = 0; t < from.size(); t += 101) {
        const TriangleIndex triangle(t);
        if (!from.knows(triangle) || !onto.knows(triangle))
            continue;
        EXPECT_GT(alignment.likeness({triangle, triangle}), 0.3);
        EXPECT_LE(alignment.likeness({triangle, triangle}), 1);
        if (from.regionOf(triangle) == BodyRegion::LeftLowerArm) {
            EXPECT_LT(alignment.likeness({triangle, *onto.mirrored(triangle)}), 0.1);
            ++arms;
        }
    }
    EXPECT_GT(arms, 3);
}

TEST_F(PairProposal, PairsAreMirrored)
{
    const BodyPlaces from(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    const BodyPlaces onto(m_heavy, UpAxis::Y, ErrorCode::TransferNoLimbsOfTarget);
    int arms = 0;
    for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y)) {
        if (from.regionOf(proposed.pair.onTemplate) != BodyRegion::RightUpperArm)
            continue;
        const auto mirrored = mirroredPair(proposed.pair, from, onto);
        ASSERT_TRUE(mirrored);
        EXPECT_EQ(from.regionOf(mirrored->onTemplate), BodyRegion::LeftUpperArm);
        EXPECT_EQ(onto.regionOf(mirrored->onTarget), BodyRegion::LeftUpperArm);
        ++arms;
    }
    EXPECT_GT(arms, 0);
}

TEST_F(PairProposal, AllPairsAreMirroredOnce)
{
    const BodyPlaces from(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    const BodyPlaces onto(m_heavy, UpAxis::Y, ErrorCode::TransferNoLimbsOfTarget);
    std::vector<TrianglePair> pairs;
    for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y, {}, 40)) {
        if (middleOf(m_average, proposed.pair.onTemplate).x() > 0.1)
            pairs.push_back(proposed.pair);
    }
    ASSERT_GT(pairs.size(), 5U);
    const std::vector<TrianglePair> all = withMirroredPairs(pairs, from, onto);
    EXPECT_GT(all.size(), pairs.size());
    EXPECT_LE(all.size(), 2 * pairs.size());
    EXPECT_TRUE(std::ranges::equal(pairs, std::span(all).first(pairs.size())));
    std::set<TriangleIndex> onTarget;
    for (std::size_t p = 0; p < all.size(); ++p) {
        EXPECT_TRUE(onTarget.insert(all[p].onTarget).second);
        EXPECT_EQ(middleOf(m_average, all[p].onTemplate).x() > 0, p < pairs.size());
    }
}

TEST_F(PairProposal, PartsWithoutPairsAreTold)
{
    const BodyPlaces from(m_average, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate);
    std::vector<TrianglePair> pairs;
    EXPECT_EQ(regionsWithoutPairs(pairs, from).size(), bodyRegions);
    for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y)) {
        if (from.regionOf(proposed.pair.onTemplate) != BodyRegion::LeftShin)
            pairs.push_back(proposed.pair);
    }
    EXPECT_EQ(regionsWithoutPairs(pairs, from), std::vector{BodyRegion::LeftShin});
}

TEST(PairProposalOfOtherThings, IsRefused)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    const PosedMesh mesh{bar.topology, bar.positions};
    EXPECT_EQ(codeOf([&] { proposePairs(mesh, mesh, UpAxis::Y); }), ErrorCode::TransferNoLimbsOfTemplate);
}
