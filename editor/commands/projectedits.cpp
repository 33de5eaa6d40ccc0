// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectedits.h"

#include "editor/commands/changeproject.h"
#include "editor/commands/entryedits.h"
#include "editor/commands/entrynames.h"
#include "editor/documents/editcheck.h"
#include "editor/documents/evaluationnames.h"
#include "editor/documents/evaluationtexts.h"
#include "model/core/contains.h"
#include "model/project/checks/validateevaluations.h"
#include "model/project/document/brokenentry.h"
#include "model/project/document/framenote.h"
#include "model/project/fields/entrypaths.h"
#include "model/project/fields/references.h"

#include <QCoreApplication>
#include <cmath>

namespace quadrille {

namespace {

struct ProjectTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ProjectEdits)
};

/// Moves spans and cuts them to 0 … last; those outside go.
template <typename Span>
void shiftSpans(std::vector<Span>& spans, std::int64_t shift, std::optional<std::int64_t> last)
{
    std::vector<Span> kept;
    for (Span& span : spans) {
        const std::int64_t first = std::max<std::int64_t>(0, span.frames.first.value + shift);
        std::int64_t end = span.frames.last.value + shift;
        if (last)
            end = std::min(end, *last);
        span.frames = {FrameIndex(first), FrameIndex(end)};
        if (span.frames.count() > 0)
            kept.push_back(std::move(span));
    }
    spans = std::move(kept);
}

/// Whether a table cannot be computed of a project.
bool hasProblems(const Project& project, const EvaluationEntry& evaluation)
{
    Project alone = project;
    alone.evaluations = {evaluation};
    ProjectProblems problems;
    validateEvaluations(alone, problems);
    return hasErrors(problems);
}

QString removalText(Section section, const QStringList& names)
{
    const int count = static_cast<int>(names.size());
    if (count == 1)
        return ProjectTexts::tr("Remove “%1”")
            .arg(section == Section::Evaluations ? evaluationTitle(names.front()) : names.front());
    return QCoreApplication::translate("quadrille::ProjectEdits", findSection(section)->removal, nullptr,
                                       count);
}

} // namespace

QStringList addSequences(ProjectDocument& document, std::vector<SequenceEntry> sequences,
                         std::vector<CharacterEntry> characters, std::optional<double> fps)
{
    Project preview = document.project();
    // What left its character out still means the one that was alone.
    const bool namesCharacter = preview.characters.size() == 1 && !characters.empty();
    if (namesCharacter)
        nameOnlyCharacter(preview);
    ProjectPart part;
    if (fps && *fps != preview.settings.fps)
        part.fps = fps;
    for (CharacterEntry& character : characters) {
        const QString wanted = QString::fromStdString(character.name);
        const std::string before = character.name;
        character.name = freeName(preview, Section::Characters, wanted).toStdString();
        for (SequenceEntry& sequence : sequences) {
            if (sequence.character == before)
                sequence.character = character.name;
        }
        part.of<CharacterEntry>().emplace_back(preview.characters.size(), character);
        preview.characters.push_back(std::move(character));
    }
    QStringList names;
    for (SequenceEntry& sequence : sequences) {
        names += freeName(preview, Section::Sequences, QString::fromStdString(sequence.name));
        sequence.name = names.back().toStdString();
        part.of<SequenceEntry>().emplace_back(preview.sequences.size(), sequence);
        preview.sequences.push_back(std::move(sequence));
    }
    const QString text = names.size() == 1
                             ? ProjectTexts::tr("Add “%1”").arg(names.front())
                             : ProjectTexts::tr("Add %n sequences", nullptr, static_cast<int>(names.size()));
    std::unique_ptr<ProjectCommand> command;
    if (namesCharacter) {
        preview.settings.fps = part.fps.value_or(preview.settings.fps);
        command = std::make_unique<ChangeProject>(document, text, std::move(preview));
    } else {
        command = std::make_unique<InsertPart>(document, text, std::move(part));
    }
    return wasTaken(document, std::move(command)) ? names : QStringList();
}

void removeEntries(ProjectDocument& document, Section section, const QStringList& names)
{
    std::vector<std::string> gone;
    for (const QString& name : names)
        gone.push_back(name.toStdString());
    const Project& before = document.project();
    Project after = before;
    if (const auto kind = findSection(section)->kind)
        removeEntries(after, *kind, gone);
    else if (section == Section::Evaluations)
        std::erase_if(after.evaluations, [&](const EvaluationEntry& evaluation) {
            return names.contains(evaluationName(evaluation));
        });
    else
        sectionlists::forEachNamed(after, [&](Section own, auto& entries) {
            if (own == section)
                std::erase_if(entries, [&](const auto& entry) { return contains(gone, entry.name); });
        });
    // Tables of results that were of what is gone.
    std::erase_if(after.evaluations, [&](const EvaluationEntry& evaluation) {
        return hasProblems(after, evaluation) && !hasProblems(before, evaluation);
    });
    document.push(std::make_unique<ChangeProject>(document, removalText(section, names), std::move(after)));
}

QString duplicateSequence(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<SequenceEntry>(document, ProjectTexts::tr("Duplicate “%1”").arg(name), name);
}

bool renameEntry(ProjectDocument& document, const EntryRef& entry, const QString& after)
{
    const QString name = after.trimmed();
    if (name == entry.name)
        return true;
    if (const auto problem = problemWithRename(document.project(), entry, name)) {
        EditRefusals::of(document).refuse(*problem);
        return false;
    }
    Project changed = document.project();
    if (const auto kind = findSection(entry.section)->kind)
        renameEntry(changed, *kind, entry.name.toStdString(), name.toStdString());
    else
        sectionlists::forEachNamed(changed, [&](Section own, auto& entries) {
            if (own == entry.section)
                std::ranges::find(entries, entry.name.toStdString(), [](const auto& each) {
                    return each.name;
                })->name = name.toStdString();
        });
    auto command = std::make_unique<ChangeProject>(
        document, ProjectTexts::tr("Rename “%1” to “%2”").arg(entry.name, name), std::move(changed),
        std::pair(EntryRef{entry.section, name}, entry.name));
    return wasTaken(document, std::move(command));
}

void setSequenceRange(ProjectDocument& document, const QString& name, std::optional<FrameRange> range,
                      EditPhase phase, const SequenceEntry* base)
{
    const double fps = document.project().settings.fps;
    SequenceEntry after = base != nullptr ? *base : entryOf<SequenceEntry>(document.project(), name);
    const double rate = fps / after.sourceFps.value_or(fps);
    const auto firstOf = [](const std::optional<FrameRange>& r) { return r ? r->first.value : 0; };
    const auto shift = std::llround(static_cast<double>(firstOf(after.range) - firstOf(range)) * rate);
    std::optional<std::int64_t> last;
    if (range)
        last = std::llround(static_cast<double>(range->count() - 1) * rate);
    shiftSpans(after.labels, shift, last);
    shiftSpans(after.contacts, shift, last);
    std::vector<FrameNote> notes = notesOf(after.unknown);
    for (FrameNote& note : notes)
        note.frame.value += shift;
    std::erase_if(notes, [&](const FrameNote& note) {
        return note.frame.value < 0 || (last && note.frame.value > *last);
    });
    setNotes(after.unknown, std::move(notes));
    after.range = range;
    document.push(
        std::make_unique<ChangeEntry<SequenceEntry>>(document, ProjectTexts::tr("Trim “%1”").arg(name), name,
                                                     QStringLiteral("range"), std::move(after), phase));
}

void setSequenceFps(ProjectDocument& document, const QString& name, std::optional<double> fps,
                    EditPhase phase)
{
    editEntry<SequenceEntry>(
        document, ProjectTexts::tr("Change the frame rate of “%1”").arg(name), name, QStringLiteral("fps"),
        [&](SequenceEntry& entry) { entry.sourceFps = fps; }, phase);
}

void setSequenceAxes(ProjectDocument& document, const QString& name, std::optional<CoordinateSystem> axes,
                     EditPhase phase)
{
    editEntry<SequenceEntry>(
        document, ProjectTexts::tr("Change axes or unit of “%1”").arg(name), name, QStringLiteral("axes"),
        [&](SequenceEntry& entry) { entry.sourceAxes = axes; }, phase);
}

void setSequenceTexture(ProjectDocument& document, const QString& name, const TextureReference& texture)
{
    editEntry<SequenceEntry>(document, ProjectTexts::tr("Change the texture of “%1”").arg(name), name,
                             QStringLiteral("texture"),
                             [&](SequenceEntry& entry) { entry.texture = texture; });
}

void setSequenceCharacter(ProjectDocument& document, const QString& name, const QString& character)
{
    editEntry<SequenceEntry>(document, ProjectTexts::tr("Change the character of “%1”").arg(name), name,
                             QStringLiteral("character"),
                             [&](SequenceEntry& entry) { entry.character = character.toStdString(); });
}

void setSequenceLabels(ProjectDocument& document, const QString& name, std::vector<LabelSpan> labels,
                       EditPhase phase)
{
    editEntry<SequenceEntry>(
        document, ProjectTexts::tr("Label “%1”").arg(name), name, QStringLiteral("labels"),
        [&](SequenceEntry& entry) { entry.labels = std::move(labels); }, phase);
}

void setSequenceContacts(ProjectDocument& document, const QString& name, std::vector<ContactSpan> contacts,
                         EditPhase phase)
{
    editEntry<SequenceEntry>(
        document, ProjectTexts::tr("Mark foot contacts of “%1”").arg(name), name, QStringLiteral("contacts"),
        [&](SequenceEntry& entry) { entry.contacts = std::move(contacts); }, phase);
}

void setJointAngles(ProjectDocument& document, const QString& name, const std::string& bvh)
{
    editEntry<SequenceEntry>(
        document, ProjectTexts::tr("Change the reference joint angles of “%1”").arg(name), name,
        QStringLiteral("jointAngles"), [&](SequenceEntry& entry) { entry.jointAngles = bvh; });
}

void setCharacterNotes(ProjectDocument& document, const QString& name, const QString& notes)
{
    editEntry<CharacterEntry>(document, ProjectTexts::tr("Edit the notes of “%1”").arg(name), name,
                              QStringLiteral("notes"),
                              [&](CharacterEntry& entry) { entry.notes = notes.toStdString(); });
}

void setCharacterTexture(ProjectDocument& document, const QString& name, const TextureReference& texture)
{
    editEntry<CharacterEntry>(document, ProjectTexts::tr("Change the texture of “%1”").arg(name), name,
                              QStringLiteral("texture"),
                              [&](CharacterEntry& entry) { entry.texture = texture; });
}

void setCharacterMesh(ProjectDocument& document, const QString& name, const std::string& mesh)
{
    editEntry<CharacterEntry>(document, ProjectTexts::tr("Change the mesh of “%1”").arg(name), name,
                              QStringLiteral("mesh"), [&](CharacterEntry& entry) { entry.mesh = mesh; });
}

void setSettings(ProjectDocument& document, const ProjectSettings& settings, EditPhase phase)
{
    const QString text = ProjectTexts::tr("Change the project settings");
    std::vector<BrokenEntry> broken = brokenEntries(document.project());
    const auto count =
        std::erase_if(broken, [](const BrokenEntry& entry) { return entry.section == "settings"; });
    if (count == 0) {
        document.push(std::make_unique<ChangeEntry<ProjectSettings>>(document, text, QString(), QString(),
                                                                     settings, phase));
        return;
    }
    // They take the place of those that cannot be read.
    Project after = document.project();
    after.settings = settings;
    setBrokenEntries(after, broken);
    document.push(std::make_unique<ChangeProject>(document, text, std::move(after)));
}

QString addExport(ProjectDocument& document, ExportEntry entry)
{
    return addEntry(document, ProjectTexts::tr("Add export “%1”"), std::move(entry));
}

void setExport(ProjectDocument& document, const QString& name, const ExportEntry& entry)
{
    editEntry<ExportEntry>(document, ProjectTexts::tr("Change export “%1”").arg(name), name,
                           QStringLiteral("export"), [&](ExportEntry& changed) { changed = entry; });
}

QString addEvaluation(ProjectDocument& document, EvaluationEntry entry)
{
    const QString name = evaluationName(entry);
    Project after = document.project();
    after.evaluations.push_back(std::move(entry));
    auto command = std::make_unique<ChangeProject>(
        document, ProjectTexts::tr("Add evaluation “%1”").arg(evaluationTitle(name)), std::move(after));
    return wasTaken(document, std::move(command)) ? name : QString();
}

void relinkMedia(ProjectDocument& document, const std::vector<std::pair<std::string, std::string>>& newPaths)
{
    Project after = document.project();
    forEachPath(after, [&](const StoredPath& stored) {
        const auto found =
            std::ranges::find(newPaths, stored.path, &std::pair<std::string, std::string>::first);
        if (found != newPaths.end() && !stored.isOutput)
            stored.path = found->second;
    });
    document.push(
        std::make_unique<ChangeProject>(document, ProjectTexts::tr("Relink media"), std::move(after)));
}

} // namespace quadrille
