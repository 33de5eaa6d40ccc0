// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Parts of the making of an appearance model: texels of a layout, principal components beside those of
// OpenCV.
#include "model/appearance/pca.h"
#include "model/appearance/usedtexels.h"
#include "model/core/random.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <opencv2/core.hpp>

using namespace quadrille;

namespace {

/// A layout of square charts with a grid of triangles in each.
Topology layout(int charts, int cells)
{
    TopologyData data;
    for (int chart = 0; chart < charts * charts; ++chart) {
        const std::uint32_t first = data.vertexCount;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const auto along = [&](int at, int step) {
                    return (static_cast<float>(at) + 0.1F +
                            0.8F * static_cast<float>(step) / static_cast<float>(cells)) /
                           static_cast<float>(charts);
                };
                data.uvs.emplace_back(along(chart % charts, i), along(chart / charts, j));
                ++data.vertexCount;
            }
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const std::uint32_t a = first + static_cast<std::uint32_t>(j * (cells + 1) + i);
                const std::uint32_t c = a + static_cast<std::uint32_t>(cells) + 1;
                for (const auto& t : {std::array{a, a + 1, c}, std::array{a + 1, c + 1, c}}) {
                    data.triangles.push_back({VertexIndex(t[0]), VertexIndex(t[1]), VertexIndex(t[2])});
                    data.triangleUvs.push_back(t);
                }
            }
    }
    return Topology(std::move(data));
}

void findUsedTexels(benchmark::State& state)
{
    const Topology topology = layout(4, 25); // 20,000 triangles
    for (auto _ : state)
        benchmark::DoNotOptimize(
            usedTexels(topology, static_cast<int>(state.range(0)), static_cast<int>(state.range(0))));
}

/// Bytes that vary in some directions and by noise.
cv::Mat noisySamples(int count, int size)
{
    cv::Mat samples(count, size, CV_8U);
    Random random(1);
    for (int s = 0; s < count; ++s) {
        const double strength = 40 * random.normal();
        for (int k = 0; k < size; ++k)
            samples.at<std::uint8_t>(s, k) = cv::saturate_cast<std::uint8_t>(
                128 + strength * std::sin(0.001 * k) + static_cast<double>(random.next() % 16));
    }
    return samples;
}

constexpr int kept = 50;

void takeComponents(benchmark::State& state)
{
    const cv::Mat bytes = noisySamples(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const SampleSet samples{bytes.rows, bytes.cols,
                            [&](std::int64_t sample, std::int64_t first, std::span<float> values) {
                                const std::uint8_t* row = bytes.ptr(static_cast<int>(sample)) + first;
                                std::copy_n(row, values.size(), values.begin());
                            }};
    for (auto _ : state)
        benchmark::DoNotOptimize(principalComponents(samples, kept).components.data());
}

void takeComponentsByOpenCv(benchmark::State& state)
{
    const cv::Mat bytes = noisySamples(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    cv::Mat samples;
    bytes.convertTo(samples, CV_32F);
    for (auto _ : state) {
        const cv::PCA pca(samples, cv::noArray(), cv::PCA::DATA_AS_ROW, kept);
        benchmark::DoNotOptimize(pca.project(samples).data);
    }
}

} // namespace

BENCHMARK(findUsedTexels)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
// Fifty textures of which a third is used, and two hundred that are used throughout.
BENCHMARK(takeComponents)
    ->Args({50, 1 << 20})
    ->Args({200, 3 << 20})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(takeComponentsByOpenCv)
    ->Args({50, 1 << 20})
    ->Args({200, 3 << 20})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
