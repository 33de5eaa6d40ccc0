// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/sharedtable.h"
#include "model/core/table.h"
#include "model/graph/digraph.h"
#include "model/transition/framelayout.h"

namespace quadrille {

/// α where none is given: weight of a frame of time against the cost of transitions (SMCAS §4.1.2).
inline constexpr double usualAlpha = 0.01;

/// What the graphs of one character are made from, whatever α: the transitions between its frames, checked on
/// entry. Edge weights come from it (SMCAS eq. 10).
class TransitionCosts
{
public:
    /// \param cost  D, frames × frames, as in TransitionTable; infinite where there is no transition.
    /// \param length  L, frames × frames, cells of the warp path; at least 1 where there is a transition.
    /// \param largestDistance  d_max, the largest pose distance between frames of the character, in the unit
    /// of D; 0 only where every cost is 0 or infinite.
    /// \pre Both tables are as large as the layout.
    /// \throws Error BadArgument for a cost that is negative or NaN, and for d_max.
    TransitionCosts(Table<float> cost, Table<std::uint16_t> length, double largestDistance,
                    FrameLayout layout)
        : TransitionCosts(std::move(layout), largestDistance, std::move(cost),
                          SharedTable<std::uint16_t>(std::move(length)))
    {
    }
    /// The same without a copy of lengths that others have. \throws Error, \pre as the constructor.
    TransitionCosts(FrameLayout layout, double largestDistance, Table<float> cost,
                    SharedTable<std::uint16_t> length);

    const FrameLayout& layout() const { return m_layout; }
    TableView<float> cost() const { return m_cost; }
    TableView<std::uint16_t> length() const { return *m_length; }
    /// Gives back the memory of lengths in a file until they are looked at again.
    void unloadLengths() const { m_length.unload(); }
    double largestDistance() const { return m_largestDistance; }
    bool hasTransition(NodeIndex from, NodeIndex to) const { return m_cost(from, to) < infinite; }
    /// E(i,j) = D/d_max + α·L; `unreachable` where there is no transition. Original edges weigh α.
    double weight(NodeIndex from, NodeIndex to, double alpha) const
    {
        return m_cost(from, to) / m_largestDistance + alpha * (*m_length)(from, to);
    }

private:
    static constexpr float infinite = std::numeric_limits<float>::infinity();
    Table<float> m_cost;
    SharedTable<std::uint16_t> m_length;
    double m_largestDistance;
    FrameLayout m_layout;
};

/// Weights of the complete digraph, frames × frames: original edges and every transition, without those
/// inside one sequence that are dearer than playing on, α(j−i); `unreachable` elsewhere and on the diagonal.
/// Where an original edge has a transition beside it, the original stands: no transition is cheaper.
/// \throws Error BadArgument (see requireAlpha).
Table<double> completeWeights(const TransitionCosts& costs, double alpha);

/// One row of them, from a frame to all. \param row  out: `frames` weights. \pre α is valid.
void completeWeightsFrom(const TransitionCosts& costs, NodeIndex from, double alpha, double* row);

/// \throws Error BadArgument unless α is finite and not negative.
void requireAlpha(double alpha);

} // namespace quadrille
