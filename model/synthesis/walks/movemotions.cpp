// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/movemotions.h"

#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/walks/travel.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

MoveMotions::MoveMotions(const WalkGraph& graph, const WalkMotion& motion, const PathCourse& course,
                         ShownCharges charges)
    : m_graph(graph)
    , m_motion(motion)
    , m_course(course)
    , m_charges(std::move(charges))
    , m_motions(graph.moves().size())
{
    for (const Vec3d& centre : motion.roots->centres) {
        const Vec3d point = course.pointOf(centre);
        m_arcLengths.push_back(m_points.empty() ? 0 : m_arcLengths.back() + (point - m_points.back()).norm());
        m_points.push_back(point);
    }
    for (NodeIndex node = 0; node < graph.nodeCount(); ++node)
        m_headings.push_back(quadrille::headingAt(m_points, graph.layout(), node));
    m_walkable.assign(m_points.size(), 0);
    for (MoveIndex index = 0; index < static_cast<MoveIndex>(graph.moves().size()); ++index) {
        if (graph.move(index).kind == EdgeKind::Original)
            of(index);
    }
    for (NodeIndex node = graph.nodeCount() - 1; node >= 0; --node) {
        double& walkable = m_walkable[static_cast<std::size_t>(node)];
        const auto [begin, end] = graph.from(node);
        for (MoveIndex index = begin; index < end; ++index) {
            const WalkMove& move = graph.move(index);
            walkable = std::max(walkable, move.kind == EdgeKind::Transition
                                              ? unreachable
                                              : m_walkable[static_cast<std::size_t>(move.to)] +
                                                    (point(move.to) - point(node)).norm());
        }
    }
}

const MoveMotions::Motion& MoveMotions::of(MoveIndex index)
{
    Motion& motion = m_motions[static_cast<std::size_t>(index)];
    if (!motion.isKnown)
        compute(index, motion);
    return motion;
}

void MoveMotions::prepare(MoveIndex begin, MoveIndex end)
{
    tbb::parallel_for(begin, end, [this](MoveIndex index) { of(index); });
}

void MoveMotions::prepare(std::vector<MoveIndex> moves)
{
    std::sort(moves.begin(), moves.end());
    moves.erase(std::unique(moves.begin(), moves.end()), moves.end());
    tbb::parallel_for(std::size_t{0}, moves.size(), [&](std::size_t i) { of(moves[i]); });
}

void MoveMotions::compute(MoveIndex index, Motion& motion) const
{
    motion.isKnown = true;
    const WalkMove& move = m_graph.move(index);
    const auto append = [&](const Vec3d& point, const Vec3d& before, const FramePair& frames) {
        const double walked = motion.steps.empty() ? 0 : static_cast<double>(motion.steps.back().arcLength);
        motion.steps.push_back({.point = point.cast<float>(),
                                .arcLength = static_cast<float>(walked + (point - before).norm()),
                                .source = frames.source,
                                .destination = frames.destination});
    };
    const Vec3d& begin = point(move.from);
    motion.begin = begin.head<2>();
    motion.heading = headingAt(move.to);
    if (move.kind == EdgeKind::Original) {
        append(point(move.to), begin, {move.to, move.to});
        return;
    }
    const Transition transition = m_motion.transition({move.from, move.to});
    const TransitionMotion moved = transitionMotion(*m_motion.roots, transition, m_motion.blend);
    motion.exit = moved.exit();
    motion.exit.shift *= m_course.metresPerUnit();
    motion.heading += motion.exit.turn;
    Vec3d before = begin;
    for (std::size_t t = 1; t < moved.steps.size(); ++t) {
        const Vec3d here = m_course.pointOf(moved.steps[t].centre);
        append(here, before, transition.path[t]);
        before = here;
    }
    if (motion.steps.empty())
        append(begin, begin, {move.from, move.to});
    if (m_charges.uneven > 0)
        motion.weight += m_charges.uneven * unevennessOf(move, motion);
    if (!m_charges.frames.empty())
        motion.weight += weightOfFrames(transition, moved);
}

/// Like captured frames, those of a transition weigh as the walk leaves them.
double MoveMotions::weightOfFrames(const Transition& transition, const TransitionMotion& moved) const
{
    double weight = 0;
    for (std::size_t t = 0; t + 1 < moved.steps.size(); ++t) {
        const double lambda = moved.steps[t].lambda;
        weight += (1 - lambda) * m_charges.frames[static_cast<std::size_t>(transition.path[t].source)] +
                  lambda * m_charges.frames[static_cast<std::size_t>(transition.path[t].destination)];
    }
    return weight;
}

/// With the frames that are played before and behind, as many as a fifth of a second has.
double MoveMotions::unevennessOf(const WalkMove& move, const Motion& motion) const
{
    constexpr double within = 0.2; // seconds
    const double height = m_motion.roots->stances.height * m_course.metresPerUnit();
    if (m_motion.fps <= 0 || height <= 0)
        return 0;
    const auto ahead = std::max<NodeIndex>(1, static_cast<NodeIndex>(std::lround(within * m_motion.fps)));
    const FrameLayout& layout = m_graph.layout();
    const NodeIndex first = std::max(move.from - ahead, layout.firstOf(layout.sequenceOf(move.from)));
    const NodeIndex last = std::min(move.to + ahead, layout.lastOf(layout.sequenceOf(move.to)));
    std::vector<double> walked; // at each frame
    for (NodeIndex node = first; node <= move.from; ++node)
        walked.push_back(wayBetween(move.from, node));
    for (const Step& step : motion.steps)
        walked.push_back(static_cast<double>(step.arcLength));
    const double end = walked.back();
    for (NodeIndex node = move.to + 1; node <= last; ++node)
        walked.push_back(end + wayBetween(move.to, node));
    double sum = 0;
    const auto reach = static_cast<std::size_t>(ahead);
    for (std::size_t f = 0; f + reach + 1 < walked.size(); ++f) {
        const double change = walked[f + reach + 1] - walked[f + reach] - (walked[f + 1] - walked[f]);
        sum += std::pow(change * m_motion.fps / height, 2);
    }
    return sum;
}

GroundMotion MoveMotions::placedOnStart(NodeIndex node) const
{
    const double way = travelAt(m_points, m_graph.layout(), node).norm();
    const double turn = m_course.directionFrom(0, std::max(way, leastTravel)) - headingAt(node);
    return GroundMotion::taking(point(node).head<2>(), m_course.at(0).head<2>(), wrappedAngle(turn));
}

} // namespace quadrille
