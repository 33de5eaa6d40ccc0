// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/assimpscene.h"

#include "model/core/image.h"

#include <algorithm>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <map>

namespace quadrille {

namespace {

Eigen::Matrix4d toMatrix(const aiMatrix4x4& m)
{
    Eigen::Matrix4d matrix;
    for (unsigned r = 0; r < 4; ++r)
        for (unsigned c = 0; c < 4; ++c)
            matrix(static_cast<int>(r), static_cast<int>(c)) = static_cast<double>(m[r][c]);
    return matrix;
}

Vec3f toVector(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

int metadata(const aiScene& source, const char* key, int fallback)
{
    int value = fallback;
    return source.mMetaData && source.mMetaData->Get(key, value) ? value : fallback;
}

/// Turns the axes that an FBX file names to x right, y up, z to the viewer. Assimp only reports them; other
/// formats it turns itself and names none.
Eigen::Matrix4d axisMatrix(const aiScene& source)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix(3, 3) = 1;
    const auto setRow = [&](int row, const char* axis, const char* sign) {
        const int column = metadata(source, axis, row);
        if (column >= 0 && column < 3)
            matrix(row, column) = metadata(source, sign, 1) < 0 ? -1 : 1;
    };
    setRow(0, "CoordAxis", "CoordAxisSign");
    setRow(1, "UpAxis", "UpAxisSign");
    setRow(2, "FrontAxis", "FrontAxisSign");
    return matrix.determinant() > 0 ? matrix : Eigen::Matrix4d::Identity();
}

class Converter
{
public:
    Converter(const aiScene& source, const std::filesystem::path& file) : m_source(source), m_file(file) {}

    Scene convert()
    {
        SceneNode world;
        world.matrix = axisMatrix(m_source);
        m_scene.nodes.push_back(std::move(world));
        if (m_source.mRootNode)
            addNode(*m_source.mRootNode, 0);
        addMaterials();
        for (const auto& [node, index] : m_nodes) {
            if (node->mNumMeshes > 0)
                addMesh(*node, index);
        }
        if (m_polygons > 0)
            m_scene.issues.push_back({Issue::Severity::Info,
                                      Issue::Code::PolygonsTriangulated,
                                      {m_file, {}, {{"count", std::to_string(m_polygons)}}}});
        return std::move(m_scene);
    }

private:
    void addNode(const aiNode& node, int parent)
    {
        const int index = static_cast<int>(m_scene.nodes.size());
        SceneNode result;
        result.name = node.mName.C_Str();
        result.parent = parent;
        result.matrix = toMatrix(node.mTransformation);
        aiVector3D scale;
        aiVector3D translation;
        aiQuaternion rotation;
        node.mTransformation.Decompose(scale, rotation, translation);
        result.translation = toVector(translation).cast<double>();
        result.scale = toVector(scale).cast<double>();
        result.rotation = Eigen::Quaterniond(rotation.w, rotation.x, rotation.y, rotation.z).normalized();
        m_nodeOfName.try_emplace(result.name, index);
        m_scene.nodes.push_back(std::move(result));
        m_nodes.emplace_back(&node, index);
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            addNode(*node.mChildren[c], index);
    }

    void addMaterials()
    {
        for (unsigned m = 0; m < std::min(m_source.mNumMaterials, 65535U); ++m) {
            const aiMaterial& material = *m_source.mMaterials[m];
            m_scene.materials.push_back({material.GetName().C_Str(), {}});
            aiString path;
            if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path) == aiReturn_SUCCESS ||
                material.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == aiReturn_SUCCESS)
                m_scene.materials.back().texture = findTexture(path.C_Str());
        }
    }

    Texture findTexture(const std::string& path)
    {
        const auto [entry, isNew] = m_textures.try_emplace(path);
        if (!isNew)
            return entry->second;
        Texture& texture = entry->second;
        if (const aiTexture* embedded = m_source.GetEmbeddedTexture(path.c_str()))
            texture.embedded = decodeEmbedded(*embedded);
        else
            texture.file = findFile(path);
        if (texture.isEmpty())
            m_scene.issues.push_back(
                {Issue::Severity::Warning, Issue::Code::TextureMissing, {m_file, {}, {{"path", path}}}});
        return texture;
    }

    static std::shared_ptr<const Image> decodeEmbedded(const aiTexture& texture)
    {
        if (texture.mHeight == 0) {
            const auto* bytes = reinterpret_cast<const std::byte*>(texture.pcData);
            try {
                return std::make_shared<const Image>(decodeImage({bytes, texture.mWidth}));
            } catch (const Error&) {
                return nullptr;
            }
        }
        auto image =
            std::make_shared<Image>(static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight));
        for (std::size_t i = 0; i < image->pixels.size() / 4; ++i) {
            const aiTexel& texel = texture.pcData[i];
            const std::array values{texel.r, texel.g, texel.b, texel.a};
            std::copy(values.begin(), values.end(),
                      image->pixels.begin() + static_cast<std::ptrdiff_t>(i * 4));
        }
        return image;
    }

    /// The file where it is said to be, or a picture of its name beside the scene or in "textures".
    std::filesystem::path findFile(std::string path) const
    {
        std::replace(path.begin(), path.end(), '\\', '/');
        const std::filesystem::path named(path);
        const auto folder = m_file.parent_path();
        const auto exists = [](const std::filesystem::path& candidate) {
            std::error_code error;
            return std::filesystem::is_regular_file(candidate, error);
        };
        if (isPicture(named) && exists(folder / named))
            return folder / named;
        for (const auto& place : {folder, folder / "textures"}) {
            for (const auto& extension : {named.extension().string(), std::string(".png"),
                                          std::string(".jpg"), std::string(".jpeg"), std::string(".tif")}) {
                auto candidate = place / (named.stem().string() + extension);
                if (isPicture(candidate) && exists(candidate))
                    return candidate;
            }
        }
        return {};
    }

    static bool isPicture(const std::filesystem::path& path)
    {
        std::string extension = path.extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        static constexpr std::array known = {".png", ".jpg", ".jpeg", ".tif", ".tiff"};
        return std::find(known.begin(), known.end(), extension) != known.end();
    }

    void addMesh(const aiNode& node, int index)
    {
        SceneMesh mesh;
        mesh.node = index;
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            addPart(mesh, *m_source.mMeshes[node.mMeshes[m]]);
        m_scene.meshes.push_back(std::move(mesh));
    }

    void addPart(SceneMesh& mesh, const aiMesh& part)
    {
        const auto first = mesh.positions.size();
        for (unsigned v = 0; v < part.mNumVertices; ++v)
            mesh.positions.push_back(toVector(part.mVertices[v]));
        if (part.HasTextureCoords(0)) {
            mesh.uvs.resize(first, Vec2f::Zero());
            for (unsigned v = 0; v < part.mNumVertices; ++v)
                mesh.uvs.emplace_back(part.mTextureCoords[0][v].x, part.mTextureCoords[0][v].y);
        } else if (!mesh.uvs.empty()) {
            mesh.uvs.resize(mesh.positions.size(), Vec2f::Zero());
        }
        addFaces(mesh, part, first);
        addBones(mesh, part, first);
        addShapes(mesh, part, first);
    }

    void addFaces(SceneMesh& mesh, const aiMesh& part, std::size_t first)
    {
        for (unsigned f = 0; f < part.mNumFaces; ++f) {
            const aiFace& face = part.mFaces[f];
            m_polygons += face.mNumIndices > 3;
            for (unsigned c = 0; c < face.mNumIndices; ++c) {
                if (face.mIndices[c] >= part.mNumVertices)
                    throw Error(ErrorCode::IndexOutOfRange, {m_file,
                                                             {},
                                                             {{"what", "vertex"},
                                                              {"index", std::to_string(face.mIndices[c])},
                                                              {"count", std::to_string(part.mNumVertices)}}});
            }
            const auto corner = [&](unsigned c) {
                return static_cast<std::uint32_t>(first + face.mIndices[c]);
            };
            for (unsigned c = 2; c < face.mNumIndices; ++c) {
                mesh.triangles.push_back({corner(0), corner(c - 1), corner(c)});
                mesh.triangleMaterials.push_back(static_cast<std::uint16_t>(
                    std::min<std::size_t>(part.mMaterialIndex, m_scene.materials.size() - 1)));
            }
        }
    }

    /// The parts of one mesh name the same bones again; equal ones become one joint, so that their vertices
    /// can be welded.
    std::uint32_t jointOf(SceneMesh& mesh, const aiBone& bone) const
    {
        const auto node = m_nodeOfName.find(bone.mName.C_Str());
        const SceneJoint joint{node == m_nodeOfName.end() ? mesh.node : node->second,
                               toMatrix(bone.mOffsetMatrix)};
        const auto same = std::find_if(mesh.joints.begin(), mesh.joints.end(), [&](const SceneJoint& other) {
            return other.node == joint.node && other.inverseBind == joint.inverseBind;
        });
        if (same != mesh.joints.end())
            return static_cast<std::uint32_t>(same - mesh.joints.begin());
        mesh.joints.push_back(joint);
        return static_cast<std::uint32_t>(mesh.joints.size() - 1);
    }

    void addBones(SceneMesh& mesh, const aiMesh& part, std::size_t first) const
    {
        if (part.HasBones() || !mesh.influences.empty())
            mesh.influences.resize(mesh.positions.size());
        for (unsigned b = 0; b < part.mNumBones; ++b) {
            const aiBone& bone = *part.mBones[b];
            const std::uint32_t joint = jointOf(mesh, bone);
            for (unsigned w = 0; w < bone.mNumWeights; ++w) {
                const aiVertexWeight& weight = bone.mWeights[w];
                if (weight.mVertexId >= part.mNumVertices)
                    throw Error(ErrorCode::IndexOutOfRange, {m_file,
                                                             {},
                                                             {{"what", "vertex"},
                                                              {"index", std::to_string(weight.mVertexId)},
                                                              {"count", std::to_string(part.mNumVertices)}}});
                mesh.influences[first + weight.mVertexId].push_back({joint, weight.mWeight});
            }
        }
    }

    static void addShapes(SceneMesh& mesh, const aiMesh& part, std::size_t first)
    {
        if (part.mNumAnimMeshes > mesh.morphTargets.size()) {
            mesh.morphTargets.resize(part.mNumAnimMeshes, std::vector<Vec3f>(first, Vec3f::Zero()));
            mesh.morphWeights.resize(part.mNumAnimMeshes, 0.0F);
        }
        for (std::size_t t = 0; t < mesh.morphTargets.size(); ++t) {
            auto& offsets = mesh.morphTargets[t];
            const aiAnimMesh* shape = t < part.mNumAnimMeshes ? part.mAnimMeshes[t] : nullptr;
            if (shape && shape->HasPositions() && shape->mNumVertices == part.mNumVertices) {
                for (unsigned v = 0; v < part.mNumVertices; ++v)
                    offsets.push_back(toVector(shape->mVertices[v] - part.mVertices[v]));
            } else {
                offsets.resize(mesh.positions.size(), Vec3f::Zero());
            }
        }
    }

    const aiScene& m_source;
    const std::filesystem::path& m_file;
    Scene m_scene;
    std::vector<std::pair<const aiNode*, int>> m_nodes; ///< with their index in the scene
    std::map<std::string, int> m_nodeOfName;
    std::map<std::string, Texture> m_textures;
    std::int64_t m_polygons = 0;
};

} // namespace

Scene sceneFromAssimp(const aiScene& source, const std::filesystem::path& file)
{
    Scene scene = Converter(source, file).convert();
    readAssimpAnimations(source, scene);
    return scene;
}

} // namespace quadrille
