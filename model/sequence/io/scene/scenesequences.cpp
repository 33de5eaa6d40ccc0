// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/scenesequences.h"

#include "model/core/message.h"
#include "model/core/seriesname.h"
#include "model/sequence/io/files/appendbytes.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/mesh/findtextures.h"
#include "model/sequence/io/mesh/meshfile.h"
#include "model/sequence/io/scene/keyrate.h"
#include "model/sequence/io/scene/skinning.h"
#include "model/sequence/io/scene/weld.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

namespace quadrille {

namespace {

constexpr double maxClipFrames = 1e7;

void appendVector(std::string& row, const Vec3f& v)
{
    for (const float x : {v.x(), v.y(), v.z()})
        appendBytes(row, x + 0.0F); // −0 becomes 0
}

/// Influences without zero weights, the same joints together, sorted; weights sum to one.
std::vector<SceneInfluence> tidied(std::vector<SceneInfluence> influences)
{
    std::sort(influences.begin(), influences.end(),
              [](const auto& a, const auto& b) { return a.joint < b.joint; });
    std::vector<SceneInfluence> tidy;
    float sum = 0;
    for (const SceneInfluence& influence : influences) {
        if (!(influence.weight > 0) || !std::isfinite(influence.weight))
            continue;
        sum += influence.weight;
        if (!tidy.empty() && tidy.back().joint == influence.joint)
            tidy.back().weight += influence.weight;
        else
            tidy.push_back(influence);
    }
    for (SceneInfluence& influence : tidy)
        influence.weight /= sum;
    return tidy;
}

std::vector<std::uint32_t> attributeClasses(const SceneMesh& mesh)
{
    if (mesh.influences.empty() && mesh.morphTargets.empty())
        return {};
    RowClasses classes;
    std::vector<std::uint32_t> result(mesh.positions.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
        std::string row;
        for (const auto& target : mesh.morphTargets)
            appendVector(row, target[v]);
        if (!mesh.influences.empty()) {
            for (const SceneInfluence& influence : mesh.influences[v]) {
                appendBytes(row, influence.joint);
                appendBytes(row, influence.weight);
            }
        }
        result[v] = classes.classOf(std::move(row));
    }
    return result;
}

/// The weld that the file itself names; nothing if it would join different places.
std::optional<Weld> namedWeld(const SceneMesh& mesh)
{
    if (mesh.originalVertices.empty())
        return std::nullopt;
    Weld weld;
    weld.vertexOf = mesh.originalVertices;
    weld.firstOf.assign(mesh.originalVertexCount, 0);
    for (std::size_t v = mesh.positions.size(); v-- > 0;)
        weld.firstOf[weld.vertexOf[v]] = static_cast<std::uint32_t>(v);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (mesh.positions[v] != mesh.positions[weld.firstOf[weld.vertexOf[v]]])
            return std::nullopt;
    }
    return weld;
}

Weld weldMesh(const SceneMesh& mesh)
{
    auto named = namedWeld(mesh);
    return named ? std::move(*named) : weldVertices(mesh.positions, attributeClasses(mesh), mesh.triangles);
}

void checkFinite(const SceneMesh& mesh, const std::filesystem::path& file)
{
    const auto check = [&](const std::vector<Vec3f>& points) {
        const auto bad =
            std::find_if(points.begin(), points.end(), [](const Vec3f& p) { return !p.allFinite(); });
        if (bad != points.end()) {
            throw Error(ErrorCode::NonFiniteCoordinate,
                        {file, {}, {{"vertex", std::to_string(bad - points.begin())}}});
        }
    };
    check(mesh.positions);
    for (const auto& target : mesh.morphTargets)
        check(target);
}

/// Puts the meshes of a scene together.
class Merger
{
public:
    explicit Merger(const Scene& scene) : m_scene(scene), m_materialOf(scene.materials.size(), -1) {}

    void add(SceneMesh mesh)
    {
        for (auto& influences : mesh.influences)
            influences = tidied(std::move(influences));
        const Weld weld = weldMesh(mesh);
        const auto first = static_cast<std::uint32_t>(model.rest.size());
        addJoints(mesh, weld);
        for (const std::uint32_t v : weld.firstOf)
            model.rest.push_back(mesh.positions[v]);
        for (std::size_t t = 0; t < mesh.morphTargets.size(); ++t) {
            MorphTarget target{mesh.node, static_cast<std::uint32_t>(t), mesh.morphWeights[t], first, {}};
            target.offsets.reserve(weld.vertexCount());
            for (const std::uint32_t v : weld.firstOf)
                target.offsets.push_back(mesh.morphTargets[t][v]);
            model.morphTargets.push_back(std::move(target));
        }
        addTriangles(mesh, weld, first);
        splitCount += static_cast<std::int64_t>(mesh.positions.size());
    }

    /// The topology with the lists that say nothing left out.
    TopologyData finishedTopology()
    {
        topology.vertexCount = static_cast<std::uint32_t>(model.rest.size());
        if (!m_hasUvs) {
            topology.uvs.clear();
            topology.triangleUvs.clear();
        }
        if (topology.materials.size() == 1 && topology.materials.front().empty())
            topology.materials.clear();
        if (topology.materials.size() < 2)
            topology.triangleMaterials.clear();
        return std::move(topology);
    }

    SkinnedModel model;
    TopologyData topology;
    std::vector<Texture> textures; ///< one per material of the topology
    std::int64_t splitCount = 0;
    std::int64_t degenerateCount = 0;

private:
    void addJoints(const SceneMesh& mesh, const Weld& weld)
    {
        const auto firstJoint = static_cast<std::uint32_t>(model.joints.size());
        model.joints.insert(model.joints.end(), mesh.joints.begin(), mesh.joints.end());
        const auto rigid = static_cast<std::uint32_t>(model.joints.size());
        model.joints.push_back({mesh.node, Eigen::Matrix4d::Identity()});
        if (model.influenceStart.empty())
            model.influenceStart.push_back(0);
        for (const std::uint32_t v : weld.firstOf) {
            if (mesh.influences.empty() || mesh.influences[v].empty())
                model.influences.push_back({rigid, 1.0F});
            else
                for (const SceneInfluence& influence : mesh.influences[v])
                    model.influences.push_back({firstJoint + influence.joint, influence.weight});
            model.influenceStart.push_back(static_cast<std::uint32_t>(model.influences.size()));
        }
    }

    void addTriangles(const SceneMesh& mesh, const Weld& weld, std::uint32_t first)
    {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& corners = mesh.triangles[t];
            Triangle triangle;
            for (std::size_t c = 0; c < 3; ++c)
                triangle[c] = VertexIndex(first + weld.vertexOf[corners[c]]);
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
                ++degenerateCount;
                continue;
            }
            topology.triangles.push_back(triangle);
            m_hasUvs = m_hasUvs || !mesh.uvs.empty();
            std::array<std::uint32_t, 3> uvs{};
            for (std::size_t c = 0; c < 3; ++c)
                uvs[c] = uvIndex(mesh.uvs.empty() ? Vec2f(Vec2f::Zero()) : mesh.uvs[corners[c]]);
            topology.triangleUvs.push_back(uvs);
            topology.triangleMaterials.push_back(
                materialIndex(mesh.triangleMaterials.empty() ? 0 : mesh.triangleMaterials[t]));
        }
    }

    std::uint32_t uvIndex(const Vec2f& uv)
    {
        const auto key = std::pair(std::bit_cast<std::uint32_t>(uv.x() + 0.0F),
                                   std::bit_cast<std::uint32_t>(uv.y() + 0.0F));
        const auto [entry, isNew] = m_uvs.try_emplace(key, static_cast<std::uint32_t>(topology.uvs.size()));
        if (isNew)
            topology.uvs.push_back(uv);
        return entry->second;
    }

    std::uint16_t materialIndex(std::uint16_t material)
    {
        if (m_scene.materials.empty())
            return 0;
        int& index = m_materialOf[material];
        if (index < 0) {
            index = static_cast<int>(topology.materials.size());
            topology.materials.push_back(m_scene.materials[material].name);
            textures.push_back(m_scene.materials[material].texture);
        }
        return static_cast<std::uint16_t>(index);
    }

    const Scene& m_scene;
    std::vector<int> m_materialOf;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_uvs;
    bool m_hasUvs = false;
};

TextureSet textureSet(std::vector<Texture> textures)
{
    if (std::all_of(textures.begin(), textures.end(), [](const Texture& t) { return t.isEmpty(); }))
        return {};
    const Texture& first = textures.front();
    const bool same = std::all_of(textures.begin(), textures.end(), [&](const Texture& t) {
        return t.file == first.file && t.embedded == first.embedded;
    });
    return same ? TextureSet::single(first) : TextureSet::perMaterial(std::move(textures));
}

/// Scene files cannot change a material's picture: clips whose texture changes have theirs beside the file.
TextureSet texturesOfClip(const TextureSet& ofScene, const std::filesystem::path& file, std::int64_t frames)
{
    if (frames < 2)
        return ofScene;
    const SourceFiles take{.path = file, .files = {file}, .stem = seriesStem(file)};
    return findTextures({.take = take, .frameCount = frames, .named = {}, .ofMesh = ofScene}).textures;
}

std::string wholeNumber(double value)
{
    std::array<char, 32> text{};
    return {text.begin(), std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 6).ptr};
}

std::int64_t clipFrames(const SceneClip& clip, double fps, const std::filesystem::path& file)
{
    // Times are stored as float: a last key that lies on a frame may come out a little before it.
    const double frames = std::floor((clip.last - clip.first) * fps + 1e-3) + 1;
    if (!(frames <= maxClipFrames)) {
        throw Error(ErrorCode::CountTooLarge,
                    {file, {}, {{"count", wholeNumber(frames)}, {"what", "frames"}}});
    }
    return static_cast<std::int64_t>(frames);
}

void checkOptions(const Scene& scene, const std::filesystem::path& file, const ImportOptions& options)
{
    if (!(options.fps > 0) || !std::isfinite(options.fps)) {
        throw Error(ErrorCode::BadArgument,
                    {file,
                     {},
                     {{"reason", "A frame rate of " + std::to_string(options.fps) + " is not possible"},
                      {"remedy", QUADRILLE_MESSAGE("Give a positive number of frames a second.")}}});
    }
    if (options.clip.empty())
        return;
    std::string known;
    for (const SceneClip& clip : scene.clips) {
        if (clip.name == options.clip)
            return;
        known.append(known.empty() ? "" : ", ").append(clip.name);
    }
    throw Error(ErrorCode::BadArgument,
                {file,
                 {},
                 {{"reason", "There is no clip “" + options.clip + "”"},
                  {"remedy", known.empty() ? "The file has no clips." : "The file has: " + known + "."}}});
}

/// Names that are empty or given twice become "stem", "name 2", ….
void makeNamesUnique(std::vector<SceneClip>& clips, const std::string& stem)
{
    std::map<std::string, int> uses;
    for (SceneClip& clip : clips) {
        if (clip.name.empty())
            clip.name = stem;
        const int use = ++uses[clip.name];
        if (use > 1)
            clip.name.append(" ").append(std::to_string(use));
    }
}

void addIssue(std::vector<Issue>& issues, Issue::Severity severity, Issue::Code code,
              const std::filesystem::path& file, std::vector<std::pair<std::string, std::string>> values)
{
    issues.push_back({severity, code, {file, {}, std::move(values)}});
}

} // namespace

ImportResult sequencesFromScene(Scene scene, const std::filesystem::path& file, const ImportOptions& options,
                                const Progress& progress)
{
    const std::string stem = file.stem().string();
    makeNamesUnique(scene.clips, stem);
    checkOptions(scene, file, options);
    if (std::none_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const SceneMesh& mesh) { return !mesh.triangles.empty(); }))
        throw Error(ErrorCode::SceneWithoutMesh, {file, {}, {}});

    Merger merger(scene);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        progress.report(static_cast<std::int64_t>(m), static_cast<std::int64_t>(scene.meshes.size()));
        checkFinite(scene.meshes[m], file);
        merger.add(std::move(scene.meshes[m]));
    }
    ImportResult result;
    result.issues = std::move(scene.issues);
    const auto topology = buildTopology(merger.finishedTopology(), merger.model.rest, file, result.issues);
    merger.model.nodes = std::move(scene.nodes);
    merger.model.file = file;
    const auto model = std::make_shared<const SkinnedModel>(std::move(merger.model));
    const TextureSet textures = textureSet(std::move(merger.textures));

    result.coordinates = scene.coordinates;
    result.hasOwnFps = true;
    result.isSampled = true;
    if (merger.splitCount > topology->vertexCount())
        addIssue(
            result.issues, Issue::Severity::Info, Issue::Code::VerticesWelded, file,
            {{"from", std::to_string(merger.splitCount)}, {"to", std::to_string(topology->vertexCount())}});
    if (merger.degenerateCount > 0)
        addIssue(result.issues, Issue::Severity::Warning, Issue::Code::DuplicateFaces, file,
                 {{"count", std::to_string(merger.degenerateCount)}});

    if (scene.clips.empty())
        scene.clips.push_back({stem, 0, 0, {}});
    const std::vector<std::optional<double>> rates = keyRates(scene.clips);
    for (std::size_t c = 0; c < scene.clips.size(); ++c) {
        SceneClip& clip = scene.clips[c];
        if (!options.clip.empty() && clip.name != options.clip)
            continue;
        const std::optional<double> own = rates[c];
        const double fps = own.value_or(options.fps);
        const std::int64_t frames = clipFrames(clip, fps, file);
        result.hasOwnFps = result.hasOwnFps && (own || frames == 1);
        const auto shared = std::make_shared<const SceneClip>(std::move(clip));
        auto sequence = makeSequence(shared->name, topology,
                                     std::make_shared<SkinnedFrames>(model, shared, fps, frames), fps);
        sequence.textures = texturesOfClip(textures, file, frames);
        result.sequences.push_back(std::move(sequence));
    }
    return result;
}

} // namespace quadrille
