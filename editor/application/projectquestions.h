// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QDateTime;
class QWidget;

namespace quadrille::questions {

// What is asked before a project is opened, saved or left. Each waits for its answer.

enum class Locked
{
    OpenCopy,
    ReadOnly,
    TakeOver,
    Cancel,
};
/// A project that is open elsewhere. \param holder in words. \param title  of the project; so for those
/// below.
Locked askLocked(QWidget* window, const QString& title, const QString& holder);

enum class Unwritable
{
    SaveAs,
    TakeOver,
    Cancel,
};
/// A project that may not be saved. \param canTakeOver offers that, too.
Unwritable askUnwritable(QWidget* window, const QString& sentence, bool canTakeOver);

enum class Changed
{
    SaveAs,
    Overwrite,
    Reload,
    Cancel,
};
/// A file that somebody else wrote since it was opened.
Changed askChanged(QWidget* window, const QString& title);

/// Whether unsaved edits may go for what is in the file.
bool mayReload(QWidget* window, const QString& title);

/// Whether the copy from before the last save shall be opened in the place of a file that cannot be read.
/// \param problem why, a sentence.
bool mayOpenBackup(QWidget* window, const QString& title, const QString& problem, const QDateTime& saved);

} // namespace quadrille::questions
