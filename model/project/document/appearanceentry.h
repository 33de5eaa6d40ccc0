// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/flowmethod.h"
#include "model/project/document/animationentry.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A stroke of a brush over a texture.
struct MaskStrokeEntry
{
    /// u and v of its points, one after the other: 0 … 1 from the lower left corner of the texture, as UVs.
    std::vector<double> points;
    double radius = 0.02; ///< in widths of the texture
    bool erases = false;  ///< takes away what strokes before it have marked
    UnknownKeys unknown;

    bool operator==(const MaskStrokeEntry&) const = default;
};

/// A captured texture of which a part is not known, to be filled in (SMCAS §5.3).
struct CompletionEntry
{
    NamedFrame frame;
    std::string mask; ///< a picture of the texture's size, white where it is not known; may be empty
    std::vector<MaskStrokeEntry> strokes; ///< over the mask, in order
    UnknownKeys unknown;

    bool operator==(const CompletionEntry&) const = default;
};

/// What frames of variations take their textures from.
enum class VariedTextures
{
    Learned, ///< from their poses, as textures were learned to vary with them
    Nearest, ///< from the captured frames that they vary
};

/// A model of the textures of one character: Eigen textures and Eigen warps (SMCAS §5).
struct AppearanceEntry
{
    std::string name;
    std::string character;              ///< may be left out in a file with one character
    std::vector<std::string> sequences; ///< learned from; all that have a texture per frame when empty
    std::int64_t components = 50;       ///< of both spaces together, at most
    double warpShare = 0.33;            ///< of the components
    FlowMethod flow = FlowMethod::TvL1;
    std::optional<NamedFrame> reference; ///< that all textures are aligned to; the medoid when empty
    VariedTextures varied = VariedTextures::Learned;
    std::vector<CompletionEntry> completions;
    UnknownKeys unknown;

    bool operator==(const AppearanceEntry&) const = default;
};

} // namespace quadrille
