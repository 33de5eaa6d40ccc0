// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathgeometry.h"

#include "widgets/viewport/scenemarks.h"

#include <algorithm>
#include <limits>

namespace quadrille::widgets {

namespace {

using Points = std::vector<QVector3D>;

std::ptrdiff_t offset(std::size_t index)
{
    return static_cast<std::ptrdiff_t>(index);
}

/// Handles of the curve through anchors that goes at each along the line between its neighbours.
Points withHandles(const Points& anchors)
{
    const std::size_t count = anchors.size();
    const auto tangent = [&](std::size_t i) {
        const QVector3D& before = anchors[i == 0 ? 0 : i - 1];
        const QVector3D& after = anchors[std::min(i + 1, count - 1)];
        return (after - before).normalized();
    };
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) {
            const float reach = (anchors[i] - anchors[i - 1]).length() / 3.0F;
            points.push_back(anchors[i - 1] + reach * tangent(i - 1));
            points.push_back(anchors[i] - reach * tangent(i));
        }
        points.push_back(anchors[i]);
    }
    return points;
}

Points anchorsOf(PathKind kind, const Points& points)
{
    Points anchors;
    for (std::size_t i = 0; i < anchorCount(kind, points.size()); ++i)
        anchors.push_back(points[anchorIndex(kind, i)]);
    return anchors;
}

float distanceToLine(const QVector3D& point, const QVector3D& a, const QVector3D& b)
{
    const QVector3D along = b - a;
    const float squared = along.lengthSquared();
    const float t =
        squared > 0.0F ? std::clamp(QVector3D::dotProduct(point - a, along) / squared, 0.0F, 1.0F) : 0.0F;
    return (point - a - t * along).length();
}

void simplify(const Points& stroke, std::size_t first, std::size_t last, float tolerance, Points& kept)
{
    std::size_t farthest = first;
    float greatest = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
        const float distance = distanceToLine(stroke[i], stroke[first], stroke[last]);
        if (distance > greatest) {
            greatest = distance;
            farthest = i;
        }
    }
    if (farthest == first)
        return;
    simplify(stroke, first, farthest, tolerance, kept);
    kept.push_back(stroke[farthest]);
    simplify(stroke, farthest, last, tolerance, kept);
}

} // namespace

SampledCurve::SampledCurve(std::vector<QVector3D> points) : m_points(std::move(points))
{
    m_lengths.reserve(m_points.size());
    double walked = 0.0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (i > 0)
            walked += static_cast<double>((m_points[i] - m_points[i - 1]).length());
        m_lengths.push_back(walked);
    }
}

QVector3D SampledCurve::at(double metres) const
{
    const auto after = std::upper_bound(m_lengths.begin(), m_lengths.end(), std::max(0.0, metres));
    if (after == m_lengths.end())
        return m_points.back();
    const auto i = static_cast<std::size_t>(after - m_lengths.begin());
    const double t = (std::max(0.0, metres) - m_lengths[i - 1]) / (m_lengths[i] - m_lengths[i - 1]);
    return m_points[i - 1] + static_cast<float>(t) * (m_points[i] - m_points[i - 1]);
}

std::vector<QVector3D> SampledCurve::part(double from, double to) const
{
    if (isEmpty() || to <= from)
        return {};
    Points points{at(from)};
    for (std::size_t i = 0; i < m_points.size(); ++i)
        if (m_lengths[i] > from && m_lengths[i] < to)
            points.push_back(m_points[i]);
    points.push_back(at(to));
    return points;
}

std::size_t anchorCount(PathKind kind, std::size_t points)
{
    return kind == PathKind::Bezier ? (points + 2) / 3 : points;
}

std::size_t anchorIndex(PathKind kind, std::size_t anchor)
{
    return kind == PathKind::Bezier ? 3 * anchor : anchor;
}

bool isHandle(PathKind kind, std::size_t point)
{
    return kind == PathKind::Bezier && point % 3 != 0;
}

std::size_t anchorOf(PathKind kind, std::size_t point)
{
    return kind == PathKind::Bezier ? (point + 1) / 3 : point;
}

std::size_t oppositeHandle(std::size_t handle, std::size_t points)
{
    const bool isAfter = handle % 3 == 1;
    if (isAfter && handle < 2)
        return handle;
    const std::size_t other = isAfter ? handle - 2 : handle + 2;
    return other < points ? other : handle;
}

std::vector<std::size_t> anchorSamples(PathKind kind, const std::vector<QVector3D>& points,
                                       const std::vector<QVector3D>& samples)
{
    constexpr float same = 1e-5F; // metres
    std::vector<std::size_t> places;
    std::size_t place = 0;
    for (const QVector3D& anchor : anchorsOf(kind, points)) {
        std::size_t found = place;
        while (found < samples.size() && (samples[found] - anchor).length() > same)
            ++found;
        if (found < samples.size())
            place = found;
        places.push_back(place);
    }
    return places;
}

std::vector<QVector3D> movedPoint(PathKind kind, std::vector<QVector3D> points, std::size_t point,
                                  const QVector3D& place, bool mirrored)
{
    const QVector3D shift = place - points[point];
    points[point] = place;
    if (kind != PathKind::Bezier)
        return points;
    if (!isHandle(kind, point)) {
        if (point > 0)
            points[point - 1] += shift;
        if (point + 1 < points.size())
            points[point + 1] += shift;
    } else if (const std::size_t opposite = oppositeHandle(point, points.size());
               mirrored && opposite != point) {
        const QVector3D anchor = points[anchorIndex(kind, anchorOf(kind, point))];
        const float reach = (points[opposite] - anchor).length();
        const QVector3D direction = (anchor - place).normalized();
        if (!direction.isNull())
            points[opposite] = anchor + reach * direction;
    }
    return points;
}

std::vector<QVector3D> appendedPoint(PathKind kind, std::vector<QVector3D> points, const QVector3D& place)
{
    if (kind == PathKind::Bezier && !points.empty()) {
        const QVector3D from = points.back();
        const float reach = (place - from).length() / 3.0F;
        QVector3D direction = (place - from).normalized();
        if (points.size() > 1) {
            const QVector3D onwards = from - points[points.size() - 2];
            if (onwards.length() > 1e-5F)
                direction = onwards.normalized();
        }
        const QVector3D first = from + reach * direction;
        points.push_back(first);
        points.push_back(place - reach * (place - first).normalized());
    }
    points.push_back(place);
    return points;
}

std::vector<QVector3D> insertedPoint(PathKind kind, std::vector<QVector3D> points, std::size_t anchor,
                                     float t, const QVector3D& place)
{
    if (kind != PathKind::Bezier) {
        points.insert(points.begin() + offset(anchor) + 1, place);
        return points;
    }
    // De Casteljau's division of the segment.
    const auto between = [t](const QVector3D& a, const QVector3D& b) { return a + t * (b - a); };
    const std::size_t first = 3 * anchor;
    const QVector3D a = between(points[first], points[first + 1]);
    const QVector3D b = between(points[first + 1], points[first + 2]);
    const QVector3D c = between(points[first + 2], points[first + 3]);
    const QVector3D ab = between(a, b);
    const QVector3D bc = between(b, c);
    points[first + 1] = a;
    points[first + 2] = c;
    const Points middle{ab, between(ab, bc), bc};
    points.insert(points.begin() + offset(first) + 2, middle.begin(), middle.end());
    return points;
}

float nearestParameter(const std::vector<QVector3D>& points, std::size_t anchor, const QVector3D& place)
{
    const QVector3D* p = &points[3 * anchor];
    const auto distanceAt = [&](float t) {
        const float s = 1.0F - t;
        const QVector3D at =
            s * s * s * p[0] + 3.0F * s * s * t * p[1] + 3.0F * s * t * t * p[2] + t * t * t * p[3];
        return (at - place).lengthSquared();
    };
    constexpr int steps = 64;
    float best = 0.0F;
    for (int i = 1; i <= steps; ++i) {
        const float t = static_cast<float>(i) / steps;
        if (distanceAt(t) < distanceAt(best))
            best = t;
    }
    for (float step = 0.5F / steps; step > 1e-5F; step /= 2.0F) {
        for (const float t : {best - step, best + step})
            if (t > 0.0F && t < 1.0F && distanceAt(t) < distanceAt(best))
                best = t;
    }
    return best;
}

bool isSmooth(const std::vector<QVector3D>& points, std::size_t anchor)
{
    const std::size_t index = 3 * anchor;
    if (index == 0 || index + 1 >= points.size())
        return false;
    const QVector3D before = (points[index] - points[index - 1]).normalized();
    const QVector3D after = (points[index + 1] - points[index]).normalized();
    constexpr float oneDegree = 0.99985F;
    return QVector3D::dotProduct(before, after) > oneDegree;
}

std::vector<QVector3D> smoothedAnchor(std::vector<QVector3D> points, std::size_t anchor)
{
    const std::size_t index = 3 * anchor;
    if (index == 0 || index + 1 >= points.size())
        return points;
    const QVector3D before = points[index] - points[index - 1];
    const QVector3D after = points[index + 1] - points[index];
    QVector3D direction = (before.normalized() + after.normalized()).normalized();
    if (direction.isNull())
        direction = after.normalized();
    points[index - 1] = points[index] - before.length() * direction;
    points[index + 1] = points[index] + after.length() * direction;
    return points;
}

std::vector<QVector3D> removedAnchor(PathKind kind, std::vector<QVector3D> points, std::size_t anchor)
{
    const std::size_t count = anchorCount(kind, points.size());
    if (count <= 2)
        return {};
    const std::size_t index = anchorIndex(kind, anchor);
    if (kind != PathKind::Bezier) {
        points.erase(points.begin() + offset(index));
        return points;
    }
    const std::size_t first = anchor == 0 ? 0 : anchor + 1 == count ? index - 2 : index - 1;
    points.erase(points.begin() + offset(first), points.begin() + offset(first) + 3);
    return points;
}

std::vector<QVector3D> convertedPoints(const std::vector<QVector3D>& points, PathKind from, PathKind to)
{
    const bool hadHandles = from == PathKind::Bezier;
    const bool hasHandles = to == PathKind::Bezier;
    if (hadHandles == hasHandles)
        return points;
    const Points anchors = anchorsOf(from, points);
    return hasHandles ? withHandles(anchors) : anchors;
}

std::vector<QVector3D> widenedOutline(const PathObstacle& obstacle, float distance, const QVector3D& up)
{
    if (obstacle.isDisc())
        return circleOnGround(obstacle.corners.front(), obstacle.radius + distance, up);
    Points outline = obstacle.corners;
    const std::size_t count = outline.size();
    const auto corner = [&](std::size_t i) { return outline[i % count]; };
    QVector3D area;
    for (std::size_t i = 0; i < count; ++i)
        area += QVector3D::crossProduct(corner(i) - corner(0), corner(i + 1) - corner(0));
    if (QVector3D::dotProduct(area, up) < 0.0F)
        std::reverse(outline.begin(), outline.end());
    Points wide;
    for (std::size_t i = 0; i < count; ++i) {
        const auto outwards = [&](const QVector3D& from, const QVector3D& to) {
            return QVector3D::crossProduct(to - from, up).normalized();
        };
        const QVector3D first = outwards(corner(i + count - 1), corner(i));
        const QVector3D second = outwards(corner(i), corner(i + 1));
        const float turn = QVector3D::dotProduct(QVector3D::crossProduct(first, second), up);
        if (turn < 0.0F) { // an inner corner
            wide.push_back(corner(i) + distance * (first + second).normalized());
            continue;
        }
        constexpr int steps = 6;
        for (int step = 0; step <= steps; ++step) {
            const float t = static_cast<float>(step) / steps;
            wide.push_back(corner(i) + distance * ((1.0F - t) * first + t * second).normalized());
        }
    }
    return wide;
}

std::vector<QVector3D> reversedPoints(std::vector<QVector3D> points)
{
    std::reverse(points.begin(), points.end());
    return points;
}

std::vector<QVector3D> simplifiedStroke(const std::vector<QVector3D>& stroke, float tolerance)
{
    if (stroke.size() < 3)
        return stroke;
    Points kept{stroke.front()};
    simplify(stroke, 0, stroke.size() - 1, tolerance, kept);
    kept.push_back(stroke.back());
    return kept;
}

} // namespace quadrille::widgets
