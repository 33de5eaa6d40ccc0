// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/result.h"
#include "model/sequence/meshsequence.h"

#include <filesystem>
#include <optional>
#include <string>

namespace quadrille {

// The section “projections” as results: a texture for each frame as a picture of its own.

/// Where the step of an entry writes its textures, in the folder of a project's results.
std::filesystem::path projectionFolder(const std::filesystem::path& results, const std::string& name);

/// The textures of an entry as they were computed last, for a clip; nothing where there are none, or not as
/// many as the clip has frames. \param folder  the project's.
std::optional<TextureSet> projectedTextures(const std::filesystem::path& results,
                                            const std::filesystem::path& folder, const std::string& name,
                                            const MeshSequence& clip);

} // namespace quadrille
