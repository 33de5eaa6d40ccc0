// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/onlinetransition.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace quadrille {

namespace {

/// Bounds in single precision are no more than this share of the greatest distance too high.
constexpr double boundSlack = 2e-6;

/// A blend as four nodes; what is not needed repeats a node with weight 0.
std::array<std::size_t, 4> paddedNodes(const NodeWeights& weights)
{
    std::array<std::size_t, 4> nodes{};
    for (std::size_t n = 0; n < 4; ++n)
        nodes[n] =
            static_cast<std::size_t>(weights.nodes[n < static_cast<std::size_t>(weights.count) ? n : 0]);
    return nodes;
}

std::array<float, 4> paddedWeights(const NodeWeights& weights)
{
    std::array<float, 4> padded{};
    for (std::size_t n = 0; n < static_cast<std::size_t>(weights.count); ++n)
        padded[n] = static_cast<float>(weights.weights[n]);
    return padded;
}

float blendOf(const std::array<float, 4>& weights, const std::array<float, 4>& values)
{
    return (weights[0] * values[0] + weights[1] * values[1]) +
           (weights[2] * values[2] + weights[3] * values[3]);
}

std::array<float, 4> valuesAt(const float* values, const std::array<std::size_t, 4>& nodes)
{
    return {values[nodes[0]], values[nodes[1]], values[nodes[2]], values[nodes[3]]};
}

} // namespace

TransitionSearch::Side::Side(const MotionSpace& motion, std::size_t frameCount,
                             const TransitionSearchSettings& settings)
    : space(motion.weights)
    , places(transitionPlaces(motion.weights, settings.steps))
    , stepsAFrame(settings.stepsAFrame)
    , isCyclic(motion.isCyclic)
    , frames(frameCount)
    , reaches(static_cast<std::size_t>(settings.depth) + 1)
{
    std::map<std::array<std::size_t, 4>, std::vector<std::size_t>> byNodes;
    for (std::size_t p = 0; p < places.places.size(); ++p)
        byNodes[paddedNodes(places.weights[p])].push_back(p);
    for (const auto& [nodes, members] : byNodes) {
        groups.push_back({nodes, points.size(), members.size()});
        for (const std::size_t p : members)
            points.push_back({paddedWeights(places.weights[p]), p + 1});
    }
    reach.resize(points.size());
    order.resize(points.size());
    ends.resize(groups.size() * reaches);
}

const NodeWeights& TransitionSearch::Side::weights(std::size_t place) const
{
    return place == 0 ? own : places.weights[place - 1];
}

const SpacePoint& TransitionSearch::Side::placeOf(std::size_t place) const
{
    return place == 0 ? ownPlace : places.places[place - 1];
}

void TransitionSearch::Side::start(const SpacePoint& place)
{
    own = space.at(place);
    ownPlace = space.placeOf(own);
    for (std::size_t p = 0; p < points.size(); ++p)
        reach[p] = framesBetween(places, ownPlace, places.places[points[p].place - 1], stepsAFrame);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        // Counts of each reach become where it ends; backwards, points of one reach keep their order.
        std::size_t* end = ends.data() + g * reaches;
        std::fill(end, end + reaches, 0);
        const Group& group = groups[g];
        for (std::size_t p = group.first; p < group.first + group.count; ++p)
            if (static_cast<std::size_t>(reach[p]) < reaches)
                ++end[reach[p]];
        std::size_t before = group.first;
        for (std::size_t r = 0; r < reaches; ++r)
            before += std::exchange(end[r], before);
        for (std::size_t p = group.first; p < group.first + group.count; ++p)
            if (static_cast<std::size_t>(reach[p]) < reaches)
                order[end[reach[p]]++] = p;
    }
}

TransitionSearch::TransitionSearch(std::shared_ptr<const SimilarityTable> table, const MotionSpace& source,
                                   const MotionSpace& target, const TransitionSearchSettings& settings)
    : m_table(std::move(table))
    , m_settings(settings)
    , m_source(source, m_table->sourceFrames, settings)
    , m_target(target, m_table->targetFrames, settings)
{
    assert(settings.depth >= 0 && settings.steps > 0 && settings.stepsAFrame > 0 && settings.choices > 0);
    const std::size_t pairs = m_table->leasts.size();
    m_rowLeasts.assign(pairs * m_table->sourceNodes, std::numeric_limits<float>::infinity());
    m_columnLeasts.assign(pairs * m_table->targetNodes, std::numeric_limits<float>::infinity());
    const float* value = m_table->distances.data();
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        float* row = m_rowLeasts.data() + pair * m_table->sourceNodes;
        float* column = m_columnLeasts.data() + pair * m_table->targetNodes;
        for (std::size_t s = 0; s < m_table->sourceNodes; ++s) {
            for (std::size_t t = 0; t < m_table->targetNodes; ++t, ++value) {
                row[s] = std::min(row[s], *value);
                column[t] = std::min(column[t], *value);
            }
        }
    }
    m_blocks.reserve(m_source.reaches * m_target.reaches * m_table->targetFrames);
    m_leaving.resize(m_source.points.size() + 1);
    m_arriving.resize(m_target.points.size() + 1);
    m_row.resize(m_table->targetNodes);
    m_column.resize(m_table->sourceNodes);
    m_leasts.resize(m_table->targetNodes);
    m_found.reserve(settings.choices + 1);
    m_choices.reserve(settings.choices);
}

bool TransitionSearch::isBetter(const Found& a, const Found& b)
{
    const auto key = [](const Found& found) {
        const Block& block = found.block;
        return std::make_tuple(found.cost, block.l + block.m, block.l, block.end, found.leaving,
                               found.arrival);
    };
    return key(a) < key(b);
}

double TransitionSearch::limitOf(const Block& block) const
{
    for (const Found& found : m_found)
        if (found.block.l == block.l && found.block.m == block.m)
            return found.cost;
    return m_found.size() < m_settings.choices ? std::numeric_limits<double>::infinity()
                                               : m_found.back().cost;
}

void TransitionSearch::offer(const Block& block, std::size_t leaving, std::size_t arrival)
{
    Found found{.block = block, .leaving = leaving, .arrival = arrival};
    found.dissimilarity = dissimilarity(*m_table, block.leavingFrame, m_source.weights(leaving),
                                        block.arrivalFrame, m_target.weights(arrival));
    found.cost = found.dissimilarity + m_settings.latencyWeight * (block.l + block.m);
    const auto same = std::find_if(m_found.begin(), m_found.end(), [&](const Found& other) {
        return other.block.l == block.l && other.block.m == block.m;
    });
    if (same != m_found.end()) {
        if (!isBetter(found, *same))
            return;
        m_found.erase(same);
    }
    m_found.insert(std::upper_bound(m_found.begin(), m_found.end(), found, isBetter), found);
    if (m_found.size() > m_settings.choices)
        m_found.pop_back();
}

/// Blocks of a frame that is left and an end frame, by their latency until the function says false.
template <typename Use>
void TransitionSearch::forBlocks(const SpaceState& source, const TransitionGoal& goal, Use use)
{
    const std::size_t from = nearestFrame(source.frame, m_source.frames, m_source.isCyclic);
    const std::size_t targetFrames = m_target.frames;
    const std::size_t endCount = (goal.lastFrame + targetFrames - goal.firstFrame) % targetFrames + 1;
    for (int l = 0; l <= m_settings.depth; ++l) {
        const std::size_t leaving = from + static_cast<std::size_t>(l);
        if (!m_source.isCyclic && leaving >= m_source.frames)
            break;
        for (std::size_t e = 0; e < endCount; ++e) {
            std::size_t arrival = (goal.firstFrame + e) % targetFrames;
            for (int m = 0; m <= m_settings.depth; ++m) {
                if (!use(Block{.l = l,
                               .m = m,
                               .leavingFrame = leaving % m_source.frames,
                               .arrivalFrame = arrival,
                               .end = e}))
                    break;
                if (arrival == 0 && !m_target.isCyclic)
                    break;
                arrival = (arrival + targetFrames - 1) % targetFrames;
            }
        }
    }
}

std::size_t TransitionSearch::survivors(const Side& side, int frames, const float* leasts, float limit,
                                        std::vector<Survivor>& out) const
{
    std::size_t count = 0;
    out[count] = {paddedWeights(side.own), paddedNodes(side.own), 0};
    if (blendOf(out[count].weights, valuesAt(leasts, out[count].nodes)) <= limit)
        ++count;
    for (std::size_t g = 0; g < side.groups.size(); ++g) {
        const Group& group = side.groups[g];
        const std::array<float, 4> values = valuesAt(leasts, group.nodes);
        if (std::min(std::min(values[0], values[1]), std::min(values[2], values[3])) > limit)
            continue;
        const std::size_t end = side.ends[g * side.reaches + static_cast<std::size_t>(frames)];
        for (std::size_t i = group.first; i < end; ++i) {
            const Point& point = side.points[side.order[i]];
            if (blendOf(point.weights, values) <= limit)
                out[count++] = {point.weights, group.nodes, point.place};
        }
    }
    return count;
}

float TransitionSearch::limitOfDistance(const Block& block) const
{
    const double limit = limitOf(block);
    if (limit == std::numeric_limits<double>::infinity())
        return std::numeric_limits<float>::infinity();
    const double left = limit - m_settings.latencyWeight * (block.l + block.m);
    return static_cast<float>((left / 1000 + boundSlack) * static_cast<double>(m_table->greatest));
}

/// The nearest to a place of the other side, whose blend of the table is given.
std::size_t TransitionSearch::bestOf(const std::vector<Survivor>& survivors, std::size_t count,
                                     const float* values)
{
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const float value = blendOf(survivors[i].weights, valuesAt(values, survivors[i].nodes));
        if (value < least) {
            least = value;
            best = i;
        }
    }
    return best;
}

void TransitionSearch::blendRows(const Survivor& left, const float* values)
{
    const std::size_t columns = m_table->targetNodes;
    for (std::size_t t = 0; t < columns; ++t)
        m_row[t] =
            blendOf(left.weights, {values[left.nodes[0] * columns + t], values[left.nodes[1] * columns + t],
                                   values[left.nodes[2] * columns + t], values[left.nodes[3] * columns + t]});
}

void TransitionSearch::blendColumns(const Survivor& right, const float* values)
{
    for (std::size_t s = 0; s < m_table->sourceNodes; ++s)
        m_column[s] = blendOf(right.weights, valuesAt(values + s * m_table->targetNodes, right.nodes));
}

/// Finds a good pair soon, by choosing the best place on either side for the one on the other in turns.
void TransitionSearch::descend(const Block& block, const float* values, std::size_t leaving,
                               std::size_t arriving)
{
    std::size_t i = 0;
    for (int turn = 0; turn < 2; ++turn) {
        blendRows(m_leaving[i], values);
        const std::size_t j = bestOf(m_arriving, arriving, m_row.data());
        blendColumns(m_arriving[j], values);
        i = bestOf(m_leaving, leaving, m_column.data());
        offer(block, m_leaving[i].place, m_arriving[j].place);
    }
}

/// Leaves out what is too bad even if each of its nodes may have the best of the other side for itself.
std::size_t TransitionSearch::narrowed(std::vector<Survivor>& kept, std::size_t count,
                                       std::span<const float> leasts, float limit)
{
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (blendOf(kept[i].weights, valuesAt(leasts.data(), kept[i].nodes)) <= limit)
            kept[left++] = kept[i];
    return left;
}

void TransitionSearch::visit(const Block& block)
{
    const std::size_t pair = m_table->pairOf(block.leavingFrame, block.arrivalFrame);
    const std::size_t sourceNodes = m_table->sourceNodes;
    const std::size_t targetNodes = m_table->targetNodes;
    float limit = limitOfDistance(block);
    std::size_t leaving =
        survivors(m_source, block.l, m_rowLeasts.data() + pair * sourceNodes, limit, m_leaving);
    if (leaving == 0)
        return;
    std::size_t arriving =
        survivors(m_target, block.m, m_columnLeasts.data() + pair * targetNodes, limit, m_arriving);
    if (arriving == 0)
        return;
    const float* values = m_table->block(block.leavingFrame, block.arrivalFrame).data();
    if (leaving * arriving > sourceNodes * arriving + targetNodes * leaving) {
        descend(block, values, leaving, arriving);
        limit = limitOfDistance(block);
        std::fill(m_column.begin(), m_column.end(), std::numeric_limits<float>::infinity());
        for (std::size_t s = 0; s < sourceNodes; ++s)
            for (std::size_t j = 0; j < arriving; ++j)
                m_column[s] =
                    std::min(m_column[s], blendOf(m_arriving[j].weights,
                                                  valuesAt(values + s * targetNodes, m_arriving[j].nodes)));
        leaving = narrowed(m_leaving, leaving, m_column, limit);
        std::fill(m_leasts.begin(), m_leasts.end(), std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < leaving; ++i) {
            blendRows(m_leaving[i], values);
            for (std::size_t t = 0; t < targetNodes; ++t)
                m_leasts[t] = std::min(m_leasts[t], m_row[t]);
        }
        arriving = narrowed(m_arriving, arriving, m_leasts, limit);
    }
    for (std::size_t i = 0; i < leaving; ++i) {
        blendRows(m_leaving[i], values);
        for (std::size_t j = 0; j < arriving; ++j) {
            const Survivor& right = m_arriving[j];
            if (blendOf(right.weights, valuesAt(m_row.data(), right.nodes)) > limit)
                continue;
            offer(block, m_leaving[i].place, right.place);
            limit = limitOfDistance(block);
        }
    }
}

std::span<const TransitionChoice> TransitionSearch::search(const SpaceState& source,
                                                           const TransitionGoal& goal)
{
    assert(goal.firstFrame < m_target.frames && goal.lastFrame < m_target.frames);
    assert(m_target.isCyclic || goal.firstFrame <= goal.lastFrame);
    const double slack = boundSlack * 1000;
    const auto mostCost = [&] {
        return m_found.size() < m_settings.choices ? std::numeric_limits<double>::infinity()
                                                   : m_found.back().cost;
    };
    m_source.start(source.place);
    m_target.start(goal.place);
    m_found.clear();
    m_blocks.clear();
    // Both places as they are, at first: an end frame before has the same arrival frame a frame earlier.
    forBlocks(source, goal, [&](const Block& block) {
        if (m_settings.latencyWeight * (block.l + block.m) > mostCost())
            return false;
        offer(block, 0, 0);
        return block.end == 0;
    });
    forBlocks(source, goal, [&](Block block) {
        const double latency = m_settings.latencyWeight * (block.l + block.m);
        const float least = m_table->leasts[m_table->pairOf(block.leavingFrame, block.arrivalFrame)];
        block.bound = static_cast<double>(least) * m_table->scale() + latency;
        if (block.bound <= limitOf(block) + slack)
            m_blocks.push_back(block);
        return latency <= mostCost();
    });
    std::sort(m_blocks.begin(), m_blocks.end(), [](const Block& a, const Block& b) {
        return std::tie(a.bound, a.l, a.m, a.end) < std::tie(b.bound, b.l, b.m, b.end);
    });
    for (const Block& block : m_blocks)
        if (block.bound <= limitOf(block) + slack)
            visit(block);
    m_choices.clear();
    for (const Found& found : m_found)
        m_choices.push_back({.sourceFrames = found.block.l,
                             .targetFrames = found.block.m,
                             .leavingFrame = found.block.leavingFrame,
                             .arrivalFrame = found.block.arrivalFrame,
                             .endFrame = (goal.firstFrame + found.block.end) % m_target.frames,
                             .leavingPlace = m_source.placeOf(found.leaving),
                             .arrivalPlace = m_target.placeOf(found.arrival),
                             .dissimilarity = found.dissimilarity,
                             .latencyCost = found.cost - found.dissimilarity});
    return m_choices;
}

} // namespace quadrille
