// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/projection/textureprojector.h"
#include "tests/model/projection/photographs.h"
#include "tests/model/render/scenes.h"

#include <array>
#include <atomic>
#include <cmath>
#include <gmock/gmock.h>
#include <numeric>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::DoubleNear;
using ::testing::Each;

namespace {

using Picture = std::shared_ptr<const Image>;

Picture evenPicture(int width, int height, std::uint8_t value)
{
    Image image(width, height);
    std::ranges::fill(image.pixels, value);
    return std::make_shared<const Image>(std::move(image));
}

/// No two of its neighbours are alike.
Image mottled(int width, int height)
{
    Image image(width, height);
    std::uint32_t state = 1;
    for (std::uint8_t& value : image.pixels)
        value = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24);
    return image;
}

/// A ball in the middle of a ring of cameras.
class SeenBall : public ::testing::Test
{
protected:
    SeenBall()
        : sequence(ball(48, 1))
        , frame(sequence.frame(FrameIndex(0)))
        , cameras(ringOfCameras(boundsOf(sequence), 5, 1))
    {
    }

    ProjectedTexels project(const std::vector<Picture>& pictures, const Progress& progress = {}) const
    {
        return TextureProjector(sequence.topology, pinholesOf(cameras, side, side), 128, 64)
            .project(frame.positions(), pictures, progress);
    }

    static constexpr int side = 240;
    MeshSequence sequence;
    Frame frame;
    std::vector<Camera> cameras;
};

} // namespace

TEST(TextureProjector, GivesATextureBackThatACameraSeesFromTheFront)
{
    // A sheet of 64 × 64 in the middle of 128 × 128 pixels, each of which is a texel.
    const auto mesh = std::make_shared<const Topology>(quadTopology());
    const std::vector<Vec3f> positions = quadPositions(-32, -32, 32, 32);
    const Image texture = mottled(64, 64);
    auto picture = std::make_shared<Image>(128, 128);
    for (int y = 0; y < 64; ++y)
        std::copy_n(texture.pixel(0, y), 4 * 64, picture->pixel(32, y + 32));
    const TextureProjector projector(mesh, {pinholeOf(unitCamera(64), 128, 128)}, 64, 64);
    const ProjectedTexels projected = projector.project(positions, std::vector<Picture>{picture});
    EXPECT_GE(projected.seen, 60 * 60);
    EXPECT_EQ(projected.sights, projected.seen);
    int differing = 0;
    for (std::size_t t = 0; t < projected.colours.size(); ++t) {
        const ProjectedTexels::Colour& colour = projected.colours[t];
        const std::uint8_t* wanted = texture.pixels.data() + 4 * projector.atlas().places[t].texel;
        if (colour.trust > 0 &&
            (colour.red != wanted[0] || colour.green != wanted[1] || colour.blue != wanted[2]))
            ++differing;
    }
    EXPECT_EQ(differing, 0);
}

TEST(TextureProjector, TakesTheMeanOfWhatIsFinerThanATexel)
{
    // Texels of eight pixels, of which those in the middle are white.
    const auto mesh = std::make_shared<const Topology>(quadTopology());
    auto picture = std::make_shared<Image>(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            std::fill_n(picture->pixel(x, y), 4,
                        static_cast<std::uint8_t>(x % 8 == 3 || x % 8 == 4 ? 255 : 0));
    const TextureProjector projector(mesh, {pinholeOf(unitCamera(128), 256, 256)}, 16, 16);
    const ProjectedTexels projected =
        projector.project(quadPositions(-64, -64, 64, 64), std::vector<Picture>{picture});
    EXPECT_EQ(projected.seen, 256);
    // Near the edges of the sheet samples are finer, so that they do not reach over them.
    for (std::size_t t = 0; t < projected.colours.size(); ++t)
        if (std::min({t % 16, 15 - t % 16, t / 16, 15 - t / 16}) >= 3) {
            EXPECT_NEAR(int{projected.colours[t].red}, 64, 2) << t;
        }
}

TEST(TextureProjector, KeepsApartWhatLiesInFrontAndBehind)
{
    // A black card before a white wall, in the right and the left half of the atlas. Texels have 25 pixels.
    TopologyData data = quadTopology();
    data.vertexCount = 8;
    for (std::size_t t = 0; t < 2; ++t) {
        Triangle card = data.triangles[t];
        for (VertexIndex& corner : card)
            corner.value += 4;
        data.triangles.push_back(card);
        data.triangleUvs.push_back(data.triangleUvs[t]);
        for (std::uint32_t& uv : data.triangleUvs.back())
            uv += 4;
    }
    data.uvs = {{0, 0}, {0.5F, 0}, {0.5F, 1}, {0, 1}, {0.5F, 0}, {1, 0}, {1, 1}, {0.5F, 1}};
    std::vector<Vec3f> positions = quadPositions(-20, -20, 20, 20);
    const std::vector<Vec3f> card = quadPositions(-4, -4, 4, 4, 10);
    positions.insert(positions.end(), card.begin(), card.end());
    auto picture = std::make_shared<Image>(400, 400);
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x)
            std::fill_n(
                picture->pixel(x, y), 4,
                static_cast<std::uint8_t>(std::max(std::abs(x - 199.5), std::abs(y - 199.5)) < 80 ? 0 : 255));
    const TextureProjector projector(std::make_shared<const Topology>(data),
                                     {pinholeOf(unitCamera(20), 400, 400)}, 32, 16);
    const ProjectedTexels projected = projector.project(positions, std::vector<Picture>{picture});
    std::array<int, 2> seen{};
    for (std::size_t t = 0; t < projected.colours.size(); ++t) {
        const bool isCard = projector.atlas().places[t].texel % 32 >= 16;
        if (projected.colours[t].trust == 0)
            continue;
        EXPECT_EQ(int{projected.colours[t].red}, isCard ? 0 : 255);
        ++seen[isCard ? 1 : 0];
    }
    EXPECT_EQ(seen[0], 256 - 36); // all but those behind the card
    EXPECT_EQ(seen[1], 256);
}

TEST(TextureProjector, BlendsInLinearLight)
{
    // Two cameras that see a point from the left and the right alike, one in black and one in white.
    const auto mesh = std::make_shared<const Topology>(quadTopology());
    std::vector<PinholeCamera> cameras;
    for (const double x : {-30.0, 30.0}) {
        Camera camera = unitCamera(60);
        camera.eye.x() = x;
        cameras.push_back(pinholeOf(camera, 400, 400));
    }
    const TextureProjector projector(mesh, cameras, 9, 9);
    const ProjectedTexels projected =
        projector.project(quadPositions(-9, -9, 9, 9),
                          std::vector<Picture>{evenPicture(400, 400, 0), evenPicture(400, 400, 255)});
    EXPECT_EQ(projected.seen, 81);
    EXPECT_EQ(projected.sights, 162);
    EXPECT_NEAR(int{projected.colours[40].red}, 188, 1); // half the light, and not 128
    EXPECT_THAT(projected.shares, Each(DoubleNear(0.5, 1e-6)));
    EXPECT_LT(int{projected.colours[36].red}, 188);
    EXPECT_GT(int{projected.colours[44].red}, 188);
}

TEST_F(SeenBall, HasWeightsThatAddUpToOne)
{
    const std::vector<Picture> pictures(cameras.size(), evenPicture(side, side, 200));
    const ProjectedTexels projected = project(pictures);
    EXPECT_NEAR(std::accumulate(projected.shares.begin(), projected.shares.end(), 0.0), 1, 1e-6);
    EXPECT_GT(projected.seen, 128 * 64 / 2);
    for (const ProjectedTexels::Colour& colour : projected.colours)
        EXPECT_EQ(int{colour.red}, colour.trust > 0 ? 200 : 0);
}

TEST_F(SeenBall, IsBlendedContinuously)
{
    std::vector<Picture> pictures;
    for (std::size_t c = 0; c < cameras.size(); ++c)
        pictures.push_back(evenPicture(side, side, static_cast<std::uint8_t>(60 + 40 * c)));
    // Texels of a third of a pixel, so that margins of three pixels are slopes and not steps. Where no camera
    // is trusted, colours of others take over by and by.
    const TextureProjector projector(sequence.topology, pinholesOf(cameras, side, side), 1024, 512);
    const ProjectedTexels projected = projector.project(frame.positions(), pictures);
    constexpr int trusted = 26;
    int largest = 0;
    int compared = 0;
    for (std::size_t t = 0; t + 1 < projected.colours.size(); ++t) { // all texels are covered, in rows
        const auto& here = projected.colours[t];
        const auto& next = projected.colours[t + 1];
        if (t % 1024 == 1023 || here.trust < trusted || next.trust < trusted)
            continue;
        largest = std::max(largest, std::abs(int{here.red} - int{next.red}));
        ++compared;
    }
    EXPECT_GT(compared, 1024 * 512 / 2);
    EXPECT_LE(largest, 27); // of 160 within nine texels, half again as steep in their middle
}

TEST_F(SeenBall, DoesNotDependOnThreadsNorOnCamerasWithoutAPicture)
{
    std::vector<Picture> pictures = photographs(sequence, FrameIndex(0), cameras, side, side);
    const ProjectedTexels all = project(pictures);
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(project(pictures).colours, all.colours);
    }
    pictures[1] = nullptr;
    const ProjectedTexels fewer = project(pictures);
    EXPECT_LT(fewer.seen, all.seen);
    EXPECT_EQ(fewer.shares[1], 0);
    const std::vector<Picture> none(cameras.size());
    const ProjectedTexels nothing = project(none);
    EXPECT_EQ(nothing.seen, 0);
    EXPECT_THAT(nothing.shares, Each(0));
    EXPECT_THAT(nothing.colours, Each(ProjectedTexels::Colour()));
}

TEST_F(SeenBall, MayHoldACameraWithinIt)
{
    cameras.front().eye = Vec3d(0, 0.5, 0);
    cameras.front().nearDistance = 0.001;
    const std::vector<Picture> pictures(cameras.size(), evenPicture(side, side, 9));
    EXPECT_EQ(project(pictures).shares.front(), 0); // it sees backs only
}

TEST_F(SeenBall, IsRefusedWhereSomethingIsWrong)
{
    const std::vector<Picture> pictures(cameras.size(), evenPicture(side, side, 9));
    std::vector<Picture> other = pictures;
    other[2] = evenPicture(side, side + 1, 9);
    EXPECT_THROW(project(other), Error);
    other.pop_back();
    EXPECT_THROW(project(other), Error);
    std::vector<PinholeCamera> calibrated = pinholesOf(cameras, side, side);
    const TextureProjector projector(sequence.topology, calibrated, 16, 16);
    std::vector<Vec3f> broken(frame.positions().begin(), frame.positions().end());
    broken[7].y() = NAN;
    EXPECT_THROW(projector.project(broken, pictures), Error);
    calibrated[1].fx = -1;
    EXPECT_THROW(TextureProjector(sequence.topology, calibrated, 16, 16), Error);
}

TEST_F(SeenBall, CanBeCancelled)
{
    const std::vector<Picture> pictures(cameras.size(), evenPicture(side, side, 9));
    CancelToken token;
    std::atomic<double> reached = 0;
    const Progress progress(token, [&](double fraction) {
        reached = fraction;
        if (fraction > 0.5)
            token.cancel();
    });
    EXPECT_THROW(project(pictures, progress), Error);
    EXPECT_LT(reached, 1);
}
