// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/result.h"

#include <filesystem>

namespace quadrille {

/// What a result file says of itself.
struct ResultHeader
{
    std::string step; ///< "sequences/walk/statistics"
    std::string key;  ///< hash of inputs, settings and algorithm version
};

/// Writes a result as one HDF5 file, atomically. The same result gives the same bytes.
///
/// Root attributes: `format` ("quadrille-result"), `stage` (the step), `key`, `checksum`. An array is a
/// dataset with the attributes `unit`, `description` and, where they exist, `columns` (texts). A table is a
/// group with the attributes `description` and `columns`, its columns being one-dimensional datasets. Texts
/// are UTF-8 of a fixed size, padded with zeros. `files` is a table of the files written outside of the
/// store. \throws Error WriteFailed, PermissionDenied.
void writeResultFile(const std::filesystem::path& file, const ResultHeader& header, const Result& result);

/// \throws Error FileNotFound, PermissionDenied, ResultDamaged (also when the checksum differs).
Result readResultFile(const std::filesystem::path& file);
/// Reads the files that a result names, alone. \throws Error as readResultFile, without the checksum.
std::vector<WrittenFile> readWrittenFiles(const std::filesystem::path& file);
/// Reads the header alone.
/// \throws Error as readResultFile, without the checksum.
ResultHeader readResultHeader(const std::filesystem::path& file);

/// Hash of everything in a result and its header.
std::string checksumOf(const ResultHeader& header, const Result& result);

} // namespace quadrille
