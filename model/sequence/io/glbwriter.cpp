// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/glbwriter.h"

#include "model/core/file.h"
#include "model/sequence/io/cornersplit.h"
#include "model/sequence/io/exporttexture.h"
#include "model/sequence/io/gltf.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace quadrille {

namespace {

using Json = nlohmann::ordered_json;

constexpr int floatType = 5126;
constexpr int uintType = 5125;
constexpr std::uint64_t largestGlb = std::numeric_limits<std::uint32_t>::max();
/// Above this a float no longer holds every whole number.
constexpr std::uint32_t largestExactVertex = 1U << 24;

/// How far the vertices of a frame are from the first one's.
struct FrameOffsets
{
    Vec3f low = Vec3f::Zero();
    Vec3f high = Vec3f::Zero();
    std::uint64_t moved = 0; ///< split vertices that are not where they are in the first frame
};

Json toJson(const Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Plans the document first, from one pass over the frames, then writes it in a second one: the frames never
/// lie in memory together.
class Writer
{
public:
    Writer(const MeshSequence& sequence, const ExportOptions& options, std::filesystem::path out)
        : m_sequence(sequence)
        , m_options(options)
        , m_out(std::move(out))
        , m_split(splitCorners(sequence.topology->data()))
        , m_first(sequence.frame(FrameIndex(0)))
    {
    }

    ExportResult write(const Progress& progress)
    {
        planMaterials();
        planMesh();
        planMorphTargets(progress.part(0, 0.4));
        planNodes();
        std::string json = finishedJson();
        if (28 + json.size() + m_bytes > largestGlb) {
            throw Error(
                ErrorCode::FormatCannotStore,
                {m_out,
                 {},
                 {{"format", "GLB"}, {"what", "more than 4 GB (this would be " + sizeText(m_bytes) + ")"}}});
        }
        writeAtomically(m_out, [&](const std::filesystem::path& path) {
            std::ofstream file(path, std::ios::binary);
            if (!file)
                throwSystemError(m_out, errno, ErrorCode::WriteFailed);
            writeAll(file, json, progress.part(0.4, 1));
        });
        m_result.files.push_back(m_out);
        return std::move(m_result);
    }

private:
    using Source = std::function<void(std::ostream&)>;

    /// Adds a buffer view whose bytes `source` will write.
    std::size_t addView(std::uint64_t bytes, Source source)
    {
        Json view = {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", bytes}};
        m_json["bufferViews"].push_back(std::move(view));
        m_parts.push_back({std::move(source), (4 - bytes % 4) % 4});
        m_bytes += (bytes + 3) / 4 * 4;
        return m_json["bufferViews"].size() - 1;
    }

    template <typename T>
    std::size_t addView(std::vector<T> values)
    {
        const std::uint64_t bytes = values.size() * sizeof(T);
        return addView(bytes, [values = std::move(values), bytes](std::ostream& out) {
            out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(bytes));
        });
    }

    std::size_t addAccessor(Json accessor)
    {
        m_json["accessors"].push_back(std::move(accessor));
        return m_json["accessors"].size() - 1;
    }

    std::size_t addArray(std::size_t view, int type, std::uint64_t count, const char* shape)
    {
        return addAccessor(
            {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}});
    }

    void planMaterials()
    {
        const auto& names = m_sequence.topology->data().materials;
        const TextureSet& textures = m_sequence.textures;
        if (m_options.textures && textures.kind() == TextureSet::Kind::PerFrame) {
            m_result.issues.push_back(
                {Issue::Severity::Warning,
                 Issue::Code::Other,
                 {m_out,
                  {},
                  {{"text", "GLB cannot change textures: only that of the first frame was written."}}}});
        }
        for (std::size_t m = 0; m < std::max<std::size_t>(1, names.size()); ++m) {
            Json material = {{"name", m < names.size() ? names[m] : m_sequence.name}};
            material["pbrMetallicRoughness"] = {{"metallicFactor", 0}, {"roughnessFactor", 1}};
            const int index = textures.indexFor(m_sequence.sourceFrame(FrameIndex(0)), static_cast<int>(m));
            const Texture texture =
                index < 0 ? Texture() : textures.textures()[static_cast<std::size_t>(index)];
            if (m_options.textures && !texture.isEmpty())
                material["pbrMetallicRoughness"]["baseColorTexture"] = {
                    {"index", textureIndex(index, texture)}};
            m_json["materials"].push_back(std::move(material));
        }
    }

    std::size_t textureIndex(int index, const Texture& texture)
    {
        if (const auto known = m_textureOf.find(index); known != m_textureOf.end())
            return known->second;
        EncodedTexture encoded = encodeTexture(texture);
        const std::string mimeType = encoded.mimeType;
        const std::size_t view = addView(std::move(encoded.bytes));
        m_json["images"].push_back({{"bufferView", view}, {"mimeType", mimeType}});
        const std::size_t source = m_json["images"].size() - 1;
        m_json["textures"].push_back({{"source", source}});
        return m_textureOf[index] = m_json["textures"].size() - 1;
    }

    void planMesh()
    {
        const TopologyData& topology = m_sequence.topology->data();
        const std::uint64_t count = m_split.vertexOf.size();
        std::vector<Vec3f> positions;
        for (const std::uint32_t v : m_split.vertexOf)
            positions.push_back(m_first.positions()[v]);
        Vec3f low = positions.front();
        Vec3f high = low;
        for (const Vec3f& p : positions) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const std::size_t position = addArray(addView(std::move(positions)), floatType, count, "VEC3");
        m_json["accessors"][position]["min"] = toJson(low);
        m_json["accessors"][position]["max"] = toJson(high);
        m_attributes = {{"POSITION", position}};
        if (!m_split.uvOf.empty()) {
            std::vector<Vec2f> uvs;
            for (const std::uint32_t uv : m_split.uvOf)
                uvs.emplace_back(topology.uvs[uv].x(), 1.0F - topology.uvs[uv].y());
            m_attributes["TEXCOORD_0"] = addArray(addView(std::move(uvs)), floatType, count, "VEC2");
        }
        if (topology.vertexCount <= largestExactVertex) {
            const std::vector<float> vertices(m_split.vertexOf.begin(), m_split.vertexOf.end());
            m_attributes[gltfVertexAttribute] = addArray(addView(vertices), floatType, count, "SCALAR");
        }
        for (std::size_t m = 0; m < m_json["materials"].size(); ++m)
            planPrimitive(m);
    }

    void planPrimitive(std::size_t material)
    {
        const auto& materials = m_sequence.topology->data().triangleMaterials;
        std::vector<std::uint32_t> corners;
        for (std::size_t t = 0; t < m_split.triangles.size(); ++t) {
            if ((materials.empty() ? 0 : materials[t]) == material)
                corners.insert(corners.end(), m_split.triangles[t].begin(), m_split.triangles[t].end());
        }
        if (corners.empty())
            return;
        const std::uint64_t count = corners.size();
        m_primitives.push_back({{"attributes", m_attributes},
                                {"indices", addArray(addView(std::move(corners)), uintType, count, "SCALAR")},
                                {"material", material}});
    }

    FrameOffsets offsetsOf(FrameIndex frame) const
    {
        FrameOffsets offsets;
        const Frame other = m_sequence.frame(frame);
        bool isFirst = true;
        for (const std::uint32_t v : m_split.vertexOf) {
            const Vec3f offset = other.positions()[v] - m_first.positions()[v];
            offsets.moved += offset != Vec3f::Zero();
            offsets.low = isFirst ? offset : Vec3f(offsets.low.cwiseMin(offset));
            offsets.high = isFirst ? offset : Vec3f(offsets.high.cwiseMax(offset));
            isFirst = false;
        }
        return offsets;
    }

    void planMorphTargets(const Progress& progress)
    {
        const std::int64_t frames = m_sequence.frameCount();
        Json targets = Json::array();
        for (std::int64_t f = 1; f < frames; ++f) {
            progress.report(f, frames);
            const FrameOffsets offsets = offsetsOf(FrameIndex(f));
            const std::uint64_t count = m_split.vertexOf.size();
            Json accessor = {{"componentType", floatType}, {"count", count}, {"type", "VEC3"}};
            accessor["min"] = toJson(offsets.low);
            accessor["max"] = toJson(offsets.high);
            const std::uint64_t sparse = std::max<std::uint64_t>(1, offsets.moved);
            if (sparse * (sizeof(std::uint32_t) + sizeof(Vec3f)) < count * sizeof(Vec3f))
                accessor["sparse"] = planSparse(FrameIndex(f), sparse);
            else
                accessor["bufferView"] = addView(count * sizeof(Vec3f), [this, f](std::ostream& out) {
                    writeOffsets(out, FrameIndex(f), false);
                });
            targets.push_back({{"POSITION", addAccessor(std::move(accessor))}});
        }
        if (targets.empty())
            return;
        for (Json& primitive : m_primitives)
            primitive["targets"] = targets;
        planAnimation(static_cast<std::size_t>(frames));
    }

    Json planSparse(FrameIndex frame, std::uint64_t count)
    {
        const auto indices = addView(count * sizeof(std::uint32_t),
                                     [this, frame](std::ostream& out) { writeMovedVertices(out, frame); });
        const auto values = addView(count * sizeof(Vec3f),
                                    [this, frame](std::ostream& out) { writeOffsets(out, frame, true); });
        return {{"count", count},
                {"indices", {{"bufferView", indices}, {"componentType", uintType}}},
                {"values", {{"bufferView", values}}}};
    }

    /// Weight k − 1 is one in frame k and zero in every other frame.
    void planAnimation(std::size_t frames)
    {
        std::vector<float> times(frames);
        for (std::size_t f = 0; f < frames; ++f)
            times[f] = static_cast<float>(static_cast<double>(f) / m_sequence.fps);
        std::vector<float> weights(frames * (frames - 1), 0.0F);
        for (std::size_t f = 1; f < frames; ++f)
            weights[f * (frames - 1) + f - 1] = 1.0F;
        const float lastTime = times.back();
        const std::uint64_t weightCount = weights.size();
        const auto input = addArray(addView(std::move(times)), floatType, frames, "SCALAR");
        m_json["accessors"][input]["min"] = {0};
        m_json["accessors"][input]["max"] = {lastTime};
        const auto output = addArray(addView(std::move(weights)), floatType, weightCount, "SCALAR");
        m_json["animations"] = {
            {{"name", m_sequence.name},
             {"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}},
             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    }

    /// glTF is y up and in metres; a sequence in another system gets a node that turns and scales it.
    void planNodes()
    {
        Json node = {{"name", m_sequence.name}, {"mesh", 0}};
        if (m_options.to != CoordinateSystem()) {
            Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
            matrix.topLeftCorner<3, 3>() = conversionMatrix(m_options.to, CoordinateSystem());
            node["matrix"] = std::vector<float>(matrix.data(), matrix.data() + 16);
        }
        m_json["scene"] = 0;
        m_json["scenes"] = {{{"nodes", {0}}}};
        m_json["nodes"] = Json::array({std::move(node)});
        m_json["meshes"] = Json::array({{{"name", m_sequence.name}, {"primitives", m_primitives}}});
        if (m_sequence.frameCount() > 1)
            m_json["meshes"][0]["weights"] =
                std::vector<int>(static_cast<std::size_t>(m_sequence.frameCount() - 1), 0);
    }

    std::string finishedJson()
    {
        m_json["asset"] = {{"version", "2.0"}, {"generator", "Quadrille"}};
        m_json["buffers"] = Json::array({{{"byteLength", m_bytes}}});
        std::string text = m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return text;
    }

    void writeMovedVertices(std::ostream& out, FrameIndex frame) const
    {
        const Frame other = m_sequence.frame(frame);
        std::vector<std::uint32_t> moved;
        for (std::uint32_t i = 0; i < m_split.vertexOf.size(); ++i) {
            const std::uint32_t v = m_split.vertexOf[i];
            if (other.positions()[v] != m_first.positions()[v])
                moved.push_back(i);
        }
        if (moved.empty())
            moved.push_back(0);
        out.write(reinterpret_cast<const char*>(moved.data()),
                  static_cast<std::streamsize>(moved.size() * sizeof(std::uint32_t)));
    }

    void writeOffsets(std::ostream& out, FrameIndex frame, bool onlyMoved) const
    {
        const Frame other = m_sequence.frame(frame);
        std::vector<Vec3f> offsets;
        for (const std::uint32_t v : m_split.vertexOf) {
            const Vec3f offset = other.positions()[v] - m_first.positions()[v];
            if (!onlyMoved || other.positions()[v] != m_first.positions()[v])
                offsets.push_back(offset);
        }
        if (offsets.empty())
            offsets.emplace_back(Vec3f::Zero());
        out.write(reinterpret_cast<const char*>(offsets.data()),
                  static_cast<std::streamsize>(offsets.size() * sizeof(Vec3f)));
    }

    void writeAll(std::ofstream& file, const std::string& json, const Progress& progress) const
    {
        const auto number = [&](std::uint64_t value) {
            const auto narrow = static_cast<std::uint32_t>(value);
            file.write(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
        };
        file << "glTF";
        number(2);
        number(28 + json.size() + m_bytes);
        number(json.size());
        file << "JSON" << json;
        number(m_bytes);
        file.write("BIN\0", 4);
        for (std::size_t p = 0; p < m_parts.size(); ++p) {
            progress.report(static_cast<std::int64_t>(p), static_cast<std::int64_t>(m_parts.size()));
            m_parts[p].write(file);
            file.write("\0\0\0", static_cast<std::streamsize>(m_parts[p].padding));
            if (!file)
                throwSystemError(m_out, errno, ErrorCode::WriteFailed);
        }
        file.flush();
        if (!file)
            throwSystemError(m_out, errno, ErrorCode::WriteFailed);
    }

    struct Part
    {
        Source write;
        std::uint64_t padding;
    };

    const MeshSequence& m_sequence;
    const ExportOptions& m_options;
    std::filesystem::path m_out;
    CornerSplit m_split;
    Frame m_first;
    Json m_json = Json::object();
    Json m_attributes;
    Json m_primitives = Json::array();
    std::map<int, std::size_t> m_textureOf;
    std::vector<Part> m_parts;
    std::uint64_t m_bytes = 0;
    ExportResult m_result;
};

} // namespace

const FormatInfo& GlbExporter::format() const
{
    static const FormatInfo info{.id = "gltf", .name = "glTF", .extensions = {".glb"}};
    return info;
}

ExportResult GlbExporter::write(const MeshSequence& sequence, const std::filesystem::path& out,
                                const ExportOptions& options, const Progress& progress) const
{
    const std::uint64_t estimate = estimateGlbBytes(sequence);
    ExportResult result = Writer(sequence, options, out).write(progress);
    if (estimate > glbLargeBytes)
        result.issues.push_back(
            {Issue::Severity::Warning, Issue::Code::FileLarge, {out, {}, {{"size", sizeText(estimate)}}}});
    return result;
}

} // namespace quadrille
