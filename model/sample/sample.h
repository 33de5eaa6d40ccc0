// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/progress.h"
#include "model/sample/skeleton.h"
#include "model/sequence/meshsequence.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

struct SampleOptions
{
    /// Takes differ with it; the figure does not.
    std::uint64_t seed = 1;
    /// Side of the bodies' textures, texels: 64 … 1024, a power of two.
    int textureSize = 1024;
    /// Takes of each kind, 1 … 3.
    int takesPerKind = 2;
};

/// Light of one frame: what is baked into its texture.
struct SampleLight
{
    Vec3d direction = Vec3d::UnitY(); ///< to the light, unit length, in the world
    Vec3d colour = Vec3d::Ones();     ///< of the directional part, RGB
    Vec3d ambient = Vec3d::Zero();    ///< RGB
};

/// How far a frame's texture is shifted: the texel at x shows what belongs to x + offset(x). A square grid of
/// nodes over the texture, from its upper left corner, bilinear in between.
struct SampleWarp
{
    static constexpr int nodes = 17;    ///< per side
    std::vector<Vec2f> offsets;         ///< nodes × nodes in rows from the top, texels; y grows downwards
    Vec2f at(double u, double v) const; ///< \param u,v in [0, 1] from the upper left corner
};

/// Changing light and misalignment of one take, per frame.
struct SampleAppearance
{
    int textureSize = 512;
    std::vector<SampleLight> lights;
    std::vector<SampleWarp> warps;
};

/// One performance with everything that is known about it.
struct SampleTake
{
    std::string kind; ///< "walk", "jump long", …
    MeshSequence sequence;
    std::vector<SkeletonPose> poses; ///< one per frame
    FrameRange flight;               ///< of a jump: no foot on the ground
    /// Set for the takes that are written with a texture per frame.
    std::optional<SampleAppearance> appearance;
};

/// A body at rest with its texture.
struct SampleBody
{
    std::string name;
    std::shared_ptr<const Topology> topology;
    std::vector<Vec3f> rest;
    std::shared_ptr<const Image> texture;
};

/// A place on a mesh: a triangle and the weights of its corners.
struct SurfacePoint
{
    TriangleIndex triangle;
    Vec3d weights = Vec3d::UnitX();
};
struct LandmarkPair
{
    std::string name;
    SurfacePoint source; ///< on the character
    SurfacePoint target; ///< on the target body
};

/// The built-in character, in memory. The takes share one texture; `frameTexture` makes those of single
/// frames.
struct SampleCharacter
{
    SampleBody body;
    Skeleton skeleton;
    std::vector<VertexWeights> weights;
    std::vector<SampleTake> takes;
    /// Another figure at rest: other proportions, another mesh.
    SampleBody target;
    /// The same places on the character and on the target.
    std::vector<LandmarkPair> landmarks;
};

/// Makes the takes of the built-in character. The same options give the same bytes, whatever the number of
/// threads. \throws Error BadArgument, Cancelled.
SampleCharacter makeSampleCharacter(const SampleOptions& options = {}, const Progress& progress = {});

/// Writes the character, its takes, the target body, the ground truth and a project that uses them all.
/// \param folder is made; files of an earlier sample in it are replaced.
/// \return the project file.
/// \throws Error BadArgument, WriteFailed, PermissionDenied, Cancelled.
std::filesystem::path writeSample(const std::filesystem::path& folder, const SampleOptions& options = {},
                                  const Progress& progress = {});

} // namespace quadrille
