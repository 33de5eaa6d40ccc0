// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/hdf5sequence.h"

#include "model/core/file.h"
#include "model/core/hdf5.h"
#include "model/core/message.h"
#include "model/sequence/io/mesh/meshfile.h"
#include "model/sequence/io/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

/// Deflate packs at most about a thousand to one: more values than that cannot be in the file.
constexpr double largestRatio = 1100;
constexpr std::size_t blockBytes = std::size_t{4} << 20;

[[noreturn]] void failReading(const std::filesystem::path& file, std::optional<FrameIndex> frame = {})
{
    if (const int number = hdf5SystemError(); number != 0)
        throwSystemError(file, number, ErrorCode::ReadFailed);
    throw Error(ErrorCode::ReadFailed,
                {file, {.frame = frame}, {{"reason", QUADRILLE_MESSAGE("a part of the file is damaged")}}});
}

/// What a dataset is, as far as it matters here.
struct DatasetShape
{
    std::string name;
    H5T_class_t type = H5T_NO_CLASS;
    std::vector<hsize_t> size;
};

Hdf5Handle openDataset(const Hdf5Handle& file, const std::string& name)
{
    return {H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose};
}

std::vector<std::string> datasetNames(const Hdf5Handle& file)
{
    std::vector<std::string> names;
    const auto visit = [](hid_t, const char* name, const H5O_info_t* info, void* out) -> herr_t {
        if (info->type == H5O_TYPE_DATASET)
            static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, visit, &names, H5O_INFO_BASIC);
    return names;
}

std::optional<DatasetShape> shapeOf(const Hdf5Handle& file, const std::string& name)
{
    const Hdf5Handle dataset = openDataset(file, name);
    const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
    if (!type.isValid() || !space.isValid())
        return std::nullopt;
    DatasetShape shape{name, H5Tget_class(type.id()), {}};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 1)
        return std::nullopt;
    shape.size.resize(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.id(), shape.size.data(), nullptr);
    return shape;
}

/// Refuses more values than the file can hold.
/// \throws Error CountTooLarge, FileSyntax.
void checkSize(const Hdf5Handle& file, const DatasetShape& shape, const std::filesystem::path& path)
{
    double values = 1;
    std::string count;
    for (const hsize_t n : shape.size) {
        values *= static_cast<double>(n);
        count += (count.empty() ? "" : " × ") + std::to_string(n);
    }
    if (values > largestRatio * static_cast<double>(InputFile(path).size())) {
        throw Error(ErrorCode::CountTooLarge,
                    {path, {}, {{"count", count}, {"what", "values of “" + shape.name + "”"}}});
    }
    if (!holdsAllValues(openDataset(file, shape.name))) {
        throw Error(ErrorCode::FileSyntax,
                    {path, {}, {{"reason", "“" + shape.name + "” has less data than " + count + " values"}}});
    }
}

/// The triangles; those that name a vertex twice are left out.
TopologyData readFaces(const Hdf5Handle& file, const DatasetShape& shape, const std::filesystem::path& path,
                       std::vector<Issue>& issues)
{
    checkSize(file, shape, path);
    std::vector<std::int64_t> values(shape.size[0] * 3);
    const Hdf5Handle dataset = openDataset(file, shape.name);
    if (H5Dread(dataset.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        failReading(path);
    TopologyData data;
    PolygonCollector collector;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % 3 == 0)
            collector.begin();
        // What does not fit becomes the largest index, which Topology refuses.
        const bool fits = values[i] >= 0 && values[i] < std::int64_t{0xffffffff};
        collector.add(fits ? static_cast<std::uint32_t>(values[i]) : 0xffffffffU);
        if (i % 3 == 2)
            collector.end(data);
    }
    collector.finish(data, path, issues);
    return data;
}

/// Reads frames of one dataset in blocks: in a dataset vertices × 3 × frames a frame lies scattered, and some
/// neighbours cost little more than one.
class Hdf5Frames : public FrameSource
{
public:
    Hdf5Frames(std::shared_ptr<const Hdf5Handle> file, std::filesystem::path path, Hdf5Handle dataset,
               std::uint32_t vertexCount, std::int64_t frameCount, bool framesLast)
        : m_file(std::move(file))
        , m_path(std::move(path))
        , m_dataset(std::move(dataset))
        , m_vertexCount(vertexCount)
        , m_frameCount(frameCount)
        , m_framesLast(framesLast)
    {
    }
    std::int64_t frameCount() const override { return m_frameCount; }
    std::uint32_t vertexCount() const override { return m_vertexCount; }
    std::filesystem::path fileOf(FrameIndex) const override { return m_path; }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        const auto lock = lockHdf5();
        if (frame.value < m_blockFirst || frame.value >= m_blockFirst + m_blockCount)
            readBlock(frame);
        const auto at = static_cast<std::size_t>(frame.value - m_blockFirst);
        const auto count = static_cast<std::size_t>(m_blockCount);
        const std::size_t values = out.size() * 3;
        auto* to = reinterpret_cast<float*>(out.data());
        for (std::size_t i = 0; i < values; ++i)
            to[i] = m_framesLast ? m_block[i * count + at] : m_block[at * values + i];
    }

private:
    void readBlock(FrameIndex frame) const
    {
        const std::size_t frameBytes = std::size_t{m_vertexCount} * sizeof(Vec3f);
        const auto length = static_cast<std::int64_t>(std::max<std::size_t>(1, blockBytes / frameBytes));
        const std::int64_t first = frame.value / length * length;
        const std::int64_t count = std::min(length, m_frameCount - first);
        m_blockCount = 0;
        m_block.resize(static_cast<std::size_t>(count) * m_vertexCount * 3);
        const auto frames = static_cast<hsize_t>(count);
        const std::array<hsize_t, 3> size = m_framesLast ? std::array<hsize_t, 3>{m_vertexCount, 3, frames}
                                                         : std::array<hsize_t, 3>{frames, m_vertexCount, 3};
        std::array<hsize_t, 3> start{0, 0, 0};
        start[m_framesLast ? 2 : 0] = static_cast<hsize_t>(first);
        const Hdf5Handle from(H5Dget_space(m_dataset.id()), H5Sclose);
        const Hdf5Handle to(H5Screate_simple(3, size.data(), nullptr), H5Sclose);
        if (H5Sselect_hyperslab(from.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) < 0 ||
            H5Dread(m_dataset.id(), H5T_NATIVE_FLOAT, to.id(), from.id(), H5P_DEFAULT, m_block.data()) < 0)
            failReading(m_path, frame);
        m_blockFirst = first;
        m_blockCount = count;
    }

    std::shared_ptr<const Hdf5Handle> m_file; ///< keeps the file open
    std::filesystem::path m_path;
    Hdf5Handle m_dataset;
    std::uint32_t m_vertexCount;
    std::int64_t m_frameCount;
    bool m_framesLast;
    // The block read last, guarded by the lock of the library.
    mutable std::vector<float> m_block;
    mutable std::int64_t m_blockFirst = 0;
    mutable std::int64_t m_blockCount = 0;
};

std::optional<double> fpsOf(const Hdf5Handle& dataset)
{
    if (H5Aexists(dataset.id(), "fps") <= 0)
        return std::nullopt;
    const Hdf5Handle attribute(H5Aopen(dataset.id(), "fps", H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
    double fps = 0;
    if (H5Sget_simple_extent_npoints(space.id()) != 1 ||
        H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &fps) < 0 || !(fps > 0) || !std::isfinite(fps))
        return std::nullopt;
    return fps;
}

struct Content
{
    std::optional<DatasetShape> faces;
    std::vector<DatasetShape> sequences;
};

Content listContent(const Hdf5Handle& file)
{
    Content content;
    for (const std::string& name : datasetNames(file)) {
        auto shape = shapeOf(file, name);
        if (!shape)
            continue;
        const auto& size = shape->size;
        if (shape->type == H5T_INTEGER && size.size() == 2 && size[1] == 3) {
            if (!content.faces || name.ends_with("faces"))
                content.faces = std::move(shape);
        } else if (shape->type == H5T_FLOAT && size.size() == 3 && (size[1] == 3 || size[2] == 3)) {
            content.sequences.push_back(std::move(*shape));
        }
    }
    return content;
}

} // namespace

const FormatInfo& Hdf5Importer::format() const
{
    static const FormatInfo info{
        .id = "hdf5", .name = "HDF5 (Dynamic FAUST)", .extensions = {".hdf5", ".h5"}};
    return info;
}

bool Hdf5Importer::recognises(std::string_view head) const
{
    return head.starts_with("\x89HDF\r\n\x1a\n");
}

ImportResult Hdf5Importer::open(const SourceFiles& source, const ImportOptions& options,
                                const Progress& progress) const
{
    progress.report(0);
    const auto& path = source.files.front();
    const auto lock = lockHdf5();
    const auto file = std::make_shared<const Hdf5Handle>(openHdf5(path));
    const Content content = listContent(*file);
    if (content.sequences.empty()) {
        throw Error(
            ErrorCode::FileSyntax,
            {path, {}, {{"reason", QUADRILLE_MESSAGE("there is no dataset of vertices × 3 × frames")}}});
    }
    if (!content.faces)
        throw Error(ErrorCode::NoFaces, {path, {}, {}});
    ImportResult result;
    TopologyData triangles = readFaces(*file, *content.faces, path, result.issues);
    std::shared_ptr<const Topology> topology;
    for (const DatasetShape& shape : content.sequences) {
        checkSize(*file, shape, path);
        const auto name = shape.name.substr(shape.name.find_last_of('/') + 1);
        if (!options.clip.empty() && name != options.clip)
            continue;
        const bool framesLast = shape.size[1] == 3;
        const hsize_t vertices = shape.size[framesLast ? 0 : 1];
        const auto frames = static_cast<std::int64_t>(shape.size[framesLast ? 2 : 0]);
        if (vertices == 0 || frames == 0)
            throw Error(ErrorCode::NoVertices, {path, {}, {}});
        if (!topology || topology->vertexCount() != vertices) {
            triangles.vertexCount = static_cast<std::uint32_t>(vertices);
            topology = buildTopology(triangles, {}, path, result.issues);
        }
        Hdf5Handle dataset = openDataset(*file, shape.name);
        const auto fps = fpsOf(dataset);
        result.hasOwnFps = result.hasOwnFps || fps.has_value();
        result.sequences.push_back(
            makeSequence(name, topology,
                         std::make_shared<Hdf5Frames>(file, path, std::move(dataset), topology->vertexCount(),
                                                      frames, framesLast),
                         fps.value_or(options.fps)));
    }
    if (result.sequences.empty()) {
        throw Error(ErrorCode::BadArgument,
                    {path,
                     {},
                     {{"reason", "There is no clip “" + options.clip + "”"},
                      {"remedy", QUADRILLE_MESSAGE("Clips are named after the datasets.")}}});
    }
    return result;
}

} // namespace quadrille
