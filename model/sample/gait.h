// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/posture.h"

#include <functional>
#include <vector>

namespace quadrille {

/// How somebody walks or runs; lengths in metres, angles in radians.
struct GaitStyle
{
    double speed = 1.35;     ///< metres per second
    double cycles = 0.95;    ///< of two steps, per second
    double duty = 0.61;      ///< share of a cycle that a foot stands; below 0.5 there is flight
    double stepWidth = 0.15; ///< between the feet
    double hipHeight = 0.950;
    double bounce = 0.018;
    double lowest = 0.06; ///< phase at which the hips are lowest
    double sway = 0.022;
    double hipTwist = 0.11;
    double hipDrop = 0.055;
    double lean = 0.04;
    double chestTwist = 0.20;
    double armSwing = 0.42;
    double armBase = 0.02;
    double armOut = 0.13;
    double elbow = 0.30;
    double elbowSwing = 0.22;
    double strike = 0.30;   ///< toes up when the heel comes down
    double toeOff = 0.75;   ///< heel up when the foot leaves
    double lift = 0.045;    ///< of the swinging foot
    double heelLift = 0.20; ///< further heel up early in the swing
    double phase = 0;       ///< at the start: 0 is the left heel's strike
    double headNod = 0.015;
    double asymmetry = 0; ///< of arm swing, left against right
};

/// A walk along a path: speed and turning may change.
struct GaitPlan
{
    GaitStyle style;
    double duration = 2; ///< seconds
    /// Share of the style's speed at a time; 1 when empty.
    std::function<double(double)> speed;
    /// Share of the style's cadence at a time; 1 when empty.
    std::function<double(double)> cadence;
    /// Rate of turning to the left, radians per second; 0 when empty.
    std::function<double(double)> turning;
};

/// A foot on the ground, seconds.
struct Footstep
{
    double plant = 0;
    double lift = 0;
};

struct GaitMotion
{
    std::vector<Posture> frames;
    /// Per side (left, right), ascending; the first may begin before 0, the last end after the duration.
    std::array<std::vector<Footstep>, 2> steps;
};

/// Postures at `fps` frames per second, frame 0 at time 0, starting at the origin towards +z.
GaitMotion makeGait(const Skeleton& skeleton, const GaitPlan& plan, double fps);

} // namespace quadrille
