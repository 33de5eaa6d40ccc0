// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <functional>
#include <string>

namespace quadrille {

/// A path of the project file; empty where none is given.
struct StoredPath
{
    std::string& path;
    std::string owner;   ///< "sequences/walk"
    std::string pointer; ///< JSON pointer of the path
    bool isOutput;       ///< it is written, otherwise read
};

/// Calls a function with each path of a project, in the order of the file; clips that are sources are none.
void forEachPath(Project& project, const std::function<void(const StoredPath&)>& visit);

} // namespace quadrille
