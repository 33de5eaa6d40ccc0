// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <string>
#include <vector>

namespace quadrille {

/// Everything in the project, besides the content of files, that an opened sequence's frames and textures
/// depend on. Names and paths are not in it: what was renamed or moved need not be computed again.
std::string sequenceSettings(const Project& project, const SequenceEntry& entry);
/// The same of several sequences, with their names.
std::string sequenceSettings(const Project& project, const std::vector<std::string>& names);
/// When the feet stand, as the entry says.
std::string contactSettings(const SequenceEntry& entry);

} // namespace quadrille
