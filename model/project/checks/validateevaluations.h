// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// What the section “evaluations” says wrong. Reads no file.
void validateEvaluations(const Project& project, ProjectProblems& problems);

} // namespace quadrille
