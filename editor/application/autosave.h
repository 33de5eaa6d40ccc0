// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

namespace quadrille {

class JobRunner;

/// Edits that were never saved, kept from a run of the program that did not end well.
struct Recovery
{
    QString id;
    QString projectFile; ///< empty when the project was untitled
    QDateTime saved;
    Project project;

    QString title() const;
};

/// Keeps a copy of what is not saved, and finds the copies that a crash left behind.
class Autosave : public QObject
{
    Q_OBJECT

public:
    Autosave(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    /// Ends well: takes the copy away.
    ~Autosave() override;

    /// \param seconds between two copies; 0 for none.
    void setInterval(int seconds);
    /// Copies now if there are unsaved edits since the last copy.
    void copyNow();

    /// Takes a recovered copy over: it goes once this program has one of its own, or nothing is unsaved.
    void adopt(const Recovery& recovery);

    /// The newest copy that no running program holds.
    static std::optional<Recovery> findRecovery();
    static void discard(const Recovery& recovery);

private:
    void follow(const ChangeEvent& event);
    void removeCopy();

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    QString m_id;
    QString m_adopted; ///< id of the recovered copy; empty without one
    std::unique_ptr<QLockFile> m_lock;
    QTimer m_timer;
    quint64 m_revision = 0; ///< counts edits, so that a copy that comes too late is taken away again
    bool m_isDirty = false;
};

} // namespace quadrille
