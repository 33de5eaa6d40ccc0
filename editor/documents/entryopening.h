// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"

namespace quadrille {

/// A sequence of a project with all frames of its source, and what opening found.
struct OpenedEntry
{
    MeshSequence sequence;
    std::vector<Issue> issues;
};

/// Opens the source of an entry without cutting or resampling it, in the project's axes and with its
/// textures. Paths are absolute.
/// \throws Error as openSequences; ImageCountMismatch.
OpenedEntry openEntry(const SequenceEntry& entry, const CharacterEntry& character,
                      const ProjectSettings& settings, const Progress& progress);

} // namespace quadrille
