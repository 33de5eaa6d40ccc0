// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of models of appearance; as those of projectedits.h.

/// \return the name that the model got.
QString addAppearance(ProjectDocument& document, AppearanceEntry appearance);
/// \return the copy's name.
QString duplicateAppearance(ProjectDocument& document, const QString& name);
/// Exchanges the values of a model; its name stays.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setAppearance(ProjectDocument& document, const QString& name, const QString& text,
                   const QString& property, AppearanceEntry after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
