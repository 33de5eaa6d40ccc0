// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/render/rendersettings.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// The middle of the figure in every frame, horizontally, smoothed over half a second so that a camera that
/// follows it does not shake; the vertical coordinate stays that of the first frame.
/// \throws Error as MeshSequence::frame, Cancelled.
std::vector<Vec3d> followPath(const MeshSequence& sequence, UpAxis up, const Progress& progress = {});

/// One camera for each frame of a clip. Keys say where it stands; otherwise the turntable turns evenly and
/// does not repeat its first view at the end, so that the clip can be looped. Without an explicit view,
/// cameras frame what they shall see. \throws Error as MeshSequence::frame, Cancelled.
std::vector<Camera> clipCameras(const MeshSequence& sequence, const RenderSettings& settings,
                                const Progress& progress = {});

} // namespace quadrille
