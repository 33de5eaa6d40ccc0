// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/avifilm.h"
#include "model/film/mp4film.h"
#include "model/film/planes.h"
#include "model/sequence/io/clipexport.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/render/reference.h"
#include "tests/model/render/scenes.h"

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;

namespace {

constexpr int width = 1280;
constexpr int height = 720;

/// A second of a figure of 20,000 triangles.
const std::vector<Image>& pictures()
{
    static const std::vector<Image> drawn = [] {
        MeshSequence sequence = ball(71, 25);
        sequence.textures = TextureSet::single({{}, smoothTexture(1024, 1024)});
        std::vector<Image> images(25);
        drawClip(
            sequence, {}, {}, [](FrameIndex, Image&) {},
            [&](FrameIndex frame, const Image& image) {
                images[static_cast<std::size_t>(frame.value)] = image;
            });
        return images;
    }();
    return drawn;
}

void tell(benchmark::State& state, const fs::path& file)
{
    const auto count = static_cast<double>(pictures().size());
    state.counters["bytes"] = static_cast<double>(fs::file_size(file)) / count;
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pictures().size())); // frames
}

template <typename Film>
void writeFilm(benchmark::State& state, const char* name)
{
    const TemporaryFolder folder;
    const fs::path file = folder / name;
    pictures();
    for (auto _ : state) {
        Film film(file, file, {width, height, 25, static_cast<std::int64_t>(pictures().size())});
        for (const Image& picture : pictures())
            film.add(picture);
        film.finish();
    }
    tell(state, file);
}

void writeH264(benchmark::State& state)
{
    writeFilm<Mp4Film>(state, "a.mp4");
}
BENCHMARK(writeH264)->Unit(benchmark::kMillisecond)->UseRealTime();

void writeMotionJpeg(benchmark::State& state)
{
    writeFilm<AviFilm>(state, "a.avi");
}
BENCHMARK(writeMotionJpeg)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The peer: OpenCV's writer, with what it makes of MPEG-4 and Motion JPEG by itself.
void writeByOpenCv(benchmark::State& state, const char* name, int codec)
{
    const TemporaryFolder folder;
    const fs::path file = folder / name;
    pictures();
    for (auto _ : state) {
        cv::VideoWriter writer(file.string(), codec, 25, {width, height});
        cv::Mat colors;
        for (const Image& picture : pictures()) {
            cv::cvtColor(cv::Mat(height, width, CV_8UC4, const_cast<std::uint8_t*>(picture.pixels.data())),
                         colors, cv::COLOR_RGBA2BGR);
            writer.write(colors);
        }
    }
    tell(state, file);
}
BENCHMARK_CAPTURE(writeByOpenCv, mpeg4, "a.mp4", cv::VideoWriter::fourcc('m', 'p', '4', 'v'))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(writeByOpenCv, motionJpeg, "a.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Colours alone; OpenCV knows no matrix but that of BT.601.
void convertColors(benchmark::State& state)
{
    Planes planes;
    for (auto _ : state) {
        toPlanes(pictures().front(), planes);
        benchmark::DoNotOptimize(planes.luma.data());
    }
}
BENCHMARK(convertColors)->Unit(benchmark::kMillisecond);

void convertColorsByOpenCv(benchmark::State& state)
{
    const cv::Mat picture(height, width, CV_8UC4,
                          const_cast<std::uint8_t*>(pictures().front().pixels.data()));
    cv::setNumThreads(1);
    cv::Mat planes;
    for (auto _ : state)
        cv::cvtColor(picture, planes, cv::COLOR_RGBA2YUV_I420);
}
BENCHMARK(convertColorsByOpenCv)->Unit(benchmark::kMillisecond);

} // namespace
