// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace quadrille {

/// Colour maps (map_Kd) of a material library by material, as the library names them; options are left out.
std::map<std::string, std::string> readColourMaps(std::string_view text);

/// A path that another file names, perhaps with backslashes, an absolute path of another machine or another
/// case of letters.
/// \return the file that is meant, or empty when there is none.
std::filesystem::path resolveNamedFile(const std::filesystem::path& folder, std::string name);

} // namespace quadrille
