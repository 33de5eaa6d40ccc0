// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Playing textures of 2048² at 30 frames a second for a minute, with 256 MB of cache: how many frames had not
// come when they were due. A series of JPEG files, read again on each round, and frames between two of them
// by a model of appearance. Second argument: the loader's threads. Third: whether a viewport shows them,
// whose drawing takes cores from the loader where it is done by software.
#include "editor/playback/frameloader.h"
#include "model/appearance/modeltextures.h"
#include "model/core/mediacache.h"
#include "model/sequence/framesource.h"
#include "tests/model/appearance/appearancefixture.h"
#include "widgets/viewport/viewport.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>
#include <benchmark/benchmark.h>

namespace quadrille {
namespace {

constexpr int textureSide = 2048;
constexpr int texturesOnDisc = 45; // 45 × 16 MB: far more than the cache holds
constexpr int framesPerSecond = 30;
constexpr int framesPlayed = 60 * framesPerSecond;
constexpr std::size_t cacheBytes = std::size_t{256} << 20;
const std::string takeName = "take";

/// A square that shows the whole atlas.
MeshSequence square(std::vector<Texture> textures)
{
    TopologyData data;
    data.vertexCount = 4;
    data.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    data.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)},
                      {VertexIndex(0), VertexIndex(2), VertexIndex(3)}};
    data.triangleUvs = {{0, 1, 2}, {0, 2, 3}};
    const auto frames = std::ssize(textures);
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frames; ++f)
        for (const Vec2f& uv : data.uvs)
            positions.emplace_back(uv.x(), uv.y(), 0.0F);
    MeshSequence sequence = makeSequence(takeName, std::make_shared<Topology>(std::move(data)),
                                         std::make_shared<MemoryFrames>(std::move(positions), 4), frames);
    sequence.textures = TextureSet::perFrame(std::move(textures));
    return sequence;
}

class Textures
{
public:
    Textures()
    {
        const auto model = std::make_shared<const AppearanceModel>(
            test::quantised(test::randomSpaces(test::texelsOfAtlas(textureSide),
                                               {.components = 4,
                                                .warpComponents = 10,
                                                .frames = texturesOnDisc,
                                                .warp = 1,
                                                .orthonormal = false},
                                               1)));
        const AppearanceDecoder decoder(model);
        FrameAppearances known{.model = model};
        for (std::size_t f = 0; f < model->frames.size(); ++f) {
            const AppearanceCoefficients coefficients = coefficientsOf(*model, f);
            const FrameIndex frame(static_cast<std::int64_t>(f));
            known.coefficients[{takeName, frame}] = coefficients;
            series.push_back({.file = m_folder.path().toStdString() + "/" + std::to_string(f) + ".jpg"});
            writeImage(decoder.decode(coefficients), series.back().file, 90);
        }
        const ModelTextures blender([known] { return std::optional(known); });
        for (std::size_t f = 0; f < series.size(); ++f) {
            const std::size_t other = (f + series.size() / 2) % series.size();
            const auto captured = [&](std::size_t frame) {
                return CapturedTexture{takeName, FrameIndex(static_cast<std::int64_t>(frame)), series[frame]};
            };
            blends.push_back(blender.between(captured(f), captured(other), 0.4));
        }
    }

    std::vector<Texture> series;
    std::vector<Texture> blends;

private:
    QTemporaryDir m_folder;
};

void play(benchmark::State& state)
{
    static const Textures textures;
    const bool isBlended = state.range(0) != 0;
    const MeshSequence sequence = square(isBlended ? textures.blends : textures.series);
    MediaCache::shared()->setBudget(0); // nothing is left of other runs
    MediaCache::shared()->setBudget(cacheBytes);
    std::unique_ptr<widgets::Viewport> viewport;
    int figure = -1;
    if (state.range(2) != 0) {
        viewport = std::make_unique<widgets::Viewport>();
        viewport->resize(900, 700);
        viewport->show();
        widgets::FigureMesh mesh{.vertexCount = 4};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        mesh.triangleUvs = sequence.topology->data().triangleUvs;
        figure = viewport->addFigure(mesh);
    }
    FrameLoader loader(nullptr, static_cast<int>(state.range(1)));
    const int stream = loader.addStream(sequence);
    std::int64_t arrived = -1;
    std::size_t mostBytes = 0;
    int late = 0;
    QObject::connect(&loader, &FrameLoader::loaded, &loader, [&](int, const LoadedFrame& frame) {
        arrived = frame.frame.value;
        mostBytes = std::max(mostBytes, MediaCache::shared()->statistics().bytes);
        if (viewport) {
            const auto positions = frame.positions->positions();
            viewport->setPositions(figure,
                                   {reinterpret_cast<const float*>(positions.data()), positions.size() * 3});
            viewport->setTexture(figure, frame.textures.front().second);
        }
    });
    for ([[maybe_unused]] const auto& each : state) {
        QEventLoop events;
        QElapsedTimer clock;
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        std::int64_t shown = -1;
        QObject::connect(&timer, &QTimer::timeout, &events, [&] {
            const std::int64_t due = clock.elapsed() * framesPerSecond / 1000;
            if (due == shown)
                return;
            // Frames that are passed over, and one that was asked for and is not there yet.
            if (shown >= 0)
                late +=
                    static_cast<int>(due - shown - 1) + (arrived == shown % sequence.frameCount() ? 0 : 1);
            shown = due;
            if (due >= framesPlayed)
                return events.quit();
            loader.want(stream, FrameIndex(due % sequence.frameCount()), 1);
        });
        clock.start();
        timer.start(1);
        events.exec();
    }
    state.counters["late"] = late;
    state.counters["of"] = framesPlayed;
    state.counters["cache_MB"] = static_cast<double>(mostBytes >> 20);
}

BENCHMARK(play)
    ->ArgNames({"blended", "threads", "shown"})
    ->Args({0, 2, 0})
    ->Args({0, 2, 1})
    ->Args({1, 2, 0})
    ->Args({1, 2, 1})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

} // namespace
} // namespace quadrille
