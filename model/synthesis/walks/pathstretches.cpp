// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathstretches.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <tbb/parallel_for.h>
#include <tuple>
#include <utility>

namespace quadrille {

namespace {

/// A transition out of a take, some frames after a stretch began.
struct Leave
{
    MoveIndex move = noMove;
    double weight = 0; ///< with that of the frames before it
};

/// A stretch in the making.
class StretchMaker
{
public:
    StretchMaker(const StretchMaterial& material, std::size_t begin)
        : m_material(material), m_begin(material.grid.frame(begin))
    {
        m_last = m_begin;
    }

    /// Plays on to a frame of the take that it is in. \return whether there is one.
    bool playTo(NodeIndex node)
    {
        while (m_last < node) {
            const MoveIndex move = m_material.graph.playedOn(m_last);
            if (move == noMove)
                return false;
            m_stretch.weight += m_material.graph.move(move).weight;
            m_walked += m_material.motions.wayBetween(m_last, m_last + 1);
            ++m_last;
            pass(m_material.motions.point(m_last), m_last, m_last);
        }
        return true;
    }

    void leave(MoveIndex index)
    {
        const WalkMove& move = m_material.graph.move(index);
        const MoveMotions::Motion& motion = m_material.motions.of(index);
        m_stretch.weight += move.weight + motion.weight;
        const double begun = m_walked;
        for (const MoveMotions::Step& step : motion.steps) {
            m_walked = begun + static_cast<double>(step.arcLength);
            pass(step.point.cast<double>(), step.source, step.destination);
        }
        m_placement = m_placement * motion.exit;
        m_last = move.to;
    }

    /// Plays on for so many frames, then to the next frame of the grid from which it has led on.
    std::optional<Stretch> ended(NodeIndex least)
    {
        if (!playTo(m_last + least))
            return std::nullopt;
        std::size_t end = m_material.grid.before(m_last);
        while (m_material.grid.frame(end) != m_last || m_walked < m_material.leastWay) {
            if (!playTo(m_last + 1)) {
                m_stretch.leadsOn = false;
                break;
            }
            end = m_material.grid.before(m_last);
        }
        m_stretch.to = end;
        m_stretch.turn = m_placement.turn;
        sample();
        return std::move(m_stretch);
    }

private:
    void pass(const Vec3d& point, NodeIndex source, NodeIndex destination)
    {
        const Vec3d& origin = m_material.motions.point(m_begin);
        const Vec2d ground = m_placement(Vec2d(point.head<2>())) - origin.head<2>();
        m_passed.push_back({.point = {ground.x(), ground.y(), point.z()},
                            .walked = m_walked,
                            .source = source,
                            .destination = destination});
    }

    void sample()
    {
        constexpr std::size_t count = 4;
        std::size_t before = 0;
        double walked = 0;
        for (std::size_t i = 1; i <= count; ++i) {
            const std::size_t passed = m_passed.size() * i / count;
            if (passed == before)
                continue;
            Stretch::Sample sample = m_passed[passed - 1];
            sample.way = sample.walked - walked;
            sample.frames = static_cast<double>(passed - before);
            walked = sample.walked;
            before = passed;
            m_stretch.samples.push_back(sample);
        }
    }

    const StretchMaterial& m_material;
    NodeIndex m_begin;
    NodeIndex m_last; ///< frame that it has come to
    GroundMotion m_placement;
    double m_walked = 0;
    std::vector<Stretch::Sample> m_passed; ///< every output frame
    Stretch m_stretch;
};

/// The lightest transitions to each part of each take from a frame and the next ones.
std::vector<Leave> leavesAfter(const StretchMaterial& material, NodeIndex begin)
{
    constexpr NodeIndex part = 8; ///< frames
    constexpr std::size_t most = 128;
    const WalkGraph& graph = material.graph;
    const FrameLayout& layout = graph.layout();
    std::map<std::tuple<NodeIndex, int, NodeIndex>, Leave> lightest;
    double played = 0;
    for (NodeIndex node = begin; node < begin + material.grid.stride() ||
                                 material.motions.wayBetween(begin, node) < material.leastWay;
         ++node) {
        const auto [first, end] = graph.from(node);
        for (MoveIndex index = first; index < end; ++index) {
            const WalkMove& move = graph.move(index);
            if (move.kind == EdgeKind::Original)
                continue;
            const int sequence = layout.sequenceOf(move.to);
            const Leave leave{.move = index, .weight = played + move.weight};
            const auto [known, isNew] =
                lightest.try_emplace({(node - begin) / material.grid.stride(), sequence,
                                      (move.to - layout.firstOf(sequence)) / part},
                                     leave);
            if (!isNew && leave.weight < known->second.weight)
                known->second = leave;
        }
        const MoveIndex next = graph.playedOn(node);
        if (next == noMove)
            break;
        played += graph.move(next).weight;
    }
    std::vector<Leave> leaves;
    std::ranges::transform(lightest, std::back_inserter(leaves),
                           [](const auto& placed) { return placed.second; });
    std::ranges::stable_sort(leaves, {}, &Leave::weight);
    leaves.resize(std::min(leaves.size(), most));
    return leaves;
}

std::vector<Stretch> stretchesFrom(const StretchMaterial& material, std::size_t begin,
                                   const std::vector<Leave>& leaves)
{
    std::vector<Stretch> stretches;
    if (std::optional<Stretch> stretch = StretchMaker(material, begin).ended(1))
        stretches.push_back(*std::move(stretch));
    for (const Leave& leave : leaves) {
        StretchMaker maker(material, begin);
        maker.playTo(material.graph.move(leave.move).from);
        maker.leave(leave.move);
        if (std::optional<Stretch> stretch = maker.ended(std::max(0, material.leastRun - 1)))
            stretches.push_back(*std::move(stretch));
    }
    return stretches;
}

} // namespace

FrameGrid::FrameGrid(const FrameLayout& layout, NodeIndex stride) : m_layout(layout), m_stride(stride)
{
    for (int sequence = 0; sequence < layout.sequenceCount(); ++sequence) {
        m_firstOf.push_back(m_frames.size());
        for (NodeIndex frame = layout.firstOf(sequence); frame <= layout.lastOf(sequence); frame += stride)
            m_frames.push_back(frame);
    }
}

std::size_t FrameGrid::before(NodeIndex node) const
{
    const int sequence = m_layout.sequenceOf(node);
    const NodeIndex count = (m_layout.countOf(sequence) - 1) / m_stride + 1;
    const NodeIndex index = (node - m_layout.firstOf(sequence)) / m_stride;
    return m_firstOf[static_cast<std::size_t>(sequence)] +
           static_cast<std::size_t>(std::min(index, count - 1));
}

std::vector<std::vector<Stretch>> stretchesOf(const StretchMaterial& material)
{
    const std::size_t count = material.grid.count();
    std::vector<std::vector<Leave>> leaves(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t begin) {
        leaves[begin] = leavesAfter(material, material.grid.frame(begin));
    });
    std::vector<MoveIndex> moves;
    for (const std::vector<Leave>& some : leaves)
        std::ranges::transform(some, std::back_inserter(moves), &Leave::move);
    material.motions.prepare(std::move(moves));
    std::vector<std::vector<Stretch>> stretches(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t begin) {
        stretches[begin] = stretchesFrom(material, begin, leaves[begin]);
    });
    return stretches;
}

} // namespace quadrille
