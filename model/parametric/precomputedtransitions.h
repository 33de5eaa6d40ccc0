// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/onlinetransition.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// A transition that is always the same.
struct FixedTransition
{
    std::size_t leavingFrame = 0; ///< of the source
    std::size_t arrivalFrame = 0; ///< of the target
    SpacePoint leavingPlace{};
    SpacePoint arrivalPlace{};
    double dissimilarity = 0; ///< E_S, 0 … 1000
};

struct PrecomputedTransitionSettings
{
    std::size_t count = 10;   ///< at most
    std::size_t apart = 3;    ///< frames of source or target between any two of them
    double latencyWeight = 5; ///< λ for a frame
    int steps = 10;           ///< of each axis' range, as TransitionSearchSettings
    double stepsAFrame = 1;   ///< likewise
};

/// The best fixed transitions from a motion space to another one, with which the online search is compared
/// (IA4D section 3.2.4, Table 2).
class PrecomputedTransitions
{
public:
    /// Pairs of frames that are no worse than the eight pairs around them, each at its best pair of places,
    /// the best first; those too near to a better one are left out. The best places are nodes, as between
    /// them dissimilarities are bilinear. \pre The table is of these spaces.
    PrecomputedTransitions(const SimilarityTable& table, const MotionSpace& source, const MotionSpace& target,
                           const PrecomputedTransitionSettings& settings = {});

    const std::vector<FixedTransition>& transitions() const { return m_transitions; }

    /// The one of least cost: the source is played on until it is left, the target from the arrival on until
    /// the goal; both last long enough for the place to move there, in cycles another round if need be. None
    /// where spaces without a cycle have no frames left for any.
    std::optional<TransitionChoice> choose(const SpaceState& source, const TransitionGoal& goal) const;

private:
    struct Side
    {
        TransitionPlaces places;
        WeightSpace weights;
        std::size_t frames = 0;
        bool isCyclic = false;

        Side(const MotionSpace& space, int steps);
        std::optional<int> framesUntil(std::size_t from, std::size_t to, int least) const;
        SpacePoint within(const SpacePoint& place) const { return weights.placeOf(weights.at(place)); }
    };

    PrecomputedTransitionSettings m_settings;
    Side m_source;
    Side m_target;
    std::vector<FixedTransition> m_transitions;
};

/// From where to where a transition is asked for.
struct TransitionRequest
{
    SpaceState source;
    TransitionGoal goal; ///< one frame
};

/// Random states of two spaces, the same for the same seed.
std::vector<TransitionRequest> randomRequests(const MotionSpace& source, const MotionSpace& target,
                                              std::size_t count, std::uint64_t seed);

} // namespace quadrille
