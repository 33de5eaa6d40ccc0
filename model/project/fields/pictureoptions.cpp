// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/pictureoptions.h"

#include "model/project/fields/readfields.h"
#include "model/project/fields/writefields.h"
#include "model/project/json/jsontext.h"

namespace quadrille {

RenderSettings pictureFromJson(const UnknownKeys& json, const std::string& pointer, ProjectProblems& problems)
{
    RenderSettings settings;
    if (json.isNone())
        return settings;
    readFields({json.json(), pointer, problems}, settings);
    if (!settings.view)
        return settings;
    if (const double distance = (settings.view->eye - settings.view->target).norm(); distance > 0) {
        settings.view->nearDistance = distance / 100;
        settings.view->farDistance = distance * 1000;
    }
    return settings;
}

UnknownKeys pictureToJson(const RenderSettings& settings)
{
    return UnknownKeys(writeFields(settings));
}

} // namespace quadrille
