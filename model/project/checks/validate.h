// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille {

/// What the document itself says wrong: names that are missing, doubled or unusable, characters and clips
/// that do not exist, sources that go round in a circle, empty ranges, impossible rates. Reads no other file.
ProjectProblems validate(const Project& project);

} // namespace quadrille
