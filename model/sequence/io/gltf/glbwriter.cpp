// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/glbwriter.h"

#include "model/core/seriesname.h"
#include "model/core/stagedfiles.h"
#include "model/render/shading.h"
#include "model/sequence/io/files/copytextures.h"
#include "model/sequence/io/files/exporttexture.h"
#include "model/sequence/io/gltf/glbparts.h"
#include "model/sequence/io/gltf/gltf.h"
#include "model/sequence/io/scene/cornersplit.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>

namespace quadrille {

namespace {

using OrderedJson = GlbParts::Json;

constexpr int floatType = GlbParts::floatType;
constexpr int uintType = GlbParts::uintType;
constexpr std::uint64_t largestGlb = std::numeric_limits<std::uint32_t>::max();
/// Above this a float no longer holds every whole number.
constexpr std::uint32_t largestExactVertex = 1U << 24;

enum class Attribute
{
    Position,
    Normal,
};

OrderedJson toJson(const Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

/// The split vertices that are not as in the first frame.
std::vector<std::uint32_t> movedIn(const std::vector<Vec3f>& offsets)
{
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = 0; i < offsets.size(); ++i) {
        if (offsets[i] != Vec3f::Zero())
            moved.push_back(i);
    }
    return moved;
}

/// A sparse accessor has at least one value: that of the first vertex, which is not changed by it.
template <typename T>
std::vector<T> orOne(std::vector<T> values, const T& fallback)
{
    if (values.empty())
        values.push_back(fallback);
    return values;
}

template <typename T>
void writeValues(std::ostream& out, const std::vector<T>& values)
{
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(T)));
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
        , m_neighbours(trianglesOfVertices(sequence.topology->triangles(), sequence.topology->vertexCount()))
    {
        m_first[0] = valuesOf(Attribute::Position, FrameIndex(0));
        if (options.normals)
            m_first[1] = valuesOf(Attribute::Normal, FrameIndex(0));
    }

    ExportResult write(const Progress& progress)
    {
        planMaterials();
        planMesh();
        planMorphTargets(progress.part(0, 0.4));
        planNodes();
        m_parts.finish();
        if (m_parts.fileBytes() > largestGlb) {
            throw Error(
                ErrorCode::FormatCannotStore,
                {m_out,
                 {},
                 {{"format", "GLB"},
                  {"what", "more than 4 GB (this would be " + sizeText(m_parts.bufferBytes()) + ")"}}});
        }
        const auto write = [&](const std::filesystem::path& file) {
            m_parts.write(file, m_out, progress.part(0.4, 0.7));
        };
        if (!hasFrameTextures()) {
            writeGuarded(m_out, write, m_options.guard);
            m_result.files.push_back(m_out);
            return std::move(m_result);
        }
        if (m_options.guard != nullptr)
            m_options.guard->checkPlace(m_out);
        StagedFiles files(m_out.parent_path(), m_options.guard);
        write(files.add(m_out.filename().string()));
        const std::string stem = seriesStem(m_out);
        copyTextures(m_sequence, stem, files, progress.part(0.7, 1));
        m_result.files = {m_out}; // what was asked for is the first
        std::ranges::remove_copy(files.commit(), std::back_inserter(m_result.files), m_out);
        m_result.issues.push_back({Issue::Severity::Info,
                                   Issue::Code::TexturesBeside,
                                   {m_out, {}, {{"path", "textures/" + stem}}}});
        return std::move(m_result);
    }

private:
    /// Those are written beside, since no material can change them.
    bool hasFrameTextures() const
    {
        return m_options.textures && m_sequence.textures.kind() == TextureSet::Kind::PerFrame;
    }

    void planMaterials()
    {
        const auto& names = m_sequence.topology->data().materials;
        const TextureSet& textures = m_sequence.textures;
        for (std::size_t m = 0; m < std::max<std::size_t>(1, names.size()); ++m) {
            OrderedJson material = {{"name", m < names.size() ? names[m] : m_sequence.name}};
            material["pbrMetallicRoughness"] = {{"metallicFactor", 0}, {"roughnessFactor", 1}};
            const int index = textures.indexFor(m_sequence.sourceFrame(FrameIndex(0)), static_cast<int>(m));
            const Texture texture =
                index < 0 ? Texture() : textures.textures()[static_cast<std::size_t>(index)];
            if (m_options.textures && !texture.isEmpty())
                material["pbrMetallicRoughness"]["baseColorTexture"] = {
                    {"index", textureIndex(index, texture)}};
            m_parts.json["materials"].push_back(std::move(material));
        }
    }

    std::size_t textureIndex(int index, const Texture& texture)
    {
        if (const auto known = m_textureOf.find(index); known != m_textureOf.end())
            return known->second;
        EncodedTexture encoded = encodeTexture(texture);
        const std::string mimeType = encoded.mimeType;
        const std::size_t view = m_parts.addView(std::move(encoded.bytes));
        m_parts.json["images"].push_back({{"bufferView", view}, {"mimeType", mimeType}});
        const std::size_t source = m_parts.json["images"].size() - 1;
        m_parts.json["textures"].push_back({{"source", source}});
        return m_textureOf[index] = m_parts.json["textures"].size() - 1;
    }

    void planMesh()
    {
        const TopologyData& topology = m_sequence.topology->data();
        const std::uint64_t count = m_split.vertexOf.size();
        std::vector<Vec3f> positions;
        for (const std::uint32_t v : m_split.vertexOf)
            positions.push_back(m_first[0][v]);
        Vec3f low = positions.front();
        Vec3f high = low;
        for (const Vec3f& p : positions) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const std::size_t position =
            m_parts.addArray(m_parts.addView(std::move(positions)), floatType, count, "VEC3");
        m_parts.json["accessors"][position]["min"] = toJson(low);
        m_parts.json["accessors"][position]["max"] = toJson(high);
        m_attributes = {{"POSITION", position}};
        if (m_options.normals) {
            std::vector<Vec3f> normals;
            for (const std::uint32_t v : m_split.vertexOf)
                normals.push_back(m_first[1][v]);
            m_attributes["NORMAL"] =
                m_parts.addArray(m_parts.addView(std::move(normals)), floatType, count, "VEC3");
        }
        if (!m_split.uvOf.empty()) {
            std::vector<Vec2f> uvs;
            for (const std::uint32_t uv : m_split.uvOf)
                uvs.emplace_back(topology.uvs[uv].x(), 1.0F - topology.uvs[uv].y());
            m_attributes["TEXCOORD_0"] =
                m_parts.addArray(m_parts.addView(std::move(uvs)), floatType, count, "VEC2");
        }
        if (topology.vertexCount <= largestExactVertex) {
            const std::vector<float> vertices(m_split.vertexOf.begin(), m_split.vertexOf.end());
            m_attributes[gltfVertexAttribute] =
                m_parts.addArray(m_parts.addView(vertices), floatType, count, "SCALAR");
        }
        for (std::size_t m = 0; m < m_parts.json["materials"].size(); ++m)
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
        m_primitives.push_back(
            {{"attributes", m_attributes},
             {"indices", m_parts.addArray(m_parts.addView(std::move(corners)), uintType, count, "SCALAR")},
             {"material", material}});
    }

    /// An attribute in a frame, per vertex of the topology.
    std::vector<Vec3f> valuesOf(Attribute attribute, FrameIndex frame) const
    {
        const Frame shown = m_sequence.frame(frame);
        if (attribute == Attribute::Position)
            return {shown.positions().begin(), shown.positions().end()};
        std::vector<Vec3f> normals =
            vertexNormals(shown.positions(), m_sequence.topology->triangles(), m_neighbours);
        // glTF wants unit length, also where no triangle says which way.
        std::replace(normals.begin(), normals.end(), Vec3f(Vec3f::Zero()), Vec3f(0, 1, 0));
        return normals;
    }

    /// What a morph target adds to the first frame, per split vertex.
    std::vector<Vec3f> offsetsOf(Attribute attribute, FrameIndex frame) const
    {
        const std::vector<Vec3f> values = valuesOf(attribute, frame);
        const std::vector<Vec3f>& first = m_first[static_cast<std::size_t>(attribute)];
        std::vector<Vec3f> offsets;
        offsets.reserve(m_split.vertexOf.size());
        for (const std::uint32_t v : m_split.vertexOf)
            offsets.push_back(values[v] - first[v]);
        return offsets;
    }

    void planMorphTargets(const Progress& progress)
    {
        const std::int64_t frames = m_sequence.frameCount();
        OrderedJson targets = OrderedJson::array();
        for (std::int64_t f = 1; f < frames; ++f) {
            progress.report(f, frames);
            const FrameIndex frame(f);
            const std::vector<Vec3f> offsets = offsetsOf(Attribute::Position, frame);
            OrderedJson position = accessorOf(Attribute::Position, frame, offsets);
            Vec3f low = offsets.front();
            Vec3f high = low;
            for (const Vec3f& offset : offsets) {
                low = low.cwiseMin(offset);
                high = high.cwiseMax(offset);
            }
            position["min"] = toJson(low);
            position["max"] = toJson(high);
            const bool isDense = position.contains("bufferView");
            OrderedJson target = {{"POSITION", m_parts.addAccessor(std::move(position))}};
            // Where nearly all vertices move, nearly all normals turn: they need not be counted.
            if (m_options.normals && isDense)
                target["NORMAL"] = m_parts.addAccessor(denseAccessor(Attribute::Normal, frame));
            else if (m_options.normals)
                target["NORMAL"] = m_parts.addAccessor(
                    accessorOf(Attribute::Normal, frame, offsetsOf(Attribute::Normal, frame)));
            targets.push_back(std::move(target));
        }
        if (targets.empty())
            return;
        for (OrderedJson& primitive : m_primitives)
            primitive["targets"] = targets;
        planAnimation(static_cast<std::size_t>(frames));
    }

    OrderedJson emptyAccessor() const
    {
        return {{"componentType", floatType}, {"count", m_split.vertexOf.size()}, {"type", "VEC3"}};
    }

    OrderedJson denseAccessor(Attribute attribute, FrameIndex frame)
    {
        OrderedJson accessor = emptyAccessor();
        accessor["bufferView"] = m_parts.addView(
            m_split.vertexOf.size() * sizeof(Vec3f),
            [this, attribute, frame](std::ostream& out) { writeValues(out, offsetsOf(attribute, frame)); });
        return accessor;
    }

    /// Sparse where that is smaller.
    OrderedJson accessorOf(Attribute attribute, FrameIndex frame, const std::vector<Vec3f>& offsets)
    {
        const std::uint64_t count = std::max<std::size_t>(1, movedIn(offsets).size());
        if (count * (sizeof(std::uint32_t) + sizeof(Vec3f)) >= offsets.size() * sizeof(Vec3f))
            return denseAccessor(attribute, frame);
        const auto indices =
            m_parts.addView(count * sizeof(std::uint32_t), [this, attribute, frame](std::ostream& out) {
                writeValues(out, orOne(movedIn(offsetsOf(attribute, frame)), 0U));
            });
        const auto values =
            m_parts.addView(count * sizeof(Vec3f), [this, attribute, frame](std::ostream& out) {
                std::vector<Vec3f> all = offsetsOf(attribute, frame);
                std::erase(all, Vec3f(Vec3f::Zero()));
                writeValues(out, orOne(std::move(all), Vec3f(Vec3f::Zero())));
            });
        OrderedJson accessor = emptyAccessor();
        accessor["sparse"] = {{"count", count},
                              {"indices", {{"bufferView", indices}, {"componentType", uintType}}},
                              {"values", {{"bufferView", values}}}};
        return accessor;
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
        const auto input = m_parts.addArray(m_parts.addView(std::move(times)), floatType, frames, "SCALAR");
        m_parts.json["accessors"][input]["min"] = {0};
        m_parts.json["accessors"][input]["max"] = {lastTime};
        const auto output =
            m_parts.addArray(m_parts.addView(std::move(weights)), floatType, weightCount, "SCALAR");
        m_parts.json["animations"] = {
            {{"name", m_sequence.name},
             {"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}},
             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    }

    /// glTF is y up and in metres; a sequence in another system gets a node that turns and scales it.
    void planNodes()
    {
        OrderedJson node = {{"name", m_sequence.name}, {"mesh", 0}};
        if (m_options.to != CoordinateSystem()) {
            Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
            matrix.topLeftCorner<3, 3>() = conversionMatrix(m_options.to, CoordinateSystem());
            node["matrix"] = std::vector<float>(matrix.data(), matrix.data() + 16);
        }
        m_parts.json["scene"] = 0;
        m_parts.json["scenes"] = {{{"nodes", {0}}}};
        m_parts.json["nodes"] = OrderedJson::array({std::move(node)});
        m_parts.json["meshes"] =
            OrderedJson::array({{{"name", m_sequence.name}, {"primitives", m_primitives}}});
        if (m_sequence.frameCount() > 1)
            m_parts.json["meshes"][0]["weights"] =
                std::vector<int>(static_cast<std::size_t>(m_sequence.frameCount() - 1), 0);
    }

    const MeshSequence& m_sequence;
    const ExportOptions& m_options;
    std::filesystem::path m_out;
    CornerSplit m_split;
    IncidentTriangles m_neighbours;
    std::array<std::vector<Vec3f>, 2> m_first; ///< by attribute: what the first frame has
    GlbParts m_parts;
    OrderedJson m_attributes;
    OrderedJson m_primitives = OrderedJson::array();
    std::map<int, std::size_t> m_textureOf;
    ExportResult m_result;
};

} // namespace

const FormatInfo& GlbExporter::format() const
{
    static const FormatInfo info{
        .id = "gltf", .name = "glTF", .extensions = {".glb"}, .frameTexturesBeside = true};
    return info;
}

ExportResult GlbExporter::write(const MeshSequence& sequence, const std::filesystem::path& out,
                                const ExportOptions& options, const Progress& progress) const
{
    const std::uint64_t estimate = estimateGlbBytes(sequence, options.normals);
    ExportResult result = Writer(sequence, options, out).write(progress);
    if (estimate > glbLargeBytes)
        result.issues.push_back(
            {Issue::Severity::Warning, Issue::Code::FileLarge, {out, {}, {{"size", sizeText(estimate)}}}});
    return result;
}

} // namespace quadrille
