// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace quadrille;

namespace {

/// A triangle that rises by one metre a frame; frame f has its corners at height f.
MeshSequence rising(std::int64_t frames, double fps)
{
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frames; ++f) {
        const auto height = static_cast<float>(f);
        positions.insert(positions.end(), {Vec3f(0, height, 0), Vec3f(1, height, 0), Vec3f(0, height, 1)});
    }
    auto topology = std::make_shared<const Topology>(
        TopologyData{.vertexCount = 3, .triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}}});
    return makeSequence("rising", topology, std::make_shared<MemoryFrames>(std::move(positions), 3), fps);
}

float height(const MeshSequence& sequence, std::int64_t frame)
{
    return sequence.frame(FrameIndex(frame)).positions()[0].y();
}

} // namespace

TEST(MeshSequence, CutsFramesLabelsAndContacts)
{
    auto sequence = rising(10, 25);
    sequence.labels = {{"walk", {FrameIndex(0), FrameIndex(4)}}, {"run", {FrameIndex(5), FrameIndex(9)}}};
    sequence.contacts = {{"left", {FrameIndex(8), FrameIndex(9)}}};
    const auto cut = sequence.cutTo({FrameIndex(3), FrameIndex(6)});
    EXPECT_EQ(cut.frameCount(), 4);
    EXPECT_EQ(height(cut, 0), 3);
    EXPECT_EQ(height(cut.cutTo({FrameIndex(1), FrameIndex(1)}), 0), 4);
    EXPECT_EQ(cut.labels, (std::vector<LabelSpan>{{"walk", {FrameIndex(0), FrameIndex(1)}},
                                                  {"run", {FrameIndex(2), FrameIndex(3)}}}));
    EXPECT_TRUE(cut.contacts.empty());
}

TEST(MeshSequence, RefusesARangeOutside)
{
    const auto sequence = rising(3, 25);
    EXPECT_THROW(sequence.cutTo({FrameIndex(0), FrameIndex(3)}), Error);
    EXPECT_THROW(sequence.cutTo({FrameIndex(-1), FrameIndex(1)}), Error);
    EXPECT_THROW(sequence.cutTo({FrameIndex(2), FrameIndex(1)}), Error);
}

TEST(MeshSequence, ResamplesLinearlyInTime)
{
    const auto faster = resampled(rising(5, 25), 50);
    EXPECT_EQ(faster.frameCount(), 9);
    for (int f = 0; f < 9; ++f)
        EXPECT_FLOAT_EQ(height(faster, f), 0.5F * static_cast<float>(f));
    const auto slower = resampled(rising(121, 120), 30);
    EXPECT_EQ(slower.frameCount(), 31);
    EXPECT_FLOAT_EQ(height(slower, 30), 120);
}

TEST(MeshSequence, ResamplesOnlyItsRange)
{
    const auto cut = rising(10, 25).cutTo({FrameIndex(4), FrameIndex(6)});
    const auto faster = resampled(cut, 50);
    EXPECT_EQ(faster.frameCount(), 5);
    EXPECT_FLOAT_EQ(height(faster, 1), 4.5F);
    EXPECT_FLOAT_EQ(height(faster, 4), 6);
}

TEST(MeshSequence, RefusesImpossibleRates)
{
    EXPECT_THROW(resampled(rising(3, 25), 0), Error);
    EXPECT_THROW(resampled(rising(3, 25), std::numeric_limits<double>::quiet_NaN()), Error);
}

TEST(MeshSequence, ReportsFrameAndVertexOfABadCoordinate)
{
    std::vector<Vec3f> positions(6, Vec3f::Zero());
    positions[4].z() = std::numeric_limits<float>::infinity();
    auto topology = rising(1, 25).topology;
    const auto sequence = makeSequence("bad", topology, std::make_shared<MemoryFrames>(positions, 3), 25);
    EXPECT_NO_THROW(sequence.frame(FrameIndex(0)));
    try {
        sequence.frame(FrameIndex(1));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::NonFiniteCoordinate);
        EXPECT_EQ(error.context().place.frame, FrameIndex(1));
        EXPECT_EQ(error.context().values.at(0).second, "1");
    }
    EXPECT_THROW(loadFrames(sequence), Error);
}

TEST(MeshSequence, LoadsAllFramesAndCanBeCancelled)
{
    const auto sequence = rising(4, 25).cutTo({FrameIndex(1), FrameIndex(3)});
    const auto all = loadFrames(sequence);
    ASSERT_EQ(all.size(), 9U);
    EXPECT_EQ(all[6].y(), 3);
    CancelToken token;
    token.cancel();
    EXPECT_THROW(loadFrames(sequence, Progress(token)), Error);
}

TEST(Axes, ConvertsUpAndUnits)
{
    const Eigen::Matrix3f m = conversionMatrix({UpAxis::Z, 0.01}, {UpAxis::Y, 1.0});
    EXPECT_TRUE((m * Vec3f(100, 200, 300)).isApprox(Vec3f(1, 3, -2)));
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const Eigen::Matrix3f there = conversionMatrix({up, 1}, {UpAxis::Z, 1});
        Vec3f axis = Vec3f::Zero();
        axis[static_cast<int>(up)] = 1;
        EXPECT_TRUE((there * axis).isApprox(Vec3f::UnitZ()));
        EXPECT_NEAR(there.determinant(), 1, 1e-6);
    }
}
