// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace quadrille {

struct EditorContext;

/// Lets sequences and the project's exports go out.
class ExportFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ExportFlow(EditorContext& context, QWidget* window);

    /// Asks how some sequences shall go out.
    void exportSequences(const QStringList& names);
    /// Shows an export of the project, to be changed and written again.
    void editExport(const QString& name);

signals:
    void exported(const QStringList& files);

private:
    void exportSelection();
    void updateAction();

    EditorContext& m_context;
    QWidget* m_window;
    QString m_format = QStringLiteral("gltf"); ///< that was chosen last
    QString m_folder;
};

} // namespace quadrille
