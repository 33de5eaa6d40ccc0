// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/meshfile.h"

#include "model/core/file.h"
#include "model/sequence/io/mesh/findtextures.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// A mesh that is in memory; remembers its file for messages.
class SingleMesh : public MemoryFrames
{
public:
    SingleMesh(std::vector<Vec3f> positions, std::uint32_t vertexCount, fs::path file)
        : MemoryFrames(std::move(positions), vertexCount), m_file(std::move(file))
    {
    }
    fs::path fileOf(FrameIndex) const override { return m_file; }

private:
    fs::path m_file;
};

/// A numbered series: one file per frame, read when asked for.
class SeriesFrames : public FrameSource
{
public:
    SeriesFrames(std::vector<fs::path> files, decltype(MeshFormat::parse) parse,
                 std::shared_ptr<const Topology> topology, std::shared_ptr<const PositionReader> reader)
        : m_files(std::move(files))
        , m_parse(parse)
        , m_topology(std::move(topology))
        , m_reader(std::move(reader))
    {
    }
    std::int64_t frameCount() const override { return static_cast<std::int64_t>(m_files.size()); }
    std::uint32_t vertexCount() const override { return m_topology->vertexCount(); }
    fs::path fileOf(FrameIndex frame) const override
    {
        return m_files[static_cast<std::size_t>(frame.value)];
    }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        try {
            readFileOf(fileOf(frame), out);
        } catch (const Error& error) {
            auto context = error.context();
            context.place.frame = frame;
            throw Error(error.code(), std::move(context));
        }
    }

private:
    void readFileOf(const fs::path& file, MutablePositions out) const
    {
        const FileContent content = readFile(file);
        if (m_reader && m_reader->read(content.text(), out))
            return;
        const MeshFile mesh = m_parse(content.text(), file);
        checkSameTopology(m_topology->data(), mesh.topology, file);
        std::copy(mesh.positions.begin(), mesh.positions.end(), out.begin());
    }

    std::vector<fs::path> m_files;
    decltype(MeshFormat::parse) m_parse;
    std::shared_ptr<const Topology> m_topology;
    std::shared_ptr<const PositionReader> m_reader;
};

class MeshImporter : public Importer
{
public:
    explicit MeshImporter(MeshFormat format) : m_format(std::move(format)) {}
    const FormatInfo& format() const override { return m_format.info; }
    bool recognises(std::string_view head) const override
    {
        return m_format.recognises && m_format.recognises(head);
    }
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override
    {
        progress.report(0);
        const fs::path& file = source.files.front();
        const FileContent content = readFile(file);
        MeshFile mesh = m_format.parse(content.text(), file);
        progress.report(0.5);
        ImportResult result;
        result.issues = std::move(mesh.issues);
        const auto topology = buildTopology(mesh.topology, mesh.positions, file, result.issues);
        std::shared_ptr<const FrameSource> frames;
        if (source.files.size() == 1) {
            frames = std::make_shared<SingleMesh>(std::move(mesh.positions), topology->vertexCount(), file);
        } else {
            auto reader =
                m_format.makePositionReader ? m_format.makePositionReader(content.text(), mesh) : nullptr;
            frames =
                std::make_shared<SeriesFrames>(source.files, m_format.parse, topology, std::move(reader));
        }
        auto sequence = makeSequence(source.stem, topology, std::move(frames), options.fps);
        auto named = texturesNamedBy(mesh, file);
        result.issues.insert(result.issues.end(), named.issues.begin(), named.issues.end());
        auto found =
            findTextures({source, sequence.frameCount(), options.textures, std::move(named.textures)});
        result.issues.insert(result.issues.end(), found.issues.begin(), found.issues.end());
        sequence.textures = std::move(found.textures);
        result.sequences.push_back(std::move(sequence));
        progress.report(1);
        return result;
    }

private:
    MeshFormat m_format;
};

void report(std::vector<Issue>& issues, Issue::Code code, std::int64_t count, const fs::path& file,
            Issue::Severity severity = Issue::Severity::Warning)
{
    if (count > 0)
        issues.push_back({severity, code, {file, {}, {{"count", std::to_string(count)}}}});
}

std::int64_t countWithoutArea(const std::vector<Triangle>& triangles, Positions positions)
{
    return std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
        const Vec3d a = positions[triangle[0].value].cast<double>();
        const Vec3d ab = positions[triangle[1].value].cast<double>() - a;
        const Vec3d ac = positions[triangle[2].value].cast<double>() - a;
        // Relative to the edges: a tiny mesh is no worse than a large one. 1e-9 is far below what positions
        // in float can tell from zero.
        return ab.cross(ac).squaredNorm() <= 1e-18 * ab.squaredNorm() * ac.squaredNorm();
    });
}

std::string joined(const Triangle& triangle)
{
    return std::to_string(triangle[0].value) + ", " + std::to_string(triangle[1].value) + ", " +
           std::to_string(triangle[2].value);
}

} // namespace

std::unique_ptr<Importer> makeMeshImporter(MeshFormat format)
{
    return std::make_unique<MeshImporter>(std::move(format));
}

std::shared_ptr<const Topology> buildTopology(TopologyData data, Positions positions, const fs::path& file,
                                              std::vector<Issue>& issues)
{
    auto topology = std::make_shared<const Topology>(std::move(data), file);
    if (topology->isPolygonSoup()) {
        throw Error(ErrorCode::PolygonSoup,
                    {file, {}, {{"count", std::to_string(topology->triangles().size())}}});
    }
    const auto& statistics = topology->statistics();
    report(issues, Issue::Code::NonManifoldEdges, statistics.nonManifoldEdges, file);
    report(issues, Issue::Code::UnusedVertices, statistics.unusedVertices, file, Issue::Severity::Info);
    if (positions.size() == topology->vertexCount()) {
        report(issues, Issue::Code::DegenerateTriangles, countWithoutArea(topology->triangles(), positions),
               file, Issue::Severity::Info);
    }
    return topology;
}

void checkSameTopology(const TopologyData& first, const TopologyData& other, const fs::path& file)
{
    if (other.vertexCount != first.vertexCount) {
        throw Error(ErrorCode::VertexCountMismatch, {file,
                                                     {},
                                                     {{"found", std::to_string(other.vertexCount)},
                                                      {"expected", std::to_string(first.vertexCount)}}});
    }
    const auto differs = [&file](std::string what) {
        throw Error(ErrorCode::TopologyMismatch, {file, {}, {{"what", std::move(what)}}});
    };
    if (other.triangles.size() != first.triangles.size()) {
        differs(std::to_string(other.triangles.size()) + " triangles instead of " +
                std::to_string(first.triangles.size()));
    }
    for (std::size_t t = 0; t < first.triangles.size(); ++t) {
        if (other.triangles[t] != first.triangles[t]) {
            differs("triangle " + std::to_string(t) + " joins vertices " + joined(other.triangles[t]) +
                    " instead of " + joined(first.triangles[t]));
        }
    }
    if (other.triangleUvs.empty() != first.triangleUvs.empty())
        differs(first.triangleUvs.empty() ? "it has texture coordinates" : "it has no texture coordinates");
    // Exporters may round differently from file to file; a fifth of a pixel in a map of 16,384 is no matter.
    constexpr float tolerance = 1e-5F;
    for (std::size_t t = 0; t < first.triangleUvs.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec2f difference = other.uvs[other.triangleUvs[t][c]] - first.uvs[first.triangleUvs[t][c]];
            if (!(difference.cwiseAbs().maxCoeff() <= tolerance))
                differs("triangle " + std::to_string(t) + " has other texture coordinates");
        }
    }
}

} // namespace quadrille
