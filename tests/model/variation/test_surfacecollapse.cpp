// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/surfacecollapse.h"
#include "tests/model/transition/swayingtube.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::uint32_t sides = 8;
constexpr std::uint32_t tubeLength = 33; // rings

/// A leg of 1.6 m; its last fifth, the foot, is as long as `foot` says, as a share.
std::vector<Vec3f> leg(double foot)
{
    std::vector<Vec3f> positions;
    for (std::uint32_t ring = 0; ring < tubeLength; ++ring) {
        const double along = 0.05 * ring;
        const double height = along <= 1.3 ? along : 1.3 + foot * (along - 1.3);
        for (std::uint32_t k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            positions.push_back(Vec3d(0.06 * std::cos(angle), height, 0.06 * std::sin(angle)).cast<float>());
        }
    }
    return positions;
}

} // namespace

TEST(SurfaceCollapse, SeesACrumpledFoot)
{
    const auto topology = tubeTopology(sides, tubeLength);
    const std::vector<Vec3f> whole = leg(1);
    const std::vector<Positions> poses{whole};
    const SurfaceCollapse collapse(*topology, {}, poses);
    EXPECT_EQ(collapse.of(whole), 0);
    EXPECT_EQ(collapse.of(leg(0.7)), 0); // shorter, but not crumpled
    // A foot that is a fifth as long is most of the last quarter of the leg.
    EXPECT_GT(collapse.of(leg(0.2)), 0.5);
    // Folded back into the leg, its triangles are as large as before.
    EXPECT_GT(collapse.of(leg(-1)), 0.05);
    // What the poses show themselves is no collapse.
    const std::vector<Vec3f> crumpled = leg(0.2);
    const std::vector<Positions> both{whole, crumpled};
    EXPECT_EQ(SurfaceCollapse(*topology, {}, both).of(leg(0.2)), 0);
}
