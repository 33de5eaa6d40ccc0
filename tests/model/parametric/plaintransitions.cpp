// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/parametric/plaintransitions.h"

#include <algorithm>
#include <cmath>

namespace quadrille::test {

namespace {

struct ReachedPlace
{
    SpacePoint place;
    NodeWeights weights;
    int frames = 0;
};

std::vector<ReachedPlace> reachedPlaces(const MotionSpace& space, const SpacePoint& place,
                                        const TransitionSearchSettings& settings)
{
    const TransitionPlaces places = transitionPlaces(space.weights, settings.steps);
    const NodeWeights own = space.weights.at(place);
    const SpacePoint within = space.weights.placeOf(own);
    std::vector<ReachedPlace> reached{{within, own, 0}};
    for (std::size_t p = 0; p < places.places.size(); ++p)
        reached.push_back({places.places[p], places.weights[p],
                           framesBetween(places, within, places.places[p], settings.stepsAFrame)});
    return reached;
}

} // namespace

std::vector<TransitionChoice> plainTransitions(const SimilarityTable& table, const MotionSpace& source,
                                               const MotionSpace& target, const SpaceState& state,
                                               const TransitionGoal& goal,
                                               const TransitionSearchSettings& settings)
{
    const auto sourceFrames = static_cast<int>(table.sourceFrames);
    const auto targetFrames = static_cast<int>(table.targetFrames);
    const std::vector<ReachedPlace> from = reachedPlaces(source, state.place, settings);
    const std::vector<ReachedPlace> to = reachedPlaces(target, goal.place, settings);
    int start = static_cast<int>(std::floor(state.frame + 0.5));
    start = source.isCyclic ? start % sourceFrames : std::min(start, sourceFrames - 1);
    std::vector<TransitionChoice> choices;
    for (int latency = 0; latency <= 2 * settings.depth; ++latency) {
        for (int l = std::max(0, latency - settings.depth); l <= std::min(latency, settings.depth); ++l) {
            const int m = latency - l;
            if (!source.isCyclic && start + l >= sourceFrames)
                continue;
            const auto leaving = static_cast<std::size_t>((start + l) % sourceFrames);
            TransitionChoice best{.dissimilarity = 1e9};
            int end = static_cast<int>(goal.firstFrame);
            while (true) {
                const int arrival = end - m;
                for (const ReachedPlace& i : from) {
                    for (const ReachedPlace& j : to) {
                        if (i.frames > l || j.frames > m || (!target.isCyclic && arrival < 0))
                            continue;
                        const auto arriving =
                            static_cast<std::size_t>((arrival % targetFrames + targetFrames) % targetFrames);
                        const double cost = dissimilarity(table, leaving, i.weights, arriving, j.weights);
                        // As the search does, so that rounding makes the same ties.
                        if (cost + settings.latencyWeight * latency >= best.cost())
                            continue;
                        best = {.sourceFrames = l,
                                .targetFrames = m,
                                .leavingFrame = leaving,
                                .arrivalFrame = arriving,
                                .endFrame = static_cast<std::size_t>(end),
                                .leavingPlace = i.place,
                                .arrivalPlace = j.place,
                                .dissimilarity = cost,
                                .latencyCost = settings.latencyWeight * latency};
                    }
                }
                if (end == static_cast<int>(goal.lastFrame))
                    break;
                end = (end + 1) % targetFrames;
            }
            if (best.dissimilarity < 1e9)
                choices.push_back(best);
        }
    }
    // By latency and l already.
    std::stable_sort(
        choices.begin(), choices.end(),
        [](const TransitionChoice& a, const TransitionChoice& b) { return a.cost() < b.cost(); });
    choices.resize(std::min(choices.size(), settings.choices));
    return choices;
}

} // namespace quadrille::test
