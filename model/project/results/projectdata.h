// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/store/dataitem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace quadrille {

/// All data in the result store of a project, fresh or not; computes nothing.
/// \param wanted  the one that is asked for, where one is: large arrays that lie in files of their own, of
/// the section “appearance”, are read for its sake only. \throws Error Cancelled; those of
/// readAppearanceFile.
std::vector<DataItem> projectData(const Project& project, const std::filesystem::path& projectFile,
                                  const Progress& progress = {}, const std::string& wanted = {});

} // namespace quadrille
