// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/similarity.h"
#include "model/parametric/transitionplaces.h"
#include "model/parametric/transitionsettings.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// Where a space is played.
struct SpaceState
{
    double frame = 0; ///< counts as the nearest whole one
    SpacePoint place{};
};

/// Where a transition has to lead: to any of some frames, at a place.
struct TransitionGoal
{
    std::size_t firstFrame = 0;
    std::size_t lastFrame = 0; ///< included; in a cycle it may lie before the first
    SpacePoint place{};
};

/// A way from one space to another: the source is played on for some frames, then the target until it is
/// where it is wanted.
struct TransitionChoice
{
    int sourceFrames = 0;         ///< l
    int targetFrames = 0;         ///< m
    std::size_t leavingFrame = 0; ///< of the source
    std::size_t arrivalFrame = 0; ///< of the target
    std::size_t endFrame = 0;     ///< of the target, one of the goal's
    SpacePoint leavingPlace{};
    SpacePoint arrivalPlace{};
    double dissimilarity = 0; ///< E_S, 0 … 1000
    double latencyCost = 0;   ///< λ·(l + m)

    double cost() const { return dissimilarity + latencyCost; }
    bool operator==(const TransitionChoice&) const = default;
};

/// Finds transitions from a motion space to another one while they are played (IA4D section 3.2.2). Of all
/// l, m ≤ depth, all end frames and all places that are reached in l frames from the source's place, and from
/// which the goal's is reached in m, it finds those of the least E_S + λ·(l + m). Places are the one where it
/// is, and those of transitionPlaces. In a space without a cycle the trellis ends with its frames.
///
/// It is exact: bounds leave out only what costs more than what was found. Among ways that cost the same the
/// first by (l + m, l, end frame from the goal's first on, place that is left, place of arrival) is taken.
class TransitionSearch
{
public:
    /// \pre The table is of these spaces; they are not needed any more afterwards.
    TransitionSearch(std::shared_ptr<const SimilarityTable> table, const MotionSpace& source,
                     const MotionSpace& target, const TransitionSearchSettings& settings = {});

    /// The best ways that differ in (l, m), the best first; at least one. They are valid until the next
    /// search. Allocates nothing. One thread at a time.
    /// \pre Frames are those of the spaces. Cost: in practice some microseconds a space of one parameter; at
    /// worst frames of the goal · depth² · places².
    std::span<const TransitionChoice> search(const SpaceState& source, const TransitionGoal& goal);

private:
    /// Places that have their nodes in common.
    struct Group
    {
        std::array<std::size_t, 4> nodes{};
        std::size_t first = 0; ///< of points
        std::size_t count = 0;
    };
    struct Point
    {
        std::array<float, 4> weights{}; ///< of the group's nodes
        std::size_t place = 0;          ///< 0 is the one where the space is, then transitionPlaces
    };
    /// A space, and what is reached in it.
    struct Side
    {
        Side(const MotionSpace& space, std::size_t frames, const TransitionSearchSettings& settings);
        void start(const SpacePoint& place);
        const NodeWeights& weights(std::size_t place) const;
        const SpacePoint& placeOf(std::size_t place) const;

        WeightSpace space;
        TransitionPlaces places;
        double stepsAFrame;
        bool isCyclic;
        std::size_t frames;
        std::size_t reaches; ///< depth + 1
        std::vector<Group> groups;
        std::vector<Point> points;
        NodeWeights own;
        SpacePoint ownPlace{};
        std::vector<int> reach;         ///< of points
        std::vector<std::size_t> order; ///< points of each group by their reach
        std::vector<std::size_t> ends;  ///< of each group and reach: where it ends in order
    };
    /// A frame of the source, one of the target, and the latency with which they are met.
    struct Block
    {
        double bound = 0;
        int l = 0;
        int m = 0;
        std::size_t leavingFrame = 0;
        std::size_t arrivalFrame = 0;
        std::size_t end = 0; ///< from the goal's first on
    };
    /// A place that may be part of something better.
    struct Survivor
    {
        std::array<float, 4> weights{};
        std::array<std::size_t, 4> nodes{};
        std::size_t place = 0;
    };
    struct Found
    {
        Block block;
        std::size_t leaving = 0; ///< places
        std::size_t arrival = 0;
        double dissimilarity = 0;
        double cost = 0;
    };

    static bool isBetter(const Found& a, const Found& b);
    std::size_t survivors(const Side& side, int frames, const float* leasts, float limit,
                          std::vector<Survivor>& out) const;
    template <typename Use>
    void forBlocks(const SpaceState& source, const TransitionGoal& goal, Use use);
    void visit(const Block& block);
    void descend(const Block& block, const float* values, std::size_t leaving, std::size_t arriving);
    void blendRows(const Survivor& left, const float* values);
    void blendColumns(const Survivor& right, const float* values);
    static std::size_t bestOf(const std::vector<Survivor>& survivors, std::size_t count, const float* values);
    static std::size_t narrowed(std::vector<Survivor>& kept, std::size_t count, std::span<const float> leasts,
                                float limit);
    float limitOfDistance(const Block& block) const;
    void offer(const Block& block, std::size_t leaving, std::size_t arrival);
    /// What something with the latency of a block may cost at most to be taken.
    double limitOf(const Block& block) const;

    std::shared_ptr<const SimilarityTable> m_table;
    TransitionSearchSettings m_settings;
    Side m_source;
    Side m_target;
    std::vector<float> m_rowLeasts;    ///< of each block and source node
    std::vector<float> m_columnLeasts; ///< of each block and target node
    std::vector<Block> m_blocks;
    std::vector<Survivor> m_leaving;
    std::vector<Survivor> m_arriving;
    std::vector<float> m_row;    ///< of the table, for a place that is left: of each target node
    std::vector<float> m_column; ///< for a place of arrival: of each source node
    std::vector<float> m_leasts; ///< of all places that are left: of each target node the least
    std::vector<Found> m_found;
    std::vector<TransitionChoice> m_choices;
};

} // namespace quadrille
