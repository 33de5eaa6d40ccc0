// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/mediacache.h"

#include <atomic>
#include <future>
#include <gtest/gtest.h>
#include <latch>
#include <thread>
#include <vector>

using namespace quadrille;

namespace {

MediaCache::Loaded item(int value, std::size_t bytes = 10)
{
    return {std::make_shared<int>(value), bytes};
}

int valueOf(const std::shared_ptr<const void>& pointer)
{
    return *static_cast<const int*>(pointer.get());
}

} // namespace

TEST(MediaCache, LoadsOnceAndStaysWithinItsBudget)
{
    MediaCache cache(20);
    const MediaId id;
    int loads = 0;
    const auto get = [&](int index) {
        return valueOf(cache.get(id, index, [&] {
            ++loads;
            return item(index);
        }));
    };
    EXPECT_EQ(get(1), 1);
    EXPECT_EQ(get(2), 2);
    EXPECT_EQ(get(1), 1); // 2 is now the least recently used
    EXPECT_EQ(loads, 2);
    EXPECT_EQ(get(3), 3);
    EXPECT_EQ(get(1), 1);
    EXPECT_EQ(loads, 3);
    EXPECT_EQ(get(2), 2);
    EXPECT_EQ(loads, 4);
    EXPECT_LE(cache.statistics().bytes, 20U);
}

TEST(MediaCache, ItemsInUseOutliveTheCache)
{
    MediaCache cache(5);
    const auto held = cache.get(MediaId(), 0, [] { return item(7); });
    EXPECT_EQ(cache.statistics().items, 0U); // larger than the budget
    EXPECT_EQ(valueOf(held), 7);
}

TEST(MediaCache, SourcesDoNotMix)
{
    MediaCache cache;
    const MediaId a;
    const MediaId b;
    EXPECT_EQ(valueOf(cache.get(a, 0, [] { return item(1); })), 1);
    EXPECT_EQ(valueOf(cache.get(b, 0, [] { return item(2); })), 2);
    cache.drop(a);
    EXPECT_EQ(cache.statistics().items, 1U);
    EXPECT_EQ(valueOf(cache.get(b, 0, [] { return item(3); })), 2);
}

TEST(MediaCache, AFailedLoadLeavesNothing)
{
    MediaCache cache;
    const MediaId id;
    EXPECT_THROW(cache.get(id, 0, []() -> MediaCache::Loaded { throw 1; }), int);
    EXPECT_EQ(cache.statistics().items, 0U);
}

TEST(MediaCache, ThreadsThatMissTheSameItemWaitForOneLoad)
{
    constexpr int threads = 4;
    MediaCache cache;
    const MediaId id;
    std::atomic<int> loads = 0;
    std::promise<void> release;
    std::promise<void> begun;
    const auto load = [&] {
        ++loads;
        begun.set_value();
        release.get_future().wait();
        return item(5);
    };
    std::vector<std::future<int>> values;
    values.push_back(std::async(std::launch::async, [&] { return valueOf(cache.get(id, 0, load)); }));
    begun.get_future().wait();
    std::latch asked(threads);
    for (int t = 0; t < threads; ++t) {
        values.push_back(std::async(std::launch::async, [&] {
            asked.count_down();
            return valueOf(cache.get(id, 0, load));
        }));
    }
    asked.wait();
    release.set_value();
    for (auto& value : values)
        EXPECT_EQ(value.get(), 5);
    EXPECT_EQ(loads, 1);
}

TEST(MediaCache, AFailedLoadReachesAllWhoWaitAndIsTriedAgain)
{
    MediaCache cache;
    const MediaId id;
    std::promise<void> release;
    std::promise<void> begun;
    auto first = std::async(std::launch::async, [&] {
        return cache.get(id, 0, [&]() -> MediaCache::Loaded {
            begun.set_value();
            release.get_future().wait();
            throw 1;
        });
    });
    begun.get_future().wait();
    auto second = std::async(std::launch::async, [&] { return cache.get(id, 0, [] { return item(2); }); });
    while (cache.statistics().hits == 0)
        std::this_thread::yield();
    release.set_value();
    EXPECT_THROW(first.get(), int);
    EXPECT_THROW(second.get(), int);
    EXPECT_EQ(valueOf(cache.get(id, 0, [] { return item(3); })), 3);
}
