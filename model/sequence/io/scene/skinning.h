// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/framesource.h"
#include "model/sequence/io/scene/scene.h"

#include <memory>

namespace quadrille {

/// Offsets of some consecutive vertices of a skinned model.
struct MorphTarget
{
    int node = 0;             ///< whose weights drive it
    std::uint32_t weight = 0; ///< which of the node's weights
    float restWeight = 0;     ///< where no clip says otherwise
    std::uint32_t first = 0;  ///< vertex of the first offset
    std::vector<Vec3f> offsets;
};

/// Welded meshes of a scene and what moves them: vertex = Σ weight · global(joint) · inverseBind · (rest + Σ
/// morph weight · offset). Shared by all clips of a file.
struct SkinnedModel
{
    std::vector<SceneNode> nodes;
    std::vector<SceneJoint> joints;
    std::vector<Vec3f> rest;
    /// Influences of vertex v: [influenceStart[v], influenceStart[v + 1]); joints of the model, weights sum
    /// to 1.
    std::vector<std::uint32_t> influenceStart;
    std::vector<SceneInfluence> influences;
    std::vector<MorphTarget> morphTargets;
    std::filesystem::path file;
};

/// Frames of a skinned model, computed when asked for: frame k is the clip at first + k / fps.
class SkinnedFrames : public FrameSource
{
public:
    SkinnedFrames(std::shared_ptr<const SkinnedModel> model, std::shared_ptr<const SceneClip> clip,
                  double fps, std::int64_t frameCount);

    std::int64_t frameCount() const override { return m_frameCount; }
    std::uint32_t vertexCount() const override { return static_cast<std::uint32_t>(m_model->rest.size()); }
    void read(FrameIndex frame, MutablePositions out) const override;
    std::filesystem::path fileOf(FrameIndex) const override { return m_model->file; }

private:
    std::vector<Eigen::Matrix4f> jointMatrices(double seconds) const;
    void applyMorphs(double seconds, MutablePositions out) const;

    std::shared_ptr<const SkinnedModel> m_model;
    std::shared_ptr<const SceneClip> m_clip;
    std::vector<const NodeTracks*> m_tracksOfNode; ///< into the clip; null where a node does not move
    double m_fps;
    std::int64_t m_frameCount;
    bool m_hasMorphs;
};

/// Linear blend skinning in place.
/// \param influenceStart  vertices + 1; \param matrices  joint matrices that the influences index.
void skin(std::span<const std::uint32_t> influenceStart, std::span<const SceneInfluence> influences,
          std::span<const Eigen::Matrix4f> matrices, MutablePositions positions);

} // namespace quadrille
