// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/progress.h"
#include "model/sample/atlas.h"
#include "model/sample/skeleton.h"
#include "model/sequence/meshsequence.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

struct SampleOptions
{
    /// Takes differ with it; the figure does not.
    std::uint64_t seed = 1;
    /// Side of the character's texture, texels.
    int textureSize = 1024;
    /// Takes of each kind, 1 … 3.
    int takesPerKind = 2;
};

/// One performance with everything that is known about it.
struct SampleTake
{
    std::string kind; ///< "walk", "jump long", …
    MeshSequence sequence;
    std::vector<SkeletonPose> poses; ///< one per frame
    FrameRange flight;               ///< of a jump: no foot on the ground
};

/// A body at rest with its texture.
struct SampleBody
{
    std::string name;
    std::shared_ptr<const Topology> topology;
    std::vector<Vec3f> rest;
    std::shared_ptr<const Image> texture;
    Atlas atlas;
};

/// The built-in character, in memory.
struct SampleCharacter
{
    SampleBody body;
    Skeleton skeleton;
    std::vector<VertexWeights> weights;
    std::vector<SampleTake> takes;
};

/// Makes the built-in character. The same options give the same bytes, whatever the number of threads.
/// \throws Error BadArgument, Cancelled.
SampleCharacter makeSampleCharacter(const SampleOptions& options = {}, const Progress& progress = {});

/// Writes the character, its takes, the target body, the ground truth and a project that uses them all.
/// \param folder is made; files of an earlier sample in it are replaced.
/// \return the project file.
/// \throws Error BadArgument, WriteFailed, PermissionDenied, Cancelled.
std::filesystem::path writeSample(const std::filesystem::path& folder, const SampleOptions& options = {},
                                  const Progress& progress = {});

} // namespace quadrille
