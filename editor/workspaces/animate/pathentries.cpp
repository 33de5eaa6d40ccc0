// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathentries.h"

#include "model/project/document/groundpoint.h"
#include "model/project/document/pathcurve.h"
#include "model/synthesis/walks/pathcourse.h"
#include "widgets/tools/pathgeometry.h"
#include "widgets/viewport/ruler.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double shortestSpan = 0.01; // metres
/// Decimals in metres: what the hand does not mean should not stand in the file.
constexpr int finest = 4;

/// The lengths at which a curve passes its points, last its own length.
std::vector<double> anchorLengths(const PathEntry& path, double metresPerUnit)
{
    const PathSpace space{.up = UpAxis::Y};
    const auto points = space.toView(path.points, false);
    const widgets::SampledCurve curve(space.toView(curveOf(path, metresPerUnit), false));
    std::vector<double> lengths;
    if (curve.isEmpty())
        return lengths;
    for (const std::size_t sample : widgets::anchorSamples(kindOf(path.curve), points, curve.points()))
        lengths.push_back(curve.lengthAt(sample));
    return lengths;
}

/// A length between the same two points as before, and as far between them.
double carried(double length, const std::vector<double>& before, const std::vector<double>& after)
{
    const auto next = std::upper_bound(before.begin(), before.end(), length);
    const auto index = static_cast<std::size_t>(next - before.begin());
    if (index == 0 || next == before.end() || index >= after.size())
        return after.empty() || before.empty()
                   ? length
                   : length - before.back() + after[std::min(index, after.size()) - 1];
    const double t = (length - before[index - 1]) / (before[index] - before[index - 1]);
    return after[index - 1] + t * (after[index] - after[index - 1]);
}

int axisOf(UpAxis up)
{
    return static_cast<int>(up);
}

} // namespace

const PathEntry* findPath(const AnimationEntry& animation)
{
    for (const ConstraintEntry& constraint : animation.constraints)
        if (const auto* path = std::get_if<PathEntry>(&constraint))
            return path;
    return nullptr;
}

PathEntry* findPath(AnimationEntry& animation)
{
    for (ConstraintEntry& constraint : animation.constraints)
        if (auto* path = std::get_if<PathEntry>(&constraint))
            return path;
    return nullptr;
}

void removePath(AnimationEntry& animation)
{
    std::erase_if(animation.constraints, [](const ConstraintEntry& constraint) {
        return std::holds_alternative<PathEntry>(constraint);
    });
}

widgets::PathKind kindOf(PathCurve curve)
{
    switch (curve) {
    case PathCurve::Polyline:
        return widgets::PathKind::Polyline;
    case PathCurve::Bezier:
        return widgets::PathKind::Bezier;
    case PathCurve::CatmullRom:
        break;
    }
    return widgets::PathKind::CatmullRom;
}

PathCurve curveOf(widgets::PathKind kind)
{
    switch (kind) {
    case widgets::PathKind::Polyline:
        return PathCurve::Polyline;
    case widgets::PathKind::Bezier:
        return PathCurve::Bezier;
    case widgets::PathKind::CatmullRom:
        break;
    }
    return PathCurve::CatmullRom;
}

QVector3D PathSpace::toView(const Vec3d& point, bool onGround) const
{
    const Eigen::Vector3f single = point.cast<float>();
    QVector3D shown(single.x(), single.y(), single.z());
    if (onGround)
        shown[axisOf(up)] = ground;
    return shown;
}

Vec3d PathSpace::fromView(const QVector3D& point, bool onGround) const
{
    const widgets::Ruler ruler(metresPerUnit);
    Vec3d result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = ruler.rounded(static_cast<double>(point[axis]), finest);
    if (onGround)
        result[axisOf(up)] = 0;
    return result;
}

QVector3D PathSpace::toView(const Vec2d& corner) const
{
    return toView(pointOnGround(corner, up), true);
}

Vec2d PathSpace::groundFromView(const QVector3D& point) const
{
    const Vec3d whole = fromView(point, true);
    Vec2d corner;
    for (int axis = 0, next = 0; axis < 3; ++axis)
        if (axis != axisOf(up))
            corner[next++] = whole[axis];
    return corner;
}

std::vector<QVector3D> PathSpace::toView(const std::vector<Vec3d>& points, bool onGround) const
{
    std::vector<QVector3D> shown;
    shown.reserve(points.size());
    for (const Vec3d& point : points)
        shown.push_back(toView(point, onGround));
    return shown;
}

std::vector<Vec3d> PathSpace::fromView(const std::vector<QVector3D>& points, bool onGround) const
{
    std::vector<Vec3d> own;
    own.reserve(points.size());
    for (const QVector3D& point : points)
        own.push_back(fromView(point, onGround));
    return own;
}

std::vector<Vec3d> PathSpace::fromView(const std::vector<QVector3D>& points, const PathEntry& before) const
{
    const std::vector<QVector3D> shown = toView(before.points, !before.inSpace);
    std::vector<Vec3d> own;
    own.reserve(points.size());
    for (const QVector3D& point : points) {
        const auto known = std::find(shown.begin(), shown.end(), point);
        own.push_back(known == shown.end() ? fromView(point, !before.inSpace)
                                           : before.points[static_cast<std::size_t>(known - shown.begin())]);
    }
    return own;
}

widgets::PathSampler PathSpace::sampler() const
{
    return [metres = metresPerUnit](widgets::PathKind kind, const std::vector<QVector3D>& points) {
        std::vector<Vec3d> own;
        own.reserve(points.size());
        for (const QVector3D& point : points)
            own.emplace_back(point.x(), point.y(), point.z());
        std::vector<QVector3D> samples;
        for (const Vec3d& point : curveOf(curveOf(kind), own, metres)) {
            const Eigen::Vector3f single = point.cast<float>();
            samples.emplace_back(single.x(), single.y(), single.z());
        }
        return samples;
    };
}

widgets::PathObstacle PathSpace::toView(const ObstacleEntry& obstacle) const
{
    widgets::PathObstacle shown;
    for (const Vec2d& corner : obstacle.corners)
        shown.corners.push_back(toView(corner));
    shown.radius = static_cast<float>(obstacle.radius);
    return shown;
}

ObstacleEntry PathSpace::fromView(const widgets::PathObstacle& obstacle, ObstacleEntry before) const
{
    const widgets::Ruler ruler(metresPerUnit);
    before.corners.clear();
    for (const QVector3D& corner : obstacle.corners)
        before.corners.push_back(groundFromView(corner));
    before.radius = obstacle.isDisc() ? ruler.rounded(static_cast<double>(obstacle.radius), finest) : 0;
    return before;
}

double lengthOf(const PathEntry& path, double metresPerUnit)
{
    const std::vector<Vec3d> curve = curveOf(path, metresPerUnit);
    double length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (curve[i] - curve[i - 1]).norm();
    return length;
}

PathEntry withPoints(const PathEntry& before, std::vector<Vec3d> points, double metresPerUnit)
{
    PathEntry after = before;
    after.points = std::move(points);
    if (before.spans.empty())
        return after;
    const auto old = anchorLengths(before, metresPerUnit);
    const auto now = anchorLengths(after, metresPerUnit);
    // A point between others changes the curve little, so that lengths stay what they are.
    const bool isSameStart = now.size() == old.size() ||
                             (now.size() > old.size() && !before.points.empty() &&
                              std::equal(before.points.begin(), before.points.end(), after.points.begin()));
    if (!isSameStart)
        return after;
    for (PathSpanEntry& span : after.spans) {
        span.from = std::max(0.0, carried(span.from, old, now));
        span.to = std::max(span.from + shortestSpan / metresPerUnit, carried(span.to, old, now));
    }
    return after;
}

PathEntry withCurve(const PathEntry& before, PathCurve curve, double metresPerUnit)
{
    const PathSpace space{.up = UpAxis::Y, .metresPerUnit = metresPerUnit};
    const auto points =
        widgets::convertedPoints(space.toView(before.points, false), kindOf(before.curve), kindOf(curve));
    PathEntry after = before;
    after.curve = curve;
    after.points = space.fromView(points, false);
    const auto old = anchorLengths(before, metresPerUnit);
    const auto now = anchorLengths(after, metresPerUnit);
    for (PathSpanEntry& span : after.spans) {
        span.from = std::max(0.0, carried(span.from, old, now));
        span.to = std::max(span.from + shortestSpan / metresPerUnit, carried(span.to, old, now));
    }
    return after;
}

PathEntry withSpace(const PathEntry& before, bool inSpace, UpAxis up, double height)
{
    PathEntry after = before;
    after.inSpace = inSpace;
    for (Vec3d& point : after.points)
        point[axisOf(up)] = !inSpace ? 0 : before.inSpace ? point[axisOf(up)] : height;
    return after;
}

PathEntry reversed(const PathEntry& before, double metresPerUnit)
{
    PathEntry after = before;
    const double length = lengthOf(before, metresPerUnit);
    std::reverse(after.points.begin(), after.points.end());
    std::reverse(after.spans.begin(), after.spans.end());
    for (PathSpanEntry& span : after.spans) {
        const double from = std::max(0.0, length - span.to);
        span.to = std::max(from + shortestSpan / metresPerUnit, length - span.from);
        span.from = from;
    }
    return after;
}

PathEntry closed(const PathEntry& before)
{
    if (isClosed(before) || before.points.empty())
        return before;
    const PathSpace space{.up = UpAxis::Y};
    const auto points = space.toView(before.points, false);
    PathEntry after = before;
    after.points =
        space.fromView(widgets::appendedPoint(kindOf(before.curve), points, points.front()), false);
    after.points.back() = after.points.front();
    return after;
}

bool isClosed(const PathEntry& path)
{
    return path.points.size() > 2 && path.points.front() == path.points.back();
}

bool blocksAnEnd(const PathEntry& path, const ObstacleEntry& obstacle, UpAxis up)
{
    if (path.points.size() < 2 || obstacle.corners.empty())
        return false;
    const Ground ground(up);
    Obstacle own{.radius = obstacle.radius};
    for (const Vec2d& corner : obstacle.corners)
        own.outline.push_back(ground.of(pointOnGround(corner, up)));
    const auto isBlocked = [&](const Vec3d& point) {
        const double distance = distanceFrom(own, ground.of(point));
        return distance <= 0 || distance < path.clearance;
    };
    return isBlocked(path.points.front()) || isBlocked(path.points.back());
}

} // namespace quadrille
