// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/mediacache.h"

#include <gtest/gtest.h>

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
