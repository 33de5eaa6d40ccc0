// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"
#include "model/project/document/findentry.h"
#include "model/project/document/project.h"

#include <QObject>
#include <QTemporaryDir>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace quadrille {

class ResultSession;
struct WorkingProject;

class ProjectCommand;

/// The open project: its value, its file and the history of its edits. Every edit is a command; whoever shows
/// something listens to `changed`. Paths inside are absolute while the project is open.
class ProjectDocument : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t defaultHistoryBytes = std::size_t{64} << 20;

    explicit ProjectDocument(QObject* parent = nullptr);
    ~ProjectDocument() override;

    const Project& project() const { return m_project; }
    /// Null when there is no such entry.
    const SequenceEntry* sequence(const QString& name) const;
    const CharacterEntry* character(const QString& name) const;
    const AnimationEntry* animation(const QString& name) const;
    const VariationEntry* variation(const QString& name) const;
    const ExportEntry* exportEntry(const QString& name) const;
    /// \param name  see evaluationName().
    const EvaluationEntry* evaluation(const QString& name) const;
    /// The character of a sequence: the one it names, or the only one.
    const CharacterEntry* characterOf(const SequenceEntry& sequence) const;

    /// The project file; empty while it is untitled.
    const std::filesystem::path& file() const { return m_file; }
    bool isUntitled() const { return m_file.empty(); }
    /// What results lie beside while the document is untitled.
    std::filesystem::path untitledFile() const;
    /// The file that results lie beside: the project's, or one in a temporary folder while it is untitled.
    std::filesystem::path workingFile() const;
    /// The project as its file would hold it, beside workingFile(): for jobs that rebuild parts of it.
    Project snapshot() const;
    /// The snapshot with its file and what all values of this project share, for jobs that want results.
    WorkingProject working() const;
    /// Shared by all values of the open project.
    ResultSession& session() const { return *m_session; }
    /// The file's name without folder and ending, or "Untitled".
    QString title() const;
    bool isModified() const { return m_recovered || !m_undoStack.isClean(); }

    QUndoStack* undoStack() { return &m_undoStack; }
    bool canUndo() const;
    void undo();
    void redo();
    /// Runs a command and puts it on the undo stack; one that changes nothing is dropped.
    void push(std::unique_ptr<ProjectCommand> command);
    /// Oldest commands beyond this many bytes can no longer be undone.
    void setHistoryBytes(std::size_t bytes);

    /// Shows a project value that has no file: a new one, or one recovered after a crash.
    /// \param recovered it holds edits that were never saved.
    void reset(Project project, bool recovered = false);
    /// Shows the project of a file.
    /// \throws Error as loadProject; the document stays as it was then.
    void load(const std::filesystem::path& file);
    /// Shows a value in the place of `file`, as recovered after a crash: modified from the start.
    void recover(Project project, const std::filesystem::path& file);
    /// Writes the project to its file.
    /// \throws Error as saveProject; the file on disk and the document stay as they were then.
    void save();
    /// Writes the project to another file, which is its file from now on.
    void saveAs(const std::filesystem::path& file);

signals:
    /// An entry has another name, before `changed` says so: whoever keeps something under a name keeps it
    /// under the new one from now on. Nothing is shown anew yet.
    void renamed(const quadrille::ChangeEvent& event);
    void changed(const quadrille::ChangeEvent& event);

private:
    friend class ProjectCommand;
    /// For commands: edits the value, then tells.
    void apply(const std::function<void(Project&)>& edit, const std::vector<ChangeEvent>& events);
    void show(Project project, std::filesystem::path file, bool recovered);
    void expireOldCommands();

    Project m_project;
    std::filesystem::path m_file;
    std::shared_ptr<ResultSession> m_session; ///< of the project that is open
    QTemporaryDir m_untitledFolder;
    QUndoStack m_undoStack;
    std::size_t m_historyBytes = defaultHistoryBytes;
    bool m_recovered = false;
};

} // namespace quadrille
