// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/store/dataitem.h"

#include <filesystem>
#include <vector>

namespace quadrille {

/// All data in the result store of a project, fresh or not; computes nothing.
/// \throws Error Cancelled.
std::vector<DataItem> projectData(const Project& project, const std::filesystem::path& projectFile,
                                  const Progress& progress = {});

} // namespace quadrille
