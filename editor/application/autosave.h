// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

namespace quadrille {

/// Keeps a copy of what is not saved, for the case that the program does not end well: written some seconds
/// after an edit, beside the interface and beside all jobs.
class Autosave : public QObject
{
    Q_OBJECT

public:
    /// \param document  outlives it.
    explicit Autosave(ProjectDocument& document, QObject* parent = nullptr);
    /// Ends well: takes the copy away. Waits until that is done.
    ~Autosave() override;

    /// \param seconds that an edit is without a copy at most; 0 for no copies.
    void setDelay(int seconds);
    /// Copies now if there are unsaved edits since the last copy. Takes the project's value at once and
    /// writes it on a thread of its own.
    void copyNow();

    /// Takes a recovered copy over: it goes once this program has one of its own, or nothing is unsaved.
    /// \param recovery  its id.
    void adopt(const QString& recovery);

signals:
    /// A copy could not be written.
    void failed(const quadrille::Error& error);

private:
    void follow();
    void write(const Project& project, const QString& file, const QString& adopted);
    void removeCopy();

    ProjectDocument& m_document;
    QString m_id;
    QString m_adopted; ///< id of the recovered copy; empty without one
    QLockFile m_lock;
    QTimer m_timer;
    int m_delay = 0; ///< milliseconds
    bool m_isDirty = false;
    bool m_hasCopy = false;
    QThreadPool m_writer; ///< one thread, so that one thing is done after the other
};

} // namespace quadrille
