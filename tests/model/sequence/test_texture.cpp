// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/meshsequence.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

class NoBlender : public TextureBlender
{
public:
    Texture between(const CapturedTexture& /*first*/, const CapturedTexture& /*second*/,
                    double /*weight*/) const override
    {
        return {};
    }
    Texture inPlaceOf(const CapturedTexture& /*texture*/) const override { return {}; }
    Texture ofPose(const std::shared_ptr<const FrameSource>& /*poses*/, FrameIndex /*frame*/,
                   double /*share*/, const Texture& /*captured*/) const override
    {
        return {};
    }
};

/// A picture of one pixel that counts how often it is made.
Texture countingTexture(int& times)
{
    return {.made = [&times] {
        ++times;
        Image image(1, 1);
        image.pixels = {7, 8, 9, 255};
        return image;
    }};
}

MeshSequence triangleOf(std::int64_t frames)
{
    auto topology = std::make_shared<const Topology>(
        TopologyData{.vertexCount = 3, .triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}}});
    return makeSequence(
        "triangle", topology,
        std::make_shared<MemoryFrames>(std::vector<Vec3f>(static_cast<std::size_t>(3 * frames)), 3), 10);
}

} // namespace

TEST(Texture, IsMadeWhenItIsAskedFor)
{
    int times = 0;
    const Texture texture = countingTexture(times);
    EXPECT_FALSE(texture.isEmpty());
    EXPECT_TRUE(Texture().isEmpty());
    EXPECT_EQ(times, 0);
    EXPECT_EQ(texture.load()->pixels, (decltype(Image::pixels){7, 8, 9, 255}));
    EXPECT_EQ(times, 1);
}

TEST(Texture, ThatIsMadeStaysInTheCacheAsLongAsThereIsRoom)
{
    int times = 0;
    const TextureSet set = TextureSet::perFrame({countingTexture(times), countingTexture(times)});
    MediaCache roomy(1000);
    EXPECT_EQ(set.image(0, roomy), set.image(0, roomy));
    EXPECT_EQ(times, 1);
    set.image(1, roomy);
    EXPECT_EQ(times, 2);
    MediaCache small(4);
    for (int i = 0; i < 4; ++i)
        set.image(i % 2, small);
    EXPECT_EQ(times, 6) << "room for one of the two";
}

TEST(Texture, ThatCannotBeMadeTellsWhoAsks)
{
    const TextureSet set = TextureSet::perFrame({{.made = []() -> Image {
        throw Error(ErrorCode::FileNotFound, {"gone.png", {}, {}});
    }}});
    MediaCache cache(1000);
    EXPECT_THROW(set.image(0, cache), Error);
    EXPECT_THROW(set.image(0, cache), Error) << "the cache keeps no failure";
}

TEST(TextureSet, HasAFileThatComesAgainOnce)
{
    const Texture walk{"walk.png", nullptr};
    const Texture made{{}, nullptr, [] { return Image(1, 1); }};
    const Texture untold{"walk.png", nullptr, {}, ColourMarks::Ignored};
    const TextureSet set = TextureSet::perFrame({walk, {"run.png", nullptr}, walk, made, made, untold, {}});
    std::vector<int> indices;
    for (int frame = -1; frame < 8; ++frame)
        indices.push_back(set.indexFor(FrameIndex(frame)));
    EXPECT_EQ(indices, (std::vector<int>{-1, 0, 1, 0, 3, 4, 5, -1, -1}));
}

TEST(TextureSet, KeepsItsBlenderWhenASequenceIsCutOrResampled)
{
    MeshSequence sequence = triangleOf(9);
    std::vector<Texture> textures;
    for (int f = 0; f < 9; ++f)
        textures.push_back({std::to_string(f), nullptr});
    const auto blender = std::make_shared<const NoBlender>();
    sequence.textures = TextureSet::perFrame(textures).blendedBy(blender);
    EXPECT_EQ(sequence.textures.blender(), blender);
    EXPECT_EQ(sequence.cutTo({FrameIndex(2), FrameIndex(8)}).textures.blender(), blender);
    const MeshSequence slower = resampled(sequence.cutTo({FrameIndex(2), FrameIndex(8)}), 5);
    EXPECT_EQ(slower.textures.blender(), blender);
    EXPECT_EQ(slower.textures.textures().at(1).file, "4");
    EXPECT_EQ(transformed(slower, Eigen::Matrix3f::Identity()).textures.blender(), blender);
}
