// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/animationentry.h"

#include <vector>

namespace quadrille {

/// The curve of a path as points close together, as walks follow it.
/// \param metresPerUnit  of the points. \return the points that it passes, with others between them; none
/// where there are fewer than two.
std::vector<Vec3d> curveOf(PathCurve curve, const std::vector<Vec3d>& points, double metresPerUnit);
inline std::vector<Vec3d> curveOf(const PathEntry& path, double metresPerUnit)
{
    return curveOf(path.curve, path.points, metresPerUnit);
}

} // namespace quadrille
