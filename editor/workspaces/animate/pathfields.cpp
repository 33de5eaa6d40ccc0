// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathfields.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/document/groundpoint.h"
#include "model/project/document/lengthunit.h"
#include "widgets/viewport/ruler.h"

#include <QDoubleSpinBox>
#include <QLocale>
#include <QSignalBlocker>
#include <cmath>

namespace quadrille {

namespace {

constexpr auto inMetres = "inMetres"; ///< what a field was made with: lowest value, decimals and step

} // namespace

QDoubleSpinBox* numberField(double lowest, int decimals, double step)
{
    auto* field = new QDoubleSpinBox;
    constexpr double highest = 10'000;
    field->setRange(lowest, highest);
    field->setDecimals(decimals);
    field->setSingleStep(step);
    field->setKeyboardTracking(false);
    field->setProperty(inMetres, QVariantList{lowest, decimals, step});
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

QString lengthText(const PathTool& tool, double length)
{
    const int decimals = widgets::Ruler(settingsOf(tool).axes.metresPerUnit).decimals(2);
    return QLocale().toString(length, 'f', decimals);
}

void setUnit(const PathTool& tool, std::initializer_list<QDoubleSpinBox*> fields)
{
    const widgets::Ruler ruler(settingsOf(tool).axes.metresPerUnit);
    const double farthest = farthestPlace(ruler.metresPerUnit());
    for (QDoubleSpinBox* field : fields) {
        const QSignalBlocker quiet(field);
        const QVariantList usual = field->property(inMetres).toList();
        const double lowest = usual[0].toDouble();
        field->setDecimals(ruler.decimals(usual[1].toInt()));
        field->setRange(lowest < 0 ? -farthest : lowest / ruler.decade(), farthest);
        field->setSingleStep(usual[2].toDouble() / ruler.decade());
        field->setSuffix(QLatin1Char(' ') + unitOf(tool));
    }
}

} // namespace quadrille
