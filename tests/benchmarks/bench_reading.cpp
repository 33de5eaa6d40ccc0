// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Reading sequences: an OBJ series beside OpenMesh's reader, a PLY series and a point cache beside a plain
// read of the same bytes. All files are in the page cache.
#include "model/core/file.h"
#include "model/sequence/io/registry.h"
#include "model/sequence/meshsequence.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <benchmark/benchmark.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <unistd.h>

using namespace quadrille;

namespace {

namespace fs = std::filesystem;

constexpr int columns = 64;
constexpr int rows = 64;
constexpr std::int64_t frames = 20;

/// A tube that sways, of 4,160 vertices and 8,192 triangles with UVs.
MeshSequence swayingTube()
{
    TopologyData data;
    data.vertexCount = columns * (rows + 1);
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c)
            data.uvs.emplace_back(static_cast<float>(c) / columns, static_cast<float>(r) / rows);
    }
    const auto vertex = [](int r, int c) {
        return VertexIndex(static_cast<std::uint32_t>(r * columns + c % columns));
    };
    const auto uv = [](int r, int c) { return static_cast<std::uint32_t>(r * (columns + 1) + c); };
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            data.triangles.push_back({vertex(r, c), vertex(r, c + 1), vertex(r + 1, c + 1)});
            data.triangleUvs.push_back({uv(r, c), uv(r, c + 1), uv(r + 1, c + 1)});
            data.triangles.push_back({vertex(r, c), vertex(r + 1, c + 1), vertex(r + 1, c)});
            data.triangleUvs.push_back({uv(r, c), uv(r + 1, c + 1), uv(r + 1, c)});
        }
    }
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frames; ++f) {
        for (int r = 0; r <= rows; ++r) {
            for (int c = 0; c < columns; ++c) {
                const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(c) / columns;
                const float height = 1.8F * static_cast<float>(r) / rows;
                const float sway = 0.1F * std::sin(height + 0.3F * static_cast<float>(f));
                positions.emplace_back(0.2F * std::cos(angle) + sway, height, 0.2F * std::sin(angle));
            }
        }
    }
    return makeSequence("tube", std::make_shared<const Topology>(std::move(data)),
                        std::make_shared<MemoryFrames>(std::move(positions), columns * (rows + 1)), 25);
}

/// The tube in every format, in a folder that is removed at the end.
class Files
{
public:
    static const Files& instance()
    {
        static const Files files;
        return files;
    }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    ~Files() { fs::remove_all(m_folder); }

    fs::path objSeries() const { return m_folder / "obj"; }
    fs::path plySeries() const { return m_folder / "ply"; }
    fs::path pointCache() const { return m_folder / "tube.pc2"; }
    fs::path mesh() const { return objSeries() / "tube_0000.obj"; }

private:
    Files() : m_folder(fs::temp_directory_path() / ("quadrille-bench-" + std::to_string(::getpid())))
    {
        const MeshSequence tube = swayingTube();
        exportSequence(tube, objSeries() / "tube.obj");
        exportSequence(tube, plySeries() / "tube.ply");
        exportSequence(tube, pointCache());
    }

    fs::path m_folder;
};

std::uint64_t bytesIn(const fs::path& folder)
{
    std::uint64_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        bytes += entry.file_size();
    return bytes;
}

/// Opening and reading all frames, as a first look at a series costs; on one thread.
void readSeries(benchmark::State& state, const fs::path& folder)
{
    for (auto _ : state) {
        const MeshSequence sequence = openSequences(folder).sequences.front();
        std::vector<Vec3f> out(sequence.topology->vertexCount());
        for (std::int64_t f = 0; f < sequence.frameCount(); ++f)
            sequence.source->read(FrameIndex(f), out);
        benchmark::DoNotOptimize(out.data());
    }
    state.SetItemsProcessed(state.iterations() * frames);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytesIn(folder)));
}

void objSeries(benchmark::State& state)
{
    readSeries(state, Files::instance().objSeries());
}

void objSeriesByOpenMesh(benchmark::State& state)
{
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    const fs::path folder = Files::instance().objSeries();
    for (auto _ : state) {
        for (const fs::path& file : findSource(folder).files) {
            Mesh mesh;
            mesh.request_halfedge_texcoords2D();
            OpenMesh::IO::Options options = OpenMesh::IO::Options::FaceTexCoord;
            if (!OpenMesh::IO::read_mesh(mesh, file.string(), options))
                state.SkipWithError("OpenMesh cannot read it");
            benchmark::DoNotOptimize(mesh.n_vertices());
        }
    }
    state.SetItemsProcessed(state.iterations() * frames);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytesIn(folder)));
}

void plySeries(benchmark::State& state)
{
    readSeries(state, Files::instance().plySeries());
}

void plySeriesAsBytes(benchmark::State& state)
{
    const fs::path folder = Files::instance().plySeries();
    for (auto _ : state) {
        for (const fs::path& file : findSource(folder).files)
            benchmark::DoNotOptimize(readFile(file).size);
    }
    state.SetItemsProcessed(state.iterations() * frames);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytesIn(folder)));
}

void pointCache(benchmark::State& state)
{
    ImportOptions options;
    options.mesh = Files::instance().mesh();
    const MeshSequence sequence = openSequences(Files::instance().pointCache(), options).sequences.front();
    std::vector<Vec3f> out(sequence.topology->vertexCount());
    for (auto _ : state) {
        for (std::int64_t f = 0; f < frames; ++f)
            sequence.source->read(FrameIndex(f), out);
        benchmark::DoNotOptimize(out.data());
    }
    state.SetItemsProcessed(state.iterations() * frames);
    state.SetBytesProcessed(state.iterations() * frames * static_cast<std::int64_t>(out.size()) * 12);
}

void pointCacheAsBytes(benchmark::State& state)
{
    const InputFile file(Files::instance().pointCache());
    std::vector<Vec3f> out(columns * (rows + 1));
    const std::uint64_t frameBytes = out.size() * sizeof(Vec3f);
    for (auto _ : state) {
        for (std::uint64_t f = 0; f < frames; ++f)
            file.read(32 + f * frameBytes, std::as_writable_bytes(std::span(out)));
        benchmark::DoNotOptimize(out.data());
    }
    state.SetItemsProcessed(state.iterations() * frames);
    state.SetBytesProcessed(state.iterations() * frames * static_cast<std::int64_t>(frameBytes));
}

/// A point cache of 4 GB, of which hardly anything is on disk.
void openLargePointCache(benchmark::State& state)
{
    constexpr std::int32_t vertices = columns * (rows + 1);
    constexpr std::int32_t count = 86'000;
    const fs::path path =
        fs::temp_directory_path() / ("quadrille-bench-" + std::to_string(::getpid()) + ".pc2");
    {
        std::ofstream out(path, std::ios::binary);
        const std::int32_t head[] = {1, vertices};
        const float rates[] = {0, 1};
        out.write("POINTCACHE2\0", 12);
        out.write(reinterpret_cast<const char*>(head), sizeof head);
        out.write(reinterpret_cast<const char*>(rates), sizeof rates);
        out.write(reinterpret_cast<const char*>(&count), sizeof count);
    }
    fs::resize_file(path, 32 + std::uint64_t{vertices} * 12 * count);
    ImportOptions options;
    options.mesh = Files::instance().mesh();
    for (auto _ : state) {
        const MeshSequence sequence = openSequences(path, options).sequences.front();
        benchmark::DoNotOptimize(sequence.frame(FrameIndex(count - 1)));
    }
    state.counters["gigabytes"] = static_cast<double>(fs::file_size(path)) / 1e9;
    fs::remove(path);
}

} // namespace

BENCHMARK(objSeries)->Unit(benchmark::kMillisecond);
BENCHMARK(objSeriesByOpenMesh)->Unit(benchmark::kMillisecond);
BENCHMARK(plySeries)->Unit(benchmark::kMillisecond);
BENCHMARK(plySeriesAsBytes)->Unit(benchmark::kMillisecond);
BENCHMARK(pointCache)->Unit(benchmark::kMillisecond);
BENCHMARK(pointCacheAsBytes)->Unit(benchmark::kMillisecond);
BENCHMARK(openLargePointCache)->Unit(benchmark::kMillisecond);
