// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <QString>
#include <initializer_list>

class QDoubleSpinBox;

namespace quadrille {

class PathTool;

/// A field for a number from `lowest` on; of lengths, what is usual in metres. The caller owns it.
QDoubleSpinBox* numberField(double lowest, int decimals, double step);
/// Without telling anybody.
void setValue(QDoubleSpinBox* field, double value);
/// What a field says, or the exact number where it still shows that one: the decimals that a field does not
/// show must not be lost because something beside it was edited.
double valueOf(const QDoubleSpinBox* field, double exact);
const ProjectSettings& settingsOf(const PathTool& tool);
/// The project's unit of length: "m".
QString unitOf(const PathTool& tool);
/// A length in the project's unit, without its name, as exact as two decimals of metres.
QString lengthText(const PathTool& tool, double length);
/// Writes the project's unit behind the numbers of fields, with steps and decimals that suit it, and lets
/// them reach as far as a path may; those that may be negative, to both sides. \pre They were made by
/// numberField().
void setUnit(const PathTool& tool, std::initializer_list<QDoubleSpinBox*> fields);

} // namespace quadrille
