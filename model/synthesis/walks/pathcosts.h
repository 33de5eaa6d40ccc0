// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/movemotions.h"
#include "model/synthesis/walks/pathsteering.h"

#include <optional>
#include <vector>

namespace quadrille {

/// Where a walk is along a path.
struct PathPlace
{
    GroundMotion placement;       ///< of the frame that it has come to, as captured
    double walked = 0;            ///< metres
    std::int32_t timed = 0;       ///< the timed span that is not behind it yet
    std::int32_t timedFrames = 0; ///< output frames in it so far
};

/// What output frames cost on a path.
struct PathCharge
{
    double deviation = 0; ///< of squared distances, by PathCharging
    double timing = 0;    ///< β · timing errors of the spans that were left behind
    double edges = 0;     ///< weight of transitions beyond that of their moves (MoveMotions::Motion::weight)

    /// \param mu  weight of edges.
    double total(double mu) const { return deviation + timing + mu * edges; }
};

/// Why a walk cannot go on.
struct PathFailure
{
    double reached = -1; ///< metres of the path
    int obstacle = -1;
    int span = -1; ///< whose demand is not met
};

/// The costs of following a path, and what it forbids.
class PathCosts
{
public:
    PathCosts(const PathCourse& course, const std::vector<PathSpan>& spans, NodeIndex nodes, double beta,
              const PathCharging& charging = {}, const SteeringLimits& steering = {});

    /// The first frame of a walk. \return whether it may be there.
    bool begin(const MoveMotions& motions, NodeIndex node, PathPlace& place, PathCharge& charge) const;
    /// Goes on by the frames of a move, turned towards the path (PathSteering).
    /// \param rotation  that of the placement. \param failure  of the walk that came farthest.
    /// \param points  receives where its frames are, where somebody asks.
    /// \return whether all of them may be there.
    bool follow(const MoveMotions::Motion& motion, const Eigen::Matrix2d& rotation, PathPlace& place,
                PathCharge& charge, PathFailure& failure, std::vector<Vec3d>* points = nullptr) const;
    /// What timed spans that the walk has not left cost in the end.
    double timingAtEnd(const PathPlace& place) const;
    double distance(const Vec3d& point, double walked) const { return (point - m_course.at(walked)).norm(); }
    /// What a frame costs by where it is. \param step  metres walked since the frame before.
    double deviation(const Vec3d& point, double walked, double step) const
    {
        return deviation(distance(point, walked), step, 1);
    }
    /// What it costs to be off the path. \param off  so far, metres. \param way  for so long, metres walked,
    /// \param frames  and in so many output frames.
    double deviation(double off, double way, double frames) const
    {
        const double counted = std::max(0.0, off - m_charging.deadZone);
        return counted * counted * factor(way, frames);
    }
    double deadZone() const { return m_charging.deadZone; }
    /// What the squared distance beyond the dead zone counts, there.
    double factor(double way, double frames) const
    {
        return m_charging.perMetre > 0 ? m_charging.perMetre * way : frames;
    }
    /// The span that demands frames so far along the path and that neither of two captured ones is of; −1:
    /// none.
    int missedSpan(double walked, NodeIndex source, NodeIndex destination) const;
    /// Whether timed spans are left.
    bool needsTime(const PathPlace& place) const
    {
        return static_cast<std::size_t>(place.timed) < m_timed.size();
    }
    const PathSteering& steering() const { return m_steering; }
    /// Frames that the walk is late in its timed span, if it goes on evenly.
    double lateness(const PathPlace& place) const;

private:
    struct Demand
    {
        double from = 0;
        double to = 0;
        int span = 0;
        std::vector<bool> frames; ///< by node
    };
    struct Timed
    {
        double from = 0;
        double to = 0;
        double duration = 0;
    };
    struct Shown
    {
        Vec3d point;
        double walked = 0; ///< metres
        double step = 0;   ///< of them, since the frame before
        NodeIndex source = 0;
        NodeIndex destination = 0;
    };
    /// Why a frame that shows one or two captured ones may not be there; nothing where it may.
    std::optional<PathFailure> obstruction(const Vec3d& point, double walked, NodeIndex source,
                                           NodeIndex destination) const;
    bool admit(const Shown& frame, PathPlace& place, PathCharge& charge, PathFailure& failure) const;

    double turnOf(const MoveMotions::Motion& motion, const Eigen::Matrix2d& rotation,
                  const PathPlace& place) const;

    const PathCourse& m_course;
    std::vector<Demand> m_demands;
    std::vector<Timed> m_timed; ///< by their beginnings
    double m_beta;
    PathCharging m_charging;
    PathSteering m_steering;
};

} // namespace quadrille
