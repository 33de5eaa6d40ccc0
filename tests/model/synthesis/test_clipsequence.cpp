// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/retime.h"
#include "tests/model/synthesis/cliptest.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Frames 0 … 19 and 20 … 39 of a character.
std::vector<MeshSequence> twoTakes()
{
    std::vector<MeshSequence> takes = threeTakes();
    takes.pop_back();
    const auto frames = [](int first, int last) { return FrameRange{FrameIndex(first), FrameIndex(last)}; };
    takes[0].labels = {{"walk", frames(0, 19)}, {"wave", frames(2, 3)}};
    takes[1].labels = {{"run", frames(0, 19)}};
    takes[0].contacts = {{"left", frames(0, 5)}, {"right", frames(5, 9)}};
    takes[1].contacts = {{"left", frames(3, 4)}, {"toe", frames(0, 19)}};
    return takes;
}

Clip clipOf(const std::vector<MeshSequence>& takes, const std::vector<FrameProvenance>& origins)
{
    return {.topology = takes[0].topology,
            .fps = 25,
            .positions =
                std::vector<Vec3f>(origins.size() * takes[0].topology->vertexCount(), Vec3f(1, 2, 3)),
            .origins = origins};
}

const std::vector<FrameProvenance> someOrigins{{1, 1}, {2, 2}, {3, 23, 0.4}, {4, 24, 0.5}, {25, 25}, {1, 1}};

std::vector<std::string> filesOf(const TextureSet& set)
{
    std::vector<std::string> files;
    for (const Texture& texture : set.textures())
        files.push_back(texture.file.string());
    return files;
}

std::vector<Texture> texturesNamed(const std::string& name, int count)
{
    std::vector<Texture> textures;
    for (int i = 0; i < count; ++i)
        textures.push_back({name + std::to_string(i), nullptr});
    return textures;
}

/// Makes textures that are called as what they lie between; knows no frame of the take that is not named.
class NamingBlender : public TextureBlender
{
public:
    explicit NamingBlender(std::string unknown = {}) : m_unknown(std::move(unknown)) {}

    Texture between(const CapturedTexture& first, const CapturedTexture& second, double weight) const override
    {
        if (first.sequence == m_unknown || second.sequence == m_unknown)
            return {};
        return {nameOf(first) + "-" + nameOf(second) + "-" + std::to_string(std::lround(100 * weight)),
                nullptr};
    }
    Texture inPlaceOf(const CapturedTexture& texture) const override
    {
        return texture.sequence == "a" && texture.frame == FrameIndex(2) ? Texture{"completed", nullptr}
                                                                         : Texture();
    }
    Texture ofPose(const std::shared_ptr<const FrameSource>& poses, FrameIndex frame, double share,
                   const Texture& captured) const override
    {
        if (m_unknown == "poses")
            return {};
        EXPECT_LT(frame.value, poses->frameCount());
        return {"pose" + std::to_string(frame.value) + "-" + std::to_string(std::lround(100 * share)) + "-" +
                    captured.file.string(),
                nullptr};
    }

private:
    static std::string nameOf(const CapturedTexture& texture)
    {
        return texture.sequence + std::to_string(texture.frame.value) + "=" + texture.texture.file.string();
    }

    std::string m_unknown;
};

/// The two takes with a texture per frame, called a and b; the first has lost a frame.
std::vector<MeshSequence> texturedTakes(const std::shared_ptr<const TextureBlender>& blender)
{
    std::vector<MeshSequence> takes = twoTakes();
    takes[0].name = "a";
    takes[1].name = "b";
    takes[0].textures = TextureSet::perFrame(texturesNamed("x", 20)).blendedBy(blender);
    takes[1].textures = TextureSet::perFrame(texturesNamed("y", 20)).blendedBy(blender);
    takes[0].range = {FrameIndex(1), FrameIndex(19)};
    return takes;
}

FrameRange frames(int first, int last)
{
    return {FrameIndex(first), FrameIndex(last)};
}

} // namespace

TEST(ClipSequence, HasTheFramesOfTheClip)
{
    const std::vector<MeshSequence> takes = twoTakes();
    const Clip clip = clipOf(takes, someOrigins);
    const MeshSequence sequence = toSequence("mix", clip, CharacterFrames(takes));
    EXPECT_EQ(sequence.name, "mix");
    EXPECT_EQ(sequence.frameCount(), 6);
    EXPECT_EQ(sequence.fps, 25);
    EXPECT_EQ(loadFrames(sequence), clip.positions);
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::None);
}

TEST(ClipSequence, HasTheLabelsOfTheNearerFrame)
{
    const std::vector<MeshSequence> takes = twoTakes();
    const MeshSequence sequence = toSequence("mix", clipOf(takes, someOrigins), CharacterFrames(takes));
    EXPECT_EQ(
        sequence.labels,
        (std::vector<LabelSpan>{
            {"walk", frames(0, 2)}, {"wave", frames(1, 2)}, {"run", frames(3, 4)}, {"walk", frames(5, 5)}}));
}

TEST(ClipSequence, StandsAsTheFrameThatCountsMore)
{
    const std::vector<MeshSequence> takes = twoTakes();
    Clip clip = clipOf(takes, someOrigins);
    EXPECT_EQ(
        toSequence("mix", clip, CharacterFrames(takes)).contacts,
        (std::vector<ContactSpan>{{"left", frames(0, 3)}, {"toe", frames(3, 4)}, {"left", frames(5, 5)}}));
    for (FrameProvenance& origin : clip.origins)
        origin.mirrored = true;
    EXPECT_EQ(
        toSequence("mix", clip, CharacterFrames(takes)).contacts,
        (std::vector<ContactSpan>{{"right", frames(0, 3)}, {"toe", frames(3, 4)}, {"right", frames(5, 5)}}));
}

TEST(ClipSequence, SharesOneTexture)
{
    std::vector<MeshSequence> takes = twoTakes();
    for (MeshSequence& take : takes)
        take.textures = TextureSet::single({"skin.png", nullptr});
    const MeshSequence sequence = toSequence("mix", clipOf(takes, someOrigins), CharacterFrames(takes));
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::Single);
    EXPECT_EQ(filesOf(sequence.textures), std::vector<std::string>{"skin.png"});
}

TEST(ClipSequence, SharesTexturesOfMaterials)
{
    std::vector<MeshSequence> takes = twoTakes();
    for (MeshSequence& take : takes)
        take.textures = TextureSet::perMaterial(texturesNamed("m", 2));
    const MeshSequence sequence = toSequence("mix", clipOf(takes, someOrigins), CharacterFrames(takes));
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::PerMaterial);
    EXPECT_EQ(filesOf(sequence.textures), (std::vector<std::string>{"m0", "m1"}));
}

TEST(ClipSequence, HasTheTexturesOfItsLooks)
{
    const std::vector<MeshSequence> takes = texturedTakes(std::make_shared<NamingBlender>());
    Clip clip = clipOf(takes, {{.source = 3, .destination = 3}, {.source = 3, .destination = 3}});
    clip.looks = {{.source = 3, .destination = 25, .lambda = 0.3}, {.source = 4, .destination = 4}};
    const MeshSequence sequence = toSequence("mix", clip, CharacterFrames(takes));
    EXPECT_EQ(filesOf(sequence.textures), (std::vector<std::string>{"a3=x4-b6=y6-30", "x5"}));
}

TEST(ClipSequence, TakesTheTextureOfTheNearerFrame)
{
    std::vector<MeshSequence> takes = twoTakes();
    takes[0].textures = TextureSet::perFrame(texturesNamed("a", 22));
    takes[0].range = frames(2, 19);
    takes[1].textures = TextureSet::single({"b", nullptr});
    // The first take has lost two frames: frames 18 … 37 are those of the second.
    const MeshSequence sequence = toSequence("mix", clipOf(takes, someOrigins), CharacterFrames(takes));
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::PerFrame);
    EXPECT_EQ(filesOf(sequence.textures), (std::vector<std::string>{"a3", "a4", "a5", "b", "b", "a3"}));
    EXPECT_EQ(sequence.textures.indexFor(FrameIndex(3)), 3);
    takes[1].textures = {};
    const MeshSequence without = toSequence("mix", clipOf(takes, someOrigins), CharacterFrames(takes));
    EXPECT_EQ(without.textures.indexFor(FrameIndex(2)), 2);
    EXPECT_EQ(without.textures.indexFor(FrameIndex(3)), -1);
}

TEST(ClipSequence, HasMadeTexturesInFramesBetweenCapturedOnes)
{
    const std::vector<MeshSequence> takes = texturedTakes(std::make_shared<const NamingBlender>());
    // Frame 0 of b is node 19.
    const std::vector<FrameProvenance> origins{{1, 1},       {2, 2},   {3, 22, 0.4},
                                               {4, 23, 0.5}, {24, 24}, {5, 6, 0.25}};
    const MeshSequence sequence = toSequence("mix", clipOf(takes, origins), CharacterFrames(takes));
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::PerFrame);
    EXPECT_EQ(filesOf(sequence.textures),
              (std::vector<std::string>{"x2", "completed", "a3=x4-b3=y3-40", "a4=x5-b4=y4-50", "y5",
                                        "a5=x6-a6=x7-25"}));
}

TEST(ClipSequence, TakesTheNearerTextureWhereTheBlenderKnowsNone)
{
    const std::vector<MeshSequence> takes = texturedTakes(std::make_shared<const NamingBlender>("b"));
    const MeshSequence sequence =
        toSequence("mix", clipOf(takes, {{3, 22, 0.4}, {4, 23, 0.5}, {2, 21, 0.4}}), CharacterFrames(takes));
    EXPECT_EQ(filesOf(sequence.textures), (std::vector<std::string>{"x4", "y4", "completed"}));
}

TEST(ClipSequence, HasMadeTexturesWhereItWasRetimed)
{
    const std::vector<MeshSequence> takes = texturedTakes(std::make_shared<const NamingBlender>());
    const Clip clip = clipOf(takes, {{3, 3}, {4, 4}, {5, 5}});
    const Clip slower = retimed(clip, {.time = RetimeFactor{2}}, UpAxis::Z);
    const MeshSequence sequence = toSequence("slow", slower, CharacterFrames(takes));
    EXPECT_EQ(filesOf(sequence.textures),
              (std::vector<std::string>{"x4", "a3=x4-a4=x5-50", "x5", "a4=x5-a5=x6-50", "x6"}));
}

TEST(ClipSequence, HasTexturesOfPosesInFramesOfVariations)
{
    std::vector<FrameProvenance> origins{{1, 1}, {3, 3, 0.3}, {4, 4}, {3, 22, 0.4}};
    origins[1].destinationVariation = 1;
    origins[2].sourceVariation = origins[2].destinationVariation = 2;
    origins[3].sourceVariation = 1;
    const std::vector<MeshSequence> takes = texturedTakes(std::make_shared<const NamingBlender>());
    EXPECT_EQ(filesOf(toSequence("mix", clipOf(takes, origins), CharacterFrames(takes)).textures),
              (std::vector<std::string>{"x2", "pose1-30-x4", "pose2-100-x5", "pose3-60-a3=x4-b3=y3-40"}));
    const std::vector<MeshSequence> others = texturedTakes(std::make_shared<const NamingBlender>("poses"));
    EXPECT_EQ(filesOf(toSequence("mix", clipOf(others, origins), CharacterFrames(others)).textures),
              (std::vector<std::string>{"x2", "x4", "x5", "a3=x4-b3=y3-40"}));
    const Clip shown = shownAsVariation(clipOf(takes, {{3, 3}, {3, 22, 0.4}}));
    EXPECT_EQ(filesOf(toSequence("mix", shown, CharacterFrames(takes)).textures),
              (std::vector<std::string>{"pose0-100-x4", "pose1-100-a3=x4-b3=y3-40"}));
}

TEST(ClipSequence, SharesOneTextureInVariationsToo)
{
    std::vector<MeshSequence> takes = twoTakes();
    for (MeshSequence& take : takes)
        take.textures = TextureSet::single({"skin.png", nullptr});
    const Clip shown = shownAsVariation(clipOf(takes, someOrigins));
    EXPECT_EQ(toSequence("mix", shown, CharacterFrames(takes)).textures.kind(), TextureSet::Kind::Single);
}
