// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/message.h"
#include "model/sequence/io/gltf/gltf.h"
#include "model/sequence/io/gltf/gltfdocument.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace quadrille {

namespace {

using Json = GltfDocument::Json;

KeyInterpolation interpolationOf(const GltfDocument& document, const Json& sampler)
{
    const std::string name = sampler.value("interpolation", "LINEAR");
    if (name == "LINEAR")
        return KeyInterpolation::Linear;
    if (name == "STEP")
        return KeyInterpolation::Step;
    if (name == "CUBICSPLINE")
        return KeyInterpolation::CubicSpline;
    document.fail("there is no interpolation “" + name + "”");
}

KeyTrack readTrack(const GltfDocument& document, const Json& sampler, std::size_t components,
                   std::size_t valuesPerKey)
{
    KeyTrack track;
    track.interpolation = interpolationOf(document, sampler);
    const auto times = document.floats(gltfIndex(sampler, "input"), 1);
    track.times.assign(times.begin(), times.end());
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (!std::isfinite(times[k]) || (k > 0 && !(times[k - 1] < times[k])))
            document.fail(QUADRILLE_MESSAGE("the times of an animation do not increase"));
    }
    const std::size_t rows = track.interpolation == KeyInterpolation::CubicSpline ? 3 : 1;
    track.values = document.floats(gltfIndex(sampler, "output"), components,
                                   static_cast<std::int64_t>(times.size() * rows * valuesPerKey));
    if (!std::all_of(track.values.begin(), track.values.end(), [](float v) { return std::isfinite(v); }))
        document.fail(QUADRILLE_MESSAGE("an animation has a value that is not a finite number"));
    return track;
}

std::size_t morphTargetCount(const Scene& scene, int node)
{
    for (const SceneMesh& mesh : scene.meshes)
        if (mesh.node == node)
            return mesh.morphTargets.size();
    return 0;
}

SceneClip readClip(const GltfDocument& document, const Json& animation, const std::vector<int>& nodeOf,
                   const Scene& scene)
{
    SceneClip clip;
    clip.name = animation.value("name", "");
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    std::map<int, NodeTracks> tracksOfNode;
    const Json samplers = animation.value("samplers", Json::array());
    for (const Json& channel : animation.value("channels", Json::array())) {
        const Json& target = channel.at("target");
        const auto glNode = gltfIndex(target, "node");
        if (glNode < 0)
            continue;
        if (glNode >= static_cast<std::int64_t>(nodeOf.size()))
            document.fail(QUADRILLE_MESSAGE("an animation moves a node that is not there"));
        const int node = nodeOf[static_cast<std::size_t>(glNode)];
        const auto sampler = gltfIndex(channel, "sampler");
        if (sampler < 0 || sampler >= static_cast<std::int64_t>(samplers.size()))
            document.fail(QUADRILLE_MESSAGE("an animation channel has no sampler"));
        const Json& source = samplers[static_cast<std::size_t>(sampler)];
        NodeTracks& tracks = tracksOfNode[node];
        tracks.node = node;
        KeyTrack* track = nullptr;
        const std::string path = target.value("path", "");
        if (path == "translation")
            *(track = &tracks.translation) = readTrack(document, source, 3, 1);
        else if (path == "rotation")
            *(track = &tracks.rotation) = readTrack(document, source, 4, 1);
        else if (path == "scale")
            *(track = &tracks.scale) = readTrack(document, source, 3, 1);
        else if (const auto targets = morphTargetCount(scene, node); path == "weights" && targets > 0)
            *(track = &tracks.morphWeights) = readTrack(document, source, 1, targets);
        if (!track || track->isEmpty())
            continue;
        first = std::min(first, track->times.front());
        last = std::max(last, track->times.back());
    }
    if (first <= last) {
        clip.first = first;
        clip.last = last;
    }
    for (auto& [node, tracks] : tracksOfNode)
        clip.tracks.push_back(std::move(tracks));
    return clip;
}

} // namespace

void readGltfAnimations(const GltfDocument& document, const std::vector<int>& nodeOf, Scene& scene)
{
    const Json& animations = document.list("animations");
    for (std::size_t a = 0; a < animations.size(); ++a)
        scene.clips.push_back(
            readClip(document, document.at("animations", static_cast<std::int64_t>(a)), nodeOf, scene));
}

} // namespace quadrille
