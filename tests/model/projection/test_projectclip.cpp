// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/projection/projectclip.h"
#include "tests/model/projection/photographs.h"
#include "tests/model/render/scenes.h"

#include <gmock/gmock.h>
#include <map>
#include <mutex>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Each;
using ::testing::ElementsAre;

namespace {

using TexelColour = ProjectedTexels::Colour;

constexpr TexelColour grey(std::uint8_t value, std::uint8_t trust)
{
    return {value, value, value, trust};
}

/// A sheet that one camera before it sees, and that shows its back in the second of three frames.
class TurningSheet : public ::testing::Test
{
protected:
    TurningSheet()
    {
        std::vector<Vec3f> positions;
        for (const float side : {32.0F, -32.0F, 32.0F}) {
            const std::vector<Vec3f> quad = quadPositions(-side, -32, side, 32);
            positions.insert(positions.end(), quad.begin(), quad.end());
        }
        clip = makeSequence("sheet", std::make_shared<const Topology>(quadTopology()),
                            std::make_shared<MemoryFrames>(positions, 4), 25);
    }

    ProjectedClip project(bool fills, const Progress& progress = {},
                          const Executor& executor = localExecutor())
    {
        textures.clear();
        const TextureProjector projector(clip.topology, {pinholeOf(unitCamera(64), side, side)}, 32, 32);
        return projectClip(
            projector, clip,
            [](std::size_t, FrameIndex frame) {
                Image even(side, side);
                std::ranges::fill(even.pixels, static_cast<std::uint8_t>(100 + 50 * frame.value));
                return std::make_shared<const Image>(std::move(even));
            },
            fills,
            [this](FrameIndex frame, const Image& texture) {
                const std::scoped_lock lock(mutex);
                EXPECT_TRUE(textures.emplace(frame.value, texture).second);
            },
            progress, executor);
    }

    static constexpr int side = 128;
    MeshSequence clip;
    std::mutex mutex;
    std::map<std::int64_t, Image> textures;
};

/// Runs tasks from the last to the first.
class BackwardsExecutor : public Executor
{
public:
    void run(const TaskSet& tasks, const Progress& progress) const override
    {
        for (std::int64_t task = tasks.count - 1; task >= 0; --task)
            tasks.store(task, tasks.compute(task, Progress(progress.token())));
    }
};

} // namespace

TEST(MedianColours, AreOfTheFramesThatSeeATexelWell)
{
    const std::vector<std::vector<TexelColour>> frames{
        {grey(10, 255), grey(10, 0), grey(1, 20), grey(7, 100)},
        {grey(30, 200), grey(20, 0), grey(9, 0), grey(200, 40)},
        {grey(90, 128), grey(30, 0), grey(9, 0), grey(9, 100)},
    };
    EXPECT_THAT(medianColours(frames), ElementsAre(grey(30, 255), TexelColour(), grey(1, 20), grey(7, 100)));
}

TEST(FilledTexture, LetsTheFillShowThroughWhatIsTrustedLittle)
{
    AtlasTexels atlas{.width = 6, .height = 1};
    for (std::uint32_t texel = 0; texel < 4; ++texel)
        atlas.places.push_back({texel, TriangleIndex(0), Vec2f::Zero()});
    const std::vector<TexelColour> texels{grey(200, 255), grey(200, 128), grey(0, 0), grey(0, 0)};
    const std::vector<TexelColour> fill{grey(100, 255), grey(100, 255), grey(100, 255), grey(0, 0)};
    const auto reds = [](const Image& image) {
        std::vector<int> values;
        for (int x = 0; x < image.width; ++x) {
            EXPECT_EQ(image.pixel(x, 0)[3], 255);
            values.push_back(image.pixel(x, 0)[0]);
        }
        return values;
    };
    // Half of the light of 200 and of 100 is that of 160, as 128 is a little more than half of 255.
    EXPECT_THAT(reds(filledTexture(atlas, texels, fill)), ElementsAre(200, 160, 100, 100, 100, 100));
    EXPECT_THAT(reds(filledTexture(atlas, texels, {})), ElementsAre(200, 200, 0, 0, 0, 0));
}

TEST_F(TurningSheet, TakesFromOtherFramesWhatNoCameraSees)
{
    const ProjectedClip projected = project(true);
    ASSERT_EQ(textures.size(), 3U);
    ASSERT_EQ(projected.frames.size(), 3U);
    EXPECT_GT(projected.frames[0].seen, 0.85);
    EXPECT_EQ(projected.frames[1].seen, 0);
    EXPECT_EQ(projected.frames[1].cameras, 0);
    EXPECT_EQ(projected.frames[0].cameras, 1);
    EXPECT_THAT(projected.frames[0].shares, ElementsAre(::testing::DoubleNear(1, 1e-6)));
    EXPECT_EQ(projected.timesSeen[16 * 32 + 16], 2);
    const auto middle = [this](std::int64_t frame) { return int{textures.at(frame).pixel(16, 16)[0]}; };
    EXPECT_EQ(middle(0), 100);
    EXPECT_EQ(middle(1), 100); // the lower median of 100 and 200
    EXPECT_EQ(middle(2), 200);
    EXPECT_EQ(int{textures.at(1).pixel(0, 0)[0]}, 100); // seen by none, as its neighbours
}

TEST_F(TurningSheet, MayStayUnfilled)
{
    project(false);
    EXPECT_EQ(int{textures.at(0).pixel(16, 16)[0]}, 100);
    EXPECT_EQ(int{textures.at(1).pixel(16, 16)[0]}, 0);
    EXPECT_EQ(int{textures.at(1).pixel(16, 16)[3]}, 255);
}

TEST_F(TurningSheet, DoesNotDependOnTheExecutor)
{
    const ProjectedClip projected = project(true);
    const auto before = textures;
    const ProjectedClip again = project(true, {}, BackwardsExecutor());
    EXPECT_EQ(textures, before);
    EXPECT_EQ(again.timesSeen, projected.timesSeen);
}

TEST_F(TurningSheet, CanBeCancelled)
{
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.4)
            token.cancel();
    });
    EXPECT_THROW(project(true, progress), Error);
    EXPECT_LT(textures.size(), 3U);
}
