// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/pathcourse.h"
#include "model/synthesis/walks/reachableset.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

[[noreturn]] void refuse(ErrorCode code, Values values)
{
    throw Error(code, {.values = std::move(values)});
}

void require(bool isMet, const char* reason, const char* remedy)
{
    if (!isMet)
        refuse(ErrorCode::BadArgument, {{"reason", reason}, {"remedy", remedy}});
}

bool isCount(double value)
{
    return std::isfinite(value) && value >= 0;
}

void checkSpans(const std::vector<WalkSpan>& spans, const FrameLayout& layout)
{
    for (const WalkSpan& span : spans) {
        const bool exists = span.first >= 0 && span.first <= span.last && span.last < layout.frameCount();
        require(exists && layout.sequenceOf(span.first) == layout.sequenceOf(span.last),
                "A range of frames does not lie inside one sequence",
                "Choose frames of one sequence, the first before the last.");
    }
}

void checkSet(const FrameSet& set, const FrameLayout& layout)
{
    if (set.spans.empty())
        refuse(ErrorCode::WalkFramesMissing, {{"name", set.name}});
    checkSpans(set.spans, layout);
}

void checkKeys(const std::vector<PoseKey>& keys, const FrameLayout& layout)
{
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const PoseKey& key = keys[k];
        require(key.frame >= 0 && key.frame < layout.frameCount(), "A key names a frame that does not exist",
                "Choose a frame of the character.");
        require(isCount(key.time), "The time of a key is not a number from 0 on", "Correct it.");
        require(isCount(key.tolerance.value_or(0)), "The tolerance of a key is not a number from 0 on",
                "Correct it.");
        if (k > 0 && key.time <= keys[k - 1].time)
            refuse(ErrorCode::WalkKeyOrder, {{"key", std::to_string(k + 1)},
                                             {"time", shortNumber(key.time)},
                                             {"other", std::to_string(k)},
                                             {"otherTime", shortNumber(keys[k - 1].time)}});
    }
}

void checkObstacles(const PathConstraint& path, const PathCourse& course)
{
    for (const Obstacle& obstacle : path.obstacles) {
        const bool isFinite = std::all_of(obstacle.outline.begin(), obstacle.outline.end(),
                                          [](const Vec2d& corner) { return corner.allFinite(); });
        require(isFinite && isCount(obstacle.radius) && isCount(obstacle.clearance),
                "An obstacle has a number that is not finite or is negative", "Correct it.");
        require(obstacle.outline.size() == 1 || obstacle.outline.size() >= 3,
                "An obstacle is neither a disc nor a polygon",
                "Give one centre and a radius, or at least three corners.");
    }
    const int atStart = course.obstacleAt(course.at(0).head<2>());
    if (atStart < 0)
        return;
    constexpr double step = 0.01;
    double free = 0;
    while (free < course.length() && course.obstacleAt(course.at(free).head<2>()) >= 0)
        free += step;
    refuse(ErrorCode::WalkObstacleAtStart, {{"name", path.obstacles[static_cast<std::size_t>(atStart)].name},
                                            {"free", shortNumber(std::min(free, course.length()))}});
}

void checkPathSpans(const PathConstraint& path, double length, const FrameLayout& layout)
{
    // A length with two decimals, as it is shown, stands for the exact one.
    constexpr double rounding = 0.005 + 1e-6;
    std::vector<PathSpan> timed;
    for (const PathSpan& span : path.spans) {
        require(isCount(span.from) && std::isfinite(span.to) && span.from < span.to,
                "A span of the path does not end behind its beginning", "Correct its lengths.");
        if (span.to > length + rounding)
            refuse(ErrorCode::WalkSpanOutside, {{"from", shortNumber(span.from)},
                                                {"to", shortNumber(span.to)},
                                                {"length", shortNumber(length)}});
        require(isCount(span.duration.value_or(0)), "The duration of a span is not a number from 0 on",
                "Correct it.");
        if (span.demanded)
            checkSet(*span.demanded, layout);
        if (span.duration)
            timed.push_back(span);
    }
    std::sort(timed.begin(), timed.end(),
              [](const PathSpan& a, const PathSpan& b) { return a.from < b.from; });
    for (std::size_t i = 1; i < timed.size(); ++i)
        require(timed[i].from >= timed[i - 1].to, "Two timed spans of the path overlap",
                "Let one begin where the other ends.");
}

void checkPath(const PathConstraint& path, const FrameLayout& layout, UpAxis up)
{
    require(std::all_of(path.points.begin(), path.points.end(),
                        [](const Vec3d& point) { return point.allFinite(); }),
            "A point of the path is not finite", "Draw the path again.");
    const PathCourse course(path, up);
    constexpr double shortest = 0.1; // metres: less than a step
    if (course.length() < shortest)
        refuse(ErrorCode::WalkPathShort,
               {{"length", shortNumber(course.length())}, {"needed", shortNumber(shortest)}});
    checkPathSpans(path, course.length(), layout);
    checkObstacles(path, course);
}

void checkActions(const std::vector<Action>& actions, const FrameLayout& layout)
{
    for (const Action& action : actions) {
        checkSet(action.frames, layout);
        constexpr int most = 1000;
        require(action.repetitions >= 1 && action.repetitions <= most,
                "An action is repeated less than once or more than 1,000 times", "Correct its repetitions.");
        require(isCount(action.duration.value_or(0)), "The duration of an action is not a number from 0 on",
                "Correct it.");
        require(action.leastShare > 0 && action.leastShare <= 1,
                "The share of an action that must be played is not above 0 and at most 1", "Correct it.");
    }
}

} // namespace

void checkConstraints(const WalkConstraints& constraints, const SearchSettings& settings,
                      const FrameLayout& layout, UpAxis up)
{
    require(isCount(settings.beta.value_or(0)), "The weight of timing errors is not a number from 0 on",
            "Correct it.");
    require(isCount(settings.mu), "The weight of edges is not a number from 0 on", "Correct it.");
    require(settings.budget >= 1, "The budget is less than one expansion", "Raise it.");
    const Junctions& junctions = constraints.junctions;
    require(!constraints.keys.empty() || constraints.path || !constraints.actions.empty() ||
                !junctions.required.empty() || !junctions.spans.empty(),
            "Nothing is asked of the walk", "Give a key, a path or an action.");
    checkKeys(constraints.keys, layout);
    if (constraints.path)
        checkPath(*constraints.path, layout, up);
    checkActions(constraints.actions, layout);
    if (constraints.start)
        checkSet(*constraints.start, layout);
    checkSpans(junctions.spans, layout);
    checkSpans(junctions.walk.spans, layout);
}

} // namespace quadrille
