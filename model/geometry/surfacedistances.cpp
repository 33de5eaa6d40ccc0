// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacedistances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// A correction below this share is rounding.
constexpr float leastGain = 1e-5F;

} // namespace

SurfaceDistances::SurfaceDistances(const OpenedSurface& surface)
    : m_surface(surface), m_distances(surface.places(), noWay), m_before(surface.places())
{
}

void SurfaceDistances::add(SheetVertex source, float distance)
{
    push(source, distance, source.vertex);
}

void SurfaceDistances::push(SheetVertex v, float distance, VertexIndex before)
{
    const std::size_t place = m_surface.place(v);
    if (m_distances[place] < noWay && !(distance < m_distances[place] * (1 - leastGain)))
        return;
    m_distances[place] = distance;
    m_before[place] = before;
    m_waiting.push_back({distance, v});
    std::ranges::push_heap(m_waiting, std::greater<>());
}

std::optional<SheetVertex> SurfaceDistances::next()
{
    while (!m_waiting.empty()) {
        std::ranges::pop_heap(m_waiting, std::greater<>());
        const Waiting nearest = m_waiting.back();
        m_waiting.pop_back();
        if (nearest.distance > at(nearest.vertex))
            continue;
        spread(nearest.vertex);
        return nearest.vertex;
    }
    return std::nullopt;
}

void SurfaceDistances::growTo(float limit)
{
    while (!m_waiting.empty() && m_waiting.front().distance <= limit)
        next();
}

float SurfaceDistances::growUntil(SheetVertex target, float limit)
{
    while (!m_waiting.empty() && m_waiting.front().distance <= limit &&
           m_waiting.front().distance < at(target))
        next();
    const float reached = at(target);
    if (reached > limit)
        return noWay;
    growTo(1.02F * reached + 2 * m_surface.graph->meanEdge());
    return at(target);
}

void SurfaceDistances::spread(SheetVertex from)
{
    const SurfaceGraph& graph = *m_surface.graph;
    const float here = at(from);
    for (const SurfaceGraph::Edge& edge : graph.edgesOf(from.vertex)) {
        if (const auto to = m_surface.step(from, VertexIndex(edge.to)))
            push(*to, here + edge.length, from.vertex);
    }
    for (const std::uint32_t t : graph.trianglesOf(from.vertex)) {
        const Triangle& triangle = graph.topology().triangles()[t];
        const std::size_t corner = triangle[0] == from.vertex ? 0 : triangle[1] == from.vertex ? 1 : 2;
        const auto b = m_surface.step(from, triangle[(corner + 1) % 3]);
        const auto c = m_surface.step(from, triangle[(corner + 2) % 3]);
        // Around the ends of a cut there is no telling sheets.
        if (!b || !c || m_surface.step(*b, c->vertex) != c)
            continue;
        across(from, *b, *c);
        across(from, *c, *b);
    }
}

void SurfaceDistances::across(SheetVertex a, SheetVertex b, SheetVertex to)
{
    const float fromA = at(a);
    const float fromB = at(b);
    if (!(fromB < noWay))
        return;
    const Positions pose = m_surface.graph->pose();
    const Vec3f ab = pose[b.vertex.value] - pose[a.vertex.value];
    const Vec3f ac = pose[to.vertex.value] - pose[a.vertex.value];
    const float length = ab.norm();
    if (!(length > 0))
        return;
    // The triangle in its plane: a at the origin, b on the x axis, the corner above, the source below.
    const float cornerX = ac.dot(ab) / length;
    const float cornerY = std::sqrt(std::max(0.0F, ac.squaredNorm() - cornerX * cornerX));
    const float sourceX = (fromA * fromA - fromB * fromB + length * length) / (2 * length);
    const float squared = fromA * fromA - sourceX * sourceX;
    if (squared < 0)
        return;
    const float sourceY = std::sqrt(squared);
    const float height = sourceY + cornerY;
    if (!(height > 0))
        return;
    const float gate = sourceX + (cornerX - sourceX) * sourceY / height;
    if (gate < 0 || gate > length)
        return;
    const float width = cornerX - sourceX;
    const float distance = std::sqrt(width * width + height * height);
    push(to, distance, 2 * gate < length ? a.vertex : b.vertex);
}

} // namespace quadrille
