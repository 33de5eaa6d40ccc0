// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathlayout.h"
#include "widgets/viewport/scenemarks.h"

namespace quadrille::widgets {

/// What of a path stands in the scene: the curve, its stretches with their words, obstacles. Colours are the
/// theme's.
SceneMarks pathMarks(const PathLayout& layout);

} // namespace quadrille::widgets
