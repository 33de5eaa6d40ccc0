// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace quadrille {

/// Rows of bytes in a file without a name that is gone with this object: for what does not fit into memory.
/// Safe from any thread, for different bytes.
class ScratchRows
{
public:
    /// \param folder  where the file lies; empty: the system's folder for temporary files.
    /// \throws Error WriteFailed, PermissionDenied.
    ScratchRows(std::uint64_t rowBytes, const std::filesystem::path& folder = {});
    ~ScratchRows();
    ScratchRows(const ScratchRows&) = delete;
    ScratchRows& operator=(const ScratchRows&) = delete;

    std::uint64_t rowBytes() const { return m_rowBytes; }
    /// \param offset  in the row. \throws Error WriteFailed.
    void write(std::int64_t row, std::uint64_t offset, std::span<const std::byte> bytes);
    /// Reads what was written. \throws Error ReadFailed.
    void read(std::int64_t row, std::uint64_t offset, std::span<std::byte> bytes) const;

private:
    std::uint64_t m_rowBytes;
    std::filesystem::path m_folder;
    int m_descriptor = -1;
};

} // namespace quadrille
