// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <vector>

namespace quadrille {

/// Edits that were never saved, kept from a run of the program that did not end well.
struct Recovery
{
    QString id;
    QString projectFile; ///< empty when the project was never saved
    QDateTime saved;
    Project project; ///< with absolute paths

    QString title() const;
    /// Characters, sequences, animations, … that it holds. What cannot be read counts, too.
    int entryCount() const;
};

struct Recoveries
{
    std::vector<Recovery> works; ///< newest first
    /// Where copies lie that could not be read; they were moved there.
    QStringList unreadable;
};

/// All copies that no running program holds. Reads each of them; blocks.
Recoveries findRecoveries();
/// Deletes a copy for good. Nothing happens for an empty id, or one that there is not. From any thread.
void discardRecovery(const QString& id);

/// For who keeps copies: writes one. Copies keep absolute paths: they lie in another folder than the project.
/// From any thread.
/// \throws Error as saveProject.
void writeRecovery(const Project& project, const QString& id, const QString& projectFile);
/// The file whose lock says that a copy belongs to a running program.
QString recoveryLockFile(const QString& id);

} // namespace quadrille
