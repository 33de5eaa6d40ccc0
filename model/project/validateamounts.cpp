// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/validateamounts.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double longestSeconds = 3600;
constexpr double longestTransition = 60; ///< seconds

class AmountValidator
{
public:
    AmountValidator(const CoordinateSystem& axes, ProjectProblems& problems)
        : m_farthest(farthestPlace(axes.metresPerUnit)), m_problems(problems)
    {
    }

    void check(const AnimationEntry& animation, const std::string& place)
    {
        for (std::size_t i = 0; i < animation.constraints.size(); ++i)
            std::visit(
                [&](const auto& constraint) {
                    checkConstraint(constraint, place + "/constraints/" + std::to_string(i));
                },
                animation.constraints[i]);
        constexpr double greatestBudget = 1e9;
        if (animation.search.budget)
            atMost(static_cast<double>(*animation.search.budget), greatestBudget, place + "/search/budget",
                   "The budget of the search", "expansions");
        constexpr double longestDwell = 60;
        constexpr double widestZone = 100;
        constexpr double mostSteering = 360;
        if (animation.search.dwell)
            atMost(*animation.search.dwell, longestDwell, place + "/search/dwell", "The time in a take",
                   "seconds");
        if (animation.search.deadZone)
            atMost(*animation.search.deadZone, widestZone, place + "/search/dead_zone", "The dead zone",
                   "metres");
        if (animation.search.steering)
            atMost(*animation.search.steering, mostSteering, place + "/search/steering", "The steering",
                   "degrees a metre");
        constexpr double mostRepeats = 1000;
        atMost(animation.post.steps.repeats, mostRepeats, place + "/post/repeats", "A loop", "repeats");
        if (animation.post.steps.retime)
            checkRetime(*animation.post.steps.retime, place + "/post/retime");
        for (std::size_t i = 0; i < animation.camera.size(); ++i)
            seconds(animation.camera[i].key.time, place + "/camera/" + std::to_string(i) + "/time");
    }

    void check(const VariationEntry& variation, const std::string& place)
    {
        constexpr double mostIterations = 1e7;
        constexpr double mostSteps = 1e6;
        constexpr std::size_t mostWeights = 100;
        const char* const none = "";
        atMost(variation.learning.greatestIterations, mostIterations, place + "/learning/iterations",
               "Learning", "iterations");
        atMost(variation.learning.window, mostIterations, place + "/learning/window", "The window",
               "iterations");
        atMost(variation.chain.leapfrogSteps, mostSteps, place + "/sampling/leapfrog_steps", "A trajectory",
               "steps");
        atMost(variation.chain.burnIn, mostSteps, place + "/sampling/burn_in", "The burn-in", "trajectories");
        atMost(variation.chain.thinning, mostSteps, place + "/sampling/thinning", "The thinning",
               "trajectories");
        for (std::size_t i = 0; i < variation.blends.size(); ++i) {
            const BlendEntry& blend = variation.blends[i];
            const std::size_t nodes =
                (blend.weights.size() + 2) * (blend.across ? blend.across->weights.size() + 2 : 1);
            atMost(static_cast<double>(nodes), mostWeights, place + "/blends/" + std::to_string(i), "A blend",
                   "blended takes", none);
        }
    }

    void check(const GraphEntry& graph, const std::string& place)
    {
        if (graph.durations)
            atMost(graph.durations->second, longestTransition, place + "/durations", "A transition",
                   "seconds");
    }

private:
    /// \param what  has at most so many \a unit.
    void atMost(double value, double most, const std::string& pointer, const std::string& what,
                const std::string& unit, const char* remedy = "Write less.")
    {
        if (std::isfinite(value) && std::abs(value) <= most)
            return;
        m_problems.push_back(invalidAt(
            pointer, what + " has at most " + std::to_string(std::llround(most)) + " " + unit, remedy));
    }

    void seconds(double value, const std::string& pointer)
    {
        if (std::abs(value) > longestSeconds)
            m_problems.push_back(invalidAt(pointer, "An animation lasts at most an hour, 3600 seconds",
                                           "Write an earlier time, in seconds."));
    }
    void seconds(const std::optional<double>& value, const std::string& pointer)
    {
        if (value)
            seconds(*value, pointer);
    }

    void checkConstraint(const KeyEntry& key, const std::string& place)
    {
        seconds(key.time, place + "/time");
    }

    void checkConstraint(const ActionEntry& action, const std::string& place)
    {
        constexpr double mostRepeats = 1000;
        atMost(action.repeat, mostRepeats, place + "/repeat", "An action", "repeats");
        seconds(action.duration, place + "/duration");
    }

    void checkConstraint(const PathEntry& path, const std::string& place)
    {
        const auto isFar = [this](const auto& point) {
            return point.allFinite() && point.template lpNorm<Eigen::Infinity>() > m_farthest;
        };
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            if (isFar(path.points[i]))
                far(place + "/points/" + std::to_string(i));
        }
        for (std::size_t i = 0; i < path.spans.size(); ++i)
            seconds(path.spans[i].duration, place + "/spans/" + std::to_string(i) + "/duration");
        for (std::size_t i = 0; i < path.obstacles.size(); ++i) {
            const ObstacleEntry& obstacle = path.obstacles[i];
            const std::string own = place + "/obstacles/" + std::to_string(i);
            if (obstacle.radius > m_farthest)
                far(own + "/radius");
            for (const Vec2d& corner : obstacle.corners) {
                if (isFar(corner)) {
                    far(own);
                    break;
                }
            }
        }
        if (path.clearance > m_farthest)
            far(place + "/clearance");
    }

    void far(const std::string& pointer)
    {
        m_problems.push_back(invalidAt(pointer, "Places lie at most 10 km from the origin",
                                       "Write lengths in the project's unit, and mind the decimal point."));
    }

    void checkRetime(const RetimeSettings& retime, const std::string& place)
    {
        if (const auto* factor = std::get_if<RetimeFactor>(&retime.time)) {
            constexpr double greatestFactor = 1000;
            if (std::abs(factor->value) > greatestFactor)
                m_problems.push_back(invalidAt(place + "/factor",
                                               "A clip is slowed to at most 1000 times its length",
                                               "Write 2 for half the speed."));
        } else if (const auto* duration = std::get_if<Seconds>(&retime.time)) {
            seconds(duration->value, place + "/duration");
        } else {
            const auto& curve = std::get<RetimeSettings::Curve>(retime.time);
            for (std::size_t i = 0; i < curve.size(); ++i)
                seconds(curve[i].output.value, place + "/curve/" + std::to_string(i));
        }
    }

    double m_farthest; ///< in the project's unit
    ProjectProblems& m_problems;
};

template <typename Entry>
void checkAll(const std::vector<Entry>& entries, const char* section, AmountValidator validator)
{
    for (std::size_t i = 0; i < entries.size(); ++i)
        validator.check(entries[i], section + std::to_string(i));
}

} // namespace

void validateAmounts(const Project& project, ProjectProblems& problems)
{
    const AmountValidator validator(project.settings.axes, problems);
    checkAll(project.animations, "/animations/", validator);
    checkAll(project.variations, "/variations/", validator);
    checkAll(project.graphs, "/graph/", validator);
}

double farthestPlace(double metresPerUnit)
{
    constexpr double metres = 10'000;
    constexpr double units = 1e7; // 10 km in millimetres
    return std::min(metres / metresPerUnit, units);
}

} // namespace quadrille
