// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/problem.h"
#include "model/project/document/unknownkeys.h"
#include "model/render/rendersettings.h"

namespace quadrille {

/// Settings for an export of pictures or video from its "picture" object; what is not named is at its
/// default. \param json {"width", "height", "shading", "background", "grid", "camera", "revolutions", "view":
/// {"eye", "target", "up", "fov"}}; none for all defaults. \param pointer of the object, for problems: values
/// of a wrong type, misspelt keys as warnings.
RenderSettings pictureFromJson(const UnknownKeys& json, const std::string& pointer,
                               ProjectProblems& problems);

/// The object that pictureFromJson reads.
UnknownKeys pictureToJson(const RenderSettings& settings);

} // namespace quadrille
