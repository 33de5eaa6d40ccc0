// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/usedtexels.h"
#include "model/core/error.h"
#include "model/projection/atlastexels.h"
#include "tests/model/appearance/atlas.h"
#include "tests/model/render/scenes.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Where a texel's middle lies by its triangle, from the atlas's upper left corner, texels.
Vec2d middleOf(const AtlasTexels& atlas, const AtlasTexels::Place& place, const TopologyData& data)
{
    const auto& corners = data.triangleUvs[place.triangle.value];
    const Vec2f uv = (1 - place.weights.sum()) * data.uvs[corners[0]] +
                     place.weights.x() * data.uvs[corners[1]] + place.weights.y() * data.uvs[corners[2]];
    return {double{uv.x()} * atlas.width, (1 - double{uv.y()}) * atlas.height};
}

} // namespace

TEST(AtlasTexels, LieWhereTheirTrianglesHaveThem)
{
    const Topology mesh(ball(12, 1).topology->data());
    const AtlasTexels atlas = atlasTexels(mesh, 100, 60);
    EXPECT_EQ(atlas.places.size(), 6000U); // the ball's UVs fill the atlas
    for (const AtlasTexels::Place& place : atlas.places) {
        const Vec2d wanted(place.texel % 100 + 0.5, place.texel / 100 + 0.5);
        EXPECT_LT((middleOf(atlas, place, mesh.data()) - wanted).norm(), 0.01);
        EXPECT_GE(place.weights.minCoeff(), -1e-5F);
        EXPECT_LE(place.weights.sum(), 1 + 1e-5F);
    }
}

TEST(AtlasTexels, AreThoseThatTrianglesCover)
{
    const Topology mesh(atlasOf({{4, 3, 20, 9}, {30.25, 3.25, 40.25, 21.25}}, 64, 32));
    const AtlasTexels atlas = atlasTexels(mesh, 64, 32);
    const UsedTexels used = usedTexels(mesh, 64, 32);
    std::vector<std::uint32_t> covered;
    for (std::size_t t = 0; t < used.texels.size(); ++t)
        if (used.covered[t] != 0)
            covered.push_back(used.texels[t]);
    ASSERT_EQ(atlas.places.size(), covered.size());
    EXPECT_EQ(covered.size(), 16U * 6 + 10 * 18);
    for (std::size_t t = 0; t < covered.size(); ++t)
        EXPECT_EQ(atlas.places[t].texel, covered[t]);
}

TEST(AtlasTexels, ComeInAgainOnTheOtherSide)
{
    const Topology beyond(atlasOf({{56, -4, 72, 4}}, 64, 32));
    const AtlasTexels atlas = atlasTexels(beyond, 64, 32);
    EXPECT_EQ(atlas.places.size(), 16U * 8);
    EXPECT_EQ(atlas.places.front().texel, 0U);
    EXPECT_EQ(atlas.places.back().texel, 64U * 32 - 1);
}

TEST(AtlasTexels, NeedALayout)
{
    TopologyData data = quadTopology();
    EXPECT_THROW(atlasTexels(Topology(data), 0, 8), Error);
    EXPECT_THROW(atlasTexels(Topology(data), 8, 16385), Error);
    data.uvs.assign(4, Vec2f(0.5F, 0.5F));
    EXPECT_THROW(atlasTexels(Topology(data), 8, 8), Error);
    data.uvs.assign(4, Vec2f(NAN, 0.5F));
    EXPECT_THROW(atlasTexels(Topology(data), 8, 8), Error);
    data.uvs.clear();
    data.triangleUvs.clear();
    EXPECT_THROW(atlasTexels(Topology(data), 8, 8), Error);
}
