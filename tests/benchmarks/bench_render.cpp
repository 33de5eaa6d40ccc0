// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/renderframe.h"
#include "model/render/thumbnail.h"
#include "tests/model/render/reference.h"
#include "tests/model/render/scenes.h"

#include <benchmark/benchmark.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// About 20,000 triangles.
const MeshSequence& figure()
{
    static const MeshSequence sequence = [] {
        MeshSequence s = ball(71, 8);
        s.textures = TextureSet::single({{}, smoothTexture(1024, 1024)});
        return s;
    }();
    return sequence;
}

RenderOptions vga(int samples)
{
    RenderOptions options;
    options.width = 640;
    options.height = 480;
    options.supersampling = samples;
    return options;
}

Camera camera()
{
    return frameAll(boundsOf(figure().frame(FrameIndex(0)).positions()), {.aspect = 4.0 / 3, .margin = 0.15});
}

/// One frame at 640 × 480 with light, ground and shadow; the argument is samples per direction.
void renderTextured(benchmark::State& state)
{
    const FrameRenderer renderer(figure(), vga(static_cast<int>(state.range(0))));
    const Camera view = camera();
    for (auto _ : state)
        benchmark::DoNotOptimize(renderer.render(FrameIndex(0), view));
    state.counters["triangles"] = static_cast<double>(figure().topology->triangles().size());
    state.SetItemsProcessed(state.iterations()); // frames
}
BENCHMARK(renderTextured)->Arg(1)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What the plain rasteriser below does: texture only, one sample.
void renderFlat(benchmark::State& state)
{
    RenderOptions options = vga(1);
    options.shading = RenderOptions::Shading::Flat;
    options.background = RenderOptions::Background::Transparent;
    options.grid = options.shadow = false;
    const FrameRenderer renderer(figure(), options);
    const Camera view = camera();
    for (auto _ : state)
        benchmark::DoNotOptimize(renderer.render(FrameIndex(0), view));
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(renderFlat)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The peer: one thread, no tiles, double precision.
void renderPlainReference(benchmark::State& state)
{
    const auto texture = smoothTexture(1024, 1024);
    const Camera view = camera();
    const Frame frame = figure().frame(FrameIndex(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            plainPicture(frame.positions(), figure().topology->data(), *texture, view, 640, 480));
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(renderPlainReference)->Unit(benchmark::kMillisecond)->UseRealTime();

void thumbnailStripOfTwelve(benchmark::State& state)
{
    const auto look = thumbnailLook(320, 240, RenderOptions::Background::Dark);
    for (auto _ : state)
        benchmark::DoNotOptimize(thumbnailStrip(figure(), 12, look));
}
BENCHMARK(thumbnailStripOfTwelve)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
