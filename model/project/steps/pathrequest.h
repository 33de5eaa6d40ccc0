// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/constraintentry.h"
#include "model/sequence/axes.h"
#include "model/synthesis/walks/constraints.h"

namespace quadrille {

/// The curve of a path in metres, without spans and obstacles.
PathConstraint curveInMetres(const PathEntry& path, double metresPerUnit);
/// The same with its obstacles, which are called by their numbers from 1. \param axes  of the project.
PathConstraint pathInMetres(const PathEntry& path, const CoordinateSystem& axes);

} // namespace quadrille
