// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathfields.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/numberfield.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/document/lengthunit.h"
#include "widgets/viewport/ruler.h"

#include <QLocale>

namespace quadrille {

NumberLook lengthLook(const PathTool& tool, const char* path, double lowest, double step, int decimals)
{
    return {.path = path, .step = step, .decimals = decimals, .lowest = lowest, .metresPerUnit = [&tool] {
                return settingsOf(tool).axes.metresPerUnit;
            }};
}

const ProjectSettings& settingsOf(const PathTool& tool)
{
    return tool.animation().context().document.project().settings;
}

QString unitOf(const PathTool& tool)
{
    return QString::fromStdString(unitText(settingsOf(tool).axes.metresPerUnit));
}

QString lengthText(const PathTool& tool, double length)
{
    const int decimals = widgets::Ruler(settingsOf(tool).axes.metresPerUnit).decimals(2);
    return QLocale().toString(length, 'f', decimals);
}

} // namespace quadrille
