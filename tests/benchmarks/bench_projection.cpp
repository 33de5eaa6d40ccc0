// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The texture of one frame of the sample's body, 1024 × 1024, from eight cameras of 1280 × 960, beside the
// plainest way to see: a ray for each texel and camera against all triangles. Items are texels seen or not,
// once for each camera.
#include "model/projection/projectclip.h"
#include "model/sample/sample.h"
#include "tests/model/projection/photographs.h"
#include "tests/model/projection/plainprojection.h"

#include <benchmark/benchmark.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

struct Filmed
{
    SampleBody body = makeSampleCharacter({.textureSize = 1024, .takesPerKind = 1}).body;
    std::vector<Camera> cameras = ringOfCameras(boundsOf(body.rest), 8, 1280.0 / 960);
    TextureProjector projector{body.topology, pinholesOf(cameras, 1280, 960), 1024, 1024};
    std::vector<std::shared_ptr<const Image>> pictures;

    Filmed()
    {
        MeshSequence still =
            makeSequence("still", body.topology,
                         std::make_shared<MemoryFrames>(body.rest, body.topology->vertexCount()), 25);
        still.textures = TextureSet::single({{}, body.texture});
        pictures = photographs(still, FrameIndex(0), cameras, 1280, 960);
    }
};

const Filmed& filmed()
{
    static const Filmed only;
    return only;
}

void countSights(benchmark::State& state, std::size_t texels)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(texels * filmed().cameras.size()));
}

void projectTexture(benchmark::State& state)
{
    const Filmed& f = filmed();
    for (auto _ : state)
        benchmark::DoNotOptimize(f.projector.project(f.body.rest, f.pictures));
    countSights(state, f.projector.atlas().places.size());
}
BENCHMARK(projectTexture)->Unit(benchmark::kMillisecond)->UseRealTime();

void seeByRays(benchmark::State& state)
{
    const Filmed& f = filmed();
    constexpr std::size_t step = 512; // all of them would take minutes
    const auto& places = f.projector.atlas().places;
    std::size_t texels = 0;
    for (auto _ : state) {
        texels = 0;
        for (std::size_t t = 0; t < places.size(); t += step, ++texels)
            for (const PinholeCamera& camera : f.projector.cameras())
                benchmark::DoNotOptimize(
                    plainlySees(camera, places[t], f.body.rest, f.body.topology->triangles()));
    }
    countSights(state, texels);
}
BENCHMARK(seeByRays)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What one camera sees, without texels.
void viewOfCamera(benchmark::State& state)
{
    const Filmed& f = filmed();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            CameraView(f.projector.cameras().front(), f.body.rest, f.body.topology->triangles()));
}
BENCHMARK(viewOfCamera)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Filling and spreading, once texels are known.
void fillTexture(benchmark::State& state)
{
    const Filmed& f = filmed();
    const ProjectedTexels texels = f.projector.project(f.body.rest, f.pictures);
    for (auto _ : state)
        benchmark::DoNotOptimize(filledTexture(f.projector.atlas(), texels.colours, texels.colours));
}
BENCHMARK(fillTexture)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
