// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/walks/pathcourse.h"
#include "model/synthesis/walks/walkgraph.h"

#include <functional>
#include <memory>
#include <span>

namespace quadrille {

/// What walks need to know of how frames move over the ground.
struct WalkMotion
{
    const RootPoses* roots = nullptr;
    /// The warp path of a transition that the graph has; called once for each, while it is looked at.
    std::function<Transition(const FramePair&)> transition;
    BlendSettings blend;      ///< how transitions will be blended
    double metresPerUnit = 1; ///< of the coordinates of the roots
    double fps = 0;           ///< 0: nobody asks how even the pace is
};

/// What transitions weigh beyond their moves, for what they show.
struct ShownCharges
{
    double uneven = 0;               ///< of an uneven pace (SearchSettings::unevenWeight · α)
    std::vector<double> frames = {}; ///< of each captured frame, as far as it shows; empty: none
};

/// How the moves of a graph go over the ground, in metres, each computed when it is first asked for.
class MoveMotions
{
public:
    /// An output frame of a move, in the coordinates in which the frame that it leaves lies as captured.
    struct Step
    {
        Eigen::Vector3f point; ///< as PathCourse: ground x, ground y, height or 0
        float arcLength = 0;   ///< walked since the frame that it leaves, metres
        NodeIndex source = 0;  ///< frames that are blended; equal for a captured frame
        NodeIndex destination = 0;
    };
    struct Motion
    {
        std::vector<Step> steps;     ///< as many as frames go by, without the frame that it leaves
        GroundMotion exit;           ///< places the frame that it comes to as captured
        double weight = 0;           ///< of a transition beyond that of its move (ShownCharges)
        Vec2d begin = Vec2d::Zero(); ///< of the frame that it leaves
        double heading = 0;          ///< of the way at its end, in the coordinates of the steps, radians
        bool isKnown = false;
    };

    MoveMotions(const WalkGraph& graph, const WalkMotion& motion, const PathCourse& course,
                ShownCharges charges = {});

    const Motion& of(MoveIndex move);
    /// Computes the motions of some moves, [begin, end) or given ones, on all cores; `of` is then free. What
    /// it computes does not depend on when.
    void prepare(MoveIndex begin, MoveIndex end);
    void prepare(std::vector<MoveIndex> moves);
    /// Where a captured frame lies.
    const Vec3d& point(NodeIndex node) const { return m_points[static_cast<std::size_t>(node)]; }
    /// Metres that are walked between two frames of a sequence as captured; less than 0 towards the front.
    double wayBetween(NodeIndex from, NodeIndex to) const
    {
        return m_arcLengths[static_cast<std::size_t>(to)] - m_arcLengths[static_cast<std::size_t>(from)];
    }
    /// Metres that can still be walked from a frame: without bounds where a transition leaves it or one
    /// behind it, otherwise to the end of its sequence.
    double walkableFrom(NodeIndex node) const { return m_walkable[static_cast<std::size_t>(node)]; }
    /// See quadrille::headingAt.
    double headingAt(NodeIndex node) const { return m_headings[static_cast<std::size_t>(node)]; }
    /// Turns and places a frame so that it stands on the beginning of the course and what was captured around
    /// it goes along.
    GroundMotion placedOnStart(NodeIndex node) const;

private:
    void compute(MoveIndex index, Motion& motion) const;
    double unevennessOf(const WalkMove& move, const Motion& motion) const;
    double weightOfFrames(const Transition& transition, const TransitionMotion& moved) const;

    const WalkGraph& m_graph;
    const WalkMotion& m_motion;
    const PathCourse& m_course;
    ShownCharges m_charges;
    std::vector<Vec3d> m_points;
    std::vector<double> m_arcLengths; ///< from the first frame on
    std::vector<double> m_walkable;
    std::vector<double> m_headings;
    std::vector<Motion> m_motions;
};

} // namespace quadrille
