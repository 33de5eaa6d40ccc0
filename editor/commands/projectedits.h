// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

#include <QStringList>

namespace quadrille {

// Every edit of a project, as the user names it. Each is one undo step; a drag is one for all its steps.
// Names that do not exist are a programming error.

/// A name that no entry of the section has yet: `wanted`, or `wanted 2`, `wanted 3`, …
QString freeName(const Project& project, Section section, const QString& wanted);

/// Adds sequences at the end, and the characters that come with them. Names are made free.
/// \param fps the rate that the project takes with them; empty: it keeps its own.
/// \return the names that the sequences got; none where they are refused.
QStringList addSequences(ProjectDocument& document, std::vector<SequenceEntry> sequences,
                         std::vector<CharacterEntry> characters = {}, std::optional<double> fps = {});
/// Removes entries, and everything of the project that cannot be without them: exports and sequences that
/// show them, constraints of animations.
void removeEntries(ProjectDocument& document, Section section, const QStringList& names);
/// Empty where it is refused.
/// \return the copy's name.
QString duplicateSequence(ProjectDocument& document, const QString& name);
/// False when another entry of the section has the name, or it is empty. Otherwise all that refers to it
/// speaks of the new name. EditRefusals tells why it is refused.
bool renameEntry(ProjectDocument& document, const EntryRef& entry, const QString& after);

/// Trims; labels and contacts stay on the frames of the source where they are, and are cut at the ends.
/// \param range in source frames; empty for all.
/// \param base the entry when the drag began, so that spans come back when it is dragged back; null: as it
/// is.
void setSequenceRange(ProjectDocument& document, const QString& name, std::optional<FrameRange> range,
                      EditPhase phase = EditPhase::Final, const SequenceEntry* base = nullptr);
/// \param fps  of a source that names none; empty: that of the project.
void setSequenceFps(ProjectDocument& document, const QString& name, std::optional<double> fps,
                    EditPhase phase = EditPhase::Final);
void setSequenceAxes(ProjectDocument& document, const QString& name, std::optional<CoordinateSystem> axes,
                     EditPhase phase = EditPhase::Final);
void setSequenceTexture(ProjectDocument& document, const QString& name, const TextureReference& texture);
void setSequenceCharacter(ProjectDocument& document, const QString& name, const QString& character);
void setSequenceLabels(ProjectDocument& document, const QString& name, std::vector<LabelSpan> labels,
                       EditPhase phase = EditPhase::Final);
void setSequenceContacts(ProjectDocument& document, const QString& name, std::vector<ContactSpan> contacts,
                         EditPhase phase = EditPhase::Final);
/// \param bvh  a file; empty for none.
void setJointAngles(ProjectDocument& document, const QString& name, const std::string& bvh);

void setCharacterNotes(ProjectDocument& document, const QString& name, const QString& notes);
void setCharacterTexture(ProjectDocument& document, const QString& name, const TextureReference& texture);
/// \param mesh  a file; empty for none.
void setCharacterMesh(ProjectDocument& document, const QString& name, const std::string& mesh);

/// They also take the place of settings that could not be read.
void setSettings(ProjectDocument& document, const ProjectSettings& settings,
                 EditPhase phase = EditPhase::Final);

/// Empty where it is refused.
/// \return the name that the entry got.
QString addExport(ProjectDocument& document, ExportEntry entry);
void setExport(ProjectDocument& document, const QString& name, const ExportEntry& entry);

/// Adds one of the tables that can be computed of a project. \return its name (see evaluationName()); empty
/// where it is refused, because the project has it or nothing that it could be about.
QString addEvaluation(ProjectDocument& document, EvaluationEntry entry);

/// Media that moved: the new path of each old one, as the project holds them. Where exports are written
/// stays.
void relinkMedia(ProjectDocument& document, const std::vector<std::pair<std::string, std::string>>& newPaths);

} // namespace quadrille
