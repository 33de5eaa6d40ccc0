// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// What variations are drawn from.
enum class TrajectoryDraw
{
    Smooth, ///< smooth deviations from a take, as far apart as TrajectoryLimits::spread says
    Model,  ///< the model's own trajectories, whatever their spread and their jitter
};

/// How different variations are.
inline constexpr double greatestSpread = 3; ///< of TrajectoryLimits

struct TrajectoryLimits
{
    TrajectoryDraw draw = TrajectoryDraw::Smooth;
    /// How far they are apart, as a share of how far the captured takes of the same movement are: 0 repeats
    /// the take, 1 is as different as the takes, or less where the movement would become restless. See
    /// PoseSpread::reference where there is one take.
    double spread = 0.7;
    /// Variance of a pose (CVS eq. 13) at most, as a share of what it is where nothing was learned: 0 is
    /// sure, 1 knows nothing. Trajectories with a frame beyond are rejected; where most of them are, the
    /// spread is made smaller.
    double uncertainty = 0.25;

    bool operator==(const TrajectoryLimits&) const = default;
};

} // namespace quadrille
