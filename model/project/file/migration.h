// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/jsontext.h"

#include <span>

namespace quadrille {

/// Turns a document of one version into one of the next.
struct Migration
{
    int from;
    void (*apply)(Json& document);
};

/// The migrations from every older version, oldest first; version 1 is the first there was.
std::span<const Migration> projectMigrations();

/// Brings a document up to `current` and sets its version.
/// \param text gives the place of "version" in errors.
/// \throws Error ProjectInvalid when it is no project or its version is no version, ProjectNewer.
void migrate(JsonText& text, std::span<const Migration> migrations, int current,
             const std::filesystem::path& file = {});

} // namespace quadrille
