// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of graphs and animations; as those of projectedits.h.

/// \return the name that the animation got.
QString addAnimation(ProjectDocument& document, AnimationEntry animation);
/// \return the copy's name.
QString duplicateAnimation(ProjectDocument& document, const QString& name);
/// Whether two animations ask for the same walk, but for what was decided about transitions.
bool asksTheSame(const AnimationEntry& a, const AnimationEntry& b);
/// Exchanges an animation's values; its name stays. Where they ask for another walk than before, decisions do
/// not keep to the one that they were made on any more.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setAnimation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, AnimationEntry after, EditPhase phase = EditPhase::Final);

/// The graph settings of a character, the usual ones where the project names none. A copy; setGraph() puts it
/// in.
GraphEntry graphEntry(const Project& project, const QString& character);
/// Exchanges the graph settings of the entry's character.
void setGraph(ProjectDocument& document, const QString& text, const QString& property,
              const GraphEntry& after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
