// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of projections; as those of projectedits.h.

/// \return the name that the projection got.
QString addProjection(ProjectDocument& document, ProjectionEntry projection);
/// \return the copy's name.
QString duplicateProjection(ProjectDocument& document, const QString& name);
/// Exchanges the values of a projection; its name stays.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setProjection(ProjectDocument& document, const QString& name, const QString& text,
                   const QString& property, ProjectionEntry after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
