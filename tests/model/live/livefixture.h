// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/random.h"
#include "model/live/liveplayer.h"
#include "tests/model/parametric/spacefixture.h"

#include <cmath>
#include <numbers>

namespace quadrille::test {

/// A body of boxes' corners that swings with a period of so many frames while it goes on.
struct SwingingSpace
{
    std::string name;
    std::size_t frames = 20;
    bool isCyclic = true;
    double hop = 0; ///< by how much it is higher in the middle, metres
    SpaceMeasure measure = SpaceMeasure::Speed;
    double least = 0.5; ///< metres a second, or degrees a second of turning
    double greatest = 2;
    double stride = 0.04; ///< of a frame of turning, metres
};

inline constexpr double swingingFps = 30;

inline MotionSpace makeSpace(const SwingingSpace& made)
{
    constexpr std::uint32_t vertices = 40;
    Random body(5);
    std::vector<Vec3f> rest;
    for (std::uint32_t v = 0; v < vertices; ++v)
        rest.push_back(randomPoint(body, 0.4) + Vec3f(0, 0.4F + 0.03F * static_cast<float>(v), 0));
    MotionSpace space;
    space.name = made.name;
    space.topology = stripOf(vertices);
    space.fps = swingingFps;
    space.isCyclic = made.isCyclic;
    for (const double value : {made.least, made.greatest}) {
        SpaceTake take;
        const bool turns = made.measure == SpaceMeasure::Turning;
        const double swing = turns ? 0.2 : 0.1 + 0.1 * value;
        for (std::size_t f = 0; f < made.frames; ++f) {
            const double phase = static_cast<double>(f) / static_cast<double>(made.frames);
            const auto sway = static_cast<float>(swing * std::sin(2 * std::numbers::pi * phase));
            const auto lift = static_cast<float>(made.hop * std::pow(std::sin(std::numbers::pi * phase), 2));
            for (const Vec3f& point : rest)
                take.poses.push_back(point + Vec3f(sway * point.y(), lift, 0));
            take.steps.push_back(
                turns ? GroundMotion{value * std::numbers::pi / 180 / swingingFps, Vec2d(made.stride, 0)}
                      : GroundMotion{0, Vec2d(value / swingingFps, 0)});
            take.seconds.push_back(1 / swingingFps);
        }
        space.takes.push_back(std::move(take));
    }
    const std::vector<SpacePoint> places{{made.least}, {made.greatest}};
    space.weights = WeightSpace(places, 1);
    space.parameters = {{made.name, made.measure, {}}};
    space.map =
        fitParameterMap(space.weights, space.parameters, [](const SpacePoint& place) { return place; });
    return space;
}

inline constexpr std::size_t walking = 0;
inline constexpr std::size_t turning = 1;
inline constexpr std::size_t jumping = 2;

/// Walks by speed, turns by turning, jumps without a cycle.
inline std::shared_ptr<const LiveGraph> swingingGraph()
{
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    for (const SwingingSpace& made :
         {SwingingSpace{.name = "walk"},
          SwingingSpace{
              .name = "turn", .frames = 24, .measure = SpaceMeasure::Turning, .least = -60, .greatest = 60},
          SwingingSpace{.name = "jump", .frames = 40, .isCyclic = false, .hop = 0.4}})
        spaces.push_back(std::make_shared<const MotionSpace>(makeSpace(made)));
    return std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), swingingFps));
}

/// Walks by speed, and turns by so many degrees a second on the way; jumps last.
inline std::shared_ptr<const LiveGraph> curvingGraph(double most)
{
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    for (const SwingingSpace& made : {SwingingSpace{.name = "walk"},
                                      SwingingSpace{.name = "curve",
                                      .frames = 24,
                                      .measure = SpaceMeasure::Turning,
                                      .least = -most,
                                      .greatest = most,
                                      .stride = 0.035},
                                      SwingingSpace{.name = "jump", .frames = 40, .isCyclic = false}})
        spaces.push_back(std::make_shared<const MotionSpace>(makeSpace(made)));
    return std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), swingingFps));
}

} // namespace quadrille::test
