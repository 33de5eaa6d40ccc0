// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "widgets/tools/pathshape.h"

namespace quadrille {

/// The path among what is asked of an animation; null without one.
const PathEntry* findPath(const AnimationEntry& animation);
PathEntry* findPath(AnimationEntry& animation);
void removePath(AnimationEntry& animation);

widgets::PathKind kindOf(PathCurve curve);
PathCurve curveOf(widgets::PathKind kind);

/// Between the coordinates of a project and those of a view that shows it. Both are in the project's unit and
/// axes; a view has single precision and the ground where it draws it.
struct PathSpace
{
    UpAxis up = UpAxis::Y;
    float ground = 0; ///< height of the view's ground
    double metresPerUnit = 1;

    /// \param onGround  whether its height is that of the ground, which the project calls 0.
    QVector3D toView(const Vec3d& point, bool onGround) const;
    /// Rounded to tenths of a millimetre, or what is nearest to them in the project's unit.
    Vec3d fromView(const QVector3D& point, bool onGround) const;
    QVector3D toView(const Vec2d& corner) const;
    Vec2d groundFromView(const QVector3D& point) const;

    std::vector<QVector3D> toView(const std::vector<Vec3d>& points, bool onGround) const;
    std::vector<Vec3d> fromView(const std::vector<QVector3D>& points, bool onGround) const;
    /// Points that a path has already stay exactly what they are.
    std::vector<Vec3d> fromView(const std::vector<QVector3D>& points, const PathEntry& before) const;
    /// Samples curves of a view as walks follow them. It may be kept longer than this.
    widgets::PathSampler sampler() const;
    widgets::PathObstacle toView(const ObstacleEntry& obstacle) const;
    /// \param before  gives what a view does not know.
    ObstacleEntry fromView(const widgets::PathObstacle& obstacle, ObstacleEntry before = {}) const;
};

/// The length of the curve that a path follows, in the unit of its points.
double lengthOf(const PathEntry& path, double metresPerUnit);
/// The path with other points; its spans stay at the points that they were next to. Where points were taken
/// from the end they stay as long as they are.
PathEntry withPoints(const PathEntry& before, std::vector<Vec3d> points, double metresPerUnit);
/// The path of another kind through the same points; handles are made or left out.
PathEntry withCurve(const PathEntry& before, PathCurve curve, double metresPerUnit);
/// The path on the ground, or in space. Points that are in space already keep their height. \param height  of
/// points that come from the ground.
PathEntry withSpace(const PathEntry& before, bool inSpace, UpAxis up, double height);
/// The path the other way round, with its spans.
PathEntry reversed(const PathEntry& before, double metresPerUnit);
/// The path that ends where it began. One that does already, or has no points, is given back as it is.
PathEntry closed(const PathEntry& before);
/// Whether the path has more than two points, and the last is exactly the first.
bool isClosed(const PathEntry& path);
/// Whether an end of the path is in the way of an obstacle, so that no walk can begin or end there. Within
/// the path's clearance is in the way, too. False for a path of fewer than two points.
bool blocksAnEnd(const PathEntry& path, const ObstacleEntry& obstacle, UpAxis up);

} // namespace quadrille
