// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace quadrille {

class WriteGuard;

/// One array or table that a project has computed.
struct DataItem
{
    std::string name;      ///< "sequences/walk/bounds", "frames"
    std::string character; ///< where several characters have data of this name
    bool isFresh = false;
    std::variant<DataArray, DataTable> content;

    /// Rows × columns of a table, the shape of an array.
    std::vector<std::int64_t> shape() const;
    std::string unit() const;
    std::string description() const;
};

/// Data as comma-separated values, with a header row with units.
std::string dataAsCsv(const DataItem& item);
/// Writes data as the file's ending says: `.npy` (row-major; tables as structured arrays), `.csv` (a header
/// row with units) or `.json`. Atomic.
/// \param guard decides what may be written over; null for nothing that is asked.
/// \throws Error BadArgument (another ending), what the guard throws, WriteFailed, PermissionDenied.
void writeData(const DataItem& item, const std::filesystem::path& file, WriteGuard* guard = nullptr);

} // namespace quadrille
