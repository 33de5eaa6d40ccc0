// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"

#include <gtest/gtest.h>
#include <vector>

using namespace quadrille;

TEST(Bounds, AreThoseOfEveryCountOfPositions)
{
    // Around the sixteen that are taken at a time, with the extremes everywhere.
    for (std::size_t count = 1; count < 50; ++count) {
        for (std::size_t extreme = 0; extreme < count; ++extreme) {
            std::vector<Vec3f> positions(count, Vec3f(1, 2, 3));
            positions[extreme] = Vec3f(-4, 9, 3.5F);
            const Bounds bounds = boundsOf(positions);
            EXPECT_EQ(bounds.min, Vec3d(-4, count == 1 ? 9 : 2, count == 1 ? 3.5 : 3)) << count;
            EXPECT_EQ(bounds.max, Vec3d(count == 1 ? -4 : 1, 9, 3.5)) << count;
        }
    }
}

TEST(Bounds, OfNothingAreEmpty)
{
    EXPECT_TRUE(boundsOf({}).isEmpty());
    Bounds bounds;
    bounds.add(Vec3d(1, 2, 3));
    bounds.add(boundsOf({}));
    EXPECT_EQ(bounds.size(), Vec3d::Zero());
}
