// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/largeblocks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <new>
#include <numeric>
#include <sys/mman.h>
#include <thread>
#include <vector>

using namespace quadrille;

namespace {

constexpr std::size_t page = std::size_t{2} << 20;

/// Whether the system knows of memory there.
bool isMapped(void* place)
{
    constexpr std::size_t smallPage = 4096;
    return msync(place, smallPage, MS_ASYNC) == 0;
}

} // namespace

TEST(LargeBlocks, MayBeWrittenWhole)
{
    for (const std::size_t bytes : {page, page + 1, 2 * page - 1, 3 * page, 9 * page + 5}) {
        // Several at once lie differently between pages.
        std::array<unsigned char*, 3> blocks{};
        for (unsigned char*& block : blocks) {
            block = static_cast<unsigned char*>(allocateLarge(bytes));
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % page, 0U);
            std::iota(block, block + bytes, static_cast<unsigned char>(bytes));
        }
        for (unsigned char* block : blocks) {
            EXPECT_EQ(block[bytes - 1], static_cast<unsigned char>(bytes + bytes - 1));
            freeLarge(block, bytes);
        }
    }
    releaseLargeBlocks();
}

TEST(LargeBlocks, AreKeptForTheNextOfTheirSizeUntilTheyAreReleased)
{
    releaseLargeBlocks();
    void* const block = allocateLarge(3 * page - 7);
    freeLarge(block, 3 * page - 7);
    void* const other = allocateLarge(2 * page);
    EXPECT_NE(other, block);
    EXPECT_EQ(allocateLarge(3 * page), block);
    freeLarge(block, 3 * page);
    freeLarge(other, 2 * page);
    EXPECT_TRUE(isMapped(block) && isMapped(other));
    releaseLargeBlocks();
    EXPECT_FALSE(isMapped(block) || isMapped(other));
}

TEST(LargeBlocks, GoBackToTheSystemBeyondWhatIsKept)
{
    releaseLargeBlocks();
    constexpr std::size_t bytes = 5 * page;
    std::vector<void*> blocks;
    for (std::size_t sum = 0; sum < 2 * keptBytes; sum += bytes)
        blocks.push_back(allocateLarge(bytes));
    for (void* block : blocks)
        freeLarge(block, bytes);
    const auto kept = std::ranges::count_if(blocks, isMapped);
    EXPECT_EQ(kept, static_cast<std::ptrdiff_t>(keptBytes / bytes));
    EXPECT_TRUE(isMapped(blocks.back())); // the newest ones
    EXPECT_FALSE(isMapped(blocks.front()));
    void* const huge = allocateLarge(keptBytes + 1);
    freeLarge(huge, keptBytes + 1);
    EXPECT_FALSE(isMapped(huge));
    EXPECT_TRUE(isMapped(blocks.back()));
    releaseLargeBlocks();
    EXPECT_EQ(std::ranges::count_if(blocks, isMapped), 0);
}

TEST(LargeBlocks, ComeAndGoInSeveralThreads)
{
    std::vector<std::thread> threads;
    for (unsigned char mark = 1; mark <= 4; ++mark)
        threads.emplace_back([mark] {
            for (std::size_t round = 0; round < 200; ++round) {
                const std::size_t bytes = (1 + round % 3) * page;
                auto* block = static_cast<unsigned char*>(allocateLarge(bytes));
                block[0] = block[bytes - 1] = mark;
                std::this_thread::yield();
                EXPECT_TRUE(block[0] == mark && block[bytes - 1] == mark);
                freeLarge(block, bytes);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    releaseLargeBlocks();
}

TEST(LargeBlocks, AreUsualMemoryWhereTheyAreSmall)
{
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, page - 1}) {
        auto* block = static_cast<unsigned char*>(allocateLarge(bytes));
        ASSERT_NE(block, nullptr);
        std::fill_n(block, bytes, static_cast<unsigned char>(7));
        freeLarge(block, bytes);
    }
}

TEST(LargeBlocks, AreRefusedWhereThereIsNoRoom)
{
    for (const std::size_t bytes :
         {std::numeric_limits<std::size_t>::max(), std::numeric_limits<std::size_t>::max() / 4})
        EXPECT_THROW(allocateLarge(bytes), std::bad_alloc);
}

TEST(LargeBlocks, HoldTheNumbersOfAGrowingContainer)
{
    std::vector<std::uint32_t, LargeBlocks<std::uint32_t>> numbers;
    for (std::uint32_t i = 0; i < 2'000'000; ++i)
        numbers.push_back(i);
    const auto copy = numbers;
    numbers = {};
    EXPECT_EQ(copy.front(), 0U);
    EXPECT_EQ(copy.back(), 1'999'999U);
    EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), std::uint64_t{0}), 1'999'999'000'000U);
}
