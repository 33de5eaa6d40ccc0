// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Parts of the making of an appearance model: texels of a layout, principal components beside those of
// OpenCV, and displacements beside OpenCV's TV-L1 alone, with their error: the sample's warps are known.
#include "model/appearance/flow.h"
#include "model/appearance/pca.h"
#include "model/core/random.h"
#include "model/sample/appearance.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/optflow.hpp>

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

/// Textures of a take that differ in light and warp, as files hold them, and where the texels of each are in
/// the next.
struct TexturePairs
{
    explicit TexturePairs(const std::string& kind, int size, int count)
    {
        const SampleCharacter sample = makeSampleCharacter({.textureSize = size, .takesPerKind = 1});
        charts = std::make_unique<ChartLookup>(usedTexels(*sample.body.topology, size, size));
        const TexelMap texels = mapTexels(sample.body.topology->data(), size, 8);
        const SampleBody body = forTexturesOf(size, sample.body);
        for (const SampleTake& take : sample.takes) {
            if (take.kind != kind || !take.appearance)
                continue;
            const std::int64_t frames = take.sequence.frameCount();
            for (int k = 0; k <= count; ++k) {
                const FrameIndex frame((k * 17) % frames);
                const Image texture = frameTexture(body, texels, take.sequence.frame(frame).positions(),
                                                   *take.appearance, frame);
                textures.push_back(decodeImage(encodeImage(texture, ".jpg", 86)));
                warps.push_back(take.appearance->warps[static_cast<std::size_t>(frame.value)]);
            }
        }
    }

    /// Mean distance from the truth over covered texels, texels.
    double errorOf(std::size_t pair, const std::vector<Vec2f>& field) const
    {
        const double size = charts->used().width;
        double sum = 0;
        double count = 0;
        for (std::size_t k = 0; k < field.size(); ++k) {
            if (charts->used().covered[k] == 0)
                continue;
            const auto [x, y] = charts->place(k);
            const Vec2d at(x + 0.5, y + 0.5);
            const Vec2f from = warps[pair].at(at.x() / size, at.y() / size);
            Vec2f wanted = Vec2f::Zero();
            for (int iteration = 0; iteration < 20; ++iteration) {
                const Vec2d there = (at + wanted.cast<double>()) / size;
                wanted = from - warps[pair + 1].at(there.x(), there.y());
            }
            sum += static_cast<double>((field[k] - wanted).norm());
            ++count;
        }
        return sum / count;
    }

    std::unique_ptr<ChartLookup> charts;
    std::vector<Image> textures;
    std::vector<SampleWarp> warps;
};

constexpr int pairs = 3;

template <typename Find>
void measureFlow(benchmark::State& state, const Find& find)
{
    const TexturePairs take(state.range(1) == 0 ? "idle" : "reach low", static_cast<int>(state.range(0)),
                            pairs);
    double error = 0;
    for (auto _ : state) {
        error = 0;
        for (std::size_t k = 0; k < pairs; ++k) {
            const std::vector<Vec2f> field = find(take.textures[k], take.textures[k + 1], *take.charts);
            state.PauseTiming();
            error += take.errorOf(k, field) / pairs;
            state.ResumeTiming();
        }
    }
    state.counters["texels"] = error;
    state.SetItemsProcessed(state.iterations() * pairs);
}

void findFlow(benchmark::State& state, FlowMethod method)
{
    measureFlow(state, [method](const Image& fixed, const Image& moving, const ChartLookup& charts) {
        return denseFlow(fixed, moving, charts, {.method = method});
    });
}

/// The backward warp of each pair by inverting the forward one, beside a flow of its own (findFlow).
void invertFlow(benchmark::State& state)
{
    const TexturePairs take("idle", static_cast<int>(state.range(0)), 1);
    const int size = static_cast<int>(state.range(0));
    const WarpGrid grid = WarpGrid::over(size, size);
    const auto nodes = take.charts->atNodes(
        denseFlow(take.textures[1], take.textures[0], *take.charts, {.method = FlowMethod::Dis}), grid);
    std::vector<Vec2f> field;
    for (auto _ : state)
        field = take.charts->inverse(nodes, grid);
    state.counters["texels"] = take.errorOf(0, field);
    state.SetItemsProcessed(state.iterations());
}

/// OpenCV's, as it is made, of grey pictures.
void findFlowByOpenCv(benchmark::State& state)
{
    measureFlow(state, [](const Image& fixed, const Image& moving, const ChartLookup& charts) {
        cv::Mat grey[2];
        for (const auto& [image, out] : {std::pair(&fixed, &grey[0]), std::pair(&moving, &grey[1])})
            cv::cvtColor(cv::Mat(image->height, image->width, CV_8UC4,
                                 const_cast<std::uint8_t*>(image->pixels.data())),
                         *out, cv::COLOR_RGBA2GRAY);
        cv::Mat flow;
        cv::optflow::DualTVL1OpticalFlow::create()->calc(grey[0], grey[1], flow);
        std::vector<Vec2f> field;
        for (const std::uint32_t texel : charts.used().texels)
            field.emplace_back(flow.ptr<cv::Vec2f>()[texel][0], flow.ptr<cv::Vec2f>()[texel][1]);
        return field;
    });
}

/// Where each texel of a chart is looked up: some texels off, as warps lead there.
Vec2f displacementAt(int x, int y, int size)
{
    const double turn = 20.0 / size;
    return {static_cast<float>(2.3 * std::sin(turn * y)), static_cast<float>(1.7 * std::cos(turn * x))};
}

/// Three values of each used texel, cubic within charts.
void lookUp(benchmark::State& state)
{
    const auto size = static_cast<int>(state.range(0));
    const ChartLookup charts(usedTexels(layout(4, 25), size, size));
    const auto texels = static_cast<std::size_t>(charts.count());
    Random random(1);
    std::vector<float> values(3 * texels + 1);
    for (float& value : values)
        value = static_cast<float>(random.between(0, 255));
    std::vector<Vec2f> field(texels);
    for (std::size_t k = 0; k < texels; ++k)
        field[k] = displacementAt(charts.place(k)[0], charts.place(k)[1], size);
    charts.keepInside(field);
    std::vector<float> looked(3 * texels + 1);
    for (auto _ : state) {
        charts.sample(values, field, looked);
        benchmark::DoNotOptimize(looked.data());
    }
    state.SetItemsProcessed(state.iterations() * charts.count());
}

/// Those of a whole picture, whatever belongs together.
void lookUpByOpenCv(benchmark::State& state)
{
    const auto size = static_cast<int>(state.range(0));
    cv::Mat values(size, size, CV_32FC3);
    cv::randu(values, 0, 255);
    cv::Mat places(size, size, CV_32FC2);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Vec2f off = displacementAt(x, y, size);
            places.at<cv::Vec2f>(y, x) = {static_cast<float>(x) + off.x(), static_cast<float>(y) + off.y()};
        }
    }
    cv::Mat looked;
    cv::setNumThreads(1);
    for (auto _ : state) {
        cv::remap(values, looked, places, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
        benchmark::DoNotOptimize(looked.data);
    }
    state.SetItemsProcessed(state.iterations() * size * size);
}

} // namespace

BENCHMARK(findUsedTexels)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);
// Texels a second.
BENCHMARK(lookUp)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(lookUpByOpenCv)->Arg(1024)->Unit(benchmark::kMillisecond);
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
// Takes for which nothing was tuned; JPEG of quality 86. "texels": mean distance from the true displacement.
BENCHMARK_CAPTURE(findFlow, TvL1, FlowMethod::TvL1)
    ->ArgsProduct({{512, 1024}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findFlow, Dis, FlowMethod::Dis)
    ->ArgsProduct({{512, 1024}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(findFlowByOpenCv)->Args({512, 0})->Unit(benchmark::kMillisecond);
BENCHMARK(invertFlow)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
