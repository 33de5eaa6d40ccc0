// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace quadrille {

/// Bytes before the library's own, which it leaves to others (a user block).
inline constexpr std::uint64_t sealSize = 512;

/// Writes into the first sealSize bytes of a file what it is, how long it is, and a hash of the rest, as
/// text. \throws Error WriteFailed, and what reading throws.
void sealFile(const std::filesystem::path& file);

/// Makes sure that a file is as it was sealed, before the library reads it: from damaged files it may ask for
/// any amount of memory. Cost: the file is read once. \throws Error FileNotFound, PermissionDenied,
/// ReadFailed, FileEmpty, FileTruncated; FileSyntax where it was never sealed or has changed.
void checkSeal(const std::filesystem::path& file);

} // namespace quadrille
