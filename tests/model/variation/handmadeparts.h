// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/bodyparts.h"
#include "tests/model/transition/bars.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace quadrille::test {

/// A part by its triangles.
struct HandmadePart
{
    std::string name;
    int parent = -1;
    std::function<bool(std::uint32_t triangle)> holds;
};

/// Vertices that edges join, one after the other: the first loop of them.
inline std::vector<VertexIndex> chained(const std::vector<std::array<VertexIndex, 2>>& edges)
{
    std::map<VertexIndex, std::vector<VertexIndex>> neighbours;
    for (const auto& [a, b] : edges) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    std::vector<VertexIndex> loop;
    std::set<VertexIndex> seen;
    for (VertexIndex v = edges.front()[0]; seen.insert(v).second;) {
        loop.push_back(v);
        for (const VertexIndex next : neighbours[v]) {
            if (!seen.contains(next)) {
                v = next;
                break;
            }
        }
    }
    return loop;
}

/// Parts by sets of triangles, parents first.
inline BodyParts handmadeParts(const Topology& topology, const std::vector<HandmadePart>& described)
{
    BodyParts parts;
    const auto verticesOf = [&](const std::vector<TriangleIndex>& triangles) {
        std::set<VertexIndex> vertices;
        for (const TriangleIndex t : triangles)
            vertices.insert(topology.triangles()[t.value].begin(), topology.triangles()[t.value].end());
        return std::vector(vertices.begin(), vertices.end());
    };
    for (const HandmadePart& each : described) {
        BodyPart part{.name = each.name, .parent = each.parent};
        for (std::uint32_t t = 0; t < topology.triangles().size(); ++t) {
            if (each.holds(t))
                part.triangles.emplace_back(t);
        }
        part.vertices = verticesOf(part.triangles);
        if (each.parent >= 0) {
            const BodyPart& parent = parts.parts[static_cast<std::size_t>(each.parent)];
            std::ranges::set_intersection(part.triangles, parent.triangles,
                                          std::back_inserter(part.overlapTriangles));
            part.overlap = verticesOf(part.overlapTriangles);
            // Edges of the overlap at which the other triangle belongs to one of the two only.
            std::map<std::set<VertexIndex>, std::vector<TriangleIndex>> sides;
            for (std::uint32_t t = 0; t < topology.triangles().size(); ++t) {
                const Triangle& triangle = topology.triangles()[t];
                for (std::size_t c = 0; c < 3; ++c)
                    sides[{triangle[c], triangle[(c + 1) % 3]}].emplace_back(t);
            }
            const auto has = [](const std::vector<TriangleIndex>& in, TriangleIndex t) {
                return std::ranges::binary_search(in, t);
            };
            std::vector<std::array<VertexIndex, 2>> end;
            std::vector<std::array<VertexIndex, 2>> parentEnd;
            for (const auto& [edge, triangles] : sides) {
                if (triangles.size() != 2 ||
                    has(part.overlapTriangles, triangles[0]) == has(part.overlapTriangles, triangles[1]))
                    continue;
                const TriangleIndex outer = triangles[has(part.overlapTriangles, triangles[0]) ? 1 : 0];
                (has(part.triangles, outer) ? parentEnd : end).push_back({*edge.begin(), *edge.rbegin()});
            }
            part.end = chained(end);
            part.parentEnd = chained(parentEnd);
        }
        parts.parts.push_back(std::move(part));
    }
    return parts;
}

/// Of each part its vertices in a pose.
inline std::vector<std::vector<Vec3f>> cutPose(const BodyParts& parts, Positions pose)
{
    std::vector<std::vector<Vec3f>> poses;
    for (const BodyPart& part : parts.parts) {
        poses.emplace_back();
        for (const VertexIndex v : part.vertices)
            poses.back().push_back(pose[v.value]);
    }
    return poses;
}

inline std::vector<Positions> viewed(const std::vector<std::vector<Vec3f>>& poses)
{
    return {poses.begin(), poses.end()};
}

/// A closed bar along x with as many square-ish triangles as a body has, in five parts: a trunk, two parts
/// that hang on it, and one more on each of these.
struct PartedBar
{
    Bar bar;
    BodyParts parts;

    explicit PartedBar(int rings = 61, int side = 4, float length = 2.0F, float width = 0.3F,
                       bool closed = true, int overlap = 6)
        : bar(makeBar(rings, side, length, width, closed))
    {
        const auto between = [this, rings, length](int first, int last) {
            return [this, from = at(first, rings, length), to = at(last, rings, length)](std::uint32_t t) {
                float middle = 0;
                for (const VertexIndex v : bar.topology->triangles()[t])
                    middle += bar.positions[v.value].x() / 3;
                return from <= middle && middle <= to;
            };
        };
        const int fifth = rings / 5;
        const int more = overlap / 2;
        parts = handmadeParts(*bar.topology, {{"trunk", -1, between(2 * fifth - more, 3 * fifth + more)},
                                              {"left", 0, between(fifth - more, 2 * fifth + more)},
                                              {"right", 0, between(3 * fifth - more, 4 * fifth + more)},
                                              {"left end", 1, between(-1, fifth + more)},
                                              {"right end", 2, between(4 * fifth - more, rings)}});
    }
    static float at(int ring, int rings, float length)
    {
        return length * static_cast<float>(ring) / static_cast<float>(rings - 1);
    }
};

} // namespace quadrille::test
