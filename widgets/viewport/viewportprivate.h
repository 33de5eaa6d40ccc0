// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/viewgestures.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewportoverlay.h"
#include "widgets/viewport/viewportscene.h"
#include "widgets/viewport/viewtool.h"

#include <QPointer>

class QLabel;

namespace quadrille::widgets {

class AxesGizmo;

struct Viewport::Private
{
    ViewportScene scene;
    VtkView* view = nullptr;
    QLabel* excuse = nullptr;
    QWidget* surface = nullptr; ///< the view, or the label in its place
    ViewportOverlay* overlay = nullptr;
    AxesGizmo* axes = nullptr;
    ViewGestures* gestures = nullptr;
    int nextId = 1;
    std::vector<int> order; ///< of figures in lanes; those that are not in it come last
    int anchor = -1;        ///< the figure that stays in place where several stand side by side
    Layout layout = Layout::Overlay;
    Tool tool = Tool::Navigate;
    QPointer<ViewTool> viewTool;
    float groundHeight = 0.0F;
    bool namesVisible = false;
    QString notice;
    bool hovering = false;
    bool frameWhenShown = false; ///< framing was asked for before the size was known
    std::optional<int> followed;
    QVector3D followedCentroid;
    std::vector<QVector3D> measured;

    SceneFigure* find(int id);
    std::optional<std::pair<QVector3D, QVector3D>> bounds(std::optional<int> only) const;
    Annotations annotations() const;
    std::vector<SceneFigure*> lanes();
};

} // namespace quadrille::widgets
