// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// Checks of the section “live” beyond single values; adds what is wrong.
void validateLives(const Project& project, ProjectProblems& problems);

} // namespace quadrille
