// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurvelayout.h"

#include "widgets/tools/pixeldistances.h"
#include "widgets/tools/surfacevisibility.h"

#include <QPolygonF>
#include <algorithm>
#include <limits>

namespace quadrille::widgets {

Qt::CursorShape cursorFor(const SurfaceCurvePart& part)
{
    switch (part.kind) {
    case SurfaceCurvePart::Kind::Point:
        return Qt::OpenHandCursor;
    case SurfaceCurvePart::Kind::Curve:
        return Qt::PointingHandCursor;
    case SurfaceCurvePart::Kind::None:
        break;
    }
    return Qt::ArrowCursor;
}

bool SurfaceCurveContent::has(const SurfaceCurvePart& part) const
{
    if (part.kind == SurfaceCurvePart::Kind::None || part.curve < 0 ||
        part.curve >= static_cast<int>(curves.size()))
        return false;
    const ShownCurve& curve = curves[static_cast<std::size_t>(part.curve)];
    if (part.kind == SurfaceCurvePart::Kind::Curve)
        return !curve.vertices.empty();
    return part.point >= 0 && part.point < static_cast<int>(curve.points.size());
}

std::uint32_t SurfaceCurveContent::vertexOf(const SurfaceCurvePart& part) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(part.curve)];
    return part.kind == SurfaceCurvePart::Kind::Point
               ? curve.vertices[curve.points[static_cast<std::size_t>(part.point)]]
               : curve.vertices.front();
}

std::optional<std::uint32_t> SurfaceCurveContent::vertexAfter(const SurfaceCurvePart& part) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(part.curve)];
    const auto point = static_cast<std::size_t>(part.point);
    const std::size_t from = curve.points.empty() ? 0 : curve.points[point];
    const std::size_t to = point + 1 < curve.points.size()
                               ? curve.points[point + 1]
                               : curve.vertices.size() + (curve.points.empty() ? 0 : curve.points.front());
    if (to <= from + 1)
        return std::nullopt;
    return curve.vertices[((from + to) / 2) % curve.vertices.size()];
}

const ShownCurve* SurfaceCurveContent::drawnCurve() const
{
    return drawn >= 0 && drawn < static_cast<int>(curves.size()) ? &curves[static_cast<std::size_t>(drawn)]
                                                                 : nullptr;
}

std::vector<SurfaceCurvePart> SurfaceCurveContent::points() const
{
    std::vector<SurfaceCurvePart> all;
    for (int c = 0; c < static_cast<int>(curves.size()); ++c)
        for (int p = 0; p < static_cast<int>(curves[static_cast<std::size_t>(c)].points.size()); ++p)
            all.push_back({SurfaceCurvePart::Kind::Point, c, p});
    return all;
}

const std::vector<std::vector<bool>>& SurfaceCurveLayout::seen() const
{
    if (m_seen)
        return *m_seen;
    std::vector<std::uint32_t> all;
    for (const ShownCurve& curve : m_content.curves)
        all.insert(all.end(), curve.vertices.begin(), curve.vertices.end());
    std::vector<bool> visible(all.size());
    if (m_view.size.isValid())
        visible = visibleVertices(m_view.shape, m_view.camera, m_view.size, all);
    m_seen.emplace();
    auto next = visible.begin();
    for (const ShownCurve& curve : m_content.curves) {
        const auto end = next + static_cast<std::ptrdiff_t>(curve.vertices.size());
        m_seen->emplace_back(next, end);
        next = end;
    }
    return *m_seen;
}

std::optional<QPointF> SurfaceCurveLayout::pixelOf(const SurfaceCurvePart& part) const
{
    return m_content.has(part) ? m_view.project(m_content.vertexOf(part)) : std::nullopt;
}

bool SurfaceCurveLayout::isSeen(const SurfaceCurvePart& part) const
{
    const auto pixel = pixelOf(part);
    if (!pixel || !m_view.contains(*pixel))
        return false;
    const std::size_t at = part.kind == SurfaceCurvePart::Kind::Point
                               ? curve(part.curve).points[static_cast<std::size_t>(part.point)]
                               : 0;
    return seenOf(part.curve)[at];
}

SurfaceCurvePart SurfaceCurveLayout::partAt(const QPointF& pixel) const
{
    const SurfaceCurvePart point = pointAt(pixel);
    return point.kind != SurfaceCurvePart::Kind::None ? point : curveAt(pixel);
}

SurfaceCurvePart SurfaceCurveLayout::pointAt(const QPointF& pixel) const
{
    SurfaceCurvePart found;
    double nearest = pointReach;
    for (const SurfaceCurvePart& part : m_content.points()) {
        const bool isSelected = part == m_content.selected;
        const auto at = pixelOf(part);
        if (!at || (!isSelected && !isSeen(part)))
            continue;
        const double advantage = isSelected ? 4.0 : 0.0;
        const double distance = distanceBetween(*at, pixel);
        if (distance < pointReach && distance - advantage < nearest) {
            nearest = distance - advantage;
            found = part;
        }
    }
    return found;
}

SurfaceCurvePart SurfaceCurveLayout::curveAt(const QPointF& pixel) const
{
    SurfaceCurvePart found;
    double nearest = curveReach;
    for (int c = 0; c < static_cast<int>(m_content.curves.size()); ++c) {
        const std::vector<std::uint32_t>& vertices = curve(c).vertices;
        const std::size_t count = vertices.size();
        for (std::size_t i = 0; i + (curve(c).isClosed ? 0 : 1) < count; ++i) {
            const std::size_t next = (i + 1) % count;
            if (!seenOf(c)[i] && !seenOf(c)[next])
                continue;
            const auto a = m_view.project(vertices[i]);
            const auto b = m_view.project(vertices[next]);
            if (const double distance = a && b ? distanceToSegment(pixel, *a, *b) : curveReach;
                distance < nearest) {
                nearest = distance;
                found = {SurfaceCurvePart::Kind::Curve, c, 0};
            }
        }
    }
    return found;
}

QRectF SurfaceCurveLayout::boxOf(int curve) const
{
    QPolygonF pixels;
    for (const std::uint32_t vertex : this->curve(curve).vertices)
        if (const auto pixel = m_view.project(vertex))
            pixels << *pixel;
    return pixels.boundingRect();
}

int SurfaceCurveLayout::pointBefore(int curve, const QPointF& pixel) const
{
    const ShownCurve& shown = this->curve(curve);
    const std::size_t count = shown.vertices.size();
    std::size_t place = 0;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = m_view.project(shown.vertices[i]);
        const auto b = m_view.project(shown.vertices[(i + 1) % count]);
        if (!seenOf(curve)[i] || !a || !b)
            continue;
        if (const double distance = distanceToSegment(pixel, *a, *b); distance < nearest) {
            nearest = distance;
            place = i;
        }
    }
    const auto after = std::upper_bound(shown.points.begin(), shown.points.end(), place);
    const auto before = static_cast<int>(after - shown.points.begin()) - 1;
    return before >= 0 ? before : static_cast<int>(shown.points.size()) - 1;
}

bool SurfaceCurveLayout::closesAt(const QPointF& pixel) const
{
    const ShownCurve* drawn = m_content.drawnCurve();
    if (drawn == nullptr || drawn->points.empty())
        return false;
    const auto first = m_view.project(drawn->vertices[drawn->points.front()]);
    return first && distanceBetween(*first, pixel) < pointReach;
}

std::optional<std::uint32_t> SurfaceCurveLayout::firstCursor() const
{
    if (const ShownCurve* drawn = m_content.drawnCurve(); drawn != nullptr && !drawn->points.empty())
        return drawn->vertices[drawn->points.back()];
    if (const auto place = m_view.placeAt(m_view.middle(), {}))
        return place->pick.vertex;
    return m_view.nearestVertex(m_view.middle());
}

} // namespace quadrille::widgets
