// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/projectedits.h"
#include "model/project/document/project.h"

#include <QString>
#include <optional>

namespace quadrille {

/// Whether an entry of a section has the name, be it one that cannot be read. Case and spaces count.
bool isTaken(const Project& project, Section section, const QString& name);

/// Why a text cannot be a name, or nothing. Spaces around it do not count.
std::optional<Error> problemWithText(const QString& name);

/// Why an entry cannot be called so, or nothing. Spaces around the name do not count.
std::optional<Error> problemWithRename(const Project& project, const EntryRef& entry, const QString& name);

} // namespace quadrille
