// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// Refuses a file of a known format that has no reader here, saying what to convert it to; returns when the
/// file is none of these.
/// \param head the first bytes of the file.
/// \throws Error FormatRefused.
void refuseForeignFormat(const std::filesystem::path& file, std::string_view head);

/// Extensions of refused formats that come as one file per frame.
std::vector<std::string> refusedSeriesExtensions();

} // namespace quadrille
