// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/objectreader.h"

namespace quadrille {

/// An entry of the section “animations”. Points of paths come out in the project's axes.
AnimationEntry readAnimation(const ObjectReader& reader, UpAxis up);
Json animationToJson(const AnimationEntry& animation, UpAxis up);
/// All that its frames depend on as one line of text, for the key of a result: no sound, no camera and no
/// notes.
std::string animationSettings(const AnimationEntry& animation, UpAxis up);

/// What is heard with an animation, and a key of its camera.
AudioEntry readAudio(const ObjectReader& reader);
CameraKeyEntry readCameraKey(const ObjectReader& reader);

} // namespace quadrille
