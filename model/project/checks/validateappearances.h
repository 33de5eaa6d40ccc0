// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// Adds what is wrong with the section “appearance”, as far as it can be said without the textures.
void validateAppearances(const Project& project, ProjectProblems& problems);

} // namespace quadrille
