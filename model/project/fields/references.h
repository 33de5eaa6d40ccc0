// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/fields/fieldinfo.h"

#include <string>
#include <vector>

namespace quadrille {

/// Gives an entry another name, wherever it is spoken of.
void renameEntry(Project& project, NamedKind kind, const std::string& before, const std::string& after);

/// Writes the name of the only character wherever it was left out, so that another can be added.
/// \pre There is one character.
void nameOnlyCharacter(Project& project);

/// Removes entries, and what speaks of them: sequences and exports that show them, the whole of a character,
/// variations that are left without takes, and of animations, variations and evaluations only the
/// constraints, junctions, walks, varied repeats, takes, blends and names that cannot be met any more.
void removeEntries(Project& project, NamedKind kind, const std::vector<std::string>& names);

} // namespace quadrille
