// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/render/renderframe.h"
#include "reference.h"
#include "scenes.h"

#include <array>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Each texel another colour.
std::shared_ptr<const Image> checks(int width, int height)
{
    auto image = std::make_shared<Image>(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = image->pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(x * 37 + y * 11);
            pixel[1] = static_cast<std::uint8_t>(x * 5 + y * 59 + 3);
            pixel[2] = static_cast<std::uint8_t>((x ^ y) * 16);
            pixel[3] = 255;
        }
    }
    return image;
}

MeshSequence texturedQuad(float x0, float y0, float x1, float y1, std::shared_ptr<const Image> texture)
{
    auto sequence = makeSequence("quad", std::make_shared<const Topology>(quadTopology()),
                                 std::make_shared<MemoryFrames>(quadPositions(x0, y0, x1, y1), 4), 25);
    if (texture)
        sequence.textures = TextureSet::single({{}, std::move(texture)});
    return sequence;
}

RenderOptions flat(int size)
{
    RenderOptions options;
    options.width = options.height = size;
    options.supersampling = 1;
    options.shading = RenderOptions::Shading::Flat;
    options.background = RenderOptions::Background::Transparent;
    options.grid = options.shadow = false;
    return options;
}

std::vector<int> rgba(const Image& image, int x, int y)
{
    const std::uint8_t* pixel = image.pixel(x, y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

} // namespace

TEST(RenderFrame, ShowsTexelsExactlyWhereOneTexelIsOnePixel)
{
    const auto texture = checks(12, 12);
    const auto image =
        renderFrame(texturedQuad(-6, -6, 6, 6, texture), FrameIndex(0), unitCamera(8), flat(16));
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x)
            EXPECT_EQ(rgba(image, x + 2, y + 2), rgba(*texture, x, y)) << x << ", " << y;
    }
    EXPECT_EQ(rgba(image, 1, 8), (std::vector<int>{0, 0, 0, 0}));
}

TEST(RenderFrame, TakesMeansOfTexelsWhereTheyAreSmallerThanPixels)
{
    const auto texture = checks(24, 24);
    const auto image =
        renderFrame(texturedQuad(-6, -6, 6, 6, texture), FrameIndex(0), unitCamera(8), flat(16));
    for (int i = 0; i < 3; ++i) {
        const int mean = (texture->pixel(4, 6)[i] + texture->pixel(5, 6)[i] + texture->pixel(4, 7)[i] +
                          texture->pixel(5, 7)[i] + 2) /
                         4;
        EXPECT_NEAR(image.pixel(4, 5)[i], mean, 1);
    }
}

TEST(RenderFrame, TakesTheTextureOfTheMaterialAndOfTheFrame)
{
    const auto plain = [](std::uint8_t red) {
        auto image = std::make_shared<Image>(2, 2);
        for (std::size_t i = 0; i < image->pixels.size(); i += 4) {
            image->pixels[i] = red;
            image->pixels[i + 3] = 255;
        }
        return Texture{{}, image};
    };
    TopologyData data = quadTopology();
    data.materials = {"a", "b"};
    data.triangleMaterials = {0, 1};
    auto positions = quadPositions(-6, -6, 6, 6);
    const auto again = positions;
    positions.insert(positions.end(), again.begin(), again.end());
    auto sequence = makeSequence("quad", std::make_shared<const Topology>(data),
                                 std::make_shared<MemoryFrames>(positions, 4), 25);
    sequence.textures = TextureSet::perMaterial({plain(10), plain(20)});
    auto image = renderFrame(sequence, FrameIndex(0), unitCamera(8), flat(16));
    EXPECT_EQ(image.pixel(11, 11)[0], 10); // lower right triangle
    EXPECT_EQ(image.pixel(4, 4)[0], 20);
    sequence.textures = TextureSet::perFrame({plain(30), plain(40)});
    image = renderFrame(sequence, FrameIndex(0), unitCamera(8), flat(16));
    EXPECT_EQ(image.pixel(11, 11)[0], 30);
    image = renderFrame(sequence, FrameIndex(1), unitCamera(8), flat(16));
    EXPECT_EQ(image.pixel(4, 4)[0], 40);
    sequence = sequence.cutTo({FrameIndex(1), FrameIndex(1)});
    image = renderFrame(sequence, FrameIndex(0), unitCamera(8), flat(16));
    EXPECT_EQ(image.pixel(4, 4)[0], 40);
}

TEST(RenderFrame, ShowsClayWithoutTextureOrUvs)
{
    auto options = flat(16);
    options.shading = RenderOptions::Shading::Textured;
    const auto untextured =
        renderFrame(texturedQuad(-6, -6, 6, 6, nullptr), FrameIndex(0), unitCamera(8), options);
    auto sequence = texturedQuad(-6, -6, 6, 6, checks(4, 4));
    TopologyData data = quadTopology();
    data.uvs.clear();
    data.triangleUvs.clear();
    sequence.topology = std::make_shared<const Topology>(data);
    const auto withoutUvs = renderFrame(sequence, FrameIndex(0), unitCamera(8), options);
    options.shading = RenderOptions::Shading::Clay;
    const auto clay =
        renderFrame(texturedQuad(-6, -6, 6, 6, checks(4, 4)), FrameIndex(0), unitCamera(8), options);
    EXPECT_EQ(untextured, clay);
    EXPECT_EQ(withoutUvs, clay);
    EXPECT_GT(clay.pixel(8, 8)[0], 80);
}

TEST(RenderFrame, LightsBothSidesOfASurface)
{
    auto options = flat(16);
    options.shading = RenderOptions::Shading::Clay;
    const auto sequence = texturedQuad(-6, -6, 6, 6, nullptr);
    const auto front = renderFrame(sequence, FrameIndex(0), unitCamera(8), options);
    const auto back = renderFrame(sequence, FrameIndex(0), turned(unitCamera(8), UpAxis::Y, 0.5), options);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(front.pixel(8, 8)[i], back.pixel(8, 8)[i], 1);
}

TEST(RenderFrame, SmoothsEdgesBySupersampling)
{
    // The quad ends in the middle of a column of pixels: half of each is covered.
    auto options = flat(16);
    options.supersampling = 2;
    const auto image =
        renderFrame(texturedQuad(-6, -6, 5.5F, 6, checks(4, 4)), FrameIndex(0), unitCamera(8), options);
    EXPECT_EQ(image.pixel(12, 8)[3], 255);
    EXPECT_EQ(image.pixel(13, 8)[3], 128);
    EXPECT_EQ(image.pixel(14, 8)[3], 0);
}

TEST(RenderFrame, CastsAShadowOnTheGroundAndDrawsAGrid)
{
    const auto sequence = ball(24, 1);
    RenderOptions options;
    options.width = 160;
    options.height = 120;
    const Camera camera =
        frameAll(boundsOf(sequence), {.direction = {0, 0.6, 1}, .aspect = 4.0 / 3, .margin = 0.25});
    const auto both = renderFrame(sequence, FrameIndex(0), camera, options);
    options.shadow = false;
    const auto grid = renderFrame(sequence, FrameIndex(0), camera, options);
    options.grid = false;
    const auto none = renderFrame(sequence, FrameIndex(0), camera, options);
    int darker = 0;
    int lines = 0;
    for (std::size_t i = 0; i < both.pixels.size(); i += 4) {
        darker += both.pixels[i] + 8 < grid.pixels[i];
        EXPECT_LE(both.pixels[i], grid.pixels[i]);
        lines += grid.pixels[i] > none.pixels[i] + 12;
    }
    EXPECT_GT(darker, 300);
    EXPECT_GT(lines, 100);
}

TEST(RenderFrame, HidesWhatIsUnderTheGround)
{
    const auto sequence = ball(24, 1);
    RenderOptions options;
    options.width = options.height = 64;
    options.background = RenderOptions::Background::Transparent;
    options.shadow = true;
    const Camera camera = frameAll(boundsOf(sequence), {.direction = {0, 0.3, 1}});
    const auto whole = renderFrame(sequence, FrameIndex(0), camera, options);
    options.groundHeight = 0.5;
    const auto half = renderFrame(sequence, FrameIndex(0), camera, options);
    EXPECT_EQ(whole.pixel(32, 43)[3], 255);
    EXPECT_LT(half.pixel(32, 43)[3], 200);
    EXPECT_EQ(half.pixel(32, 24)[3], 255);
}

TEST(RenderFrame, RefusesSizesThatCannotBeDrawn)
{
    const auto sequence = ball(4, 1);
    for (const auto& [width, height, samples] :
         {std::array{0, 10, 2}, std::array{10, -1, 2}, std::array{9000, 10, 2}, std::array{10, 10, 0},
          std::array{10, 10, 5}}) {
        RenderOptions options;
        options.width = width;
        options.height = height;
        options.supersampling = samples;
        try {
            renderFrame(sequence, FrameIndex(0), Camera{}, options);
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        }
    }
}

TEST(RenderFrame, IsTheSameForAnyNumberOfThreadsAndOnEveryMachine)
{
    const auto sequence = ball(60, 3);
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    const Camera camera = frameAll(boundsOf(sequence), {.aspect = 4.0 / 3});
    const auto drawWith = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return renderFrame(sequence, FrameIndex(1), camera, options);
    };
    const auto image = drawWith(1);
    EXPECT_EQ(image, drawWith(4));
    // Changes only where the look of pictures changes on purpose.
    EXPECT_EQ(hashOf(image), 1086411312724370276ULL)
        << "look at the picture before taking the new value over";
}

TEST(RenderFrame, AgreesWithThePlainestRasteriser)
{
    RenderOptions options = flat(300);
    options.width = 400;
    const auto texture = smoothTexture(64, 32);
    for (const bool isBall : {true, false}) {
        auto sequence = isBall ? ball(40, 1) : wavySheet(50);
        sequence.textures = TextureSet::single({{}, texture});
        const Camera camera = frameAll(boundsOf(sequence), {.aspect = 4.0 / 3});
        const auto picture = renderFrame(sequence, FrameIndex(0), camera, options);
        const auto plain = plainPicture(sequence.frame(FrameIndex(0)).positions(), sequence.topology->data(),
                                        *texture, camera, options.width, options.height);
        int seen = 0;
        int different = 0;
        for (std::size_t i = 0; i < plain.pixels.size(); i += 4) {
            EXPECT_EQ(picture.pixels[i + 3], plain.pixels[i + 3]);
            seen += plain.pixels[i + 3] == 255;
            for (std::size_t k = i; k < i + 3; ++k)
                different += std::abs(picture.pixels[k] - plain.pixels[k]) > 1;
        }
        EXPECT_GT(seen, 20000);
        // The ball's rim and poles show texels smaller than pixels, where the real one takes means.
        EXPECT_LE(different, isBall ? seen / 50 : 0);
    }
}

TEST(RenderFrame, DrawsRealCapturesWithTheirTextures)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/liam";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no real captures at " << folder;
    // Its texture on a quad: the reader, the scaled texture and the picture agree in their mean.
    const auto texture = std::make_shared<const Image>(readImage(folder / "texture.jpg"));
    auto sequence = texturedQuad(-8, -8, 8, 8, texture);
    const auto image = renderFrame(sequence, FrameIndex(0), unitCamera(8), flat(16));
    double wanted = 0;
    double found = 0;
    for (std::size_t i = 0; i < texture->pixels.size(); i += 4)
        wanted += texture->pixels[i];
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        found += image.pixels[i];
    EXPECT_NEAR(found / (16 * 16), wanted * 4 / static_cast<double>(texture->pixels.size()), 1.5);
}
