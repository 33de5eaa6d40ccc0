// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/exporting/seencamera.h"

#include <QObject>
#include <QStringList>
#include <functional>

class QWidget;

namespace quadrille {

class SceneView;
struct EditorContext;

/// Lets sequences, animations, variations and the project's exports go out.
class ExportFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    /// \param view    the view in front, whose camera films begin with; null when there is none.
    /// \param shownClip  what the workspace in front works on, "SECTION/NAME"; empty where that is takes.
    ExportFlow(EditorContext& context, std::function<SceneView*()> view, std::function<QString()> shownClip,
               QWidget* window);

    /// Asks how some clips shall go out, each "sequences/NAME" or "animations/NAME", or "variations/NAME".
    /// \pre There is a clip.
    void exportClips(const QStringList& clips);
    /// Shows an export of the project, to be changed and written again.
    void editExport(const QString& name);

signals:
    void exported(const QStringList& files);

private:
    void exportSelection();
    /// The clip that is selected, else what the workspace works on, else takes that are selected or shown.
    QStringList selectedClips() const;
    void updateAction();

    /// What the view in front shows of a clip.
    std::optional<SeenCamera> seen(const QString& name, const MeshSequence& clip) const;

    EditorContext& m_context;
    std::function<SceneView*()> m_view;
    std::function<QString()> m_shownClip;
    QWidget* m_window;
    QString m_format = QStringLiteral("gltf"); ///< that was chosen last
    QString m_folder;
};

} // namespace quadrille
