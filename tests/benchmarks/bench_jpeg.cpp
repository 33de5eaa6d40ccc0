// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Reading and writing JPEG textures beside OpenCV and the reordering of colours that it needs; the memory of
// a texture beside that of a list of bytes.
#include "model/core/image.h"

#include <array>
#include <benchmark/benchmark.h>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

using namespace quadrille;

namespace {

/// Takes about as many bytes as a texture of clothes and skin: 0.1 for each pixel.
Image texture(int size)
{
    Image image(size, size);
    std::uint32_t state = 1;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            state = state * 1664525U + 1013904223U;
            const double wave = std::sin(0.05 * x) * std::cos(0.03 * y) + 0.3 * std::sin(0.9 * x + 0.7 * y);
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] =
                    static_cast<std::uint8_t>(110 + 50 * wave + 15 * c + static_cast<double>(state >> 30U));
            image.pixel(x, y)[3] = 255;
        }
    }
    return image;
}

void decode(benchmark::State& state)
{
    const auto encoded = encodeImage(texture(static_cast<int>(state.range(0))), ".jpg", 90);
    for (auto _ : state)
        benchmark::DoNotOptimize(decodeImage(encoded).pixels.data());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(encoded.size()));
}

void decodeByOpenCv(benchmark::State& state)
{
    auto encoded = encodeImage(texture(static_cast<int>(state.range(0))), ".jpg", 90);
    const cv::Mat bytes(1, static_cast<int>(encoded.size()), CV_8U, encoded.data());
    for (auto _ : state) {
        const cv::Mat decoded = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
        Image image(decoded.cols, decoded.rows);
        const cv::Mat target(decoded.rows, decoded.cols, CV_8UC4, image.pixels.data());
        cv::cvtColor(decoded, target, cv::COLOR_BGR2RGBA);
        benchmark::DoNotOptimize(image.pixels.data());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(encoded.size()));
}

void encode(benchmark::State& state)
{
    const Image image = texture(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(encodeImage(image, ".jpg", 90).data());
}

void encodeByOpenCv(benchmark::State& state)
{
    Image image = texture(static_cast<int>(state.range(0)));
    const cv::Mat source(image.height, image.width, CV_8UC4, image.pixels.data());
    for (auto _ : state) {
        cv::Mat ordered;
        cv::cvtColor(source, ordered, cv::COLOR_RGBA2BGRA);
        std::vector<unsigned char> encoded;
        cv::imencode(".jpg", ordered, encoded, {cv::IMWRITE_JPEG_QUALITY, 90});
        benchmark::DoNotOptimize(encoded.data());
    }
}

/// Makes a texture while the last ones are kept, as those are that play them.
template <typename Pixels>
void pixelMemory(benchmark::State& state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    std::array<Pixels, 4> kept;
    std::size_t next = 0;
    for (auto _ : state) {
        Pixels& pixels = kept[next++ % kept.size()];
        pixels = Pixels(side * side * 4);
        benchmark::DoNotOptimize(pixels.data());
    }
}

void memory(benchmark::State& state)
{
    pixelMemory<decltype(Image::pixels)>(state);
}

void memoryByList(benchmark::State& state)
{
    pixelMemory<std::vector<std::uint8_t>>(state);
}

} // namespace

BENCHMARK(decode)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(decodeByOpenCv)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(encode)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(encodeByOpenCv)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(memory)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(memoryByList)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
