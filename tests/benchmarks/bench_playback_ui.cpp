// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How many frames a second the editor shows: a tube of some vertices that changes in every frame, with a JPEG
// of 1024 × 1024 texels for each, from the loader's threads through the viewport to the finished picture.
// Second argument: whether the textures have been read before. Third: the level of quality that is held, from
// 0 for the best; −1 lets the governor choose, as in the editor. Fourth: frames a second that it is to reach.
// Then the size of the viewport. Shadows are made as the editor makes them.
#include "editor/playback/figureshadow.h"
#include "editor/playback/frameloader.h"
#include "model/sequence/framesource.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkview.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>
#include <cmath>
#include <numbers>

namespace quadrille {
namespace {

constexpr int frames = 25;
constexpr int textureSide = 1024;
constexpr int warmingUp = 60; // for the governor
constexpr std::size_t roomForAll = std::size_t{512} << 20;
constexpr std::size_t roomForFew = std::size_t{24} << 20;

/// Rings of 50 vertices, one above the other.
MeshSequence tube(int vertices, const QString& folder)
{
    constexpr int around = 50;
    const int rings = vertices / around;
    TopologyData data;
    data.vertexCount = static_cast<std::uint32_t>(rings * around);
    for (int ring = 0; ring < rings; ++ring)
        for (int i = 0; i < around; ++i)
            data.uvs.emplace_back(static_cast<float>(i) / around, static_cast<float>(ring) / rings);
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            const auto a = static_cast<std::uint32_t>(ring * around + i);
            const auto b = static_cast<std::uint32_t>(ring * around + (i + 1) % around);
            for (const auto& corners :
                 {std::array{a, b, a + around}, std::array{b, b + around, a + around}}) {
                data.triangles.push_back(
                    {VertexIndex(corners[0]), VertexIndex(corners[1]), VertexIndex(corners[2])});
                data.triangleUvs.push_back(corners);
            }
        }
    }
    std::vector<Vec3f> positions;
    std::vector<Texture> textures;
    for (int f = 0; f < frames; ++f) {
        for (int v = 0; v < rings * around; ++v) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(v % around) / around;
            const float height = 1.8F * static_cast<float>(v / around) / static_cast<float>(rings);
            const float radius = 0.3F + 0.05F * std::sin(8 * height + static_cast<float>(f));
            positions.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
        }
        Image image(textureSide, textureSide);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = static_cast<std::uint8_t>((i / 64) * 7 + static_cast<std::size_t>(f) * 9);
        textures.push_back({.file = folder.toStdString() + "/" + std::to_string(f) + ".jpg"});
        writeImage(image, textures.back().file);
    }
    const auto count = data.vertexCount;
    MeshSequence sequence = makeSequence("tube", std::make_shared<Topology>(std::move(data)),
                                         std::make_shared<MemoryFrames>(std::move(positions), count), frames);
    sequence.textures = TextureSet::perFrame(std::move(textures));
    return sequence;
}

widgets::FigureMesh toFigureMesh(const TopologyData& data)
{
    widgets::FigureMesh mesh;
    mesh.vertexCount = data.vertexCount;
    for (const Triangle& triangle : data.triangles)
        mesh.triangles.push_back({triangle[0].value, triangle[1].value, triangle[2].value});
    for (const Vec2f& uv : data.uvs)
        mesh.uvs.push_back({uv.x(), uv.y()});
    mesh.triangleUvs = data.triangleUvs;
    return mesh;
}

void playback(benchmark::State& state)
{
    const QTemporaryDir folder;
    const MeshSequence sequence = tube(static_cast<int>(state.range(0)), folder.path());
    const bool wasRead = state.range(1) != 0;
    MediaCache::shared()->setBudget(wasRead ? roomForAll : roomForFew);
    widgets::Viewport viewport;
    viewport.resize(static_cast<int>(state.range(4)), static_cast<int>(state.range(5)));
    viewport.show();
    const int figure = viewport.addFigure(toFigureMesh(sequence.topology->data()));
    double shadows = 0;
    viewport.setShadowMaker([&](const widgets::ShadowWish& wish) {
        QElapsedTimer timer;
        timer.start();
        widgets::GroundShadow shadow = figureShadow(wish, *sequence.topology, 1.8);
        shadows += static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        return shadow;
    });
    viewport.view()->setPictureRate(static_cast<double>(state.range(3)));
    const auto level = static_cast<int>(state.range(2));
    if (level >= 0)
        viewport.view()->holdQuality(widgets::RenderGovernor::qualityOf(level));
    FrameLoader loader;
    const int stream = loader.addStream(sequence);
    QEventLoop drawn;
    double drawing = 0;
    QObject::connect(&loader, &FrameLoader::loaded, &loader, [&](int, const LoadedFrame& frame) {
        const auto positions = frame.positions->positions();
        viewport.setPositions(figure,
                              {reinterpret_cast<const float*>(positions.data()), positions.size() * 3});
        viewport.setTexture(figure, frame.textures.front().second);
    });
    QObject::connect(&viewport, &widgets::Viewport::rendered, &drawn, [&](double milliseconds) {
        drawing += milliseconds;
        drawn.quit();
    });
    std::int64_t next = 0;
    const auto show = [&] {
        loader.want(stream, FrameIndex(next++ % frames), 1);
        drawn.exec();
    };
    for (int i = 0; i < frames; ++i)
        show();
    viewport.frameAll();
    for (int i = 0; i < warmingUp; ++i)
        show();
    drawing = 0;
    shadows = 0;
    for ([[maybe_unused]] const auto& each : state)
        show();
    state.counters["fps"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["drawing_ms"] = drawing / static_cast<double>(state.iterations());
    state.counters["shadow_ms"] = shadows / static_cast<double>(state.iterations());
    const widgets::RenderQuality quality = viewport.view()->quality();
    state.counters["samples"] = quality.samples;
    state.counters["smoothed"] = quality.smoothsEdges ? 1 : 0;
    state.counters["coarseness"] = quality.shadowCoarseness;
    state.counters["scale"] = quality.scale;
}

void eachLevel(benchmark::internal::Benchmark* playing)
{
    for (int level = 0; level < widgets::RenderGovernor::levels; ++level) {
        playing->Args({3900, 1, level, 25, 1280, 720});
        playing->Args({3000, 1, level, 60, 900, 700});
    }
}

BENCHMARK(playback)
    ->ArgNames({"vertices", "read", "level", "rate", "width", "height"})
    ->Args({3900, 1, -1, 25, 1280, 720})
    ->Args({20000, 1, -1, 25, 1280, 720})
    ->Args({3900, 0, -1, 25, 1280, 720})
    ->Args({20000, 0, -1, 25, 1280, 720})
    ->Args({3000, 1, -1, 60, 900, 700}) // steered live
    ->Apply(eachLevel)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(2.0);

} // namespace
} // namespace quadrille
