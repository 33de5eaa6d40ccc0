// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/precomputedtransitions.h"

#include "model/core/random.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// The frame beside another one; none beyond the ends of a space without a cycle.
std::optional<std::size_t> frameBeside(std::size_t frame, int offset, std::size_t frames, bool isCyclic)
{
    const auto count = static_cast<std::ptrdiff_t>(frames);
    const std::ptrdiff_t beside = static_cast<std::ptrdiff_t>(frame) + offset;
    if (!isCyclic && (beside < 0 || beside >= count))
        return {};
    return static_cast<std::size_t>((beside + count) % count);
}

std::size_t framesApart(std::size_t a, std::size_t b, std::size_t frames, bool isCyclic)
{
    const std::size_t between = a < b ? b - a : a - b;
    return isCyclic ? std::min(between, frames - between) : between;
}

bool isLocalMinimum(const SimilarityTable& table, std::size_t s, std::size_t t, bool isSourceCyclic,
                    bool isTargetCyclic)
{
    const float least = table.leasts[table.pairOf(s, t)];
    for (const int down : {-1, 0, 1}) {
        for (const int across : {-1, 0, 1}) {
            const auto source = frameBeside(s, down, table.sourceFrames, isSourceCyclic);
            const auto target = frameBeside(t, across, table.targetFrames, isTargetCyclic);
            if (source && target && table.leasts[table.pairOf(*source, *target)] < least)
                return false;
        }
    }
    return true;
}

SpacePoint randomPlaceIn(const WeightSpace& space, Random& random)
{
    const auto [least, greatest] = space.range();
    SpacePoint place{};
    for (std::size_t d = 0; d < static_cast<std::size_t>(space.dimension()); ++d)
        place[d] = random.between(least[d], greatest[d]);
    return space.placeOf(space.at(place));
}

} // namespace

PrecomputedTransitions::Side::Side(const MotionSpace& space, int steps)
    : places(transitionPlaces(space.weights, steps))
    , weights(space.weights)
    , frames(space.frameCount())
    , isCyclic(space.isCyclic)
{
}

std::optional<int> PrecomputedTransitions::Side::framesUntil(std::size_t from, std::size_t to,
                                                             int least) const
{
    const auto count = static_cast<int>(frames);
    int between = static_cast<int>(to) - static_cast<int>(from);
    if (!isCyclic)
        return between >= least ? std::optional(between) : std::nullopt;
    while (between < least)
        between += count;
    return between - (between - least) / count * count;
}

PrecomputedTransitions::PrecomputedTransitions(const SimilarityTable& table, const MotionSpace& source,
                                               const MotionSpace& target,
                                               const PrecomputedTransitionSettings& settings)
    : m_settings(settings), m_source(source, settings.steps), m_target(target, settings.steps)
{
    std::vector<FixedTransition> minima;
    for (std::size_t s = 0; s < table.sourceFrames; ++s) {
        for (std::size_t t = 0; t < table.targetFrames; ++t) {
            if (!isLocalMinimum(table, s, t, source.isCyclic, target.isCyclic))
                continue;
            const std::span<const float> block = table.block(s, t);
            const auto best = static_cast<std::size_t>(std::ranges::min_element(block) - block.begin());
            minima.push_back({s, t, source.weights.nodes()[best / table.targetNodes].place,
                              target.weights.nodes()[best % table.targetNodes].place,
                              static_cast<double>(block[best]) * table.scale()});
        }
    }
    std::ranges::stable_sort(minima, {}, &FixedTransition::dissimilarity);
    for (const FixedTransition& minimum : minima) {
        if (m_transitions.size() == settings.count)
            return;
        const bool isNew = std::ranges::none_of(m_transitions, [&](const FixedTransition& known) {
            return framesApart(known.leavingFrame, minimum.leavingFrame, table.sourceFrames,
                               source.isCyclic) < settings.apart &&
                   framesApart(known.arrivalFrame, minimum.arrivalFrame, table.targetFrames,
                               target.isCyclic) < settings.apart;
        });
        if (isNew)
            m_transitions.push_back(minimum);
    }
}

std::optional<TransitionChoice> PrecomputedTransitions::choose(const SpaceState& source,
                                                               const TransitionGoal& goal) const
{
    const std::size_t start = nearestFrame(source.frame, m_source.frames, m_source.isCyclic);
    const SpacePoint from = m_source.within(source.place);
    const SpacePoint to = m_target.within(goal.place);
    std::optional<TransitionChoice> best;
    for (const FixedTransition& fixed : m_transitions) {
        const std::optional<int> l = m_source.framesUntil(
            start, fixed.leavingFrame,
            framesBetween(m_source.places, from, fixed.leavingPlace, m_settings.stepsAFrame));
        if (!l)
            continue;
        const int least = framesBetween(m_target.places, fixed.arrivalPlace, to, m_settings.stepsAFrame);
        for (std::size_t end = goal.firstFrame;; end = (end + 1) % m_target.frames) {
            const std::optional<int> m = m_target.framesUntil(fixed.arrivalFrame, end, least);
            if (m) {
                const TransitionChoice choice{.sourceFrames = *l,
                                              .targetFrames = *m,
                                              .leavingFrame = fixed.leavingFrame,
                                              .arrivalFrame = fixed.arrivalFrame,
                                              .endFrame = end,
                                              .leavingPlace = fixed.leavingPlace,
                                              .arrivalPlace = fixed.arrivalPlace,
                                              .dissimilarity = fixed.dissimilarity,
                                              .latencyCost = m_settings.latencyWeight * (*l + *m)};
                if (!best || choice.cost() < best->cost())
                    best = choice;
            }
            if (end == goal.lastFrame)
                break;
        }
    }
    return best;
}

std::vector<TransitionRequest> randomRequests(const MotionSpace& source, const MotionSpace& target,
                                              std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<TransitionRequest> requests(count);
    for (TransitionRequest& request : requests) {
        request.source.frame = static_cast<double>(random.next() % source.frameCount());
        request.source.place = randomPlaceIn(source.weights, random);
        request.goal.firstFrame = random.next() % target.frameCount();
        request.goal.lastFrame = request.goal.firstFrame;
        request.goal.place = randomPlaceIn(target.weights, random);
    }
    return requests;
}

} // namespace quadrille
