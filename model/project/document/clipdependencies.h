// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <string>
#include <vector>

namespace quadrille {

/// The variations that the repeats of an animation are drawn from, "variations/NAME/3", in their order: those
/// of single takes of its graph that were not thrown away. None where it has no such option.
std::vector<std::string> clipsDrawnFrom(const Project& project, const AnimationEntry& animation);

/// What a clip shows: a sequence its source, a made clip the sequences whose frames it has, and the
/// variations that it is drawn from.
std::vector<std::string> shownBy(const Project& project, const std::string& clip);

/// The parts of a project that a clip is made of: settings, characters, and the sequences,
/// animations and variations that it shows, directly or through others. Where it has made clips, it is there
/// only once they are computed.
/// \param clip  "sequences/NAME", "animations/NAME", "live/NAME" or "variations/NAME/3".
Project partsOfClip(const Project& project, const std::string& clip);

/// What motion spaces depend on: the project with these alone, and without what no motion space is made of.
Project partsOfMotionSpaces(const Project& project, const std::vector<std::string>& spaces);

/// Whether a clip is, through others, made of itself.
bool isMadeOfItself(const Project& project, const std::string& clip);

} // namespace quadrille
