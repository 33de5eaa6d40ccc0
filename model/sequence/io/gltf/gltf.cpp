// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/gltf.h"

#include "model/core/message.h"
#include "model/sequence/io/gltf/gltfdocument.h"
#include "model/sequence/io/scene/scenesequences.h"

#include <algorithm>

namespace quadrille {

namespace {

using Json = GltfDocument::Json;

template <std::size_t count>
std::optional<std::array<double, count>> numbers(const Json& node, const char* key)
{
    const auto found = node.find(key);
    if (found == node.end())
        return std::nullopt;
    return found->get<std::array<double, count>>();
}

SceneNode readNode(const Json& json)
{
    SceneNode node;
    node.name = json.value("name", "");
    if (const auto t = numbers<3>(json, "translation"))
        node.translation = Vec3d(t->data());
    if (const auto r = numbers<4>(json, "rotation"))
        node.rotation = Eigen::Quaterniond((*r)[3], (*r)[0], (*r)[1], (*r)[2]).normalized();
    if (const auto s = numbers<3>(json, "scale"))
        node.scale = Vec3d(s->data());
    if (const auto m = numbers<16>(json, "matrix"))
        node.matrix = Eigen::Matrix4d(m->data());
    return node;
}

std::vector<int> parentsOf(const GltfDocument& document)
{
    const Json& nodes = document.list("nodes");
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Json& node = document.at("nodes", static_cast<std::int64_t>(n));
        const auto children = node.find("children");
        if (children == node.end())
            continue;
        for (const auto child : children->get<std::vector<std::int64_t>>()) {
            if (child < 0 || child >= static_cast<std::int64_t>(nodes.size()))
                document.fail(QUADRILLE_MESSAGE("a node has a child that is not there"));
            if (parents[static_cast<std::size_t>(child)] >= 0)
                document.fail(QUADRILLE_MESSAGE("a node has two parents"));
            parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
        }
    }
    return parents;
}

/// Appends the nodes, parents first.
/// \return scene node of each glTF node.
std::vector<int> readNodes(const GltfDocument& document, Scene& scene)
{
    const std::vector<int> parents = parentsOf(document);
    std::vector<int> nodeOf(parents.size(), -1);
    std::vector<int> path;
    for (std::size_t n = 0; n < parents.size(); ++n) {
        for (int at = static_cast<int>(n); at >= 0 && nodeOf[static_cast<std::size_t>(at)] < 0;
             at = parents[static_cast<std::size_t>(at)]) {
            if (path.size() == parents.size())
                document.fail(QUADRILLE_MESSAGE("the nodes form a circle"));
            path.push_back(at);
        }
        for (; !path.empty(); path.pop_back()) {
            SceneNode node = readNode(document.at("nodes", path.back()));
            const int parent = parents[static_cast<std::size_t>(path.back())];
            node.parent = parent < 0 ? -1 : nodeOf[static_cast<std::size_t>(parent)];
            nodeOf[static_cast<std::size_t>(path.back())] = static_cast<int>(scene.nodes.size());
            scene.nodes.push_back(std::move(node));
        }
    }
    return nodeOf;
}

/// What the JSON library says, without its own number for it.
std::string plainReason(const Json::exception& exception)
{
    const std::string_view text = exception.what();
    const auto end = text.find("] ");
    return "the JSON is not that of a scene: " +
           std::string(end == std::string_view::npos ? text : text.substr(end + 2));
}

Scene readScene(const GltfDocument& document)
{
    Scene scene;
    const auto nodeOf = readNodes(document, scene);
    readGltfMeshes(document, nodeOf, scene);
    readGltfAnimations(document, nodeOf, scene);
    return scene;
}

} // namespace

const FormatInfo& GltfImporter::format() const
{
    static const FormatInfo info{.id = "gltf", .name = "glTF", .extensions = {".glb", ".gltf"}};
    return info;
}

bool GltfImporter::recognises(std::string_view head) const
{
    return head.starts_with("glTF");
}

ImportResult GltfImporter::open(const SourceFiles& source, const ImportOptions& options,
                                const Progress& progress) const
{
    const auto& file = source.files.front();
    Scene scene;
    try {
        progress.report(0);
        const GltfDocument document(file);
        progress.report(0.3);
        scene = readScene(document);
    } catch (const Json::exception& exception) {
        throw Error(ErrorCode::FileSyntax, {file, {}, {{"reason", plainReason(exception)}}});
    }
    return sequencesFromScene(std::move(scene), file, options, progress.part(0.6, 1.0));
}

} // namespace quadrille
