// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/gait.h"

#include "model/core/smoothstep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr double tau = 2 * std::numbers::pi;

double ease(double t)
{
    return smoothStep(std::clamp(t, 0.0, 1.0));
}

double lerp(double a, double b, double t)
{
    return a + (b - a) * std::clamp(t, 0.0, 1.0);
}

struct PathPoint
{
    double time = 0;
    double phase = 0;
    double x = 0;
    double z = 0;
    double heading = 0;
    double vigour = 1; ///< share of the style's speed
    double turning = 0;
};

/// The way of the hips, sampled finely, from before the start until after the end.
class Path
{
public:
    static constexpr double step = 1.0 / 400;
    static constexpr double margin = 1.6; ///< seconds before and after

    explicit Path(const GaitPlan& plan)
    {
        const auto at = [](const std::function<double(double)>& f, double t, double fallback) {
            return f ? f(t) : fallback;
        };
        const auto forward = [&](PathPoint p, double dt) {
            p.vigour = at(plan.speed, p.time, 1);
            p.turning = at(plan.turning, p.time, 0);
            p.time += dt;
            p.phase += dt * plan.style.cycles * at(plan.cadence, p.time, 1);
            p.heading += dt * p.turning;
            const double way = dt * plan.style.speed * p.vigour;
            p.x += way * std::sin(p.heading);
            p.z += way * std::cos(p.heading);
            return p;
        };
        PathPoint start;
        start.phase = plan.style.phase;
        start.vigour = at(plan.speed, 0, 1);
        start.turning = at(plan.turning, 0, 0);
        std::vector<PathPoint> before = {start};
        while (before.back().time > -margin)
            before.push_back(forward(before.back(), -step));
        m_points.assign(before.rbegin(), before.rend());
        while (m_points.back().time < plan.duration + margin)
            m_points.push_back(forward(m_points.back(), step));
    }

    PathPoint atTime(double time) const
    {
        const double x =
            std::clamp((time - m_points.front().time) / step, 0.0, static_cast<double>(m_points.size() - 2));
        const auto i = static_cast<std::size_t>(x);
        const double t = x - static_cast<double>(i);
        const PathPoint& a = m_points[i];
        const PathPoint& b = m_points[i + 1];
        return {time,
                lerp(a.phase, b.phase, t),
                lerp(a.x, b.x, t),
                lerp(a.z, b.z, t),
                lerp(a.heading, b.heading, t),
                lerp(a.vigour, b.vigour, t),
                lerp(a.turning, b.turning, t)};
    }
    /// When a phase is reached; the ends where it never is.
    double timeOfPhase(double phase) const
    {
        const auto it = std::lower_bound(m_points.begin(), m_points.end(), phase,
                                         [](const PathPoint& p, double value) { return p.phase < value; });
        return it == m_points.end() ? m_points.back().time + 1 : it->time;
    }
    double firstPhase() const { return m_points.front().phase; }
    double lastPhase() const { return m_points.back().phase; }

private:
    std::vector<PathPoint> m_points;
};

struct Plant
{
    Footstep step;
    double x = 0;
    double z = 0;
    double yaw = 0;
    double vigour = 1;
};

std::vector<Plant> plants(const Path& path, const GaitStyle& style, std::size_t side, double ankleZ)
{
    const double offset = side == 0 ? 0.0 : 0.5;
    const double sign = side == 0 ? 1 : -1;
    std::vector<Plant> result;
    const int first = static_cast<int>(std::floor(path.firstPhase() - offset)) - 1;
    const int last = static_cast<int>(std::ceil(path.lastPhase() - offset)) + 1;
    for (int cycle = first; cycle <= last; ++cycle) {
        const double begin = cycle + offset;
        Plant plant;
        plant.step = {path.timeOfPhase(begin), path.timeOfPhase(begin + style.duty)};
        if (begin <= path.firstPhase())
            plant.step.plant = -1e3;
        if (begin + style.duty >= path.lastPhase())
            plant.step.lift = 1e3;
        const PathPoint p = path.atTime(path.timeOfPhase(begin + 0.5 * style.duty));
        const double across = sign * 0.5 * lerp(0.21, style.stepWidth, p.vigour);
        plant.x = p.x + across * std::cos(p.heading) + ankleZ * std::sin(p.heading);
        plant.z = p.z - across * std::sin(p.heading) + ankleZ * std::cos(p.heading);
        plant.yaw = p.heading;
        plant.vigour = std::clamp(p.vigour, 0.0, 1.0);
        // Cycles before the first or after the last standing one add nothing.
        if (plant.step.plant < plant.step.lift)
            result.push_back(plant);
        if (plant.step.lift > 1e2)
            break;
    }
    while (result.size() > 1 && result[1].step.plant < -1e2)
        result.erase(result.begin());
    return result;
}

double stancePitch(const GaitStyle& style, const Plant& plant, double time)
{
    const double nominal = style.duty / style.cycles;
    const double sincePlant = (time - plant.step.plant) / nominal;
    const double untilLift = (plant.step.lift - time) / nominal;
    double pitch = -style.strike * plant.vigour * (1 - ease(sincePlant / 0.16));
    const double rise = std::clamp(1 - untilLift / 0.42, 0.0, 1.0);
    pitch += style.toeOff * lerp(0.45, 1, plant.vigour) * rise * rise * (1.5 - 0.5 * rise);
    return pitch;
}

void placeFoot(SidePosture& foot, const GaitStyle& style, const std::vector<Plant>& steps, double time)
{
    std::size_t i = 0;
    while (i + 1 < steps.size() && time >= steps[i + 1].step.plant)
        ++i;
    const Plant& from = steps[i];
    foot.footX = from.x;
    foot.footZ = from.z;
    foot.footYaw = from.yaw;
    foot.footLift = 0;
    if (time <= from.step.lift || i + 1 == steps.size()) {
        foot.footPitch = stancePitch(style, from, time);
        return;
    }
    const Plant& to = steps[i + 1];
    const double v = (time - from.step.lift) / (to.step.plant - from.step.lift);
    const double moved = 0.35 * ease(v) + 0.65 * (v * v * (3 - 2 * v));
    foot.footX = lerp(from.x, to.x, moved);
    foot.footZ = lerp(from.z, to.z, moved);
    foot.footYaw = lerp(from.yaw, to.yaw, moved);
    const double vigour = 0.5 * (from.vigour + to.vigour);
    const double s = std::sin(std::numbers::pi * std::pow(v, 0.8));
    foot.footLift = style.lift * lerp(0.55, 1, vigour) * s * s;
    const double off = style.toeOff * lerp(0.45, 1, from.vigour);
    const double strike = -style.strike * to.vigour;
    // Heel up a little further, then forward to the strike.
    const double early =
        std::exp(-std::pow((v - 0.18) / 0.16, 2)) - std::exp(-std::pow(0.18 / 0.16, 2)) * (1 - v);
    foot.footPitch = lerp(off, strike, ease(v * 1.12)) + style.heelLift * vigour * std::max(early, 0.0);
}

void moveTrunk(Posture& p, const GaitStyle& style, const PathPoint& at)
{
    const double phase = at.phase;
    const double vigour = std::clamp(at.vigour, 0.0, 1.2);
    const double sway = style.sway * vigour * std::sin(tau * (phase - 0.03));
    p.hipX = at.x + sway * std::cos(at.heading);
    p.hipZ = at.z - sway * std::sin(at.heading);
    p.hipY = lerp(0.955, style.hipHeight, vigour) -
             style.bounce * vigour * std::cos(2 * tau * (phase - style.lowest));
    p.hipYaw = at.heading - style.hipTwist * vigour * std::cos(tau * phase);
    p.hipRoll = style.hipDrop * vigour * std::sin(tau * (phase - 0.02)) - 0.045 * at.turning;
    p.hipPitch = 0.35 * style.lean * vigour;
    p.spineBend = 0.65 * style.lean * vigour + 0.015 * vigour * std::cos(2 * tau * (phase - 0.1));
    p.spineTwist = vigour * (style.hipTwist + style.chestTwist * 0.55) * std::cos(tau * (phase - 0.02)) +
                   0.10 * at.turning;
    p.spineSide = 0.7 * p.hipRoll;
    p.headYaw = -vigour * style.chestTwist * 0.5 * std::cos(tau * (phase - 0.02)) + 0.18 * at.turning;
    p.headPitch = -0.55 * style.lean * vigour + style.headNod * vigour * std::cos(2 * tau * (phase - 0.14));
    p.headRoll = -0.5 * (p.hipRoll - p.spineSide);
    for (std::size_t side = 0; side < 2; ++side) {
        const double s = side == 0 ? 1 : -1;
        SidePosture& arm = p.sides[side];
        const double swing = -s * std::cos(tau * (phase - 0.03)) * vigour * (1 + s * style.asymmetry);
        const double later = -s * std::cos(tau * (phase - 0.09)) * vigour * (1 + s * style.asymmetry);
        arm.armFlex = style.armBase + style.armSwing * (swing > 0 ? 0.85 * swing : swing);
        arm.elbow = lerp(0.22, style.elbow, vigour) + style.elbowSwing * later;
        arm.armOut = style.armOut + 0.03 * std::abs(swing);
        arm.armTwist = 0.10 + 0.10 * std::max(swing, 0.0);
        arm.pronation = 0.35 + 0.08 * later;
        arm.wrist = 0.08 - 0.06 * later;
        arm.shoulderFore = 0.10 * swing;
    }
}

} // namespace

GaitMotion makeGait(const Skeleton& skeleton, const GaitPlan& plan, double fps)
{
    const Path path(plan);
    const double ankleZ = skeleton.rest[skeleton.index("leftFoot")].z();
    std::array<std::vector<Plant>, 2> steps;
    GaitMotion motion;
    for (std::size_t side = 0; side < 2; ++side) {
        steps[side] = plants(path, plan.style, side, ankleZ);
        for (const Plant& plant : steps[side])
            motion.steps[side].push_back(plant.step);
    }
    const auto frames = static_cast<int>(std::lround(plan.duration * fps));
    for (int f = 0; f < frames; ++f) {
        const double time = f / fps;
        Posture posture;
        moveTrunk(posture, plan.style, path.atTime(time));
        for (std::size_t side = 0; side < 2; ++side)
            placeFoot(posture.sides[side], plan.style, steps[side], time);
        motion.frames.push_back(posture);
    }
    return motion;
}

} // namespace quadrille
