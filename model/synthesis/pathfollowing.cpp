// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/pathfollowing.h"

#include "model/synthesis/pathcourse.h"

namespace quadrille {

std::vector<FollowedFrame> followPath(const PathConstraint& path, const ClipPlan& plan)
{
    const PathCourse course(path, plan.up);
    const Ground ground(plan.up);
    const auto inSpace = [&](const Vec3d& point) { return ground.at(point.head<2>(), point.z()); };
    std::vector<FollowedFrame> frames;
    frames.reserve(plan.frames.size());
    double walked = 0;
    Vec3d before = Vec3d::Zero();
    for (const PlannedFrame& frame : plan.frames) {
        const Vec3d point = course.pointOf(frame.centre);
        if (!frames.empty())
            walked += (point - before).norm();
        before = point;
        frames.push_back({.centre = inSpace(point), .wanted = inSpace(course.at(walked))});
    }
    return frames;
}

} // namespace quadrille
