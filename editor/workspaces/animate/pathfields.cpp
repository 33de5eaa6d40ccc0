// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathfields.h"

#include "editor/application/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/lengthunit.h"
#include "model/project/validateamounts.h"

#include <QDoubleSpinBox>
#include <QSignalBlocker>
#include <cmath>

namespace quadrille {

QDoubleSpinBox* numberField(double lowest, int decimals, double step)
{
    auto* field = new QDoubleSpinBox;
    constexpr double highest = 10'000;
    field->setRange(lowest, highest);
    field->setDecimals(decimals);
    field->setSingleStep(step);
    field->setKeyboardTracking(false);
    return field;
}

void setValue(QDoubleSpinBox* field, double value)
{
    const QSignalBlocker quiet(field);
    field->setValue(value);
}

double valueOf(const QDoubleSpinBox* field, double exact)
{
    const double halfStep = 0.5 * std::pow(10.0, -field->decimals());
    return std::abs(field->value() - exact) <= halfStep * (1 + 1e-9) ? exact : field->value();
}

const ProjectSettings& settingsOf(const PathTool& tool)
{
    return tool.animation().context().document.project().settings;
}

QString unitOf(const PathTool& tool)
{
    return QString::fromStdString(unitText(settingsOf(tool).axes.metresPerUnit));
}

void setUnit(const PathTool& tool, std::initializer_list<QDoubleSpinBox*> fields)
{
    const double farthest = farthestPlace(settingsOf(tool).axes.metresPerUnit);
    for (QDoubleSpinBox* field : fields) {
        field->setRange(field->minimum() < 0 ? -farthest : field->minimum(), farthest);
        field->setSuffix(QLatin1Char(' ') + unitOf(tool));
    }
}

} // namespace quadrille
