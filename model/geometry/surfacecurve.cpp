// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacecurve.h"

#include "model/geometry/piecerouter.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace quadrille {

SurfaceCurve::SurfaceCurve(std::shared_ptr<const SurfaceGraph> graph, const CurveSettings& settings)
    : m_router(std::make_unique<PieceRouter>(std::move(graph), settings))
{
}

SurfaceCurve::~SurfaceCurve() = default;
SurfaceCurve::SurfaceCurve(SurfaceCurve&&) noexcept = default;
SurfaceCurve& SurfaceCurve::operator=(SurfaceCurve&&) noexcept = default;

void SurfaceCurve::setObstacles(std::span<const VertexIndex> vertices)
{
    m_router->setObstacles(vertices);
}

void SurfaceCurve::route(std::vector<VertexIndex> points, Pieces kept)
{
    kept = m_router->routed(points, std::move(kept));
    m_points = std::move(points);
    m_pieces = std::move(kept);
    m_vertices.clear();
    for (const auto& piece : m_pieces)
        m_vertices.insert(m_vertices.end(), piece.begin(), piece.end());
}

void SurfaceCurve::restore(std::vector<VertexIndex> points, std::vector<VertexIndex> vertices)
{
    if (!m_router->isClosed(vertices)) {
        setPoints(std::move(points));
        return;
    }
    // Turned so that the first point comes first, then in either direction.
    for (const bool isReversed : {false, true}) {
        if (isReversed)
            std::ranges::reverse(vertices);
        if (!points.empty())
            std::rotate(vertices.begin(), std::ranges::find(vertices, points.front()), vertices.end());
        std::vector<std::size_t> starts;
        std::ranges::transform(points, std::back_inserter(starts), [&](VertexIndex p) {
            return static_cast<std::size_t>(std::ranges::find(vertices, p) - vertices.begin());
        });
        if (!std::ranges::is_sorted(starts, std::less_equal<>()) ||
            (!starts.empty() && (starts.front() != 0 || starts.back() == vertices.size())))
            continue;
        m_pieces.clear();
        starts.push_back(vertices.size());
        for (std::size_t i = 0; i + 1 < starts.size(); ++i)
            m_pieces.emplace_back(vertices.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                                  vertices.begin() + static_cast<std::ptrdiff_t>(starts[i + 1]));
        m_points = std::move(points);
        m_vertices = std::move(vertices);
        return;
    }
    setPoints(std::move(points));
}

void SurfaceCurve::setPoints(std::vector<VertexIndex> points)
{
    Pieces none(points.size());
    route(std::move(points), std::move(none));
}

void SurfaceCurve::insert(std::size_t before, VertexIndex point)
{
    std::vector<VertexIndex> points = m_points;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(before), point);
    Pieces kept = m_pieces;
    kept.resize(m_points.size());
    kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(before), std::vector<VertexIndex>());
    kept[(before + kept.size() - 1) % kept.size()].clear();
    route(std::move(points), std::move(kept));
}

void SurfaceCurve::move(std::size_t index, VertexIndex to)
{
    std::vector<VertexIndex> points = m_points;
    points[index] = to;
    Pieces kept = m_pieces;
    kept.resize(points.size());
    kept[index].clear();
    kept[(index + kept.size() - 1) % kept.size()].clear();
    route(std::move(points), std::move(kept));
}

void SurfaceCurve::remove(std::size_t index)
{
    std::vector<VertexIndex> points = m_points;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    Pieces kept = m_pieces;
    kept.resize(m_points.size());
    kept[(index + kept.size() - 1) % kept.size()].clear();
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(index));
    route(std::move(points), std::move(kept));
}

std::vector<std::size_t> SurfaceCurve::places() const
{
    std::vector<std::size_t> found;
    if (m_vertices.empty())
        return found;
    std::size_t place = 0;
    for (const auto& piece : m_pieces) {
        found.push_back(place);
        place += piece.size();
    }
    return found;
}

std::size_t SurfaceCurve::pointAfter(std::size_t place) const
{
    const std::vector<std::size_t> found = places();
    return static_cast<std::size_t>(std::ranges::upper_bound(found, place) - found.begin());
}

double lengthOf(const SurfaceGraph& graph, std::span<const VertexIndex> curve)
{
    double length = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const VertexIndex next = curve[(i + 1) % curve.size()];
        length += static_cast<double>((graph.pose()[next.value] - graph.pose()[curve[i].value]).norm());
    }
    return length;
}

} // namespace quadrille
