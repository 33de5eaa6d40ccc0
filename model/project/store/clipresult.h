// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/result.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A clip as a result: the array “positions” and the table “frames”, which says where each frame comes from;
/// where textures come from elsewhere, the table “textures”, too.
/// \param sequences  names, in the order of the layout that the origins count.
/// \param variations  names of the variations that the origins count; without any there are no columns of
/// them.
Result clipResult(const Clip& clip, const FrameLayout& layout, const std::vector<std::string>& sequences,
                  const std::string& unit, std::span<const std::string> variations = {});

/// What clipResult made of a clip; nothing where a clip is not there, or not of these sequences.
/// \param sequences  as sequencesOfClip has them. \param variations  as for clipResult; without any, origins
/// count none.
std::optional<Clip> clipOf(const Result& result, std::span<const MeshSequence> sequences, double fps,
                           std::span<const std::string> variations = {});

/// A made clip from the results of a project, with textures, labels and contacts; nothing where it is not
/// there. \param clip  "animations/NAME", "variations/NAME/3". \param sequences  as sequencesOfClip has them.
/// \throws Error PermissionDenied, ReadFailed, VertexCountMismatch.
std::optional<MeshSequence> readClip(const std::filesystem::path& results, const std::string& clip,
                                     std::span<const MeshSequence> sequences, double fps);

} // namespace quadrille
