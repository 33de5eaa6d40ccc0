// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/glbwriter.h"
#include "model/sequence/io/gltf/gltf.h"
#include "model/sequence/io/scene/keyrate.h"
#include "tests/model/sequence/io/sceneiotest.h"
#include "tests/model/sequence/io/testsequence.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// A clip with keys at frames of a rate, as files store them.
SceneClip clipAt(const std::vector<double>& frames, double fps, double start = 0)
{
    SceneClip clip;
    NodeTracks& tracks = clip.tracks.emplace_back();
    for (const double frame : frames)
        tracks.translation.times.push_back(static_cast<double>(static_cast<float>(start + frame / fps)));
    clip.first = tracks.translation.times.front();
    clip.last = tracks.translation.times.back();
    return clip;
}

std::vector<double> firstFrames(int count)
{
    std::vector<double> frames;
    for (int f = 0; f < count; ++f)
        frames.push_back(f);
    return frames;
}

} // namespace

TEST(KeyRate, IsThatOfTheFrames)
{
    for (const double fps : {12.0, 24.0, 25.0, 30.0, 60.0, 120.0, 30000.0 / 1001, 24000.0 / 1001, 17.5}) {
        for (const int count : {5, 50, 2000}) {
            const auto rate = keyRate(clipAt(firstFrames(count), fps, 1 / fps));
            ASSERT_TRUE(rate) << fps << ", " << count;
            EXPECT_NEAR(*rate, fps, count > 40 ? 1e-2 : 0.05) << count;
            EXPECT_TRUE(fps != std::round(fps) || *rate == fps) << *rate << ", " << count;
        }
    }
    EXPECT_EQ(keyRate(clipAt(firstFrames(100), 30000.0 / 1001)), 30000.0 / 1001);
}

TEST(KeyRate, IsFoundWhereFramesAreLeftOut)
{
    EXPECT_EQ(keyRate(clipAt({0, 1, 2, 9, 10, 30}, 30)), 30);
    EXPECT_EQ(keyRate(clipAt({0, 2, 5, 12, 40}, 30)), 30);
    EXPECT_EQ(keyRate(clipAt({0, 3, 5, 12, 40}, 24)), 24);
}

TEST(KeyRate, IsNotMadeUp)
{
    EXPECT_FALSE(keyRate(clipAt({0, 1}, 30))) << "too few";
    EXPECT_FALSE(keyRate(clipAt({0, 1, 2, 3}, 1))) << "seconds";
    EXPECT_FALSE(keyRate(clipAt({0, 1, 2.3, 3.1, 4.45, 7.77}, 30))) << "uneven";
    EXPECT_FALSE(keyRate({}));
}

TEST(KeyRate, IsThatOfTheOtherClipsWhereOneCannotTell)
{
    const SceneClip even = clipAt(firstFrames(20), 30);
    const SceneClip rest = clipAt({0, 9}, 30);
    EXPECT_EQ(keyRates({even, rest}), (std::vector<std::optional<double>>{30, 30}));
    EXPECT_EQ(keyRates({even, rest, clipAt(firstFrames(20), 24)}),
              (std::vector<std::optional<double>>{30, std::nullopt, 24}));
}

TEST(KeyRate, MakesASceneHaveTheFramesThatItWasWrittenWith)
{
    const TemporaryFolder folder;
    MeshSequence sequence = wanderingPyramid(9);
    sequence.fps = 30;
    GlbExporter().write(sequence, folder / "pyramid.glb", {}, {});
    const ImportResult result = GltfImporter().open(fileSource(folder / "pyramid.glb"), {.fps = 25}, {});
    EXPECT_TRUE(result.hasOwnFps);
    EXPECT_EQ(result.sequences.front().fps, 30);
    EXPECT_EQ(result.sequences.front().frameCount(), 9);
}
