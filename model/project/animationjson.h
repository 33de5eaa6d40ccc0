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

/// A point of the ground as the file has it, in the two axes of the project that are not up, in their order.
Vec3d pointOnGround(const Vec2d& point, UpAxis up);
Vec2d pointOfFile(const Vec3d& point, UpAxis up);

} // namespace quadrille
