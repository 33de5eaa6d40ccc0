// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/usedtexels.h"
#include "model/core/image.h"
#include "model/project/document/appearanceentry.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace quadrille {

/// Marks the texels that strokes cover, in order. \param mask  height × width, rows from the top: not 0 where
/// a texture is not known. Cost: texels of the strokes' surroundings.
void paintStrokes(std::span<const MaskStrokeEntry> strokes, int width, int height,
                  std::span<std::uint8_t> mask);

/// What is known of a texture that is to be completed: all but what its mask and strokes mark.
/// \param file  of the texture, for errors. \param folder  the project's. \return height × width: 1 where it
/// is known. \throws Error ProjectInvalid where texture or mask have not the size of the atlas; what reading
/// throws.
std::vector<std::uint8_t> knownTexels(const CompletionEntry& completion, const Image& texture,
                                      const UsedTexels& atlas, const std::filesystem::path& file,
                                      const std::filesystem::path& folder);

} // namespace quadrille
