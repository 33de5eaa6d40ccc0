// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of body parts and variations; as those of projectedits.h.

/// \return the name that the variations got.
QString addVariation(ProjectDocument& document, VariationEntry variation);
/// \return the copy's name.
QString duplicateVariation(ProjectDocument& document, const QString& name);
/// Exchanges the values of variations; their name stays.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setVariation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, VariationEntry after, EditPhase phase = EditPhase::Final);

/// The parts of a character's body: none where the project names none. A copy; setBodyParts() puts it in.
BodyPartsEntry bodyPartsEntry(const Project& project, const QString& character);
/// Exchanges the body parts of the entry's character.
void setBodyParts(ProjectDocument& document, const QString& text, const QString& property,
                  const BodyPartsEntry& after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
