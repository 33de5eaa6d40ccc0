// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/farthesttriangles.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

std::vector<TriangleIndex> indices(std::initializer_list<std::size_t> values)
{
    std::vector<TriangleIndex> all;
    for (const std::size_t v : values)
        all.emplace_back(v);
    return all;
}

} // namespace

TEST(FarthestTriangles, EachIsTheFarthestFromThoseBefore)
{
    TriangleRows rows(6, 1);
    rows << 0, 1, 2, 3.5F, 9, 10;
    const std::vector<bool> all(6, true);
    EXPECT_EQ(farthestTriangles(rows, all, {TriangleIndex(0U)}, 4), indices({0, 5, 3, 2}));
    EXPECT_EQ(farthestTriangles(rows, all, {TriangleIndex(3U), TriangleIndex(4U)}, 4), indices({3, 4, 0, 2}));
}

TEST(FarthestTriangles, LeavesOutWhatIsNotUsableOrTheSame)
{
    TriangleRows rows(4, 2);
    rows << 0, 0, 3, 4, 9, 9, 0, 0;
    EXPECT_EQ(farthestTriangles(rows, {true, true, false, true}, {}, 4), indices({0, 1}));
    EXPECT_TRUE(farthestTriangles(rows, std::vector<bool>(4, false), {}, 4).empty());
}

TEST(FarthestTriangles, KeepsWhatIsChosen)
{
    TriangleRows rows(3, 1);
    rows << 0, 1, 2;
    EXPECT_EQ(farthestTriangles(rows, {true, false, true}, indices({1, 1}), 1), indices({1, 1}));
}
