// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"

namespace quadrille {

/// What the document itself says wrong: names that are missing, doubled or unusable, characters and clips
/// that do not exist, sources that go round in a circle, empty ranges, impossible rates. Reads no other file.
ProjectProblems validate(const Project& project);

/// A sentence's reason why a name cannot be used, or nothing. Names are parts of targets ("sequences/NAME").
std::optional<std::string> problemWithName(const std::string& name);

} // namespace quadrille
