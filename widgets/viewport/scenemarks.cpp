// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/scenemarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace quadrille::widgets {

namespace {

struct Point
{
    float x = 0.0F;
    float y = 0.0F;
};

/// Two directions of the plane with this normal; the second a quarter turn from the first.
std::pair<QVector3D, QVector3D> directions(const QVector3D& up)
{
    const QVector3D first = std::abs(up.x()) > 0.5F ? QVector3D(0, 1, 0) : QVector3D(1, 0, 0);
    return {first, QVector3D::crossProduct(up, first).normalized()};
}

std::vector<Point> flatten(const std::vector<QVector3D>& outline, const QVector3D& up)
{
    const auto [first, second] = directions(up);
    std::vector<Point> points;
    points.reserve(outline.size());
    for (const QVector3D& corner : outline)
        points.push_back({QVector3D::dotProduct(corner, first), QVector3D::dotProduct(corner, second)});
    return points;
}

float twiceArea(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isInside(const Point& p, const Point& a, const Point& b, const Point& c)
{
    return twiceArea(a, b, p) >= 0.0F && twiceArea(b, c, p) >= 0.0F && twiceArea(c, a, p) >= 0.0F;
}

} // namespace

std::vector<QVector3D> circleOnGround(const QVector3D& centre, float radius, const QVector3D& up, int corners)
{
    const auto [first, second] = directions(up);
    std::vector<QVector3D> circle;
    circle.reserve(static_cast<std::size_t>(corners));
    for (int i = 0; i < corners; ++i) {
        const float angle =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
        circle.push_back(centre + radius * (std::cos(angle) * first + std::sin(angle) * second));
    }
    return circle;
}

std::vector<int> triangulate(const std::vector<QVector3D>& outline, const QVector3D& up)
{
    const std::vector<Point> points = flatten(outline, up);
    std::vector<int> left(points.size());
    std::iota(left.begin(), left.end(), 0);
    float area = 0.0F;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& next = points[(i + 1) % points.size()];
        area += points[i].x * next.y - next.x * points[i].y;
    }
    if (area < 0.0F)
        std::reverse(left.begin(), left.end());
    const auto at = [&](std::size_t i) -> const Point& {
        return points[static_cast<std::size_t>(left[i % left.size()])];
    };
    const auto isEar = [&](std::size_t i) {
        const std::size_t count = left.size();
        const Point& before = at(i + count - 1);
        const Point& after = at(i + 1);
        if (twiceArea(before, at(i), after) <= 0.0F)
            return false;
        for (std::size_t k = 2; k + 1 < count; ++k)
            if (isInside(at(i + k), before, at(i), after))
                return false;
        return true;
    };
    std::vector<int> triangles;
    while (left.size() >= 3) {
        const std::size_t count = left.size();
        std::size_t ear = 0;
        while (ear + 1 < count && !isEar(ear))
            ++ear;
        for (const std::size_t corner : {ear + count - 1, ear, ear + 1})
            triangles.push_back(left[corner % count]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

std::vector<QVector3D> hatchLines(const std::vector<QVector3D>& outline, const QVector3D& up, float spacing)
{
    if (outline.size() < 3)
        return {};
    const auto [first, second] = directions(up);
    const QVector3D across = (first + second).normalized(); // along this the lines follow each other
    const QVector3D along = (second - first).normalized();
    float lowest = QVector3D::dotProduct(outline.front(), across);
    float highest = lowest;
    for (const QVector3D& corner : outline) {
        lowest = std::min(lowest, QVector3D::dotProduct(corner, across));
        highest = std::max(highest, QVector3D::dotProduct(corner, across));
    }
    std::vector<QVector3D> lines;
    std::vector<std::pair<float, QVector3D>> crossings;
    for (float level = std::ceil(lowest / spacing) * spacing; level < highest; level += spacing) {
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const QVector3D& a = outline[i];
            const QVector3D& b = outline[(i + 1) % outline.size()];
            const float from = QVector3D::dotProduct(a, across) - level;
            const float to = QVector3D::dotProduct(b, across) - level;
            if ((from < 0.0F) == (to < 0.0F))
                continue;
            const QVector3D place = a + from / (from - to) * (b - a);
            crossings.emplace_back(QVector3D::dotProduct(place, along), place);
        }
        std::sort(crossings.begin(), crossings.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            lines.push_back(crossings[i].second);
            lines.push_back(crossings[i + 1].second);
        }
    }
    return lines;
}

} // namespace quadrille::widgets
