// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/appearancework.h"
#include "model/appearance/texturequality.h"
#include "widgets/controls/textureview.h"
#include "widgets/theme/colormap.h"

#include <optional>

namespace quadrille {

/// What the pair of textures is about that the Appearance workspace compares.
enum class TextureContent
{
    Frame,     ///< the texture of a captured frame, and what the model makes of it
    Between,   ///< textures between two frames: blended linearly, and by the model
    Completed, ///< a texture before and after a part of it was filled in
    Component, ///< the mean texture moved along a component, to and fro
};

/// All that such a pair is made of. A value, for jobs.
struct TextureRequest
{
    TextureContent content = TextureContent::Frame;
    OpenedAppearancePointer opened; ///< null: there is only the captured texture
    AppearanceCoefficients first;   ///< Between: of the first frame; Component: of the first texture
    AppearanceCoefficients second;  ///< of the second texture, or frame
    Texture captured;               ///< of the frame, or the first of two
    Texture other;                  ///< Between: captured with the second; Completed: the completed one
    double weight = 0;              ///< Between: of the second
    bool isSigned = true;           ///< the difference
    bool isWarp = false;            ///< Component: of Eigen warps
    int component = 0;              ///< Component: which
};

/// The first texture of a pair; null where there is none. \throws Error what reading a texture throws.
std::shared_ptr<const Image> firstTexture(const TextureRequest& request);
/// The second one; null where there is none. \throws Error as firstTexture.
std::shared_ptr<const Image> secondTexture(const TextureRequest& request);

/// A pair, ready to be shown.
struct ShownPair
{
    widgets::TexturePicture first;
    widgets::TexturePicture second;        ///< null where there is none
    widgets::TexturePicture difference;    ///< second minus first in colours, where a triangle covers it
    widgets::ScalarRange range;            ///< of the difference of two textures, grey levels
    std::optional<PictureQuality> quality; ///< none without a second texture of the same size
};

/// On threads of jobs. \throws Error as firstTexture, Cancelled. Cost: some 50 ms for 1024².
ShownPair makePair(const TextureRequest& request, const Progress& progress);

/// The difference of two textures in colours, mean of R, G and B, transparent outside of what triangles
/// cover. \param range  receives what the colours mean: ends are a power of two above nearly all differences.
/// \pre Both have the atlas's size.
QImage differencePicture(const Image& first, const Image& second, const UsedTexels& texels, bool isSigned,
                         widgets::ScalarRange& range);

} // namespace quadrille
