// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectdocument.h"

#include "editor/documents/editcheck.h"
#include "editor/documents/evaluationnames.h"
#include "editor/documents/projectcommand.h"
#include "editor/documents/projectpaths.h"
#include "model/core/file.h"
#include "model/project/document/findentry.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/usableproject.h"
#include "model/project/results/projectresults.h"

#include <algorithm>

namespace quadrille {

namespace {

const ProjectCommand* commandAt(const QUndoStack& stack, int index)
{
    return static_cast<const ProjectCommand*>(stack.command(index));
}

} // namespace

ProjectDocument::ProjectDocument(QObject* parent)
    : QObject(parent), m_session(std::make_shared<ResultSession>())
{
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, [this] { emit changed(ChangeEvent::file()); });
}

ProjectDocument::~ProjectDocument()
{
    // The history says that it is clean when it goes; nobody may be told by then.
    m_undoStack.disconnect(this);
}

const SequenceEntry* ProjectDocument::sequence(const QString& name) const
{
    return findEntry<SequenceEntry>(m_project, name);
}

const CharacterEntry* ProjectDocument::character(const QString& name) const
{
    return findEntry<CharacterEntry>(m_project, name);
}

const AnimationEntry* ProjectDocument::animation(const QString& name) const
{
    return findEntry<AnimationEntry>(m_project, name);
}

const VariationEntry* ProjectDocument::variation(const QString& name) const
{
    return findEntry<VariationEntry>(m_project, name);
}

const ExportEntry* ProjectDocument::exportEntry(const QString& name) const
{
    return findEntry<ExportEntry>(m_project, name);
}

const EvaluationEntry* ProjectDocument::evaluation(const QString& name) const
{
    const auto found = std::ranges::find(m_project.evaluations, name, evaluationName);
    return found == m_project.evaluations.end() ? nullptr : &*found;
}

const CharacterEntry* ProjectDocument::characterOf(const SequenceEntry& sequence) const
{
    if (sequence.character.empty() && m_project.characters.size() == 1)
        return &m_project.characters.front();
    return character(QString::fromStdString(sequence.character));
}

std::filesystem::path ProjectDocument::untitledFile() const
{
    return toPath(m_untitledFolder.filePath(QStringLiteral("untitled.quadrille")));
}

std::filesystem::path ProjectDocument::workingFile() const
{
    return isUntitled() ? untitledFile() : m_file;
}

Project ProjectDocument::snapshot() const
{
    return withRelativePaths(m_project, workingFile().parent_path());
}

QString ProjectDocument::title() const
{
    return isUntitled() ? tr("Untitled") : toQString(m_file.stem());
}

bool ProjectDocument::canUndo() const
{
    const int index = m_undoStack.index();
    return index > 0 && !commandAt(m_undoStack, index - 1)->isExpired();
}

void ProjectDocument::undo()
{
    if (canUndo())
        m_undoStack.undo();
}

void ProjectDocument::redo()
{
    m_undoStack.redo();
}

void ProjectDocument::push(std::unique_ptr<ProjectCommand> command)
{
    const int index = m_undoStack.index();
    const auto* last = index > 0 ? commandAt(m_undoStack, index - 1) : nullptr;
    const bool endsDrag = last != nullptr && last->isOpen();
    if (command->changesNothing() && !endsDrag)
        return;
    // Tried on the quiet first: what the file could not hold is not taken.
    const auto tried = [&] {
        const QSignalBlocker quiet(this);
        command->redo();
        Project result = m_project;
        command->undo();
        return result;
    };
    if (const auto refusal = refusalOf(m_project, tried())) {
        EditRefusals::of(*this).refuse(*refusal);
        return;
    }
    m_undoStack.push(command.release());
    expireOldCommands();
}

void ProjectDocument::setHistoryBytes(std::size_t bytes)
{
    m_historyBytes = bytes;
    expireOldCommands();
}

void ProjectDocument::expireOldCommands()
{
    std::size_t bytes = 0;
    for (int i = m_undoStack.count() - 1; i >= 0; --i) {
        bytes += commandAt(m_undoStack, i)->bytes();
        // A command that can still be redone is needed whole.
        if (bytes > m_historyBytes && i < m_undoStack.index() - 1)
            const_cast<ProjectCommand*>(commandAt(m_undoStack, i))->expire();
    }
}

void ProjectDocument::reset(Project project, bool recovered)
{
    show(std::move(project), {}, recovered);
}

void ProjectDocument::load(const std::filesystem::path& file)
{
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    ProjectReading reading = readUsableProject(readFile(absolute).text(), absolute);
    show(withAbsolutePaths(std::move(reading.project), absolute.parent_path()), absolute, false);
}

void ProjectDocument::recover(Project project, const std::filesystem::path& file)
{
    show(std::move(project), file, true);
}

void ProjectDocument::save()
{
    saveProject(withRelativePaths(m_project, m_file.parent_path()), m_file);
    m_recovered = false;
    m_undoStack.setClean();
    emit changed(ChangeEvent::file());
}

void ProjectDocument::saveAs(const std::filesystem::path& file)
{
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    saveProject(withRelativePaths(m_project, absolute.parent_path()), absolute);
    m_file = absolute;
    m_recovered = false;
    m_undoStack.setClean();
    emit changed(ChangeEvent::file());
}

void ProjectDocument::apply(const std::function<void(Project&)>& edit, const std::vector<ChangeEvent>& events)
{
    edit(m_project);
    for (const ChangeEvent& event : events) {
        if (event.kind == ChangeEvent::Kind::Renamed)
            emit renamed(event);
    }
    for (const ChangeEvent& event : events)
        emit changed(event);
}

WorkingProject ProjectDocument::working() const
{
    return {snapshot(), workingFile(), m_session};
}

void ProjectDocument::show(Project project, std::filesystem::path file, bool recovered)
{
    m_undoStack.clear();
    m_session = std::make_shared<ResultSession>();
    m_project = std::move(project);
    m_file = std::move(file);
    m_recovered = recovered;
    emit changed(ChangeEvent::reset());
    emit changed(ChangeEvent::file());
}

} // namespace quadrille

#include "moc_projectdocument.cpp"
