// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/motionspaceedits.h"

#include "editor/commands/entryedits.h"
#include "model/project/document/findentry.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct MotionSpaceTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::MotionSpaceEdits)
};

} // namespace

QString addMotionSpace(ProjectDocument& document, const QString& name, const QStringList& sequences)
{
    const Project& project = document.project();
    MotionSpaceEntry entry;
    entry.name = name.toStdString();
    if (!project.characters.empty() && project.characters.size() > 1) {
        const SequenceEntry* first =
            sequences.isEmpty() ? nullptr : findSequence(project, sequences.front().toStdString());
        const CharacterEntry* of = first == nullptr ? nullptr : characterOf(project, *first);
        entry.character = of == nullptr ? project.characters.front().name : of->name;
    }
    const QStringList own = sequencesFor(project, entry);
    for (const QString& sequence : sequences) {
        if (own.contains(sequence) && entry.takes.size() < WeightSpace::mostTakes)
            entry.takes.emplace_back().sequence = sequence.toStdString();
    }
    if (entry.takes.size() > 1)
        entry.parameters.emplace_back().name = MotionSpaceTexts::tr("speed").toStdString();
    return addEntry(document, MotionSpaceTexts::tr("Add motion space “%1”"), std::move(entry));
}

QString duplicateMotionSpace(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<MotionSpaceEntry>(document, MotionSpaceTexts::tr("Duplicate “%1”").arg(name), name);
}

void setMotionSpace(ProjectDocument& document, const QString& name, const QString& text,
                    const QString& property, MotionSpaceEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

QStringList sequencesFor(const Project& project, const MotionSpaceEntry& entry)
{
    const std::string character = characterNameOf(project, entry);
    QStringList names;
    for (const SequenceEntry& sequence : project.sequences) {
        const CharacterEntry* of = characterOf(project, sequence);
        if ((of == nullptr ? std::string() : of->name) == character)
            names += QString::fromStdString(sequence.name);
    }
    return names;
}

} // namespace quadrille
