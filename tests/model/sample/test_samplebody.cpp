// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(SampleBody, isOneClosedSurfaceOfGenusZero)
{
    const SampleCharacter character = makeSampleCharacter({.textureSize = 128});
    const TopologyStatistics& s = character.body.topology->statistics();
    EXPECT_EQ(s.components, 1);
    EXPECT_EQ(s.eulerCharacteristic, 2);
    EXPECT_TRUE(s.isClosed());
    EXPECT_EQ(s.nonManifoldVertices, 0);
    EXPECT_GE(character.body.topology->vertexCount(), 2800U);
    EXPECT_LE(character.body.topology->vertexCount(), 3300U);
}

} // namespace
} // namespace quadrille
