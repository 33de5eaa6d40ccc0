// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QObject>
#include <QPointer>

class QActionGroup;

namespace quadrille {

class SceneView;
class TimelineActions;
struct EditorContext;

/// The actions of the menus View and Playback. They act on the view of the workspace in front; what can be on
/// or off is so in all of them.
class ViewActions : public QObject
{
    Q_OBJECT

public:
    explicit ViewActions(EditorContext& context, QObject* parent = nullptr);

    /// The view that the actions act on from now on; it takes their states. Null: none.
    void setView(SceneView* view);
    SceneView* view() const { return m_view; }

private:
    void makePlaybackActions();
    void makeShadingActions();
    void makeToggles();
    void makeCameraActions();
    void makeComparingActions();
    void makeGhostActions();
    void followPins();
    bool isOn(const char* id) const;
    void apply();
    void applyComparing();
    void applyShading();
    void followColors();

    EditorContext& m_context;
    QPointer<SceneView> m_view;
    QActionGroup* m_shading = nullptr;
    QPointer<QAction> m_shadingBefore; ///< a tool coloured the view
    TimelineActions* m_timeline;
};

} // namespace quadrille
