// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Playing textures of 2048² at 30 frames a second for a minute, with 256 MB of cache: how many frames had not
// come when they were due. A series of JPEG files, read again on each round; frames between two of them by a
// model of appearance, all of them or, as in clips, a second of blends after two of captured frames. Second
// argument: the loader's threads. Third: whether a viewport shows them, whose drawing takes cores from the
// loader where it is done by software.
#include "editor/application/memory.h"
#include "editor/playback/frameloader.h"
#include "model/appearance/modeltextures.h"
#include "model/core/mediacache.h"
#include "model/core/random.h"
#include "model/sequence/framesource.h"
#include "tests/model/appearance/appearancefixture.h"
#include "widgets/viewport/viewport.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>
#include <array>
#include <benchmark/benchmark.h>
#include <cmath>

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

/// As smooth as captured ones are, so that they are decoded as fast: colours of some waves and a little
/// noise.
Image picture(int seed)
{
    Image image(textureSide, textureSide);
    Random random(static_cast<std::uint64_t>(seed));
    const double phase = random.between(0, 6);
    for (int y = 0; y < textureSide; ++y) {
        for (int x = 0; x < textureSide; ++x) {
            std::uint8_t* pixel = image.pixel(x, y);
            for (int channel = 0; channel < 3; ++channel) {
                const double wave = std::sin(0.013 * x + phase + channel) + std::sin(0.021 * y - phase) +
                                    0.5 * std::sin(0.17 * (x + y));
                pixel[channel] = static_cast<std::uint8_t>(128 + 35 * wave + random.between(-4, 4));
            }
            pixel[3] = 255;
        }
    }
    return image;
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
        FrameAppearances known{.model = model};
        for (std::size_t f = 0; f < model->frames.size(); ++f) {
            const FrameIndex frame(static_cast<std::int64_t>(f));
            known.coefficients[{takeName, frame}] = coefficientsOf(*model, f);
            series.push_back({.file = m_folder.path().toStdString() + "/" + std::to_string(f) + ".jpg"});
            writeImage(picture(static_cast<int>(f)), series.back().file, 90);
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

    /// A second of blends after two of captured frames, again and again.
    std::vector<Texture> clip() const
    {
        std::vector<Texture> clip;
        for (std::size_t f = 0; f < 2 * series.size(); ++f) {
            const std::size_t place = f % series.size();
            const bool isBlend = f % (3 * framesPerSecond) >= 2 * framesPerSecond;
            clip.push_back(isBlend ? blends[place] : series[place]);
        }
        return clip;
    }

    std::vector<Texture> series;
    std::vector<Texture> blends;

private:
    QTemporaryDir m_folder;
};

void play(benchmark::State& state)
{
    keepMemoryTight(); // as the editor does: memory of large blocks goes back at once
    static const Textures textures;
    const std::array sequences{textures.series, textures.blends, textures.clip()};
    const MeshSequence sequence = square(sequences.at(static_cast<std::size_t>(state.range(0))));
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
    ->ArgNames({"captured_blended_clip", "threads", "shown"})
    ->Args({0, 2, 0})
    ->Args({0, 2, 1})
    ->Args({1, 2, 0})
    ->Args({1, 2, 1})
    ->Args({2, 2, 0})
    ->Args({2, 2, 1})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

} // namespace
} // namespace quadrille
