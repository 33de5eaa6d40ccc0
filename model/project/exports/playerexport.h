// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/exports/exportentry.h"

namespace quadrille {

/// Whether an entry asks for a file that plays motion spaces (see BakedPlayer).
bool isPlayer(const ExportEntry& entry);

/// The results that the player of a performance is made from; those of the clip, where it is none.
std::vector<std::string> playerSteps(const Project& project, const ExportEntry& entry);

/// The sequences that it shows, whose textures it holds; none where it is no player.
std::vector<std::string> shownByPlayer(const Project& project, const ExportEntry& entry);

/// Writes the motion spaces of a performance with what leads from one to another, its recording, and the
/// textures of the captured frames where the entry wants textures.
/// \param context  has the results of playerSteps.
/// \throws Error as writeExport; FormatCannotStore (a clip that is no performance); BadArgument (a range, a
/// rate or axes, which a player has none of).
ExportResult writePlayer(const ExportEntry& entry, const std::shared_ptr<SequenceOpener>& opener,
                         const StepContext& context, WriteGuard* guard, const Progress& progress);

} // namespace quadrille
