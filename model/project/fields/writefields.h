// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/json/jsontext.h"
#include "model/render/rendersettings.h"

namespace quadrille {

// Objects of the file with their keys in their fixed order, unknown keys after the known ones. Values that
// equal their default are left out, except those that a reader of the file looks for.

Json writeFields(const Project& project);
Json writeFields(const BodyPartsEntry& parts);
Json writeFields(const VariationEntry& variation);
Json writeFields(const AppearanceEntry& appearance);
Json writeFields(const MotionSpaceEntry& space);
Json writeFields(const LiveEntry& live);
Json writeFields(const TransferEntry& transfer);
Json writeFields(const ProjectionEntry& projection);
Json writeFields(const AnimationEntry& animation, UpAxis up);
/// All that the frames of an animation depend on as one line of text, for the key of a result: no sound, no
/// camera and no notes.
std::string animationSettings(const AnimationEntry& animation, UpAxis up);
/// The members of a “picture”.
Json writeFields(const RenderSettings& settings);

} // namespace quadrille
