// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/pointcache.h"

#include "model/core/error.h"
#include "model/core/stagedfiles.h"
#include "model/sequence/io/basemesh.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/mesh/findtextures.h"
#include "model/sequence/io/registry.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "point caches are read as they are");

namespace {

void swapBytes(std::span<Vec3f> positions)
{
    for (Vec3f& p : positions) {
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(p[axis])));
    }
}

std::uint16_t swapped(std::uint16_t bits)
{
    return __builtin_bswap16(bits);
}

std::uint64_t swapped(std::uint64_t bits)
{
    return __builtin_bswap64(bits);
}

float toFloat(std::uint16_t bits)
{
    return static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits));
}

float toFloat(std::uint64_t bits)
{
    return static_cast<float>(std::bit_cast<double>(bits));
}

/// Frames in a file, read by offset when asked for.
class PointCacheFrames : public FrameSource
{
public:
    PointCacheFrames(std::shared_ptr<const InputFile> file, PointCacheLayout layout)
        : m_file(std::move(file)), m_layout(std::move(layout))
    {
    }
    std::int64_t frameCount() const override { return m_layout.frameCount; }
    std::uint32_t vertexCount() const override { return static_cast<std::uint32_t>(m_layout.vertexCount); }
    fs::path fileOf(FrameIndex) const override { return m_file->path(); }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        const auto offset = m_layout.offset + static_cast<std::uint64_t>(frame.value) * m_layout.frameBytes();
        try {
            if (m_layout.numberBytes == sizeof(std::uint16_t)) {
                readConverted<std::uint16_t>(offset, out);
            } else if (m_layout.numberBytes == sizeof(std::uint64_t)) {
                readConverted<std::uint64_t>(offset, out);
            } else {
                m_file->read(offset, std::as_writable_bytes(out));
                if (m_layout.isBigEndian)
                    swapBytes(out);
            }
        } catch (const Error& error) {
            auto context = error.context();
            context.place.frame = frame;
            throw Error(error.code(), std::move(context));
        }
    }

private:
    template <typename Bits>
    void readConverted(std::uint64_t offset, MutablePositions out) const
    {
        const auto raw = std::make_unique_for_overwrite<Bits[]>(out.size() * 3);
        m_file->read(offset, std::as_writable_bytes(std::span(raw.get(), out.size() * 3)));
        const Bits* next = raw.get();
        for (Vec3f& p : out) {
            for (int axis = 0; axis < 3; ++axis, ++next)
                p[axis] = toFloat(m_layout.isBigEndian ? swapped(*next) : *next);
        }
    }

    std::shared_ptr<const InputFile> m_file;
    PointCacheLayout m_layout;
};

/// Meshes that may belong to a point cache, the likeliest first.
std::vector<fs::path> meshesBeside(const fs::path& file)
{
    static const std::vector<std::string> extensions{".obj", ".ply"};
    const fs::path folder = file.parent_path();
    std::vector<fs::path> meshes;
    std::error_code error;
    for (const fs::path& stem : {file.stem(), fs::path("mesh")}) {
        for (const auto& extension : extensions) {
            const fs::path mesh = folder / (stem.string() + extension);
            if (fs::is_regular_file(mesh, error))
                meshes.push_back(mesh);
        }
    }
    const auto content = scanFolder(folder, extensions);
    if (content.series.empty() && content.singles.size() == 1)
        meshes.push_back(content.singles.front().files.front());
    return meshes;
}

[[noreturn]] void throwVertexCount(const fs::path& mesh, const fs::path& file, std::int64_t found,
                                   std::int64_t expected)
{
    throw Error(ErrorCode::VertexCountMismatch,
                {mesh,
                 {},
                 {{"found", std::to_string(found)},
                  {"expected", std::to_string(expected) + " (" + file.filename().string() + ")"}}});
}

BaseMesh findBaseMesh(const fs::path& file, const PointCacheLayout& layout, const ImportOptions& options,
                      const Progress& progress)
{
    if (!options.mesh.empty()) {
        auto base = readBaseMesh(options.mesh, progress);
        if (base.topology->vertexCount() != layout.vertexCount)
            throwVertexCount(options.mesh, file, base.topology->vertexCount(), layout.vertexCount);
        return base;
    }
    const auto candidates = meshesBeside(file);
    if (candidates.empty())
        throw Error(ErrorCode::FormatNeedsMesh, {file, {}, {}});
    std::int64_t otherCount = 0;
    for (const auto& candidate : candidates) {
        auto base = readBaseMesh(candidate, progress);
        if (base.topology->vertexCount() == layout.vertexCount) {
            base.issues.push_back({.severity = Issue::Severity::Info,
                                   .code = Issue::Code::MeshFound,
                                   .context = {file, {}, {{"path", candidate.string()}}}});
            return base;
        }
        otherCount = base.topology->vertexCount();
    }
    throwVertexCount(candidates.back(), file, otherCount, layout.vertexCount);
}

class PointCacheImporter : public Importer
{
public:
    explicit PointCacheImporter(PointCacheFormat format) : m_format(std::move(format)) {}
    const FormatInfo& format() const override { return m_format.info; }
    bool recognises(std::string_view head) const override { return m_format.recognises(head); }
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override
    {
        const fs::path& path = source.files.front();
        if (source.files.size() > 1) {
            throw Error(ErrorCode::SeriesAmbiguous,
                        {source.path,
                         {},
                         {{"found", std::to_string(source.files.size()) + " files, each with many frames"}}});
        }
        const auto file = std::make_shared<const InputFile>(path);
        const auto layout = m_format.readLayout(*file);
        checkLayout(layout, *file);
        auto base = findBaseMesh(path, layout, options, progress.part(0, 0.9));
        ImportResult result;
        result.issues = std::move(base.issues);
        result.issues.insert(result.issues.end(), layout.issues.begin(), layout.issues.end());
        result.hasOwnFps = layout.fps.has_value();
        auto found = findTextures({source, layout.frameCount, options.textures, base.textures});
        result.issues.insert(result.issues.end(), found.issues.begin(), found.issues.end());
        auto sequence =
            makeSequence(source.stem, base.topology, std::make_shared<PointCacheFrames>(file, layout),
                         layout.fps.value_or(options.fps));
        sequence.textures = std::move(found.textures);
        result.sequences.push_back(std::move(sequence));
        progress.report(1);
        return result;
    }

private:
    PointCacheFormat m_format;
};

class PointCacheExporter : public Exporter
{
public:
    explicit PointCacheExporter(PointCacheWriterFormat format) : m_format(std::move(format)) {}
    const FormatInfo& format() const override { return m_format.info; }
    ExportResult write(const MeshSequence& sequence, const fs::path& out, const ExportOptions& options,
                       const Progress& progress) const override
    {
        const auto write = [&](const fs::path& temporary) {
            std::ofstream file(temporary, std::ios::binary);
            if (!file)
                throwSystemError(out, errno, ErrorCode::WriteFailed);
            writeAll(sequence, file, progress);
            file.close();
            if (!file)
                throwSystemError(out, errno, ErrorCode::WriteFailed);
        };
        writeGuarded(out, write, options.guard);
        progress.report(1);
        return {{out}, {}};
    }

private:
    /// Some frames at a time, read in parallel. A file that cannot be written stays failed.
    void writeAll(const MeshSequence& sequence, std::ofstream& file, const Progress& progress) const
    {
        const std::string header = m_format.header(sequence);
        file.write(header.data(), static_cast<std::streamsize>(header.size()));
        constexpr std::int64_t batchBytes = std::int64_t{16} << 20;
        const std::int64_t frameBytes = std::int64_t{sequence.topology->vertexCount()} * 12;
        const std::int64_t batch = std::max<std::int64_t>(1, batchBytes / frameBytes);
        const std::int64_t frames = sequence.frameCount();
        for (std::int64_t first = 0; first < frames && file; first += batch) {
            const std::int64_t last = std::min(first + batch, frames) - 1;
            auto positions = loadFrames(sequence.cutTo({FrameIndex(first), FrameIndex(last)}));
            progress.report(first, frames);
            if (m_format.isBigEndian)
                swapBytes(positions);
            file.write(reinterpret_cast<const char*>(positions.data()),
                       static_cast<std::streamsize>(positions.size() * sizeof(Vec3f)));
        }
    }

    PointCacheWriterFormat m_format;
};

} // namespace

void checkLayout(const PointCacheLayout& layout, const InputFile& file)
{
    if (layout.vertexCount <= 0)
        throw Error(ErrorCode::NoVertices, {file.path(), {}, {}});
    if (layout.frameCount <= 0)
        throw Error(ErrorCode::FileSyntax,
                    {file.path(),
                     {},
                     {{"reason", "the header says " + std::to_string(layout.frameCount) + " frames"}}});
    const std::uint64_t held = file.size() - std::min(layout.offset, file.size());
    const std::uint64_t numbersAtMost = held / (std::uint64_t{3} * layout.numberBytes);
    const auto tooLarge = [&](std::int64_t count, const char* what) {
        throw Error(ErrorCode::CountTooLarge,
                    {file.path(), {}, {{"count", std::to_string(count)}, {"what", what}}});
    };
    constexpr std::int64_t verticesAtMost = 0x7FFFFFFF;
    if (static_cast<std::uint64_t>(layout.vertexCount) > numbersAtMost || layout.vertexCount > verticesAtMost)
        tooLarge(layout.vertexCount, "vertices");
    const auto framesHeld = static_cast<std::int64_t>(held / layout.frameBytes());
    if (layout.frameCount <= framesHeld)
        return;
    throw Error(ErrorCode::FileTruncated,
                {file.path(),
                 {.byte = static_cast<std::int64_t>(file.size()), .frame = FrameIndex(framesHeld)},
                 {{"expected", std::to_string(layout.frameCount) + " frames"},
                  {"found", std::to_string(framesHeld)}}});
}

std::unique_ptr<Importer> makePointCacheImporter(PointCacheFormat format)
{
    return std::make_unique<PointCacheImporter>(std::move(format));
}

std::unique_ptr<Exporter> makePointCacheExporter(PointCacheWriterFormat format)
{
    return std::make_unique<PointCacheExporter>(std::move(format));
}

} // namespace quadrille
