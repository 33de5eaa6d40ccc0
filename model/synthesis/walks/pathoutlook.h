// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/walks/pathcosts.h"
#include "model/synthesis/walks/pathstretches.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace quadrille {

/// About what a walk along a path still costs, from anywhere near it: the least cost to the end between
/// states on a coarse grid of captured frame, way walked, distance to the left of the path and heading
/// against it, backwards along the path (Bellman's recursion). It knows how each take can turn back, how far
/// the walk may be steered, and what leads into a bend before it comes. Keys, actions and timed spans do not
/// count. It says where to look first; it is no bound.
class PathOutlook
{
public:
    /// \param mu  weight of edges. \param leastRun  captured frames between two transitions.
    /// \throws Error Cancelled.
    PathOutlook(const WalkGraph& graph, const PathCourse& course, const PathCosts& costs,
                MoveMotions& motions, double mu, int leastRun, const Progress& progress = {});

    /// From a captured frame of a take that is placed so. \param walked  metres.
    double cost(NodeIndex node, double walked, const GroundMotion& placement) const;

private:
    static constexpr int headingCount = 21;
    static constexpr int sidesEach = 5;
    static constexpr int sideCount = 2 * sidesEach + 1;
    using Headings = Eigen::Array<float, headingCount, 1>;
    /// Costs by heading and distance to the left.
    using Cells = Eigen::Array<float, headingCount, sideCount>;

    /// How a take as captured is turned so that it heads along the path: each heading in turn.
    struct Facing
    {
        double first = 0; ///< radians
        Headings cosines;
        Headings sines;
    };
    /// What a stretch costs, and how far its end is from that of the path's way: along it, and to its left.
    struct Passage
    {
        Cells costs;
        Headings along;
        Headings left;
    };

    /// The way of the path while a stretch is walked from a layer on.
    struct Bend
    {
        std::vector<Vec3d> ways; ///< of its samples, from where it begins, along the path; height absolute
        double turn = 0;         ///< of the path, radians
    };

    /// Radians, to the left.
    struct Turns
    {
        std::array<double, 3> angles;
        std::size_t count = 0;
    };

    void fill(std::size_t layer, std::size_t frame, const std::vector<Stretch>& stretches);
    Turns turnsOf(const Stretch& stretch) const;
    Bend bendAlong(const Stretch& stretch, double walked) const;
    Facing facingAt(std::size_t frame) const;
    Passage passageOf(const Stretch& stretch, const Bend& bend, double walked, const Facing& facing) const;
    void addObstructions(const Stretch& stretch, double walked, double facing, Cells& costs) const;
    static void keepLeast(const Passage& passage, double turn, double shift, const Cells& toGo, Cells& best);
    Cells after(const Stretch& stretch, double end, double turn) const;
    Cells cellsAt(std::size_t frame, double walked) const;
    double directionAt(double walked) const;
    static double sideOf(int index);

    const PathCourse& m_course;
    const PathCosts& m_costs;
    const MoveMotions& m_motions;
    double m_mu;
    FrameGrid m_grid;
    double m_layerLength; ///< metres
    std::size_t m_layers;
    std::vector<double> m_headings;   ///< of the frames of the grid as captured, radians
    std::vector<double> m_directions; ///< of the path every so often, radians
    std::vector<Cells> m_costsToGo;   ///< layers × frames of the grid
};

} // namespace quadrille
