// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <QString>
#include <filesystem>

namespace quadrille {

QString toQString(const std::filesystem::path& path);
std::filesystem::path toPath(const QString& text);

/// The project with every path of media and exports taken from `folder`, as a document keeps them while it is
/// open: so that undo stays right when the project is saved elsewhere. "clip:…" sources stay.
Project withAbsolutePaths(Project project, const std::filesystem::path& folder);

/// The project with every path relative to `folder`, forward slashes, as its file holds them. Where there is
/// no way from the folder to a path (another drive) it stays absolute. What would read as a clip gets “./”.
Project withRelativePaths(Project project, const std::filesystem::path& folder);

} // namespace quadrille
