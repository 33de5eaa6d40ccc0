// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/pathrequest.h"

#include "model/project/document/groundpoint.h"
#include "model/project/document/pathcurve.h"
#include "model/synthesis/clips/ground.h"

namespace quadrille {

PathConstraint curveInMetres(const PathEntry& path, double metresPerUnit)
{
    PathConstraint constraint{.points = curveOf(path, metresPerUnit), .inSpace = path.inSpace};
    for (Vec3d& point : constraint.points)
        point *= metresPerUnit;
    return constraint;
}

PathConstraint pathInMetres(const PathEntry& path, const CoordinateSystem& axes)
{
    const double metres = axes.metresPerUnit;
    const Ground ground(axes.up);
    PathConstraint constraint = curveInMetres(path, metres);
    for (std::size_t i = 0; i < path.obstacles.size(); ++i) {
        const ObstacleEntry& entry = path.obstacles[i];
        Obstacle obstacle{.name = std::to_string(i + 1),
                          .radius = entry.isDisc() ? entry.radius * metres : 0,
                          .clearance = path.clearance * metres};
        for (const Vec2d& corner : entry.corners)
            obstacle.outline.push_back(ground.of(pointOnGround(corner * metres, axes.up)));
        constraint.obstacles.push_back(std::move(obstacle));
    }
    return constraint;
}

} // namespace quadrille
