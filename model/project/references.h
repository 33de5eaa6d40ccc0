// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// What other entries of a project speak of by name.
enum class NamedKind
{
    Character,
    Sequence,
    Animation,
    Variation,
};

/// The new name of an entry that is spoken of; nothing where it is gone.
using NameChange = std::function<std::optional<std::string>(const std::string& name)>;

/// What cannot be without entries that are gone.
struct LostEntries
{
    std::vector<std::string> sequences;
    std::vector<std::string> animations;
    std::vector<std::string> variations;
};

/// Changes all references to entries of a kind. Where the entry is gone, so is what speaks of it: sequences
/// and exports that show it, the whole of a character, variations that are left without takes, and of
/// animations, variations and evaluations only the constraints, junctions, walks, varied repeats, takes,
/// blends and names that cannot be met any more. \return the sequences, animations and variations that went;
/// references to them are still there.
LostEntries changeReferences(Project& project, NamedKind kind, const NameChange& change);

/// Gives an entry another name, wherever it is spoken of.
void renameEntry(Project& project, NamedKind kind, const std::string& before, const std::string& after);

/// Writes the name of the only character wherever it was left out, so that another can be added.
/// \pre There is one character.
void nameOnlyCharacter(Project& project);

/// Removes entries, and everything that cannot be without them.
void removeEntries(Project& project, NamedKind kind, const std::vector<std::string>& names);

} // namespace quadrille
