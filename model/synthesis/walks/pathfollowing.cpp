// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathfollowing.h"

#include "model/synthesis/walks/pathcourse.h"

namespace quadrille {

std::vector<FollowedFrame> followPath(const PathConstraint& path, const ClipPlan& plan, double metresPerUnit)
{
    const PathCourse course(path, plan.up, metresPerUnit);
    const Ground ground(plan.up);
    const auto inClip = [&](const Vec3d& point) -> Vec3d {
        return ground.at(point.head<2>(), point.z()) / metresPerUnit;
    };
    std::vector<FollowedFrame> frames;
    frames.reserve(plan.frames.size());
    double walked = 0;
    Vec3d before = Vec3d::Zero();
    for (const PlannedFrame& frame : plan.frames) {
        const Vec3d point = course.pointOf(frame.centre);
        if (!frames.empty())
            walked += (point - before).norm();
        before = point;
        const Vec3d wanted = course.at(walked);
        frames.push_back(
            {.centre = inClip(point), .wanted = inClip(wanted), .deviation = (point - wanted).norm()});
    }
    return frames;
}

} // namespace quadrille
