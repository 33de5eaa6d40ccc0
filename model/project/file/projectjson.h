// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/problem.h"
#include "model/project/document/project.h"
#include "model/project/json/json.h"

namespace quadrille {

/// Takes the known values out of a document of the current version and keeps the rest. Values of a wrong type
/// are left at their default and reported; so are keys that are not known, as warnings.
Project projectFromJson(const Json& document, ProjectProblems& problems);

/// In the order of the file; problems of one place keep theirs.
void sortByPlace(ProjectProblems& problems);

/// projectFromJson(), and what validate() says of the values that could be read.
Project readDocument(const Json& document, ProjectProblems& problems);

enum class WrittenEntries
{
    All,
    Usable, ///< without those that are broken
};
/// The document with its keys in their fixed order, unknown keys after the known ones. Values that equal
/// their default are left out, except those that a reader of the file looks for.
Json projectToJson(const Project& project, WrittenEntries entries = WrittenEntries::All);

} // namespace quadrille
