// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace quadrille {

/// Bytes of a file as memory: read where they are first looked at, and the system may take their room back
/// whenever it needs it. They stay what they are if the file is replaced or removed, so this is for files
/// that are only ever replaced whole (writeAtomically): one that shrinks in place ends the program when
/// they are looked at. Others are read by InputFile. Safe from any thread.
class MappedBytes
{
public:
    /// Null where the file has no such bytes, or the system cannot map it: it has to be read then.
    static std::shared_ptr<const MappedBytes> tryToMap(const std::filesystem::path& file,
                                                       std::uint64_t offset, std::size_t size);
    ~MappedBytes();
    MappedBytes(const MappedBytes&) = delete;
    MappedBytes& operator=(const MappedBytes&) = delete;

    std::span<const std::byte> bytes() const { return m_bytes; }
    /// Gives their room back until they are looked at again. Cost: linear in the pages that they take.
    void unload() const;

private:
    MappedBytes(std::span<std::byte> pages, std::span<const std::byte> bytes) : m_pages(pages), m_bytes(bytes)
    {
    }

    std::span<std::byte> m_pages; ///< whole ones, that the bytes lie in
    std::span<const std::byte> m_bytes;
};

} // namespace quadrille
