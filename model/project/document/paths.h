// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace quadrille {

/// How a project in `folder` writes the path of a file: relative to the folder, with forward slashes.
std::string storedPath(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The file that a project in `folder` means by a stored path; empty for an empty one.
std::filesystem::path resolvePath(std::string_view stored, const std::filesystem::path& folder);

/// The folder of a project file, absolute.
std::filesystem::path projectFolder(const std::filesystem::path& projectFile);

/// The clip that a source "clip:SECTION/NAME" means, as "SECTION/NAME"; empty when it is a file.
std::optional<std::string> clipOfSource(std::string_view source);

/// The name in a clip "SECTION/NAME" where it is of a section ("sequences", "animations"); else empty.
std::optional<std::string> nameOfClip(std::string_view clip, std::string_view section);

} // namespace quadrille
