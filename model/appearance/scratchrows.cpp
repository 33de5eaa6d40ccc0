// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/scratchrows.h"

#include "model/core/file.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace quadrille {

namespace {

/// Calls pread or pwrite until all bytes went through.
template <typename Byte, typename Call>
void transferAll(const std::filesystem::path& folder, std::uint64_t offset, std::span<Byte> bytes,
                 ErrorCode code, const Call& call)
{
    while (!bytes.empty()) {
        const ssize_t count = call(bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            throwSystemError(folder, count < 0 ? errno : EIO, code);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

} // namespace

ScratchRows::ScratchRows(std::uint64_t rowBytes, const std::filesystem::path& folder)
    : m_rowBytes(rowBytes), m_folder(folder.empty() ? std::filesystem::temp_directory_path() : folder)
{
    std::string pattern = (m_folder / "quadrille-XXXXXX").string();
    m_descriptor = ::mkstemp(pattern.data());
    if (m_descriptor < 0)
        throwSystemError(m_folder, errno, ErrorCode::WriteFailed);
    ::unlink(pattern.c_str());
}

ScratchRows::~ScratchRows()
{
    ::close(m_descriptor);
}

void ScratchRows::write(std::int64_t row, std::uint64_t offset, std::span<const std::byte> bytes)
{
    transferAll(m_folder, static_cast<std::uint64_t>(row) * m_rowBytes + offset, bytes,
                ErrorCode::WriteFailed, [this](const std::byte* data, std::size_t size, off_t at) {
                    return ::pwrite(m_descriptor, data, size, at);
                });
}

void ScratchRows::read(std::int64_t row, std::uint64_t offset, std::span<std::byte> bytes) const
{
    transferAll(m_folder, static_cast<std::uint64_t>(row) * m_rowBytes + offset, bytes, ErrorCode::ReadFailed,
                [this](std::byte* data, std::size_t size, off_t at) {
                    return ::pread(m_descriptor, data, size, at);
                });
}

} // namespace quadrille
