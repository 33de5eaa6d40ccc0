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
    /// Null when there is no such entry. Good until the next edit; so for all that follow.
    const SequenceEntry* sequence(const QString& name) const;
    const CharacterEntry* character(const QString& name) const;
    const AnimationEntry* animation(const QString& name) const;
    const VariationEntry* variation(const QString& name) const;
    const ExportEntry* exportEntry(const QString& name) const;
    /// \param name  see evaluationName().
    const EvaluationEntry* evaluation(const QString& name) const;
    /// The character of a sequence: the one it names, or the only one. Null where it names one that is not
    /// there, or names none and there are several.
    const CharacterEntry* characterOf(const SequenceEntry& sequence) const;

    /// The project file; empty while it is untitled.
    const std::filesystem::path& file() const { return m_file; }
    bool isUntitled() const { return m_file.empty(); }
    /// What results lie beside while the document is untitled. It lies in a temporary folder, which goes with
    /// the document.
    std::filesystem::path untitledFile() const;
    /// The file that results lie beside: the project's, or one in a temporary folder while it is untitled.
    std::filesystem::path workingFile() const;
    /// The project as its file would hold it, beside workingFile(): for jobs that rebuild parts of it. A copy
    /// of all of it, with paths relative to that file's folder.
    Project snapshot() const;
    /// The snapshot with its file and what all values of this project share, for jobs that want results.
    WorkingProject working() const;
    /// Shared by all values of the open project.
    ResultSession& session() const { return *m_session; }
    /// The file's name without folder and ending, or "Untitled".
    QString title() const;
    /// Whether it was edited since it was opened or saved – edits that were taken back do not count –, or
    /// recovered and not saved since.
    bool isModified() const { return m_recovered || !m_undoStack.isClean(); }

    QUndoStack* undoStack() { return &m_undoStack; }
    /// False where the last command has given its memory back, too.
    bool canUndo() const;
    void undo();
    void redo();
    /// Runs a command and puts it on the undo stack; one that changes nothing is dropped. One whose project
    /// could not be read again from its file is dropped as well, and EditRefusals::of tells why. Cost: that
    /// of running the command and of refusalOf(), which goes through the whole project.
    void push(std::unique_ptr<ProjectCommand> command);
    /// Oldest commands beyond this many bytes can no longer be undone.
    void setHistoryBytes(std::size_t bytes);

    /// Shows a project value that has no file: a new one, or one recovered after a crash. The history is
    /// emptied and a new session of results begins; `changed` tells Reset, then File. So for `load` and
    /// `recover`.
    /// \param recovered it holds edits that were never saved. \param project  with absolute paths.
    void reset(Project project, bool recovered = false);
    /// Shows the project of a file. What cannot be read of it is kept aside, as readUsableProject does. Reads
    /// the file at once, on the interface thread.
    /// \throws Error as loadProject; the document stays as it was then.
    void load(const std::filesystem::path& file);
    /// Shows a value in the place of `file`, as recovered after a crash: modified from the start.
    void recover(Project project, const std::filesystem::path& file);
    /// Before users are asked whether edits are to be saved: what they are in the middle of, as a recording,
    /// becomes an edit now.
    void settle() { emit settling(); }
    /// Writes the project to its file.
    /// \throws Error as saveProject; the file on disk and the document stay as they were then. \pre It has
    /// one.
    void save();
    /// Writes the project to another file, which is its file from now on. Media keep their places. \throws
    /// Error as `save`.
    void saveAs(const std::filesystem::path& file);

signals:
    /// See settle().
    void settling();
    /// An entry has another name, before `changed` says so: whoever keeps something under a name keeps it
    /// under the new one from now on. Nothing is shown anew yet.
    void renamed(const quadrille::ChangeEvent& event);
    /// After every edit, undo and redo, for each of its events; the project is as it will be by then.
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
