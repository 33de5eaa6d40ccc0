// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace quadrille {

struct EditorContext;

/// Lets sequences, animations, variations and the project's exports go out.
class ExportFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ExportFlow(EditorContext& context, QWidget* window);

    /// Asks how some clips shall go out, each "sequences/NAME" or "animations/NAME", or "variations/NAME".
    void exportClips(const QStringList& clips);
    /// Shows an export of the project, to be changed and written again.
    void editExport(const QString& name);

signals:
    void exported(const QStringList& files);

private:
    void exportSelection();
    /// What is selected, else what is shown.
    QStringList selectedClips() const;
    void updateAction();

    EditorContext& m_context;
    QWidget* m_window;
    QString m_format = QStringLiteral("gltf"); ///< that was chosen last
    QString m_folder;
};

} // namespace quadrille
