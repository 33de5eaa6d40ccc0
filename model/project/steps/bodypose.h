// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/media/opensequence.h"
#include "model/variation/parts/bodyparts.h"

#include <vector>

namespace quadrille {

/// A pose of a project, metres. \throws Error as SequenceOpener::open; ProjectInvalid (no such frame).
std::vector<Vec3f> poseInMetres(SequenceOpener& opener, const NamedFrame& frame,
                                const Progress& progress = {});

/// The parts of a body as the section “body_parts” has them. \param pose  in which curves are drawn, of all
/// vertices. \throws Error as cutIntoParts.
BodyParts cutParts(const Topology& topology, Positions pose, const BodyPartsEntry& entry);

} // namespace quadrille
