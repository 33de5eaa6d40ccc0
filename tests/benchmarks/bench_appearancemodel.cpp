// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Textures of 1024², one thread. From coefficients: the decoder, on 43 % of the texels as in a real capture,
// beside plain loops over components in single precision, on as many texels and on all. Half as many
// components of warps are added.
#include "model/appearance/completion.h"
#include "model/appearance/modeltextures.h"
#include "model/appearance/projection.h"
#include "model/appearance/reducedmodel.h"
#include "model/appearance/texturequality.h"
#include "model/core/random.h"
#include "tests/model/appearance/appearancefixture.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/quality/qualityssim.hpp>

using namespace quadrille;

namespace {

constexpr int atlasSize = 1024;

test::AppearanceSpaces spacesOf(const UsedTexels& texels, int components)
{
    return test::randomSpaces(texels,
                              {.components = components,
                               .warpComponents = components / 2,
                               .frames = 4,
                               .warp = 1,
                               .orthonormal = false},
                              1);
}

void decode(benchmark::State& state)
{
    const auto model = std::make_shared<const AppearanceModel>(
        test::quantised(spacesOf(test::texelsOfAtlas(atlasSize), static_cast<int>(state.range(0)))));
    const AppearanceDecoder decoder(model);
    DecodeScratch scratch;
    Image texture;
    std::size_t frame = 0;
    for (auto _ : state) {
        decoder.decode(coefficientsOf(*model, frame++ % model->frames.size()), scratch, texture);
        benchmark::DoNotOptimize(texture.pixels.data());
    }
}

/// For thumbnails, a quarter as wide and high.
void decodeReduced(benchmark::State& state)
{
    const auto model = std::make_shared<const AppearanceModel>(reduced(
        test::quantised(spacesOf(test::texelsOfAtlas(atlasSize), static_cast<int>(state.range(0)))), 4));
    const AppearanceDecoder decoder(model);
    DecodeScratch scratch;
    Image texture;
    for (auto _ : state) {
        decoder.decode(coefficientsOf(*model, 1), scratch, texture);
        benchmark::DoNotOptimize(texture.pixels.data());
    }
}

/// Between two textures by their warps, as clips take them.
void blend(benchmark::State& state)
{
    const auto model = std::make_shared<const AppearanceModel>(
        test::quantised(spacesOf(test::texelsOfAtlas(atlasSize), static_cast<int>(state.range(0)))));
    const AppearanceDecoder decoder(model);
    const std::array frames{coefficientsOf(*model, 0), coefficientsOf(*model, 1)};
    const std::array textures{decoder.decode(frames[0]), decoder.decode(frames[1])};
    DecodeScratch scratch;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            blendedTexture(decoder, frames[0], textures[0], frames[1], textures[1], 0.4, scratch)
                .pixels.data());
}

void projectTexture(benchmark::State& state)
{
    const AppearanceModel model =
        test::quantised(spacesOf(test::texelsOfAtlas(atlasSize), static_cast<int>(state.range(0))));
    const SpaceProjection projection(model.textures);
    const std::vector<float> sample = combined(model.textures, coefficientsOf(model, 1).textures);
    for (auto _ : state)
        benchmark::DoNotOptimize(projection.project(sample).data());
}

/// With a fifth of the rows missing.
void complete(benchmark::State& state)
{
    const auto model = std::make_shared<const AppearanceModel>(
        test::quantised(spacesOf(test::texelsOfAtlas(atlasSize), static_cast<int>(state.range(0)))));
    const AppearanceDecoder decoder(model);
    const Image texture = decoder.decode(coefficientsOf(*model, 1));
    std::vector<std::uint8_t> known(texture.pixels.size() / 4, 1);
    std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(2 * known.size() / 5), known.size() / 5,
                std::uint8_t{0});
    for (auto _ : state)
        benchmark::DoNotOptimize(completeTexture(decoder, texture, known).texture.pixels.data());
}

void plainly(benchmark::State& state, const UsedTexels& texels)
{
    const test::AppearanceSpaces spaces = spacesOf(texels, static_cast<int>(state.range(0)));
    const AppearanceModel frames = [&] {
        AppearanceModel model;
        model.textures.count = spaces.textures.count();
        model.textures.coefficients = spaces.textures.coefficients;
        model.warps.count = spaces.warps.count();
        model.warps.coefficients = spaces.warps.coefficients;
        model.frames = spaces.frames;
        return model;
    }();
    std::vector<float> aligned;
    Image texture(atlasSize, atlasSize);
    std::size_t frame = 0;
    for (auto _ : state) {
        test::plainFloatDecode(spaces, coefficientsOf(frames, frame++ % frames.frames.size()), aligned,
                               texture);
        benchmark::DoNotOptimize(texture.pixels.data());
    }
}

void decodePlainly(benchmark::State& state)
{
    plainly(state, test::texelsOfAtlas(atlasSize));
}

void decodeAllTexelsPlainly(benchmark::State& state)
{
    plainly(state, test::texelsOfDiscs(atlasSize, atlasSize, {{512, 512, 800}}));
}

/// Two textures of noise over noise, and where they count.
struct ComparedTextures
{
    Image first = Image(atlasSize, atlasSize);
    Image second = Image(atlasSize, atlasSize);
    UsedTexels texels = test::texelsOfAtlas(atlasSize);

    ComparedTextures()
    {
        Random random(3);
        for (std::size_t i = 0; i < first.pixels.size(); ++i) {
            first.pixels[i] = static_cast<std::uint8_t>(random.between(40, 200));
            second.pixels[i] = static_cast<std::uint8_t>(first.pixels[i] + random.between(0, 20));
        }
    }
};

void compare(benchmark::State& state)
{
    const ComparedTextures textures;
    for (auto _ : state)
        benchmark::DoNotOptimize(pictureQuality(textures.first, textures.second).similarity);
}

void compareCovered(benchmark::State& state)
{
    const ComparedTextures textures;
    for (auto _ : state)
        benchmark::DoNotOptimize(textureQuality(textures.first, textures.second, textures.texels).similarity);
}

/// Of one channel, where ours takes luma of three.
void compareByOpenCv(benchmark::State& state)
{
    const ComparedTextures textures;
    const auto channel = [](const Image& image) {
        cv::Mat values(image.height, image.width, CV_8UC1);
        for (std::size_t i = 0; i < image.pixels.size() / 4; ++i)
            values.data[i] = image.pixels[4 * i];
        return values;
    };
    const cv::Mat first = channel(textures.first);
    const cv::Mat second = channel(textures.second);
    cv::setNumThreads(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(cv::quality::QualitySSIM::compute(first, second, cv::noArray()));
}

} // namespace

BENCHMARK(decode)->Arg(20)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(decodePlainly)->Arg(20)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(decodeAllTexelsPlainly)->Arg(20)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(blend)->Arg(20)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(decodeReduced)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(projectTexture)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(complete)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(compare)->Unit(benchmark::kMillisecond);
BENCHMARK(compareCovered)->Unit(benchmark::kMillisecond);
BENCHMARK(compareByOpenCv)->Unit(benchmark::kMillisecond);
