// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

#include <QStringList>

namespace quadrille {

// Edits of motion spaces; as those of projectedits.h.

/// A motion space of some sequences, steered by their speed; of those of the first one's character, and not
/// of more than a space may have. \return the name that it got.
QString addMotionSpace(ProjectDocument& document, const QString& name, const QStringList& sequences);
/// Adds takes to a motion space: those of its character, as far as it may have more. \pre There is one.
void addTakes(ProjectDocument& document, const QString& name, const QStringList& sequences);
/// Whether one of some takes may be added so; not where there is no such space.
bool canTake(const ProjectDocument& document, const QString& name, const QStringList& sequences);
/// \return the copy's name.
QString duplicateMotionSpace(ProjectDocument& document, const QString& name);
/// Exchanges the values of a motion space; its name stays.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setMotionSpace(ProjectDocument& document, const QString& name, const QString& text,
                    const QString& property, MotionSpaceEntry after, EditPhase phase = EditPhase::Final);

/// The sequences that its takes may be. \return in project order.
QStringList sequencesFor(const Project& project, const MotionSpaceEntry& entry);

/// Adds a parameter that measures what no other one does, where there is such a thing, with a name of its
/// own.
void addParameter(MotionSpaceEntry& entry);
/// A parameter that is called by what it measured before is called by what it measures now.
void followMeasure(MotionSpaceEntry& entry, std::size_t parameter, SpaceMeasure before);

} // namespace quadrille
