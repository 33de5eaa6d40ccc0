// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/view/sceneview.h"
#include "model/project/document/animationentry.h"

#include <QJsonObject>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

/// A property of docks: whether one is hidden because the window is low, until there is something in it.
inline constexpr auto waitsForNeed = "waitsForNeed";

/// One of the window's workspaces: a page with a view in its centre, and docks of its own around it.
class Workspace : public QWidget
{
    Q_OBJECT

public:
    /// A panel that only this workspace has; the window gives it a place and a title.
    struct Panel
    {
        const char* name; ///< object name of the dock
        std::function<QString()> title;
        QWidget* content;
        Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
        bool isShown = true;  ///< the first time
        bool isLower = false; ///< below those of its area, instead of with them
    };

    using QWidget::QWidget;

    /// What the actions of the menus View and Playback act on. The same for as long as it lives.
    virtual SceneView& view() = 0;
    /// Asked for once, when the window is made.
    virtual std::vector<Panel> panels() { return {}; }
    /// The captured frame that is shown now, or that is nearest to what is shown; none without any.
    virtual std::optional<NamedFrame> shownPose() { return std::nullopt; }
    /// The clip that it works on, "SECTION/NAME", which goes out where takes are selected; empty where it
    /// shows takes.
    virtual QString shownClip() const { return {}; }
    /// What of it comes back with a project, for its session; nothing where all of it is told by what is
    /// selected. Of the project that is open.
    virtual QJsonObject look() const { return {}; }
    /// Shows it so again. \param look  as `look` gave it, maybe of an older version of the project.
    virtual void setLook(const QJsonObject& /*look*/) {}
    /// Brings a panel to the front of those that share its place. Shows its dock where it is hidden. \param
    /// content as in Panel.
    static void showPanel(QWidget* content);
    /// The workspace comes to the front, or goes.
    virtual void setActive(bool /*active*/) {}

    ClipScene& scene() { return view().scene(); }
    Player& player() { return view().player(); }
    widgets::Viewport& viewport() { return view().viewport(); }
};

} // namespace quadrille
