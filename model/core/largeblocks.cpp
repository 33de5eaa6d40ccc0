// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/largeblocks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>
#include <new>
#include <sys/mman.h>
#include <utility>

namespace quadrille {

namespace {

constexpr std::size_t pageBytes = std::size_t{2} << 20;

std::size_t wholePages(std::size_t bytes)
{
    return (bytes + pageBytes - 1) / pageBytes * pageBytes;
}

struct Block
{
    void* place = nullptr;
    std::size_t length = 0; ///< whole pages
};

void unmap(const Block& block) noexcept
{
    munmap(block.place, block.length);
}

Block map(std::size_t length)
{
    // More than is needed, as it need not begin where a page does; the rest goes back.
    void* const mapped =
        mmap(nullptr, length + pageBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED)
        throw std::bad_alloc();
    auto* const first = static_cast<std::byte*>(mapped);
    const auto address = reinterpret_cast<std::uintptr_t>(first);
    const std::size_t before = wholePages(address) - address;
    if (before > 0)
        munmap(first, before);
    if (before < pageBytes)
        munmap(first + before + length, pageBytes - before);
#ifdef MADV_HUGEPAGE
    madvise(first + before, length, MADV_HUGEPAGE);
#endif
    return {first + before, length};
}

/// What was freed last, the oldest first.
class KeptBlocks
{
public:
    /// Null where there is none of this length.
    void* take(std::size_t length) noexcept
    {
        const std::scoped_lock lock(m_mutex);
        const auto end = m_blocks.begin() + m_count;
        const auto found = std::find_if(m_blocks.begin(), end,
                                        [length](const Block& block) { return block.length == length; });
        if (found == end)
            return nullptr;
        void* const place = found->place;
        std::move(found + 1, end, found);
        --m_count;
        m_bytes -= length;
        return place;
    }

    void keep(const Block& block) noexcept
    {
        if (block.length > keptBytes)
            return unmap(block);
        Blocks dropped;
        std::ptrdiff_t old = 0;
        {
            const std::scoped_lock lock(m_mutex);
            dropped = m_blocks;
            for (; m_bytes + block.length > keptBytes; ++old)
                m_bytes -= m_blocks[static_cast<std::size_t>(old)].length;
            std::move(m_blocks.begin() + old, m_blocks.begin() + m_count, m_blocks.begin());
            m_count -= old;
            m_blocks[static_cast<std::size_t>(m_count++)] = block;
            m_bytes += block.length;
        }
        // It takes milliseconds, which nobody has to wait for.
        std::for_each(dropped.begin(), dropped.begin() + old, unmap);
    }

    void release() noexcept
    {
        const std::scoped_lock lock(m_mutex);
        std::for_each(m_blocks.begin(), m_blocks.begin() + std::exchange(m_count, 0), unmap);
        m_bytes = 0;
    }

private:
    using Blocks = std::array<Block, keptBytes / pageBytes>;

    std::mutex m_mutex;
    Blocks m_blocks{};
    std::ptrdiff_t m_count = 0;
    std::size_t m_bytes = 0;
};

/// Never destroyed: pictures may be freed after everything else.
KeptBlocks& keptBlocks()
{
    alignas(KeptBlocks) static std::byte place[sizeof(KeptBlocks)];
    static auto* const kept = new (place) KeptBlocks;
    return *kept;
}

} // namespace

void* allocateLarge(std::size_t bytes)
{
    if (bytes < pageBytes)
        return ::operator new(bytes);
    if (bytes > SIZE_MAX - 2 * pageBytes)
        throw std::bad_alloc();
    const std::size_t length = wholePages(bytes);
    if (void* const kept = keptBlocks().take(length))
        return kept;
    return map(length).place;
}

void freeLarge(void* block, std::size_t bytes) noexcept
{
    if (bytes < pageBytes)
        ::operator delete(block);
    else
        keptBlocks().keep({block, wholePages(bytes)});
}

void releaseLargeBlocks() noexcept
{
    keptBlocks().release();
}

} // namespace quadrille
