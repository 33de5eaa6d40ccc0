// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <QString>

namespace quadrille {

class PathTool;
struct NumberLook;

/// How a length or a coordinate of the path is shown, in the project's unit. \param path  in the schema, or
/// null. \param lowest, decimals, step  in metres. \param tool  outlives the look.
NumberLook lengthLook(const PathTool& tool, const char* path, double lowest, double step, int decimals = 2);
const ProjectSettings& settingsOf(const PathTool& tool);
/// The project's unit of length: "m".
QString unitOf(const PathTool& tool);
/// A length in the project's unit, without its name, as exact as two decimals of metres.
QString lengthText(const PathTool& tool, double length);

} // namespace quadrille
