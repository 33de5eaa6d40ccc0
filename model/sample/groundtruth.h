// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace quadrille {

/// A take's joint angles as BVH text: metres, degrees, Z X Y rotations, zero pose = rest pose.
std::string toBvh(const Skeleton& skeleton, const std::vector<SkeletonPose>& poses, double fps);

/// Joints (name, parent, rest position) and per vertex four joints and weights.
nlohmann::ordered_json skeletonJson(const SampleCharacter& character);
/// Contacts, flight and lighting of every take.
nlohmann::ordered_json takesJson(const SampleCharacter& character);
/// Named places on the character and on the target body.
nlohmann::ordered_json landmarksJson(const SampleCharacter& character);

/// Warps of all frames as `.npy`: float32, frames × nodes × nodes × 2, texels.
std::string warpsNpy(const SampleAppearance& appearance);

} // namespace quadrille
