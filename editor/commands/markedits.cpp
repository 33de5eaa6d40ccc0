// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/markedits.h"

#include "editor/commands/changeproject.h"
#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct MarkTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::MarkEdits)
};

} // namespace

void setLabelsOfSequences(ProjectDocument& document,
                          const std::vector<std::pair<QString, std::vector<LabelSpan>>>& labels)
{
    Project after = document.project();
    for (const auto& [name, spans] : labels)
        entryOf<SequenceEntry>(after, name).labels = spans;
    document.push(std::make_unique<ChangeProject>(
        document, MarkTexts::tr("Label %n sequences", nullptr, static_cast<int>(labels.size())),
        std::move(after)));
}

void setSequenceNotes(ProjectDocument& document, const QString& name, std::vector<FrameNote> notes,
                      EditPhase phase)
{
    SequenceEntry after = entryOf<SequenceEntry>(document.project(), name);
    setNotes(after.unknown, std::move(notes));
    setEntry(document, name, MarkTexts::tr("Change the notes of “%1”").arg(name), QStringLiteral("notes"),
             std::move(after), phase);
}

} // namespace quadrille
