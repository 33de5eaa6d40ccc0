// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/walks/pathsteering.h"

namespace quadrille {

/// Turns the frames of a walk towards its path, as the search for walks does (PathSteering): each frame after
/// the first around the centre of the body before it, each transition as a whole.
/// \param course  in metres; its unit is that of the plan. \return the plan as it is with limits of 0, and
/// along a path without length.
ClipPlan steeredPlan(ClipPlan plan, const RootPoses& roots, const FrameLayout& layout,
                     const PathCourse& course, const SteeringLimits& limits);

} // namespace quadrille
