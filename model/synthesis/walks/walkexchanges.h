// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/followwalk.h"

#include <optional>
#include <vector>

namespace quadrille {

/// Transitions that take the place of `count` ones of a walk, from `first` on.
struct WalkExchange
{
    std::size_t first = 0;
    std::size_t count = 1;
    std::vector<FramePair> pairs;
    double rank = 0; ///< lower is more promising
};

/// The ways to exchange one transition of a walk: for another between the same takes, for two by way of some
/// frames of any take, for one of these along with the transition before it or behind it, or both for one
/// that leaves the take between them out. Refers to the graph and the walk.
class WalkExchanges
{
public:
    /// \param place  of the transition. \param instead  what takes its place; empty: anything else. Those
    /// around a given one may be nearer to it than `leastRun`.
    WalkExchanges(const WalkGraph& graph, const Walk& walk, std::size_t place,
                  const std::optional<FramePair>& instead, int leastRun);

    /// At most 256 of each kind, chosen by weight and nearness to the frames of now.
    std::vector<WalkExchange> all() const;
    /// The walk after an exchange; nothing where its frames do not follow each other, or are too few.
    std::optional<Walk> changed(const WalkExchange& exchange) const;

private:
    struct Alternative
    {
        FramePair pair;
        double rank = 0;
    };

    bool isOneTake(const WalkSpan& span) const;
    NodeIndex leastAtEnd(const WalkSpan& before) const;
    bool isLeft(const FramePair& pair) const { return pair == m_walk.transition(m_place); }
    WalkSpan takeOf(NodeIndex node) const;
    double rankOf(const WalkMove& move, const FramePair& now) const;
    std::vector<Alternative> alternatives(const FramePair& now) const;
    void addDetours(std::vector<WalkExchange>& all) const;
    void addShortcut(std::size_t place, std::vector<WalkExchange>& all) const;
    void addBoth(std::size_t place, const std::vector<Alternative>& first,
                 const std::vector<Alternative>& second, std::vector<WalkExchange>& all) const;

    const WalkGraph& m_graph;
    const Walk& m_walk;
    std::size_t m_place;
    std::optional<FramePair> m_instead;
    NodeIndex m_leastRun;
};

/// The cheapest walk that an exchange makes, on all cores; of two alike the first. \param limit  it costs
/// less. \return nothing where there is none. \throws Error Cancelled.
std::optional<FoundRoute> bestExchange(const FollowedCourse& course, const WalkExchanges& exchanges,
                                       double limit, const Progress& progress);

} // namespace quadrille
