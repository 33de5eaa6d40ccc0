// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// Adds what is wrong with the section “motion_spaces”, as far as it can be said without the meshes. What
/// the editor can leave half-done is a warning.
void validateMotionSpaces(const Project& project, ProjectProblems& problems);

} // namespace quadrille
