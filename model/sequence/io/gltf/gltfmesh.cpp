// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/message.h"
#include "model/sequence/io/gltf/gltf.h"
#include "model/sequence/io/gltf/gltfdocument.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace quadrille {

namespace {

using Json = GltfDocument::Json;

constexpr std::size_t maxMaterials = 65535;

/// KHR_texture_transform of the base colour, and the set of texture coordinates it uses.
struct UvSource
{
    std::string attribute = "TEXCOORD_0";
    Eigen::Matrix2f matrix = Eigen::Matrix2f::Identity();
    Vec2f offset = Vec2f::Zero();
};

const Json* baseColour(const Json& material)
{
    const auto pbr = material.find("pbrMetallicRoughness");
    if (pbr == material.end())
        return nullptr;
    const auto texture = pbr->find("baseColorTexture");
    return texture == pbr->end() || !texture->is_object() ? nullptr : &*texture;
}

UvSource uvSourceOf(const Json& material)
{
    UvSource source;
    const Json* colour = baseColour(material);
    if (!colour)
        return source;
    auto set = colour->value("texCoord", 0);
    const auto transform =
        colour->value("extensions", Json::object()).value("KHR_texture_transform", Json::object());
    if (!transform.empty()) {
        const auto scale = transform.value("scale", std::array{1.0F, 1.0F});
        const auto offset = transform.value("offset", std::array{0.0F, 0.0F});
        const float angle = transform.value("rotation", 0.0F);
        source.matrix << std::cos(angle) * scale[0], std::sin(angle) * scale[1], -std::sin(angle) * scale[0],
            std::cos(angle) * scale[1];
        source.offset = Vec2f(offset[0], offset[1]);
        set = transform.value("texCoord", set);
    }
    source.attribute = "TEXCOORD_" + std::to_string(set);
    return source;
}

/// Reads the base colour pictures of the materials, each picture once.
class MaterialReader
{
public:
    MaterialReader(const GltfDocument& document, Scene& scene) : m_document(document), m_scene(scene) {}

    void readAll()
    {
        const Json& materials = m_document.list("materials");
        if (materials.size() >= maxMaterials)
            m_document.fail(QUADRILLE_MESSAGE("there are more than 65,534 materials"));
        for (std::size_t m = 0; m < materials.size(); ++m) {
            const Json& material = m_document.at("materials", static_cast<std::int64_t>(m));
            SceneMaterial result{material.value("name", "material " + std::to_string(m + 1)), {}};
            if (const Json* colour = baseColour(material)) {
                const Json& texture = m_document.at("textures", gltfIndex(*colour, "index"));
                if (const auto image = gltfIndex(texture, "source"); image >= 0)
                    result.texture = textureOf(image);
            }
            m_scene.materials.push_back(std::move(result));
        }
    }

private:
    Texture textureOf(std::int64_t image)
    {
        const auto [entry, isNew] = m_textures.try_emplace(image);
        if (isNew)
            entry->second = readTexture(m_document.at("images", image));
        return entry->second;
    }

    /// Pictures are sRGB there whatever they say themselves (glTF 2.0, “Images”).
    Texture readTexture(const Json& image)
    {
        const std::string uri = image.value("uri", "");
        if (!uri.empty() && !uri.starts_with("data:")) {
            const auto file = m_document.fileOfUri(uri);
            std::error_code error;
            if (std::filesystem::is_regular_file(file, error))
                return {.file = file, .marks = ColourMarks::Ignored};
            m_scene.issues.push_back({Issue::Severity::Warning,
                                      Issue::Code::TextureMissing,
                                      {m_document.path(), {}, {{"path", file.string()}}}});
            return {};
        }
        try {
            const auto data = uri.empty() ? std::nullopt : m_document.dataOfUri(uri);
            const auto bytes = data ? std::span<const std::byte>(*data)
                                    : m_document.viewBytes(gltfIndex(image, "bufferView"));
            return {
                {},
                std::make_shared<const Image>(decodeImage(bytes, m_document.path(), ColourMarks::Ignored))};
        } catch (const Error&) {
            m_scene.issues.push_back(
                {Issue::Severity::Warning,
                 Issue::Code::TextureMissing,
                 {m_document.path(), {}, {{"path", image.value("name", "in the file")}}}});
            return {};
        }
    }

    const GltfDocument& m_document;
    Scene& m_scene;
    std::map<std::int64_t, Texture> m_textures;
};

std::vector<Vec3f> toVectors(const std::vector<float>& values)
{
    std::vector<Vec3f> vectors(values.size() / 3);
    std::copy(values.begin(), values.end(), vectors.empty() ? nullptr : vectors.front().data());
    return vectors;
}

/// Puts the primitives of one glTF mesh together.
class MeshReader
{
public:
    MeshReader(const GltfDocument& document, const Scene& scene) : m_document(document), m_scene(scene) {}

    SceneMesh read(const Json& json)
    {
        const auto primitives = json.find("primitives");
        if (primitives == json.end() || !primitives->is_array())
            return std::move(m_mesh);
        for (const Json& primitive : *primitives) {
            const auto mode = primitive.value("mode", 4);
            if (mode >= 4 && mode <= 6 && primitive.contains("attributes"))
                addPrimitive(primitive, mode);
        }
        m_mesh.morphWeights.assign(m_mesh.morphTargets.size(), 0.0F);
        setWeights(json);
        finishOriginalVertices();
        return std::move(m_mesh);
    }

private:
    /// Vertices that were read, and what they were read from.
    struct Part
    {
        Json attributes;
        Json targets;
        std::size_t first;
        std::int64_t count;
    };

    void addPrimitive(const Json& primitive, int mode)
    {
        const Json& attributes = primitive.at("attributes");
        const auto material = gltfIndex(primitive, "material");
        const Json targets = primitive.value("targets", Json::array());
        // Primitives of several materials may share their vertices.
        const auto shared = std::find_if(m_parts.begin(), m_parts.end(), [&](const Part& part) {
            return part.attributes == attributes && part.targets == targets;
        });
        if (shared != m_parts.end()) {
            addTriangles(primitive, mode, shared->first, shared->count);
            m_mesh.triangleMaterials.resize(m_mesh.triangles.size(), materialIndex(material));
            return;
        }
        const auto first = m_mesh.positions.size();
        if (!attributes.contains("POSITION"))
            m_document.fail(QUADRILLE_MESSAGE("a part of a mesh has no positions"));
        const auto positions = toVectors(m_document.floats(gltfIndex(attributes, "POSITION"), 3));
        const auto count = static_cast<std::int64_t>(positions.size());
        m_mesh.positions.insert(m_mesh.positions.end(), positions.begin(), positions.end());
        m_parts.push_back({attributes, targets, first, count});
        addTriangles(primitive, mode, first, count);
        m_mesh.triangleMaterials.resize(m_mesh.triangles.size(), materialIndex(material));
        addUvs(attributes, material, first, count);
        addInfluences(attributes, first, count);
        addMorphTargets(targets, first, count);
        if (const auto original = gltfIndex(attributes, gltfVertexAttribute); original >= 0) {
            const auto vertices = m_document.floats(original, 1, count);
            m_original.insert(m_original.end(), vertices.begin(), vertices.end());
        }
    }

    std::uint16_t materialIndex(std::int64_t material) const
    {
        if (material >= static_cast<std::int64_t>(m_document.list("materials").size()))
            m_document.fail(QUADRILLE_MESSAGE("a mesh has a material that is not there"));
        // The scene's last material stands for "none".
        return static_cast<std::uint16_t>(material < 0 ? m_scene.materials.size() - 1 : material);
    }

    void addTriangles(const Json& primitive, int mode, std::size_t first, std::int64_t count)
    {
        std::vector<std::uint32_t> corners;
        if (const auto accessor = gltfIndex(primitive, "indices"); accessor >= 0) {
            corners = m_document.integers(accessor, 1);
        } else {
            for (std::int64_t v = 0; v < count; ++v)
                corners.push_back(static_cast<std::uint32_t>(v));
        }
        for (std::uint32_t& corner : corners) {
            if (corner >= static_cast<std::uint64_t>(count)) {
                throw Error(ErrorCode::IndexOutOfRange, {m_document.path(),
                                                         {},
                                                         {{"what", "vertex"},
                                                          {"index", std::to_string(corner)},
                                                          {"count", std::to_string(count)}}});
            }
            corner += static_cast<std::uint32_t>(first);
        }
        if (mode == 4) {
            for (std::size_t c = 0; c + 3 <= corners.size(); c += 3)
                m_mesh.triangles.push_back({corners[c], corners[c + 1], corners[c + 2]});
            return;
        }
        for (std::size_t c = 2; c < corners.size(); ++c) {
            if (mode == 6)
                m_mesh.triangles.push_back({corners[0], corners[c - 1], corners[c]});
            else if (c % 2 == 0)
                m_mesh.triangles.push_back({corners[c - 2], corners[c - 1], corners[c]});
            else
                m_mesh.triangles.push_back({corners[c - 1], corners[c - 2], corners[c]});
        }
    }

    void addUvs(const Json& attributes, std::int64_t material, std::size_t first, std::int64_t count)
    {
        const UvSource source = material < 0 ? UvSource{} : uvSourceOf(m_document.at("materials", material));
        const auto accessor = gltfIndex(attributes, source.attribute.c_str());
        if (accessor < 0) {
            if (!m_mesh.uvs.empty())
                m_mesh.uvs.resize(m_mesh.positions.size(), Vec2f::Zero());
            return;
        }
        m_mesh.uvs.resize(first, Vec2f::Zero());
        const auto values = m_document.floats(accessor, 2, count);
        for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
            const Vec2f uv = source.matrix * Vec2f(values[i], values[i + 1]) + source.offset;
            m_mesh.uvs.emplace_back(uv.x(), 1.0F - uv.y());
        }
    }

    void addInfluences(const Json& attributes, std::size_t first, std::int64_t count)
    {
        for (int set = 0;; ++set) {
            const auto jointsAt = gltfIndex(attributes, ("JOINTS_" + std::to_string(set)).c_str());
            const auto weightsAt = gltfIndex(attributes, ("WEIGHTS_" + std::to_string(set)).c_str());
            if (jointsAt < 0 || weightsAt < 0)
                break;
            const auto joints = m_document.integers(jointsAt, 4, count);
            const auto weights = m_document.floats(weightsAt, 4, count);
            m_mesh.influences.resize(m_mesh.positions.size());
            for (std::size_t i = 0; i < joints.size(); ++i) {
                if (weights[i] != 0.0F)
                    m_mesh.influences[first + i / 4].push_back({joints[i], weights[i]});
            }
        }
        if (!m_mesh.influences.empty())
            m_mesh.influences.resize(m_mesh.positions.size());
    }

    void addMorphTargets(const Json& targets, std::size_t first, std::int64_t count)
    {
        const std::size_t targetCount = targets.is_array() ? targets.size() : 0;
        if (targetCount > m_mesh.morphTargets.size())
            m_mesh.morphTargets.resize(targetCount, std::vector<Vec3f>(first, Vec3f::Zero()));
        for (std::size_t t = 0; t < m_mesh.morphTargets.size(); ++t) {
            auto& offsets = m_mesh.morphTargets[t];
            const auto accessor = t < targetCount ? gltfIndex(targets[t], "POSITION") : -1;
            if (accessor >= 0) {
                const auto values = toVectors(m_document.floats(accessor, 3, count));
                offsets.insert(offsets.end(), values.begin(), values.end());
            } else {
                offsets.resize(m_mesh.positions.size(), Vec3f::Zero());
            }
        }
    }

    void setWeights(const Json& json)
    {
        const auto weights = json.find("weights");
        if (weights == json.end())
            return;
        const auto values = weights->get<std::vector<float>>();
        for (std::size_t t = 0; t < std::min(values.size(), m_mesh.morphWeights.size()); ++t)
            m_mesh.morphWeights[t] = values[t];
    }

    /// Takes the vertex order that the file names, if it makes sense.
    void finishOriginalVertices()
    {
        if (m_original.size() != m_mesh.positions.size())
            return;
        std::vector<bool> seen;
        std::vector<std::uint32_t> vertices;
        for (const float value : m_original) {
            if (!(value >= 0) || value >= static_cast<float>(m_original.size()) || value != std::floor(value))
                return;
            vertices.push_back(static_cast<std::uint32_t>(value));
            if (vertices.back() >= seen.size())
                seen.resize(vertices.back() + 1);
            seen[vertices.back()] = true;
        }
        if (!std::all_of(seen.begin(), seen.end(), [](bool s) { return s; }))
            return;
        m_mesh.originalVertices = std::move(vertices);
        m_mesh.originalVertexCount = static_cast<std::uint32_t>(seen.size());
    }

    const GltfDocument& m_document;
    const Scene& m_scene;
    SceneMesh m_mesh;
    std::vector<Part> m_parts;
    std::vector<float> m_original;
};

std::vector<SceneJoint> readSkin(const GltfDocument& document, std::int64_t index,
                                 const std::vector<int>& nodeOf)
{
    const Json& skin = document.at("skins", index);
    const auto nodes = skin.at("joints").get<std::vector<std::int64_t>>();
    std::vector<float> matrices;
    if (const auto accessor = gltfIndex(skin, "inverseBindMatrices"); accessor >= 0)
        matrices = document.floats(accessor, 16);
    if (!matrices.empty() && matrices.size() < nodes.size() * 16)
        document.fail(QUADRILLE_MESSAGE("a skin has fewer matrices than joints"));
    std::vector<SceneJoint> joints;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (nodes[j] < 0 || nodes[j] >= static_cast<std::int64_t>(nodeOf.size()))
            document.fail(QUADRILLE_MESSAGE("a skin has a joint that is not there"));
        SceneJoint joint;
        joint.node = nodeOf[static_cast<std::size_t>(nodes[j])];
        if (!matrices.empty())
            joint.inverseBind = Eigen::Map<const Eigen::Matrix4f>(matrices.data() + j * 16).cast<double>();
        joints.push_back(joint);
    }
    return joints;
}

void checkJoints(const GltfDocument& document, const SceneMesh& mesh)
{
    for (const auto& influences : mesh.influences) {
        for (const SceneInfluence& influence : influences) {
            if (influence.joint >= mesh.joints.size()) {
                throw Error(ErrorCode::IndexOutOfRange, {document.path(),
                                                         {},
                                                         {{"what", "bone"},
                                                          {"index", std::to_string(influence.joint)},
                                                          {"count", std::to_string(mesh.joints.size())}}});
            }
        }
    }
}

} // namespace

void readGltfMeshes(const GltfDocument& document, const std::vector<int>& nodeOf, Scene& scene)
{
    MaterialReader(document, scene).readAll();
    scene.materials.push_back({"", {}});
    for (std::size_t n = 0; n < nodeOf.size(); ++n) {
        const Json& node = document.at("nodes", static_cast<std::int64_t>(n));
        const auto meshIndex = gltfIndex(node, "mesh");
        if (meshIndex < 0)
            continue;
        SceneMesh mesh = MeshReader(document, scene).read(document.at("meshes", meshIndex));
        mesh.node = nodeOf[n];
        if (const auto skin = gltfIndex(node, "skin"); skin >= 0) {
            mesh.joints = readSkin(document, skin, nodeOf);
            checkJoints(document, mesh);
        } else {
            mesh.influences.clear();
        }
        if (const auto weights = node.find("weights"); weights != node.end()) {
            const auto values = weights->get<std::vector<float>>();
            for (std::size_t t = 0; t < std::min(values.size(), mesh.morphWeights.size()); ++t)
                mesh.morphWeights[t] = values[t];
        }
        scene.meshes.push_back(std::move(mesh));
    }
}

} // namespace quadrille
