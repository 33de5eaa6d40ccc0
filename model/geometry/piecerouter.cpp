// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/piecerouter.h"

#include "model/core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

[[noreturn]] void fail(ErrorCode code, std::vector<std::pair<std::string, std::string>> values)
{
    ErrorContext context;
    context.values = std::move(values);
    throw Error(code, std::move(context));
}

std::string text(std::uint64_t number)
{
    return std::to_string(number);
}

} // namespace

PieceRouter::PieceRouter(std::shared_ptr<const SurfaceGraph> graph, const CurveSettings& settings)
    : m_graph(std::move(graph)), m_settings(settings), m_obstacles(m_graph->vertexCount()), m_worth(*m_graph)
{
}

void PieceRouter::setObstacles(std::span<const VertexIndex> vertices)
{
    m_obstacles.assign(m_obstacles.size(), false);
    for (const VertexIndex v : vertices) {
        if (v.value < m_obstacles.size())
            m_obstacles[v.value] = true;
    }
}

bool PieceRouter::isClosed(std::span<const VertexIndex> vertices) const
{
    std::vector<bool> isPassed(m_graph->vertexCount());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const VertexIndex v = vertices[i];
        const VertexIndex next = vertices[(i + 1) % vertices.size()];
        if (v.value >= isPassed.size() || isPassed[v.value] || !m_graph->haveEdge(v, next))
            return false;
        isPassed[v.value] = true;
    }
    return vertices.size() >= 3;
}

void PieceRouter::check(const std::vector<VertexIndex>& points) const
{
    for (auto p = points.begin(); p != points.end(); ++p) {
        if (p->value >= m_graph->vertexCount())
            fail(ErrorCode::CurveVertexOutside,
                 {{"curve", ""}, {"vertex", text(p->value)}, {"vertices", text(m_graph->vertexCount())}});
        if (m_obstacles[p->value])
            fail(ErrorCode::CurvePointTaken, {{"vertex", text(p->value)}});
        if (std::find(points.begin(), p, *p) != p)
            fail(ErrorCode::CurvePointTwice, {{"vertex", text(p->value)}});
    }
}

void PieceRouter::findLimb(const std::vector<VertexIndex>& points)
{
    if (m_limbAt != points.front()) {
        m_limbAt = points.front();
        m_loop = loopAround(*m_graph, points.front());
        m_limbLimit = 0;
        m_limb.reset();
    }
    if (!m_loop)
        return;
    if (m_limbLimit == 0) {
        m_limbLimit = static_cast<float>(lengthOf(*m_graph, *m_loop)) / 2;
        m_limb = neighbourhoodOf(*m_graph, *m_loop, m_limbLimit);
    }
    const auto isFar = [&](VertexIndex p) { return !std::isfinite(m_limb->offsets[p.value]); };
    if (m_limb && m_limbLimit < noWay && std::ranges::any_of(points, isFar)) {
        m_limbLimit = noWay;
        m_limb = neighbourhoodOf(*m_graph, *m_loop);
    }
}

bool PieceRouter::isAround(const Pieces& pieces)
{
    std::vector<VertexIndex> curve;
    for (const auto& piece : pieces)
        curve.insert(curve.end(), piece.begin(), piece.end());
    return m_worth.surroundsSomething(curve, static_cast<float>(lengthOf(*m_graph, curve)));
}

std::vector<bool> PieceRouter::reachFor(const std::vector<VertexIndex>& points) const
{
    // Near the limb's end a loop could slip over it.
    std::array<float, 2> reach{m_limb->depth(0) / 2, m_limb->depth(1) / 2};
    for (const VertexIndex p : points) {
        const float offset = m_limb->offsets[p.value];
        float& side = reach[offset < 0 ? 1 : 0];
        if (std::isfinite(offset))
            side = std::max(side, std::abs(offset) + 2 * m_graph->meanEdge());
    }
    std::vector<bool> within(m_graph->vertexCount());
    for (std::size_t v = 0; v < within.size(); ++v)
        within[v] = -reach[1] <= m_limb->offsets[v] && m_limb->offsets[v] <= reach[0];
    return within;
}

int PieceRouter::climbOf(const std::vector<VertexIndex>& piece, VertexIndex end) const
{
    int climb = m_limb->cut.crossing(piece.back(), end);
    for (std::size_t i = 0; i + 1 < piece.size(); ++i)
        climb += m_limb->cut.crossing(piece[i], piece[i + 1]);
    return climb;
}

PieceRouter::Plan PieceRouter::shortestPlan(const OpenedSurface& surface, std::size_t piece,
                                            const std::vector<VertexIndex>& points)
{
    const SheetVertex from{points[piece], 0};
    const VertexIndex end = points[(piece + 1) % points.size()];
    Plan plan{surface, piece, from, {end, 0}, noWay, SurfaceDistances(surface)};
    plan.distances.add(from, 0);
    while (const auto reached = plan.distances.next()) {
        if (reached->vertex == end) {
            plan.to = *reached;
            plan.length = plan.distances.at(*reached);
            break;
        }
    }
    return plan;
}

/// Sends the one piece round for which that is the least detour. False where none can be.
bool PieceRouter::leadAround(std::vector<Plan>& plans, int climb)
{
    for (const Plan& plan : plans)
        climb += plan.to.sheet;
    if (std::abs(climb) == 1)
        return true;
    Plan* best = nullptr;
    int bestSheet = 0;
    float least = noWay;
    for (Plan& plan : plans) {
        for (const int wanted : {-1, 1}) {
            const int sheet = plan.to.sheet + wanted - climb;
            if (std::abs(sheet) > OpenedSurface::sheetsEachWay)
                continue;
            const float length = plan.distances.growUntil({plan.to.vertex, sheet}, plan.length + least);
            if (length - plan.length < least) {
                least = length - plan.length;
                best = &plan;
                bestSheet = sheet;
            }
        }
    }
    if (best)
        best->to.sheet = bestSheet;
    return best != nullptr;
}

bool PieceRouter::routeAll(std::vector<Plan>& plans, std::vector<bool> blocked, Pieces& pieces) const
{
    const RouteRules rules{.blocked = &blocked, .creases = m_settings.creases};
    for (auto plan = plans.begin(); plan != plans.end(); ++plan) {
        auto way = shortestRoute(plan->surface, plan->distances, plan->from, plan->to, rules);
        if (!way) {
            // The next time it goes first.
            std::rotate(plans.begin(), plan, plan + 1);
            return false;
        }
        way->pop_back();
        for (const VertexIndex v : *way)
            blocked[v.value] = true;
        pieces[plan->piece] = std::move(*way);
    }
    return true;
}

PieceRouter::Attempt PieceRouter::attempt(const OpenedSurface& surface,
                                          const std::vector<VertexIndex>& points, Pieces kept) const
{
    std::vector<bool> blocked = m_obstacles;
    std::vector<Plan> plans;
    int climb = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const VertexIndex end = points[(i + 1) % points.size()];
        blocked[points[i].value] = true;
        if (kept[i].empty()) {
            plans.push_back(shortestPlan(surface, i, points));
            if (!std::isfinite(plans.back().length))
                return {std::nullopt, {points[i], end}};
            continue;
        }
        for (const VertexIndex v : kept[i])
            blocked[v.value] = true;
        if (surface.cut)
            climb += climbOf(kept[i], end);
    }
    const bool isAround = !surface.cut || leadAround(plans, climb);
    if (isAround && (routeAll(plans, blocked, kept) || routeAll(plans, blocked, kept)))
        return {std::move(kept), {}};
    return {std::nullopt, {plans.front().from.vertex, plans.front().to.vertex}};
}

PieceRouter::Pieces PieceRouter::routed(const std::vector<VertexIndex>& points, Pieces kept)
{
    check(points);
    if (points.empty())
        return {};
    // A piece that a point came to lie on has to make way.
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto isOn = [&](VertexIndex p) {
            return p != points[i] && std::ranges::find(kept[i], p) != kept[i].end();
        };
        if (std::ranges::any_of(points, isOn))
            kept[i].clear();
    }
    Attempt plain;
    if (points.size() > 2) {
        plain = attempt({m_graph.get()}, points, kept);
        if (plain.pieces && isAround(*plain.pieces))
            return std::move(*plain.pieces);
    }
    findLimb(points);
    Attempt found;
    if (m_limb) {
        const std::vector<bool> within = reachFor(points);
        found = attempt({m_graph.get(), &m_limb->cut, &within}, points, std::move(kept));
    }
    if (found.pieces)
        return std::move(*found.pieces);
    if (plain.pieces)
        return std::move(*plain.pieces);
    if (points.size() == 1 || (points.size() == 2 && !m_limb))
        return {};
    fail(ErrorCode::CurveNoRoute, {{"from", text(found.stuck[0].value)}, {"to", text(found.stuck[1].value)}});
}

} // namespace quadrille
