// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"

namespace quadrille {

/// Adds every number of the document that is too great: those that say how much memory or time something
/// takes. The limits are far beyond what a performance needs; a slip of the keyboard meets them.
void validateAmounts(const Project& project, ProjectProblems& problems);

/// The greatest coordinate or length of a path, in the project's unit: 10 km, and no more than what the
/// schema, which knows no unit, allows.
double farthestPlace(double metresPerUnit);

} // namespace quadrille
