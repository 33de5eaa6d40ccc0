// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/halfedges.h"
#include "model/sequence/topology.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

Triangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    return {VertexIndex(a), VertexIndex(b), VertexIndex(c)};
}

TopologyData tetrahedron()
{
    return {.vertexCount = 4,
            .triangles = {triangle(0, 2, 1), triangle(0, 1, 3), triangle(1, 2, 3), triangle(2, 0, 3)}};
}

ErrorCode codeOf(TopologyData data)
{
    try {
        const Topology topology(std::move(data), "mesh.obj");
    } catch (const Error& error) {
        EXPECT_EQ(error.context().file, "mesh.obj");
        return error.code();
    }
    ADD_FAILURE() << "accepted";
    return ErrorCode::Cancelled;
}

} // namespace

TEST(Topology, TetrahedronIsClosed)
{
    const Topology topology(tetrahedron());
    const auto& s = topology.statistics();
    EXPECT_TRUE(topology.isClosed());
    EXPECT_EQ(s.components, 1);
    EXPECT_EQ(s.edges, 6);
    EXPECT_EQ(s.eulerCharacteristic, 2);
    EXPECT_EQ(s.nonManifoldVertices, 0);
    EXPECT_EQ(topology.halfEdges().mesh.n_halfedges(), 12U);
}

// Sets of vertices meet by vertices that are not the first of their sets.
TEST(Topology, LabelsEveryUsedVertexInAnyOrderOfTriangles)
{
    TopologyData data;
    data.vertexCount = 6;
    const auto triangle = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return Triangle{VertexIndex(a), VertexIndex(b), VertexIndex(c)};
    };
    data.triangles = {triangle(1, 4, 5), triangle(0, 2, 4), triangle(2, 3, 5)};
    const Topology topology(data);
    EXPECT_EQ(topology.statistics().components, 1);
    EXPECT_EQ(topology.components(), std::vector<std::int32_t>(6, 0));
}

TEST(Topology, CountsBoundariesAndComponents)
{
    // Two triangles that share an edge, one apart, one vertex unused.
    const Topology topology(
        {.vertexCount = 8, .triangles = {triangle(0, 1, 2), triangle(0, 2, 3), triangle(4, 5, 6)}});
    const auto& s = topology.statistics();
    EXPECT_EQ(s.components, 2);
    EXPECT_EQ(s.boundaryEdges, 7);
    EXPECT_EQ(s.boundaryLoops, 2);
    EXPECT_EQ(s.unusedVertices, 1);
    EXPECT_FALSE(topology.isClosed());
    EXPECT_EQ(topology.components(), (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, -1}));
}

TEST(Topology, AcceptsAndCountsNonManifoldEdges)
{
    // Three triangles around the edge 0–1.
    const Topology topology(
        {.vertexCount = 5, .triangles = {triangle(0, 1, 2), triangle(1, 0, 3), triangle(0, 1, 4)}});
    EXPECT_EQ(topology.statistics().nonManifoldEdges, 1);
    EXPECT_EQ(topology.halfEdges().leftOut.size(), 1U);
    EXPECT_EQ(topology.halfEdges().mesh.n_faces(), 2U);
}

TEST(Topology, CountsVerticesWhereTwoFansTouch)
{
    const Topology topology({.vertexCount = 5, .triangles = {triangle(0, 1, 2), triangle(0, 3, 4)}});
    EXPECT_EQ(topology.statistics().nonManifoldVertices, 1);
    EXPECT_EQ(topology.statistics().components, 1);
}

TEST(Topology, KnowsAPolygonSoup)
{
    EXPECT_TRUE(
        Topology({.vertexCount = 6, .triangles = {triangle(0, 1, 2), triangle(3, 4, 5)}}).isPolygonSoup());
    EXPECT_FALSE(Topology({.vertexCount = 3, .triangles = {triangle(0, 1, 2)}}).isPolygonSoup());
}

TEST(Topology, RefusesWhatIsNoSurface)
{
    EXPECT_EQ(codeOf({}), ErrorCode::NoVertices);
    EXPECT_EQ(codeOf({.vertexCount = 3}), ErrorCode::NoFaces);
    EXPECT_EQ(codeOf({.vertexCount = 3, .triangles = {triangle(0, 1, 3)}}), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(codeOf({.vertexCount = 3,
                      .triangles = {triangle(0, 1, 2)},
                      .uvs = {{0, 0}},
                      .triangleUvs = {{0, 0, 1}}}),
              ErrorCode::IndexOutOfRange);
}
