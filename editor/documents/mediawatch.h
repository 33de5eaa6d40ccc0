// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"
#include "model/core/filestamp.h"

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <map>
#include <set>
#include <string>

namespace quadrille {

/// Notices that files of the open project's media were written since they were opened: takes, meshes,
/// textures, sounds. Looks at their stamps every few seconds, beside the interface, which serves folders on a
/// network as well; a file is told of when it has stopped changing.
class MediaWatch : public QObject
{
    Q_OBJECT

public:
    explicit MediaWatch(ProjectDocument& document, QObject* parent = nullptr);
    /// Waits for the look under way.
    ~MediaWatch() override;

    /// Files that were written since they were opened. They are forgotten when another project is opened or
    /// this one is read again, not when a file gets its old content back.
    QStringList changedFiles() const;
    /// Whether the files of all entries of the project were looked at: what is written from now on is told.
    bool isWatching() const;
    /// Milliseconds between two looks; they are rarer where looking takes long.
    void setInterval(int milliseconds);

signals:
    /// Other files are among those that were written, or none is any more.
    void changed();

private:
    using Stamps = std::map<std::string, FileStamp>; ///< by path; only of files that are there

    void follow(const ChangeEvent& event);
    void look();
    void take(const Stamps& now, qint64 milliseconds);

    ProjectDocument& m_document;
    QTimer m_timer;
    int m_interval;
    int m_generation = 0; ///< of the project's entries; what a look at former ones saw is not taken
    bool m_isWatching = false;
    bool m_isLooking = false;
    Stamps m_known;                  ///< as they were opened
    Stamps m_last;                   ///< as they were seen last
    std::set<std::string> m_found;   ///< that are not as they were opened
    std::set<std::string> m_changed; ///< of these, those that were told
    QThreadPool m_looker;
};

} // namespace quadrille
