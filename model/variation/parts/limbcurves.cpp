// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/limbcurves.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// A way without shortcuts: no vertex shares an edge with a later one but the next.
std::vector<VertexIndex> withoutChords(const SurfaceGraph& graph, const std::vector<VertexIndex>& way)
{
    std::vector<VertexIndex> kept{way.front()};
    for (std::size_t i = 0; i + 1 < way.size();) {
        std::size_t next = way.size() - 1;
        while (!graph.haveEdge(way[i], way[next]))
            --next;
        kept.push_back(way[next]);
        i = next;
    }
    return kept;
}

} // namespace

LimbCurves::LimbCurves(const SurfaceGraph& graph, const BodyLimbs& body, const Limb& limb,
                       const Limb& opposite, const std::vector<bool>& taken, std::string name)
    : m_graph(graph)
    , m_body(body)
    , m_limb(limb)
    , m_opposite(opposite)
    , m_taken(taken)
    , m_name(std::move(name))
{
    for (std::size_t v = 0; v < taken.size(); ++v)
        m_half.push_back(limb.distances[v] < opposite.distances[v]);
}

void LimbCurves::fail(ErrorCode code) const
{
    throw Error(code, {.file = {}, .place = {}, .values = {{"limb", m_name}}});
}

VertexIndex LimbCurves::armpit(const Limb& other, const Progress& progress)
{
    openTo(other);
    constexpr float fastest = 1.2F;
    const auto height = static_cast<float>(m_body.height);
    const float first = 0.15F * height;
    const float step = 0.008F * height;
    const float longest = 0.36F * height;
    std::optional<VertexIndex> best;
    float most = -infinite;
    float last = 0;
    for (const VertexIndex p : m_cut->path()) {
        const float here = m_limb.distances[p.value];
        if (here < first || here < last + step || m_taken[p.value] || !m_half[p.value])
            continue;
        progress.report(static_cast<double>(here / m_limb.distances[other.tip.value]));
        last = here;
        const float length = loopLength(p, longest);
        if (length > longest && best)
            break;
        if (fastest * here - length > most) {
            most = fastest * here - length;
            best = p;
        }
    }
    if (!best)
        fail();
    // An arm that has grown together with the trunk does not stick out, and the head takes its place.
    constexpr float longestHead = 0.28F;
    if (!m_body.hasMore && m_limb.distances[best->value] < longestHead * height)
        fail(ErrorCode::PartsLimbGrown);
    return *best;
}

VertexIndex LimbCurves::crotch()
{
    openTo(m_opposite);
    const float margin = 0.03F * static_cast<float>(m_body.height);
    std::optional<VertexIndex> best;
    for (const VertexIndex p : m_cut->path()) {
        if (m_opposite.distances[p.value] - m_limb.distances[p.value] < margin)
            break;
        if (!m_taken[p.value])
            best = p;
    }
    if (!best)
        fail();
    return *best;
}

std::vector<VertexIndex> LimbCurves::slantingLoop(VertexIndex inside) const
{
    const auto place = [&](VertexIndex v) { return m_graph.pose()[v.value]; };
    const std::vector<VertexIndex> loop = loopThrough(inside);
    const VertexIndex outside =
        *std::ranges::max_element(loop, {}, [&](VertexIndex v) { return (place(v) - place(inside)).norm(); });
    return loopThrough(inside, beyond(outside));
}

void LimbCurves::openTo(const Limb& other)
{
    const OpenedSurface surface{&m_graph};
    SurfaceDistances distances(surface);
    distances.add({m_limb.tip, 0}, 0);
    const auto way = shortestRoute(surface, distances, {m_limb.tip, 0}, {other.tip, 0}, {});
    if (!way)
        fail();
    m_cut.emplace(m_graph, withoutChords(m_graph, *way));
}

float LimbCurves::loopLength(VertexIndex through, float limit) const
{
    SurfaceDistances distances(half());
    distances.add({through, 0}, 0);
    return distances.growUntil({through, 1}, limit);
}

std::vector<VertexIndex> LimbCurves::loopThrough(VertexIndex inside) const
{
    SurfaceDistances forward(half());
    forward.add({inside, 0}, 0);
    return routed(forward, {inside, 0}, {inside, 1}, m_taken);
}

std::vector<VertexIndex> LimbCurves::loopThrough(VertexIndex inside, VertexIndex outside) const
{
    const SheetVertex start{inside, 0};
    const SheetVertex end{inside, 1};
    SurfaceDistances forward(half());
    forward.add(start, 0);
    forward.growTo(infinite);
    SurfaceDistances backward(half());
    backward.add(end, 0);
    backward.growTo(infinite);
    SheetVertex through{outside, 0};
    for (const int sheet : {-1, 1, 2}) {
        const SheetVertex v{outside, sheet};
        if (forward.at(v) + backward.at(v) < forward.at(through) + backward.at(through))
            through = v;
    }
    std::vector<VertexIndex> loop = routed(forward, start, through, m_taken);
    std::vector<bool> blocked = m_taken;
    for (const VertexIndex v : loop)
        blocked[v.value] = true;
    SurfaceDistances onward(half());
    onward.add(through, 0);
    const std::vector<VertexIndex> rest = routed(onward, through, end, blocked);
    loop.insert(loop.end(), rest.begin(), rest.end());
    return loop;
}

std::vector<VertexIndex> LimbCurves::routed(SurfaceDistances& forward, SheetVertex from, SheetVertex to,
                                            const std::vector<bool>& blocked) const
{
    auto way = shortestRoute(half(), forward, from, to, {.blocked = &blocked});
    if (!way)
        fail();
    way->pop_back();
    return std::move(*way);
}

/// The vertex farthest from the tip near one on the outside.
VertexIndex LimbCurves::beyond(VertexIndex outside) const
{
    constexpr float rise = 0.05F;
    SurfaceDistances distances({&m_graph, nullptr, &m_half});
    distances.add({outside, 0}, 0);
    VertexIndex best = outside;
    while (const auto reached = distances.next()) {
        const VertexIndex v = reached->vertex;
        if (distances.at(*reached) > rise * static_cast<float>(m_body.height))
            break;
        if (!m_taken[v.value] && m_limb.distances[v.value] > m_limb.distances[best.value])
            best = v;
    }
    return best;
}

} // namespace quadrille
