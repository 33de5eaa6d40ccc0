// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/retime.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/core/message.h"
#include "model/synthesis/clips/clipsize.h"
#include "model/synthesis/clips/frameprovenance.h"
#include "model/synthesis/finishing/monotonecurve.h"
#include "model/transition/poseinterpolation.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double mostFrames = 1e6;

/// Frames of the result for a length in frames, which need not be whole.
std::int64_t frameSteps(double length)
{
    if (!(length <= mostFrames))
        refuse(QUADRILLE_MESSAGE("A clip can be retimed to a million frames at most"),
               QUADRILLE_MESSAGE("Ask for a shorter result."));
    return std::max(std::int64_t{1}, static_cast<std::int64_t>(std::llround(length)));
}

double lengthOf(const RetimeFactor& factor, double frames, double /*fps*/)
{
    if (!(factor.value > 0) || !std::isfinite(factor.value))
        refuse(QUADRILLE_MESSAGE("The factor of a retiming is not above 0"),
               QUADRILLE_MESSAGE("Give how many times as long the result lasts: 2 for half the speed."));
    return factor.value * frames;
}

double lengthOf(Seconds duration, double /*frames*/, double fps)
{
    if (!(duration.value > 0) || !std::isfinite(duration.value))
        refuse(QUADRILLE_MESSAGE("The duration of a retiming is not above 0"),
               QUADRILLE_MESSAGE("Give the seconds that the result lasts."));
    return duration.value * fps;
}

/// A value within rounding of a whole number is that number, so that whole frames stay as they are.
double snapped(double moment)
{
    const double whole = std::round(moment);
    return std::abs(moment - whole) < 1e-6 ? whole : moment;
}

std::vector<double> evenMoments(double length, double frames)
{
    const std::int64_t steps = length > 0 ? frameSteps(length) : std::int64_t{0};
    std::vector<double> moments;
    for (std::int64_t m = 0; m <= steps; ++m)
        moments.push_back(steps == 0 ? 0
                                     : snapped(frames * static_cast<double>(m) / static_cast<double>(steps)));
    return moments;
}

std::vector<Vec2d> checkedPoints(const RetimeSettings::Curve& curve, double frames, double fps)
{
    if (curve.size() < 2)
        refuse(QUADRILLE_MESSAGE("A curve of times has fewer than two points"),
               QUADRILLE_MESSAGE("Give at least where the result begins and where it ends."));
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec2d point(curve[i].output.value * fps, curve[i].clip.value * fps);
        // A rounding error of a typed time is no reason to refuse it.
        if (!point.allFinite() || point.y() < -1e-3 || point.y() > frames + 1e-3)
            refuse(QUADRILLE_MESSAGE("A curve of times leaves the clip"),
                   QUADRILLE_MESSAGE("Give clip times from 0 to the duration of the clip."));
        if (i > 0 && (point.x() <= points.back().x() || point.y() < points.back().y()))
            throw Error(ErrorCode::TimeCurveNotMonotone, {{}, {}, {{"point", std::to_string(i + 1)}}});
        points.emplace_back(point.x(), std::clamp(point.y(), 0.0, frames));
    }
    return points;
}

std::vector<double> curveMoments(const RetimeSettings::Curve& curve, double frames, double fps)
{
    const std::vector<Vec2d> points = checkedPoints(curve, frames, fps);
    const MonotoneCurve at(points);
    const double first = points.front().x();
    const double length = points.back().x() - first;
    const std::int64_t steps = frameSteps(length);
    std::vector<double> moments;
    for (std::int64_t m = 0; m <= steps; ++m) {
        const double x = first + length * static_cast<double>(m) / static_cast<double>(steps);
        moments.push_back(std::clamp(snapped(at(x)), 0.0, frames));
    }
    return moments;
}

/// A clip at other times: its poses, and how far it goes.
class Retiming
{
public:
    /// \param clip  with the first frame of the next cycle at its end, where it is a loop.
    /// \param moments  of each frame of the result, and of its end.
    Retiming(const Clip& clip, std::vector<double> moments) : m_clip(clip), m_moments(std::move(moments)) {}

    Clip poses(std::size_t count, InterpolationMethod method, const Progress& progress) const;
    /// How far the figure has gone ahead of its poses at each moment when it keeps its speed.
    std::vector<Vec2d> shifts(const Ground& ground) const;

private:
    double lastFrame() const { return static_cast<double>(m_clip.frameCount() - 1); }
    std::int64_t frameBefore(std::size_t m) const
    {
        return static_cast<std::int64_t>(std::floor(m_moments[m]));
    }
    Vec2d centreAt(double moment, const std::vector<Vec2d>& centres) const;

    const Clip& m_clip;
    std::vector<double> m_moments;
};

Clip Retiming::poses(std::size_t count, InterpolationMethod method, const Progress& progress) const
{
    const std::size_t vertices = m_clip.topology->vertexCount();
    Clip result{.topology = m_clip.topology, .fps = m_clip.fps, .positions = {}, .origins = {}};
    checkClipSize(static_cast<std::int64_t>(count), vertices);
    result.positions.resize(count * vertices);
    std::vector<Positions> frames;
    for (std::int64_t f = 0; f < m_clip.frameCount(); ++f)
        frames.push_back(m_clip.frame(f));
    std::vector<BlendStep> steps;
    std::vector<std::size_t> between; ///< frames of the result that the steps are for
    for (std::size_t m = 0; m < count; ++m) {
        const std::int64_t frame = frameBefore(m);
        const double lambda = m_moments[m] - static_cast<double>(frame);
        const auto index = static_cast<std::size_t>(frame);
        if (lambda == 0) {
            result.origins.push_back(m_clip.origins[index]);
            std::ranges::copy(frames[index], result.frame(static_cast<std::int64_t>(m)).begin());
            continue;
        }
        result.origins.push_back(originBetween(m_clip.origins[index], m_clip.origins[index + 1], lambda));
        between.push_back(m);
        steps.push_back({.source = static_cast<int>(frame),
                         .target = static_cast<int>(frame + 1),
                         .lambda = lambda,
                         .placeSource = {},
                         .placeTarget = {}});
    }
    if (!steps.empty()) {
        const std::vector<Vec3f> blended = blendPoses(std::make_shared<const PoissonSystem>(m_clip.topology),
                                                      frames, frames, steps, method, progress);
        for (std::size_t i = 0; i < between.size(); ++i)
            std::ranges::copy(Positions(blended).subspan(i * vertices, vertices),
                              result.frame(static_cast<std::int64_t>(between[i])).begin());
    }
    return result;
}

Vec2d Retiming::centreAt(double moment, const std::vector<Vec2d>& centres) const
{
    const auto frame = static_cast<std::size_t>(std::min(std::floor(moment), lastFrame() - 1));
    const double lambda = moment - static_cast<double>(frame);
    return (1 - lambda) * centres[frame] + lambda * centres[frame + 1];
}

std::vector<Vec2d> Retiming::shifts(const Ground& ground) const
{
    std::vector<Vec2d> centres;
    for (std::int64_t f = 0; f < m_clip.frameCount(); ++f)
        centres.push_back(ground.of(centroid(m_clip.frame(f))));
    std::vector<Vec2d> shifts{Vec2d::Zero()};
    if (centres.size() < 2)
        return std::vector<Vec2d>(m_moments.size(), Vec2d::Zero());
    for (std::size_t m = 1; m < m_moments.size(); ++m) {
        const double from = m_moments[m - 1];
        const double to = m_moments[m];
        const Vec2d gone = centreAt(to, centres) - centreAt(from, centres);
        Vec2d pace = gone;
        if (to > from) {
            pace /= to - from;
        } else {
            // Time stands still: the figure goes on as at this pose.
            const double before = std::min(std::floor(from), lastFrame() - 1);
            pace = centreAt(before + 1, centres) - centreAt(before, centres);
        }
        shifts.push_back(shifts.back() + pace - gone);
    }
    return shifts;
}

void moveFrames(Clip& clip, const std::vector<Vec2d>& shifts, const Ground& ground)
{
    for (std::int64_t f = 0; f < clip.frameCount(); ++f)
        moveFrame(clip.frame(f), {0, shifts[static_cast<std::size_t>(f)]}, ground);
}

} // namespace

std::vector<double> retimedMoments(const RetimeSettings& settings, std::int64_t frames, double fps)
{
    const auto length = static_cast<double>(frames);
    if (const auto* curve = std::get_if<RetimeSettings::Curve>(&settings.time))
        return curveMoments(*curve, length, fps);
    if (const auto* duration = std::get_if<Seconds>(&settings.time))
        return evenMoments(lengthOf(*duration, length, fps), length);
    return evenMoments(lengthOf(std::get<RetimeFactor>(settings.time), length, fps), length);
}

Clip retimed(const Clip& clip, const RetimeSettings& settings, UpAxis up, InterpolationMethod interpolation,
             const Progress& progress)
{
    progress.report(0.0);
    const std::vector<double> moments = retimedMoments(settings, clip.frameCount() - 1, clip.fps);
    const Retiming retiming(clip, moments);
    Clip result = retiming.poses(moments.size(), interpolation, progress);
    if (settings.keepsRootSpeed)
        moveFrames(result, retiming.shifts(Ground(up)), Ground(up));
    progress.report(1.0);
    return result;
}

Loop retimed(const Loop& loop, const RetimeSettings& settings, UpAxis up, InterpolationMethod interpolation,
             const Progress& progress)
{
    progress.report(0.0);
    const Ground ground(up);
    const std::vector<double> moments = retimedMoments(settings, loop.cycle.frameCount(), loop.cycle.fps);
    if (moments.front() > 0 || moments.back() < static_cast<double>(loop.cycle.frameCount()))
        refuse(QUADRILLE_MESSAGE("A curve of times does not go all round a loop"),
               QUADRILLE_MESSAGE("Begin at clip time 0 and end at the duration of the loop."));
    const Clip closed = closedCycle(loop, up);
    const Retiming retiming(closed, moments);
    Loop result{.cycle = retiming.poses(moments.size() - 1, interpolation, progress),
                .travel = loop.travel,
                .closure = loop.closure};
    if (settings.keepsRootSpeed) {
        const std::vector<Vec2d> shifts = retiming.shifts(ground);
        moveFrames(result.cycle, shifts, ground);
        result.travel = GroundMotion{0, shifts.back()} * loop.travel;
    }
    progress.report(1.0);
    return result;
}

} // namespace quadrille
