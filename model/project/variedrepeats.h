// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"

#include <string>
#include <vector>

namespace quadrille {

/// Whether all takes that variations are learned from are frames of the graph that animations of their
/// character walk through: animations that draw from any variations draw from these.
bool isOfGraph(const Project& project, const VariationEntry& variation);

/// The variations that the repeats of an animation are drawn from, "variations/NAME/3", in their order: those
/// of single takes of its graph that were not thrown away. None where it has no such option.
std::vector<std::string> clipsDrawnFrom(const Project& project, const AnimationEntry& animation);

} // namespace quadrille
