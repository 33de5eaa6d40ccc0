// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/projection/textureprojector.h"
#include "model/sequence/meshsequence.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// The picture of a camera that shows a frame; null where there is none. Called from any thread.
using FramePicture = std::function<std::shared_ptr<const Image>(std::size_t camera, FrameIndex frame)>;
/// Takes the texture of a frame. Called from any thread, for several frames at a time.
using TakeTexture = std::function<void(FrameIndex frame, const Image& texture)>;

/// How much of a frame cameras see.
struct FrameCoverage
{
    double seen = 0;            ///< share of the texels that triangles cover which some camera sees
    double cameras = 0;         ///< that see such a texel, mean
    std::vector<double> shares; ///< see ProjectedTexels
};

struct ProjectedClip
{
    std::vector<FrameCoverage> frames;
    /// Per texel of the atlas, in how many frames some camera sees it; rows from top to bottom.
    std::vector<std::int32_t> timesSeen;
};

/// What stands for texels where no camera sees them: per texel the median of those frames that see it at
/// least half as well as the best. Its trust is 0 where none does.
/// \pre All frames have the same number of texels, and there is one.
std::vector<ProjectedTexels::Colour>
medianColours(std::span<const std::vector<ProjectedTexels::Colour>> frames);

/// An opaque texture of projected texels. The less they are trusted, the more `fill` shows through; texels
/// that neither knows, and those between charts, take the nearest that are known. \param fill  empty: texels
/// that no camera sees are black, and only what lies between charts is filled. \pre Texels are as those of
/// the atlas.
Image filledTexture(const AtlasTexels& atlas, std::span<const ProjectedTexels::Colour> texels,
                    std::span<const ProjectedTexels::Colour> fill);

/// The textures of all frames of a clip. \param fills  whether texels that no camera sees are filled, from up
/// to fifteen other frames that are spread over the clip, and then from their neighbours.
/// \throws Error as TextureProjector::project, and what frames, pictures and \p take throw; Cancelled.
/// Frames are shared out by the executor; what comes out does not depend on how. Memory: what projecting
/// takes for each thread, and 60 bytes per texel for filling.
ProjectedClip projectClip(const TextureProjector& projector, const MeshSequence& clip,
                          const FramePicture& picture, bool fills, const TakeTexture& take,
                          const Progress& progress = {}, const Executor& executor = localExecutor());

} // namespace quadrille
