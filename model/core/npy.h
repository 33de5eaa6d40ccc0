// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// What a .npy file says of its array (NumPy format 1.0 to 3.0).
struct NpyHeader
{
    std::string type; ///< NumPy's description, e.g. "<f4"; empty for records
    bool isFortranOrder = false;
    std::vector<std::int64_t> shape;
    std::size_t size = 0; ///< bytes before the first value
};

/// \param head the beginning of the file, with the whole header. \throws Error FileSyntax, FileTruncated.
NpyHeader parseNpyHeader(std::string_view head, const std::filesystem::path& file);

/// What stands before the values of an array in C order.
/// \param description NumPy's, as Python writes it: "'<f4'" with its quotes, or a list of columns.
std::string npyHeader(const std::string& description, std::span<const std::int64_t> shape);

} // namespace quadrille
