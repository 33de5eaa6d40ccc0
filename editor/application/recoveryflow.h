// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QWidget;

namespace quadrille {

class Autosave;
class ProjectFiles;
struct EditorContext;
struct Recovery;

/// Offers edits that a crash left unsaved.
class RecoveryFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    RecoveryFlow(EditorContext& context, Autosave& autosave, ProjectFiles& files, QWidget* window);

    /// Asks what to do with the newest copy, if there is one; nothing is lost while it is not answered.
    void offer();
    /// Opens a copy, after asking whether to save what is open.
    void recover(const Recovery& recovery);

signals:
    /// Something about copies that the user should know.
    void told(const QString& message);
    /// A copy was opened, or the question about it was answered.
    void answered();

private:
    EditorContext& m_context;
    Autosave& m_autosave;
    ProjectFiles& m_files;
    QWidget* m_window;
};

} // namespace quadrille
