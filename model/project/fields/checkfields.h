// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/problem.h"
#include "model/project/document/project.h"

namespace quadrille {

/// Adds what is wrong with single values of a project: numbers that are out of limits, ranges that are empty,
/// names that cannot be used or are there twice, paths that no system has, characters that there are not.
void checkFields(const Project& project, ProjectProblems& problems);

} // namespace quadrille
