// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/file/projectlock.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <filesystem>
#include <memory>

namespace quadrille {

/// Watches over the file of the open project: keeps its lock, and notices that somebody takes the project
/// over or writes its file. Looks every few seconds, beside the interface: folders on a network may be slow.
class ProjectGuard : public QObject
{
    Q_OBJECT

public:
    enum class Access
    {
        Full,
        ReadOnly,    ///< as the user wants it
        NotWritable, ///< its folder may not be written
        TakenOver,   ///< somebody else works on it now
    };

    explicit ProjectGuard(QObject* parent = nullptr);
    /// Waits for the look under way.
    ~ProjectGuard() override;

    /// Takes the lock of a file, if nobody has it, for watch(). Who has it otherwise is told by its state and
    /// holder. May wait for the folder.
    static std::shared_ptr<ProjectLock> lockOf(const std::filesystem::path& file);
    /// Begins to watch a file with the content that it has now. Reads the file once, for its hash.
    /// \param lock of the file; foreign only when it shall be read only.
    void watch(const std::filesystem::path& file, std::shared_ptr<ProjectLock> lock);
    /// Gives the lock back and watches nothing.
    void release();
    const std::filesystem::path& file() const { return m_file; }
    /// The lock of the watched file; null without one.
    const std::shared_ptr<ProjectLock>& lock() const { return m_lock; }

    Access access() const { return m_access; }
    /// Who has the project instead; in words.
    QString holder() const { return m_holder; }
    /// Looks at the lock at once. May wait for the folder. `accessChanged` is told where something is
    /// another.
    void lookNow();
    /// Takes the lock from whoever has it. May wait for the folder.
    void takeOver();
    /// Whether the file has another content than the program knows, at once; not where it is gone. Reads the
    /// file where its stamp is another; may wait for the folder.
    bool isChanged();
    /// What is in the file now is known: it was just written or read. Reads the file; may wait for the
    /// folder.
    void noteContent();
    /// Milliseconds between two looks.
    void setInterval(int milliseconds) { m_timer.setInterval(milliseconds); }

signals:
    /// Access or holder is another.
    void accessChanged();
    /// Somebody else wrote the file, and is done with it. Once for each content.
    void changed();

private:
    struct Shared;
    struct Seen;
    void poll();
    void take(const Seen& seen);
    void setAccess(ProjectLock::State state, const QString& holder);

    std::filesystem::path m_file;
    std::shared_ptr<ProjectLock> m_lock;
    std::shared_ptr<Shared> m_shared;
    Access m_access = Access::Full;
    bool m_wantsReadOnly = false;
    QString m_holder;
    QTimer m_timer;
    bool m_isLooking = false;
    QThreadPool m_looker;
};

/// A holder in words: "ada on studio, since 12:31".
QString describe(const LockHolder& holder);

} // namespace quadrille
