// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Baking skins and reading .anime files, each beside its plain reference.
#include "model/core/file.h"
#include "model/sequence/io/anime.h"
#include "model/sequence/io/scene/skinning.h"

#include <benchmark/benchmark.h>
#include <filesystem>
#include <fstream>
#include <random>

using namespace quadrille;

namespace {

constexpr std::uint32_t jointCount = 80;
constexpr int influencesPerVertex = 4;

struct Skin
{
    std::vector<Vec3f> rest;
    std::vector<std::uint32_t> starts{0};
    std::vector<SceneInfluence> influences;
    std::vector<Eigen::Matrix4f> matrices;
};

Skin makeSkin(std::int64_t vertices)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-1, 1);
    std::uniform_int_distribution<std::uint32_t> joint(0, jointCount - 1);
    Skin skin;
    for (std::int64_t v = 0; v < vertices; ++v) {
        skin.rest.emplace_back(real(random), real(random), real(random));
        for (int i = 0; i < influencesPerVertex; ++i)
            skin.influences.push_back({joint(random), 1.0F / influencesPerVertex});
        skin.starts.push_back(static_cast<std::uint32_t>(skin.influences.size()));
    }
    for (std::uint32_t j = 0; j < jointCount; ++j) {
        Eigen::Matrix4f matrix = Eigen::Matrix4f::Random();
        matrix.row(3) << 0, 0, 0, 1;
        skin.matrices.push_back(matrix);
    }
    return skin;
}

void bakeSkin(benchmark::State& state)
{
    const Skin source = makeSkin(state.range(0));
    std::vector<Vec3f> positions(source.rest.size());
    for (auto _ : state) {
        std::copy(source.rest.begin(), source.rest.end(), positions.begin());
        skin(source.starts, source.influences, source.matrices, positions);
        benchmark::DoNotOptimize(positions.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Each influence moves the vertex by its matrix, then the results are averaged.
void bakeSkinPlainly(benchmark::State& state)
{
    const Skin source = makeSkin(state.range(0));
    std::vector<Vec3f> positions(source.rest.size());
    for (auto _ : state) {
        for (std::size_t v = 0; v < positions.size(); ++v) {
            Vec3f sum = Vec3f::Zero();
            for (std::uint32_t i = source.starts[v]; i < source.starts[v + 1]; ++i) {
                const SceneInfluence& influence = source.influences[i];
                sum += influence.weight *
                       (source.matrices[influence.joint] * source.rest[v].homogeneous()).head<3>();
            }
            positions[v] = sum;
        }
        benchmark::DoNotOptimize(positions.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

constexpr std::int32_t animeFrames = 100;
constexpr std::int32_t animeVertices = 10000;

std::filesystem::path animeFile()
{
    const auto path = std::filesystem::temp_directory_path() / "quadrille-bench.anime";
    std::ofstream out(path, std::ios::binary);
    const std::int32_t header[] = {animeFrames, animeVertices, 1};
    const std::int32_t triangle[] = {0, 1, 2};
    const std::vector<float> positions(std::size_t{animeVertices} * 3, 1.0F);
    const auto write = [&](const void* data, std::size_t bytes) {
        out.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    };
    write(header, sizeof(header));
    write(positions.data(), positions.size() * sizeof(float));
    write(triangle, sizeof(triangle));
    for (int f = 1; f < animeFrames; ++f)
        write(positions.data(), positions.size() * sizeof(float));
    return path;
}

void readAnime(benchmark::State& state)
{
    SourceFiles source;
    source.files = {animeFile()};
    const MeshSequence sequence = AnimeImporter().open(source, {}, {}).sequences.front();
    std::vector<Vec3f> out(animeVertices);
    for (auto _ : state) {
        for (int f = 0; f < animeFrames; ++f)
            sequence.source->read(FrameIndex(f), out);
        benchmark::DoNotOptimize(out.data());
    }
    state.SetBytesProcessed(state.iterations() * animeFrames * animeVertices * 12);
}

void readBytesPlainly(benchmark::State& state)
{
    const InputFile file(animeFile());
    std::vector<Vec3f> out(animeVertices);
    for (auto _ : state) {
        for (int f = 0; f < animeFrames; ++f)
            file.read(static_cast<std::uint64_t>(f) * animeVertices * 12,
                      std::as_writable_bytes(std::span(out)));
        benchmark::DoNotOptimize(out.data());
    }
    state.SetBytesProcessed(state.iterations() * animeFrames * animeVertices * 12);
}

} // namespace

BENCHMARK(bakeSkin)->Arg(5000)->Arg(50000);
BENCHMARK(bakeSkinPlainly)->Arg(5000)->Arg(50000);
BENCHMARK(readAnime);
BENCHMARK(readBytesPlainly);
