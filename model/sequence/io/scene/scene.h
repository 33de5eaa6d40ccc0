// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/units.h"
#include "model/sequence/axes.h"
#include "model/sequence/texture.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// What scene formats (glTF, FBX, COLLADA) hold of meshes and their motion; importers fill it, scenesequences
/// turns it into sequences.

enum class KeyInterpolation
{
    Step,
    Linear,
    CubicSpline, ///< glTF's: each key holds in-tangent, value and out-tangent
};

/// Values over time. Values of quaternions are x, y, z, w.
struct KeyTrack
{
    std::vector<double> times; ///< seconds, increasing
    std::vector<float> values; ///< keys × components, or keys × 3 × components for CubicSpline
    KeyInterpolation interpolation = KeyInterpolation::Linear;

    bool isEmpty() const { return times.empty(); }
};

struct SceneNode
{
    std::string name;
    int parent = -1;
    Vec3d translation = Vec3d::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Vec3d scale = Vec3d::Ones();
    /// Used instead of the three above where no track moves the node.
    std::optional<Eigen::Matrix4d> matrix;
};

/// Moves one node during a clip; parts without keys stay what the node says.
struct NodeTracks
{
    int node = 0;
    KeyTrack translation;
    KeyTrack rotation;
    KeyTrack scale;
    KeyTrack morphWeights; ///< components: morph targets of the node's mesh
};

struct SceneClip
{
    std::string name;
    double first = 0; ///< seconds of the first key
    double last = 0;  ///< seconds of the last key
    std::vector<NodeTracks> tracks;
};

struct SceneInfluence
{
    std::uint32_t joint = 0; ///< index into SceneMesh::joints
    float weight = 0;
};

struct SceneJoint
{
    int node = 0;
    Eigen::Matrix4d inverseBind = Eigen::Matrix4d::Identity(); ///< mesh space → joint space at rest
};

/// The mesh of one node, all its parts together, vertices as the format splits them.
struct SceneMesh
{
    int node = 0;
    std::vector<Vec3f> positions;
    std::vector<Vec2f> uvs; ///< one per vertex, origin lower left; empty without
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint16_t> triangleMaterials;        ///< one per triangle, into Scene::materials
    std::vector<SceneJoint> joints;                      ///< empty without a skin
    std::vector<std::vector<SceneInfluence>> influences; ///< one list per vertex with a skin
    std::vector<std::vector<Vec3f>> morphTargets;        ///< targets × vertices, offsets
    std::vector<float> morphWeights;                     ///< of the targets, where no clip says otherwise
    /// Per vertex its place in the mesh before the format split it, where the file says; else empty.
    std::vector<std::uint32_t> originalVertices;
    std::uint32_t originalVertexCount = 0;
};

struct SceneMaterial
{
    std::string name;
    Texture texture;
};

struct Scene
{
    std::vector<SceneNode> nodes; ///< each after its parent
    std::vector<SceneMesh> meshes;
    std::vector<SceneMaterial> materials;
    std::vector<SceneClip> clips;
    CoordinateSystem coordinates;
    std::vector<Issue> issues;
};

} // namespace quadrille
