// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/assimpscene.h"

#include <algorithm>
#include <assimp/scene.h>
#include <limits>
#include <map>

namespace quadrille {

namespace {

constexpr double defaultTicksPerSecond = 25; // assimp's, where a file names none

std::array<float, 3> valuesOf(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

std::array<float, 4> valuesOf(const aiQuaternion& q)
{
    return {q.x, q.y, q.z, q.w};
}

template <typename Key>
KeyTrack trackOf(const Key* keys, unsigned count, double ticksPerSecond)
{
    KeyTrack track;
    for (unsigned k = 0; k < count; ++k) {
        const double seconds = keys[k].mTime / ticksPerSecond;
        if (!track.times.empty() && !(seconds > track.times.back()))
            continue;
        track.times.push_back(seconds);
        const auto values = valuesOf(keys[k].mValue);
        track.values.insert(track.values.end(), values.begin(), values.end());
    }
    return track;
}

KeyTrack morphTrackOf(const aiMeshMorphAnim& animation, std::size_t targetCount, double ticksPerSecond)
{
    KeyTrack track;
    for (unsigned k = 0; k < animation.mNumKeys; ++k) {
        const aiMeshMorphKey& key = animation.mKeys[k];
        const double seconds = key.mTime / ticksPerSecond;
        if (!track.times.empty() && !(seconds > track.times.back()))
            continue;
        track.times.push_back(seconds);
        std::vector<float> weights(targetCount, 0.0F);
        for (unsigned v = 0; v < key.mNumValuesAndWeights; ++v) {
            if (key.mValues[v] < targetCount)
                weights[key.mValues[v]] = static_cast<float>(key.mWeights[v]);
        }
        track.values.insert(track.values.end(), weights.begin(), weights.end());
    }
    return track;
}

class ClipReader
{
public:
    ClipReader(const aiAnimation& source, const Scene& scene) : m_source(source), m_scene(scene)
    {
        for (std::size_t n = scene.nodes.size(); n-- > 0;)
            m_nodes[scene.nodes[n].name] = static_cast<int>(n);
        if (source.mTicksPerSecond > 0)
            m_ticksPerSecond = source.mTicksPerSecond;
    }

    SceneClip read()
    {
        for (unsigned c = 0; c < m_source.mNumChannels; ++c)
            addChannel(*m_source.mChannels[c]);
        for (unsigned c = 0; c < m_source.mNumMorphMeshChannels; ++c)
            addMorphChannel(*m_source.mMorphMeshChannels[c]);
        SceneClip clip;
        clip.name = m_source.mName.C_Str();
        if (m_first <= m_last) {
            clip.first = m_first;
            clip.last = m_last;
        }
        for (auto& [node, tracks] : m_tracks)
            clip.tracks.push_back(std::move(tracks));
        return clip;
    }

private:
    NodeTracks& tracksOf(int node)
    {
        NodeTracks& tracks = m_tracks[node];
        tracks.node = node;
        return tracks;
    }

    void include(const KeyTrack& track)
    {
        if (track.isEmpty())
            return;
        m_first = std::min(m_first, track.times.front());
        m_last = std::max(m_last, track.times.back());
    }

    void addChannel(const aiNodeAnim& channel)
    {
        const auto node = m_nodes.find(channel.mNodeName.C_Str());
        if (node == m_nodes.end())
            return;
        NodeTracks& tracks = tracksOf(node->second);
        tracks.translation = trackOf(channel.mPositionKeys, channel.mNumPositionKeys, m_ticksPerSecond);
        tracks.rotation = trackOf(channel.mRotationKeys, channel.mNumRotationKeys, m_ticksPerSecond);
        tracks.scale = trackOf(channel.mScalingKeys, channel.mNumScalingKeys, m_ticksPerSecond);
        include(tracks.translation);
        include(tracks.rotation);
        include(tracks.scale);
    }

    /// Channels are named after the node, with "*" and a number behind where the mesh has several parts.
    void addMorphChannel(const aiMeshMorphAnim& channel)
    {
        const std::string name = channel.mName.C_Str();
        for (const SceneMesh& mesh : m_scene.meshes) {
            const std::string& node = m_scene.nodes[static_cast<std::size_t>(mesh.node)].name;
            if (mesh.morphTargets.empty() || (name != node && !name.starts_with(node + "*")))
                continue;
            NodeTracks& tracks = tracksOf(mesh.node);
            tracks.morphWeights = morphTrackOf(channel, mesh.morphTargets.size(), m_ticksPerSecond);
            include(tracks.morphWeights);
        }
    }

    const aiAnimation& m_source;
    const Scene& m_scene;
    double m_ticksPerSecond = defaultTicksPerSecond;
    std::map<std::string, int> m_nodes; ///< the first of a name
    std::map<int, NodeTracks> m_tracks;
    double m_first = std::numeric_limits<double>::infinity();
    double m_last = -std::numeric_limits<double>::infinity();
};

} // namespace

void readAssimpAnimations(const aiScene& source, Scene& scene)
{
    for (unsigned a = 0; a < source.mNumAnimations; ++a)
        scene.clips.push_back(ClipReader(*source.mAnimations[a], scene).read());
}

} // namespace quadrille
