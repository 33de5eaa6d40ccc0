// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace quadrille {

class Error;
struct EditorContext;

/// Brings sequences in: asks for files or folders, looks at what they hold, and lets the user decide in the
/// import preview.
class ImportFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ImportFlow(EditorContext& context, QWidget* window);

    /// Shows the import preview for files and folders. Looks for them in a job; the preview comes when it is
    /// done. \pre There is a path.
    void preview(const QStringList& paths);
    /// Brings files and folders in without asking, as the command line does. It is done in a job. Issues of
    /// takes go to the log; those that cannot be opened are told by `failed`, the others are imported.
    void open(const QStringList& paths);

signals:
    /// \param names  that the sequences got.
    void imported(const QStringList& names);
    void failed(const quadrille::Error& error);

private:
    void askFiles();
    void askFolder();

    EditorContext& m_context;
    QWidget* m_window;
    QString m_folder; ///< where files were chosen last
};

} // namespace quadrille
