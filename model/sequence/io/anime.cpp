// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/anime.h"

#include "model/core/file.h"
#include "model/core/message.h"
#include "model/sequence/io/mesh/meshfile.h"
#include "model/sequence/io/mesh/polygons.h"

#include <array>

namespace quadrille {

namespace {

constexpr std::uint64_t animeHeaderBytes = 12;

/// The first frame in memory, the offsets of the others read when asked for.
class AnimeFrames : public FrameSource
{
public:
    AnimeFrames(std::shared_ptr<const InputFile> file, std::vector<Vec3f> first, std::int64_t frameCount,
                std::uint64_t offsetsAt)
        : m_file(std::move(file)), m_first(std::move(first)), m_frameCount(frameCount), m_offsetsAt(offsetsAt)
    {
    }
    std::int64_t frameCount() const override { return m_frameCount; }
    std::uint32_t vertexCount() const override { return static_cast<std::uint32_t>(m_first.size()); }
    std::filesystem::path fileOf(FrameIndex) const override { return m_file->path(); }
    std::optional<Positions> view(FrameIndex frame) const override
    {
        return frame.value == 0 ? std::optional<Positions>(m_first) : std::nullopt;
    }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        if (frame.value == 0) {
            std::copy(m_first.begin(), m_first.end(), out.begin());
            return;
        }
        const std::uint64_t offset =
            m_offsetsAt + static_cast<std::uint64_t>(frame.value - 1) * m_first.size() * sizeof(Vec3f);
        m_file->read(offset, std::as_writable_bytes(out));
        for (std::size_t v = 0; v < out.size(); ++v)
            out[v] += m_first[v];
    }

private:
    std::shared_ptr<const InputFile> m_file;
    std::vector<Vec3f> m_first;
    std::int64_t m_frameCount;
    std::uint64_t m_offsetsAt;
};

struct Header
{
    std::int32_t frames = 0;
    std::int32_t vertices = 0;
    std::int32_t triangles = 0;
};

/// \throws Error FileTruncated, NoVertices, NoFaces, CountTooLarge.
Header readHeader(const InputFile& file)
{
    Header header;
    file.read(0, std::as_writable_bytes(std::span(&header, 1)));
    if (header.frames < 1 || header.vertices < 0 || header.triangles < 0) {
        throw Error(ErrorCode::FileSyntax,
                    {file.path(),
                     {.byte = 0},
                     {{"reason", QUADRILLE_MESSAGE("the header has counts below zero or no frame")}}});
    }
    if (header.vertices == 0)
        throw Error(ErrorCode::NoVertices, {file.path(), {}, {}});
    if (header.triangles == 0)
        throw Error(ErrorCode::NoFaces, {file.path(), {}, {}});
    const auto frameBytes = static_cast<std::uint64_t>(header.vertices) * sizeof(Vec3f);
    const auto triangleBytes = static_cast<std::uint64_t>(header.triangles) * sizeof(Triangle);
    if (animeHeaderBytes + frameBytes + triangleBytes > file.size()) {
        const bool tooMany = animeHeaderBytes + frameBytes > file.size();
        throw Error(ErrorCode::CountTooLarge,
                    {file.path(),
                     {.byte = tooMany ? 4 : 8},
                     {{"count", std::to_string(tooMany ? header.vertices : header.triangles)},
                      {"what", tooMany ? "vertices" : "triangles"}}});
    }
    const std::uint64_t expected =
        animeHeaderBytes + triangleBytes + static_cast<std::uint64_t>(header.frames) * frameBytes;
    if (expected > file.size()) {
        throw Error(ErrorCode::FileTruncated, {file.path(),
                                               {},
                                               {{"expected", std::to_string(expected) + " bytes for " +
                                                                 std::to_string(header.frames) + " frames"},
                                                {"found", std::to_string(file.size())}}});
    }
    return header;
}

/// The triangles; those that name a vertex twice are left out.
/// \throws Error IndexOutOfRange, NoFaces.
TopologyData readTriangles(const InputFile& file, const Header& header, std::uint64_t offset,
                           std::vector<Issue>& issues)
{
    std::vector<std::uint32_t> corners(static_cast<std::size_t>(header.triangles) * 3);
    file.read(offset, std::as_writable_bytes(std::span(corners)));
    TopologyData data;
    data.vertexCount = static_cast<std::uint32_t>(header.vertices);
    PolygonCollector collector;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] >= data.vertexCount) {
            throw Error(ErrorCode::IndexOutOfRange,
                        {file.path(),
                         {.byte = static_cast<std::int64_t>(offset + i * sizeof(std::uint32_t))},
                         {{"what", "vertex"},
                          {"index", std::to_string(static_cast<std::int32_t>(corners[i]))},
                          {"count", std::to_string(data.vertexCount)}}});
        }
        if (i % 3 == 0)
            collector.begin();
        collector.add(corners[i]);
        if (i % 3 == 2)
            collector.end(data);
    }
    collector.finish(data, file.path(), issues);
    return data;
}

} // namespace

const FormatInfo& AnimeImporter::format() const
{
    static const FormatInfo info{.id = "anime", .name = "DeformingThings4D", .extensions = {".anime"}};
    return info;
}

ImportResult AnimeImporter::open(const SourceFiles& source, const ImportOptions& options,
                                 const Progress& progress) const
{
    progress.report(0);
    const auto file = std::make_shared<const InputFile>(source.files.front());
    const Header header = readHeader(*file);
    std::vector<Vec3f> first(static_cast<std::size_t>(header.vertices));
    const std::uint64_t trianglesAt = animeHeaderBytes + first.size() * sizeof(Vec3f);
    const std::uint64_t offsetsAt =
        trianglesAt + static_cast<std::uint64_t>(header.triangles) * sizeof(Triangle);
    file->read(animeHeaderBytes, std::as_writable_bytes(std::span(first)));
    ImportResult result;
    auto data = readTriangles(*file, header, trianglesAt, result.issues);
    progress.report(0.5);
    const auto topology = buildTopology(std::move(data), first, file->path(), result.issues);
    result.sequences.push_back(makeSequence(
        source.files.front().stem().string(), topology,
        std::make_shared<AnimeFrames>(file, std::move(first), header.frames, offsetsAt), options.fps));
    return result;
}

} // namespace quadrille
