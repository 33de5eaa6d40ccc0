// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/nearestposes.h"
#include "model/transition/posedistance.h"
#include "tests/model/codeof.h"
#include "tests/model/transition/swayingtube.h"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Poses of a tube of 480 vertices that sways.
std::vector<Frame> poses(std::int64_t count, double step)
{
    const MeshSequence sequence = swayingTube(tubeTopology(12, 40), 12, count, step);
    std::vector<Frame> frames;
    for (std::int64_t f = 0; f < count; ++f)
        frames.push_back(sequence.frame(FrameIndex(f)));
    return frames;
}

std::vector<Positions> viewed(const std::vector<Frame>& frames)
{
    std::vector<Positions> views;
    for (const Frame& frame : frames)
        views.push_back(frame.positions());
    return views;
}

} // namespace

TEST(NearestPoses, AreThoseOfAllPairs)
{
    const std::vector<Frame> own = poses(9, 0.37);
    const std::vector<Frame> others = poses(40, 0.11);
    const std::vector<NearestPose> nearest = nearestPoses(viewed(own), viewed(others));
    ASSERT_EQ(nearest.size(), own.size());
    for (std::size_t p = 0; p < own.size(); ++p) {
        NearestPose expected{.index = -1, .distance = 1e300};
        for (std::size_t o = 0; o < others.size(); ++o) {
            const double distance = euclideanDistance(own[p].positions(), others[o].positions());
            if (distance < expected.distance)
                expected = {static_cast<std::int64_t>(o), distance};
        }
        EXPECT_EQ(nearest[p].index, expected.index) << p;
        // Single precision of the coordinates, which are of the order of 1.
        EXPECT_NEAR(nearest[p].distance, expected.distance, 1e-6) << p;
    }
}

TEST(NearestPoses, FindPosesAgainWhereverTheyAre)
{
    const std::vector<Frame> frames = poses(12, 0.3);
    std::vector<std::vector<Vec3f>> elsewhere;
    const Eigen::Quaternionf turn(Eigen::AngleAxisf(2, Vec3f(1, 2, 3).normalized()));
    for (const Frame& frame : frames) {
        elsewhere.emplace_back();
        for (const Vec3f& p : frame.positions())
            elsewhere.back().push_back(turn * p + Vec3f(5, 6, 7));
    }
    const std::vector<NearestPose> nearest =
        nearestPoses(std::vector<Positions>(elsewhere.begin(), elsewhere.end()), viewed(frames));
    for (std::size_t p = 0; p < nearest.size(); ++p) {
        EXPECT_EQ(nearest[p].index, static_cast<std::int64_t>(p));
        EXPECT_LT(nearest[p].distance, 3e-6);
    }
}

TEST(NearestPoses, AreNoneWhereThereIsNothingToChooseFrom)
{
    const std::vector<Frame> frames = poses(2, 0.3);
    EXPECT_EQ(nearestPoses(viewed(frames), {}).at(1).index, -1);
    EXPECT_TRUE(nearestPoses({}, viewed(frames)).empty());
}

TEST(NearestPoses, StopWhenCancelled)
{
    const std::vector<Frame> frames = poses(2, 0.3);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(test::codeOf([&] { nearestPoses(viewed(frames), viewed(frames), Progress(token)); }),
              ErrorCode::Cancelled);
}
