// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Textures between two frames of the sample, of which it is known how far each is shifted.
#include "model/appearance/buildappearance.h"
#include "model/appearance/modeltextures.h"
#include "model/appearance/texturequality.h"
#include "model/sample/appearance.h"
#include "model/sample/texelmap.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

constexpr int side = 256; // half of what the sample is written with; what shifts them is in proportion
constexpr std::int64_t frameStep = 6;

/// What the texture of a frame was made of.
struct Baked
{
    std::vector<Vec3f> posed;
    SampleLight light;
    SampleWarp warp;
};

class SampleTextures : public ::testing::Test
{
protected:
    SampleTextures()
        : sample(makeSampleCharacter({.textureSize = 2 * side, .takesPerKind = 1}))
        , body(forTexturesOf(side, sample.body))
        , texels(mapTexels(body.topology->data(), side, 4))
    {
        for (const SampleTake& take : sample.takes) {
            if (!take.appearance)
                continue;
            for (std::int64_t f = 0; f < take.sequence.frameCount(); f += frameStep) {
                const Frame frame = take.sequence.frame(FrameIndex(f));
                const auto at = static_cast<std::size_t>(f);
                frames.push_back({{frame.positions().begin(), frame.positions().end()},
                                  take.appearance->lights[at],
                                  take.appearance->warps[at]});
                textures.push_back(std::make_shared<const Image>(baked(frames.back())));
            }
            begins.push_back(frames.size());
        }
    }

    Image baked(const Baked& frame) const
    {
        SampleAppearance appearance{.textureSize = side, .lights = {frame.light}, .warps = {frame.warp}};
        return frameTexture(body, texels, frame.posed, appearance, FrameIndex(0));
    }

    /// The truth midway: both frames' colours in their own light, where the warp in between has them.
    Image between(Baked a, Baked b) const
    {
        for (std::size_t n = 0; n < a.warp.offsets.size(); ++n)
            a.warp.offsets[n] = b.warp.offsets[n] = 0.5F * (a.warp.offsets[n] + b.warp.offsets[n]);
        return mixedTexture(baked(a), baked(b), 0.5);
    }

    SampleCharacter sample;
    SampleBody body;
    TexelMap texels;
    std::vector<Baked> frames;
    std::vector<std::shared_ptr<const Image>> textures;
    std::vector<std::size_t> begins; ///< behind the frames of each take
};

} // namespace

TEST_F(SampleTextures, BetweenFramesAreAtMostHalfAsFarFromTheTruthAsALinearBlend)
{
    const TextureSource source{std::ssize(textures),
                               [&](std::int64_t i) { return textures[static_cast<std::size_t>(i)]; }};
    BuildAppearanceOptions options;
    options.components = 30;
    const BuiltAppearance built = buildAppearance(source, *body.topology, options);
    const AppearanceDecoder decoder(std::make_shared<const AppearanceModel>(quantised(
        built.used, built.grid, built.textures, built.warps, std::vector<AppearanceFrame>(textures.size()))));
    DecodeScratch scratch;
    double own = 0;
    double linear = 0;
    for (std::size_t a = 0; a < begins[0]; a += 2) {
        const std::size_t b = begins[0] + a; // of another take
        const auto at = [&](std::size_t frame) { return coefficientsOf(decoder.model(), frame); };
        const Image truth = between(frames[a], frames[b]);
        const Image blended = blendedTexture(decoder, at(a), *textures[a], at(b), *textures[b], 0.5, scratch);
        const Image mixed = mixedTexture(*textures[a], *textures[b], 0.5);
        own += textureQuality(truth, blended, built.used).meanSquaredError;
        linear += textureQuality(truth, mixed, built.used).meanSquaredError;
    }
    RecordProperty("ratio", std::to_string(std::sqrt(own / linear)));
    EXPECT_LE(std::sqrt(own), 0.5 * std::sqrt(linear));
}
