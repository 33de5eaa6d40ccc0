// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvecontent.h"
#include "widgets/tools/showncurve.h"

#include <QKeySequence>
#include <QString>
#include <functional>

class QAction;

namespace quadrille {

class ActionRegistry;
class PartCurveTool;

/// The actions of curves and parts, and the menu of those that concern what is selected.
class PartCurveActions
{
public:
    /// Makes the actions. \param tool  does what they ask for; outlives them, as does `content`.
    PartCurveActions(PartCurveTool& tool, const PartCurveContent& content);

    /// Enables what can be done now.
    void refresh();
    /// \param part  what was clicked on in the view.
    void showMenu(const widgets::SurfaceCurvePart& part, const QPoint& globalPosition);

private:
    ActionRegistry& actions() const;
    QAction* add(const char* id, std::function<QString()> text, std::function<QString()> tip,
                 const char* icon, const QKeySequence& shortcut, std::function<void()> run);

    PartCurveTool& m_tool;
    const PartCurveContent& m_content;
};

} // namespace quadrille
