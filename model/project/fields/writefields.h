// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/json/json.h"
#include "model/render/rendersettings.h"

namespace quadrille {

// Objects of the file with their keys in their fixed order, unknown keys after the known ones. Values that
// equal their default are left out, except those that a reader of the file looks for.

Json writeFields(const Project& project);
Json writeFields(const AnimationEntry& animation, UpAxis up);
/// The members of a “picture”.
Json writeFields(const RenderSettings& settings);

// Objects of the file as one line of text each, for the key of a result.

std::string settingsText(const BodyPartsEntry& parts);
std::string settingsText(const VariationEntry& variation);
std::string settingsText(const AppearanceEntry& appearance);
std::string settingsText(const MotionSpaceEntry& space);
std::string settingsText(const LiveEntry& live);
std::string settingsText(const TransferEntry& transfer);
std::string settingsText(const ProjectionEntry& projection);
/// All that the frames of an animation depend on: no sound, no camera and no notes.
std::string animationSettings(const AnimationEntry& animation, UpAxis up);

} // namespace quadrille
