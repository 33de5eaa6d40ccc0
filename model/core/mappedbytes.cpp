// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/mappedbytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace quadrille {

std::shared_ptr<const MappedBytes> MappedBytes::tryToMap(const std::filesystem::path& file,
                                                         std::uint64_t offset, std::size_t size)
{
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return nullptr;
    const auto pageSize = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    const std::uint64_t before = offset % pageSize;
    const std::size_t length = size + before;
    struct stat status = {};
    void* pages = MAP_FAILED;
    if (size > 0 && fstat(descriptor, &status) == 0 && offset <= static_cast<std::uint64_t>(status.st_size) &&
        size <= static_cast<std::uint64_t>(status.st_size) - offset)
        pages =
            mmap(nullptr, length, PROT_READ, MAP_PRIVATE, descriptor, static_cast<off_t>(offset - before));
    close(descriptor);
    if (pages == MAP_FAILED)
        return nullptr;
    auto* const first = static_cast<std::byte*>(pages);
    return std::shared_ptr<const MappedBytes>(
        new MappedBytes(std::span(first, length), std::span<const std::byte>(first + before, size)));
}

MappedBytes::~MappedBytes()
{
    munmap(m_pages.data(), m_pages.size());
}

void MappedBytes::unload() const
{
    madvise(m_pages.data(), m_pages.size(), MADV_DONTNEED);
}

} // namespace quadrille
