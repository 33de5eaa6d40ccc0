// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/finishing/footdrift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

namespace quadrille::test {

/// Two takes of a figure of two metres that turns its own way and walks: a foot stays where it stands, and is
/// carried with the body where it does not.
struct Walker
{
    static constexpr double fps = 25;
    FrameLayout layout;
    RootPoses roots;
    TransitionTable transitions;

    explicit Walker(std::uint32_t seed, int length = 15)
        : layout(std::array<std::int64_t, 2>{40, 46}), roots{.up = UpAxis::Z}
    {
        std::mt19937 random(seed);
        roots.stances = {.feet = {{"left", {0}}, {"right", {1}}}, .height = 2};
        std::vector<double> headings;
        for (int sequence = 0; sequence < 2; ++sequence)
            addTake(sequence, random, headings);
        const NodeIndex frames = layout.frameCount();
        Table<float> turns(frames, frames);
        for (NodeIndex i = 0; i < frames; ++i)
            for (NodeIndex j = 0; j < frames; ++j)
                turns(i, j) = static_cast<float>(wrappedAngle(headings[static_cast<std::size_t>(i)] -
                                                              headings[static_cast<std::size_t>(j)]));
        roots.turns = SharedTable<float>(std::move(turns));
        Table<std::uint16_t> lengths = Table<std::uint16_t>::Zero(frames, frames);
        Table<std::uint16_t> windows = Table<std::uint16_t>::Zero(frames, 2 * frames);
        for (NodeIndex i = 0; i + length <= 40; ++i) {
            for (NodeIndex j = 40 + length - 1; j < frames; ++j) {
                lengths(i, j) = static_cast<std::uint16_t>(length);
                windows.row(i).segment(2 * j, 2) = static_cast<std::uint16_t>(length);
            }
        }
        transitions = {.cost = SharedTable<float>(Table<float>::Zero(frames, frames)),
                       .length = SharedTable<std::uint16_t>(std::move(lengths)),
                       .windows = SharedTable<std::uint16_t>(std::move(windows))};
    }

    void addTake(int sequence, std::mt19937& random, std::vector<double>& headings)
    {
        Vec2d centre(3 * sequence, 1);
        std::array<Vec2d, 2> feet{centre + Vec2d(0, 0.2), centre + Vec2d(0, -0.2)};
        std::uint32_t standing = 3;
        const double bend = 0.03 * (2 * sequence - 1);
        for (NodeIndex f = 0; f < layout.countOf(sequence); ++f) {
            if (f % 4 == 0)
                standing = random() % 4;
            const double heading = sequence + bend * f;
            headings.push_back(heading);
            const Vec2d way = (0.04 + 0.03 * sequence) * Vec2d(std::cos(heading), std::sin(heading));
            roots.centres.emplace_back(centre.x(), centre.y(), 1);
            Support& support = roots.supports.emplace_back();
            for (std::uint32_t foot = 0; foot < 2; ++foot) {
                roots.stances.places.emplace_back(feet[foot].x(), feet[foot].y(), 0);
                if ((standing >> foot & 1U) != 0) {
                    support.vertices.push_back(foot);
                    support.places.push_back(feet[foot]);
                }
                const bool stays = (standing >> foot & 1U) != 0;
                feet[foot] += stays ? Vec2d(0, 0) : Vec2d(1.5 * way);
            }
            roots.stances.standing.push_back(standing);
            centre += way;
        }
    }

    Table<float> drifts() const { return footDrifts(roots, layout, transitions, fps); }

    /// By the plan of the clip.
    double expected(NodeIndex i, NodeIndex j) const
    {
        Transition transition{.frames = {i, j}, .sourceWindow = 15, .destinationWindow = 15};
        for (int t = 0; t < transitions.length(i, j); ++t)
            transition.path.push_back({i + t, j - transitions.length(i, j) + 1 + t});
        const Walk walk{{{std::max(i - 8, 0), i}, {j, std::min(j + 8, layout.frameCount() - 1)}}};
        const ClipPlan plan =
            planClip(roots, walk, std::span(&transition, 1), {.start = {}, .blend = BlendSettings::gentle()});
        const std::vector<std::uint32_t> standing = stancesBeforeSteps(feetOf(plan), roots.stances);
        double greatest = 0;
        for (std::size_t foot = 0; foot < 2; ++foot)
            greatest = std::max(greatest, greatestDeviation(plan, standing, foot));
        return greatest / roots.stances.height;
    }

    /// A clip of a triangle of both feet and a point beside them.
    Clip feetOf(const ClipPlan& plan) const
    {
        Clip clip{.topology = std::make_shared<const Topology>(TopologyData{
                      .vertexCount = 3, .triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}}}),
                  .fps = fps};
        for (std::size_t f = 0; f < plan.frames.size(); ++f) {
            clip.origins.push_back(plan.frames[f].origin);
            for (std::size_t foot = 0; foot < 2; ++foot)
                clip.positions.push_back(Ground(roots.up).at(placeAt(plan, f, foot), 0).cast<float>());
            clip.positions.emplace_back(0, 0, 0);
        }
        return clip;
    }

    Vec2d placeAt(const ClipPlan& plan, std::size_t f, std::size_t foot) const
    {
        const Ground ground(roots.up);
        const PlannedFrame& frame = plan.frames[f];
        const double lambda = frame.isSingle() ? 0 : frame.lambda;
        const auto placed = [&](const GroundMotion& place, NodeIndex node) -> Vec2d {
            return place(ground.of(roots.stances.placeOf(node, foot)));
        };
        return (1 - lambda) * placed(frame.placeSource, frame.times.source.frame) +
               lambda * placed(frame.placeDestination, frame.times.destination.frame);
    }

    double greatestDeviation(const ClipPlan& plan, const std::vector<std::uint32_t>& standing,
                             std::size_t foot) const
    {
        const auto first = static_cast<std::size_t>(plan.junctions.front().first);
        const auto last = static_cast<std::size_t>(plan.junctions.front().last);
        double greatest = 0;
        std::vector<std::size_t> span;
        for (std::size_t f = 0; f <= standing.size(); ++f) {
            if (f < standing.size() && (standing[f] >> foot & 1U) != 0) {
                span.push_back(f);
                continue;
            }
            Vec2d mean = Vec2d::Zero();
            for (const std::size_t g : span)
                mean += placeAt(plan, g, foot) / static_cast<double>(span.size());
            for (const std::size_t g : span)
                if (first <= g && g <= last)
                    greatest = std::max(greatest, (placeAt(plan, g, foot) - mean).norm());
            span.clear();
        }
        return greatest;
    }
};

} // namespace quadrille::test
