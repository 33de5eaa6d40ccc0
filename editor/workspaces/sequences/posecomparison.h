// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/shading.h"

#include <QObject>

class QAction;

namespace quadrille {

class PoseHeatMap;
class ClipScene;
struct EditorContext;

namespace widgets {
class Viewport;
}

/// The way of shading that colours two compared sequences by the distance of their poses: its action, and
/// what to say where it cannot be shown. It ends with the comparison.
class PoseComparison : public QObject
{
    Q_OBJECT

public:
    /// \pre The action "view.heatMap" is registered, as one of the ways of shading.
    PoseComparison(EditorContext& context, widgets::Viewport& viewport, ClipScene& scene,
                   QObject* parent = nullptr);

    const PoseHeatMap& heatMap() const { return *m_heatMap; }
    /// Why there are no colours, in a sentence; empty while there is nothing to say.
    QString problem() const;
    /// What helps with the problem; it means nothing without one.
    QString remedy() const;

signals:
    void changed();

private:
    void setOn(bool on);
    void goBack();

    EditorContext& m_context;
    widgets::Viewport& m_viewport;
    ClipScene& m_scene;
    PoseHeatMap* m_heatMap;
    QAction* m_action = nullptr;
    bool m_isNew = false;                                   ///< switched on by the trigger that is under way
    widgets::Shading m_before = widgets::Shading::Textured; ///< that it took the place of
};

} // namespace quadrille
