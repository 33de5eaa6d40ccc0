// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

namespace quadrille {

/// A file open for reading at any offset, from any thread. Reads, not maps: a file that shrinks meanwhile is
/// an error, not a crash, and resident memory stays what the caller holds.
class InputFile
{
public:
    /// \throws Error FileNotFound, PermissionDenied, ReadFailed, FileEmpty.
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    /// Bytes at opening time.
    std::uint64_t size() const { return m_size; }
    /// Fills `out` from `offset`.
    /// \throws Error FileTruncated, ReadFailed.
    void read(std::uint64_t offset, std::span<std::byte> out) const;

private:
    std::filesystem::path m_path;
    int m_descriptor = -1;
    std::uint64_t m_size = 0;
};

/// The whole content of a file.
struct FileContent
{
    std::unique_ptr<std::byte[]> data;
    std::size_t size = 0;

    std::span<const std::byte> bytes() const { return {data.get(), size}; }
    std::string_view text() const { return {reinterpret_cast<const char*>(data.get()), size}; }
};
/// \throws Error FileNotFound, PermissionDenied, ReadFailed, FileEmpty, FileTruncated.
FileContent readFile(const std::filesystem::path& path);

/// Runs `write(temporaryPath)`, then renames the temporary file over `path`: the file is there whole or not
/// at all. The temporary file lies beside `path` and keeps its extension; missing folders are made. \throws
/// what `write` throws, Error PermissionDenied, WriteFailed; the temporary file is removed then.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write);
/// \overload writing bytes.
void writeAtomically(const std::filesystem::path& path, std::string_view content);

/// Throws the Error that a system error number stands for.
/// \param fallback ReadFailed or WriteFailed, where the number says nothing better.
[[noreturn]] void throwSystemError(const std::filesystem::path& path, int error, ErrorCode fallback);

} // namespace quadrille
