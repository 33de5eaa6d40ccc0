// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// What the section “animations” says wrong by itself and about sequences that are not there. Reads no file.
void validateAnimations(const Project& project, ProjectProblems& problems);

} // namespace quadrille
