// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/skinning.h"

#include "model/sequence/io/scene/keytrack.h"

#include <algorithm>

namespace quadrille {

SkinnedFrames::SkinnedFrames(std::shared_ptr<const SkinnedModel> model, std::shared_ptr<const SceneClip> clip,
                             double fps, std::int64_t frameCount)
    : m_model(std::move(model))
    , m_clip(std::move(clip))
    , m_tracksOfNode(m_model->nodes.size(), nullptr)
    , m_fps(fps)
    , m_frameCount(frameCount)
    , m_hasMorphs(!m_model->morphTargets.empty())
{
    for (const NodeTracks& tracks : m_clip->tracks)
        m_tracksOfNode[static_cast<std::size_t>(tracks.node)] = &tracks;
}

namespace {

Eigen::Matrix4d localMatrix(const SceneNode& node, const NodeTracks* tracks, double seconds)
{
    const bool moves =
        tracks && !(tracks->translation.isEmpty() && tracks->rotation.isEmpty() && tracks->scale.isEmpty());
    if (!moves && node.matrix)
        return *node.matrix;
    Vec3d translation = node.translation;
    Vec3d scale = node.scale;
    Eigen::Quaterniond rotation = node.rotation;
    if (moves && !tracks->translation.isEmpty())
        evaluate(tracks->translation, seconds, {translation.data(), 3});
    if (moves && !tracks->rotation.isEmpty())
        rotation = evaluateRotation(tracks->rotation, seconds);
    if (moves && !tracks->scale.isEmpty())
        evaluate(tracks->scale, seconds, {scale.data(), 3});
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
    local.topLeftCorner<3, 3>() = rotation.toRotationMatrix() * scale.asDiagonal();
    local.topRightCorner<3, 1>() = translation;
    return local;
}

} // namespace

std::vector<Eigen::Matrix4f> SkinnedFrames::jointMatrices(double seconds) const
{
    const auto& nodes = m_model->nodes;
    std::vector<Eigen::Matrix4d> global(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        global[n] = localMatrix(nodes[n], m_tracksOfNode[n], seconds);
        if (nodes[n].parent >= 0)
            global[n] = global[static_cast<std::size_t>(nodes[n].parent)] * global[n];
    }
    std::vector<Eigen::Matrix4f> matrices;
    matrices.reserve(m_model->joints.size());
    for (const SceneJoint& joint : m_model->joints)
        matrices.emplace_back(
            (global[static_cast<std::size_t>(joint.node)] * joint.inverseBind).cast<float>());
    return matrices;
}

void SkinnedFrames::applyMorphs(double seconds, MutablePositions out) const
{
    std::vector<double> weights;
    int weightsOf = -1;
    for (const MorphTarget& target : m_model->morphTargets) {
        const NodeTracks* tracks = m_tracksOfNode[static_cast<std::size_t>(target.node)];
        auto weight = target.restWeight;
        if (tracks && !tracks->morphWeights.isEmpty()) {
            if (weightsOf != target.node) {
                const KeyTrack& track = tracks->morphWeights;
                const std::size_t rows =
                    track.times.size() * (track.interpolation == KeyInterpolation::CubicSpline ? 3 : 1);
                weights.resize(track.values.size() / rows);
                evaluate(track, seconds, weights);
                weightsOf = target.node;
            }
            weight = static_cast<float>(weights[target.weight]);
        }
        if (weight == 0.0F)
            continue;
        for (std::size_t v = 0; v < target.offsets.size(); ++v)
            out[target.first + v] += weight * target.offsets[v];
    }
}

void SkinnedFrames::read(FrameIndex frame, MutablePositions out) const
{
    const double seconds = m_clip->first + static_cast<double>(frame.value) / m_fps;
    std::copy(m_model->rest.begin(), m_model->rest.end(), out.begin());
    if (m_hasMorphs)
        applyMorphs(seconds, out);
    skin(m_model->influenceStart, m_model->influences, jointMatrices(seconds), out);
}

void skin(std::span<const std::uint32_t> influenceStart, std::span<const SceneInfluence> influences,
          std::span<const Eigen::Matrix4f> matrices, MutablePositions positions)
{
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const std::uint32_t first = influenceStart[v];
        const std::uint32_t end = influenceStart[v + 1];
        Eigen::Matrix4f blended = influences[first].weight * matrices[influences[first].joint];
        for (std::uint32_t i = first + 1; i < end; ++i)
            blended += influences[i].weight * matrices[influences[i].joint];
        const Vec3f& p = positions[v];
        const Eigen::Vector4f moved =
            blended.col(0) * p.x() + blended.col(1) * p.y() + blended.col(2) * p.z() + blended.col(3);
        positions[v] = moved.head<3>();
    }
}

} // namespace quadrille
