// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/alignment.h"
#include "model/appearance/chartlookup.h"
#include "model/appearance/decode.h"
#include "model/appearance/texturequality.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// The textures of a character with the frames that show them, by which its representations are measured.
struct AppearanceSubject
{
    TextureSource textures;
    std::shared_ptr<const ChartLookup> charts;
    std::shared_ptr<const Topology> topology;
    std::function<Frame(std::int64_t texture)> frame; ///< the mesh that shows a texture
    UpAxis up = UpAxis::Y;
    int cameras = 4; ///< around the body, by which pictures are compared; at least one
    /// Of how many textures, evenly spread over those that are measured, pictures are compared; none: of
    /// none, and errors in pictures say nothing.
    std::int64_t pictures = 32;
    std::filesystem::path scratchFolder;
};

/// What a representation loses of textures.
struct AppearanceErrors
{
    PictureQuality texture; ///< over the texels that are covered
    PictureQuality image;   ///< over silhouettes, as cameras see them
};

/// A texture as a representation has it, of the atlas's size; only covered texels count. Called from any
/// thread.
using RestoredTexture = std::function<Image(std::int64_t texture)>;

/// How well representations restore some textures: of each the mean over all of them, and over those of which
/// pictures are compared.
/// \throws Error Cancelled, and what reading textures and frames throws. Cost: per texture and representation
/// one SSIM of the atlas, and perhaps a picture of each camera.
std::vector<AppearanceErrors> restorationErrors(const AppearanceSubject& subject,
                                                std::span<const std::int64_t> textures,
                                                std::span<const RestoredTexture> representations,
                                                const Progress& progress = {},
                                                const Executor& executor = localExecutor());

/// A picture of the atlas's size with colours at used texels, black elsewhere.
/// \param colours  R, G, B of each used texel.
Image atlasPicture(const UsedTexels& used, std::span<const std::uint8_t> colours);

/// Moves aligned textures back by a warp of the grid (see AppearanceModel), outside of any model.
class Dealigner
{
public:
    Dealigner(const UsedTexels& used, const WarpGrid& grid);
    /// \param colours  R, G, B of each used texel. \param warp  x, y per node.
    Image dealigned(std::span<const std::uint8_t> colours, std::span<const float> warp) const;

private:
    AppearanceDecoder m_decoder;
};

} // namespace quadrille
