// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/walkmeasures.h"

#include "model/core/ranks.h"
#include "model/geometry/procrustes.h"
#include "model/synthesis/clips/makeclip.h"
#include "model/synthesis/clips/soles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace quadrille {

namespace {

/// Soles up to so much above where they stand count as on the ground, heights of the figure.
constexpr double nearGround = 0.01;

/// Per frame but the last: how fast the foot slips that slips least of those on the ground, where one is.
std::vector<double> slidesOf(const Clip& clip, const Stances& stances, UpAxis up,
                             const std::vector<double>& levels)
{
    const Ground ground(up);
    std::vector<double> slides;
    for (std::int64_t f = 0; f + 1 < clip.frameCount(); ++f) {
        std::optional<double> least;
        for (std::size_t i = 0; i < stances.feet.size(); ++i) {
            const Stances::Foot& foot = stances.feet[i];
            const Sole now = soleOf(clip.frame(f), foot.vertices, stances.height, ground);
            const Sole next = soleOf(clip.frame(f + 1), foot.vertices, stances.height, ground);
            if (std::max(now.height, next.height) >= levels[i] + nearGround * stances.height)
                continue;
            const Touch touch = touchOf(now, next, stances.height);
            const double slide = clip.fps * (touch.after - touch.before).norm();
            least = std::min(least.value_or(slide), slide);
        }
        if (least)
            slides.push_back(*least);
    }
    return slides;
}

std::vector<double> speedChangesOf(const Clip& clip, UpAxis up)
{
    const Ground ground(up);
    std::vector<double> speeds;
    for (std::int64_t f = 0; f + 1 < clip.frameCount(); ++f)
        speeds.push_back(
            clip.fps * (ground.of(centroid(clip.frame(f + 1))) - ground.of(centroid(clip.frame(f)))).norm());
    const auto ahead = static_cast<std::size_t>(std::max(1.0, std::round(clip.fps / 5)));
    std::vector<double> changes;
    for (std::size_t f = 0; f + ahead < speeds.size(); ++f)
        changes.push_back(speeds[f + ahead] - speeds[f]);
    return changes;
}

double rootMeanSquare(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

MotionMeasures measuresOf(std::vector<double> slides, const std::vector<double>& changes)
{
    return {.slide95 = slides.empty() ? 0 : quantile(std::move(slides), 0.95),
            .speedChange = rootMeanSquare(changes)};
}

void addArc(std::vector<Vec2d>& points, const Vec2d& centre, double radius, double from, double turn)
{
    const int steps = static_cast<int>(std::ceil(std::abs(turn) * radius / 0.05));
    for (int i = points.empty() ? 0 : 1; i <= steps; ++i) {
        const double angle = from + turn * i / steps;
        points.push_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
}

} // namespace

MotionMeasures measureMotion(const Clip& clip, const Stances& stances, UpAxis up,
                             const std::vector<double>& levels)
{
    return measuresOf(slidesOf(clip, stances, up, levels), speedChangesOf(clip, up));
}

std::vector<double> standingLevels(const CharacterFrames& character, const Stances& stances, UpAxis up)
{
    std::vector<std::vector<double>> heights(stances.feet.size());
    for (NodeIndex node = 0; node < character.frameCount(); ++node) {
        if (stances.at(node) == 0)
            continue;
        const Frame frame = character.frame(node);
        for (std::size_t foot = 0; foot < stances.feet.size(); ++foot)
            if (stances.stands(node, foot))
                heights[foot].push_back(
                    soleOf(frame.positions(), stances.feet[foot].vertices, stances.height, Ground(up))
                        .height);
    }
    std::vector<double> levels;
    levels.reserve(heights.size());
    for (std::vector<double>& ofFoot : heights)
        levels.push_back(ofFoot.empty() ? -std::numeric_limits<double>::infinity()
                                        : quantile(std::move(ofFoot), 0.5));
    return levels;
}

MotionMeasures measureTakes(const CharacterFrames& character, const RootPoses& roots,
                            const std::vector<WalkSpan>& shown, const std::vector<double>& levels)
{
    const FrameLayout& layout = character.layout();
    std::set<int> sequences;
    for (const WalkSpan& span : shown)
        sequences.insert(layout.sequenceOf(span.first));
    std::vector<double> slides;
    std::vector<double> changes;
    for (const int sequence : sequences) {
        const Walk whole{{{layout.firstOf(sequence), layout.lastOf(sequence)}}};
        const Clip clip = makeClip(character, planClip(roots, whole, {}));
        std::ranges::copy(slidesOf(clip, roots.stances, roots.up, levels), std::back_inserter(slides));
        std::ranges::copy(speedChangesOf(clip, roots.up), std::back_inserter(changes));
    }
    return measuresOf(std::move(slides), changes);
}

WalkCalmness calmnessOf(const ClipPlan& plan, const Walk& walk, const std::vector<bool>& locomotion,
                        double fps)
{
    WalkCalmness calmness{.seconds = static_cast<double>(plan.frameCount()) / fps,
                          .transitions = static_cast<int>(walk.transitionCount())};
    calmness.shortestRun = std::numeric_limits<NodeIndex>::max();
    for (const WalkSpan& span : walk.spans)
        calmness.shortestRun = std::min(calmness.shortestRun, span.frameCount());
    const auto blended = std::ranges::count_if(
        plan.frames, [](const PlannedFrame& frame) { return !frame.origin.isSingle(); });
    calmness.blendedShare = static_cast<double>(blended) / static_cast<double>(plan.frameCount());
    if (locomotion.empty())
        return calmness;
    const auto isStray = [&](NodeIndex node) { return locomotion[static_cast<std::size_t>(node)] ? 0 : 1; };
    double stray = 0;
    for (const PlannedFrame& frame : plan.frames)
        stray += (1 - frame.origin.lambda) * isStray(frame.origin.source) +
                 frame.origin.lambda * isStray(frame.origin.destination);
    calmness.strayShare = stray / static_cast<double>(plan.frameCount());
    return calmness;
}

std::vector<Vec2d> standardPath(std::string_view name)
{
    constexpr double pi = std::numbers::pi;
    std::vector<Vec2d> points;
    const auto go = [&points](const Vec2d& to) {
        if (points.empty())
            points.emplace_back(0, 0);
        const Vec2d from = points.back();
        const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.05));
        for (int i = 1; i <= steps; ++i)
            points.push_back(from + (to - from) * i / steps);
    };
    if (name == "straight")
        go({8, 0});
    else if (name == "s") {
        for (int i = 0; i <= 180; ++i)
            points.emplace_back(8.0 * i / 180, 0.8 * std::sin(2 * pi * i / 180));
    } else if (name == "circle")
        addArc(points, {0, 3}, 3, -pi / 2, 2 * pi);
    else if (name == "right-angle") {
        go({4, 0});
        go({4, 4});
    } else {
        assert(name == "figure-of-eight");
        addArc(points, {0, 2}, 2, -pi / 2, 2 * pi);
        addArc(points, {0, -2}, 2, pi / 2, -2 * pi);
    }
    return points;
}

} // namespace quadrille
