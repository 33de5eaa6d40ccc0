// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/constraintautomaton.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace quadrille {

/// States that have met as much of what is asked, the most promising first.
/// \tparam Candidate  has a rank (lower is more promising) and an order, which no two share.
template <typename Candidate>
class BeamLayer
{
public:
    /// \param quarters  of the action that is being performed.
    BeamLayer(const AutomatonState& stage, int quarters) : m_stage(stage), m_quarters(quarters) {}

    bool has(const AutomatonState& stage, int quarters) const
    {
        return quarters == m_quarters && stage.key == m_stage.key && stage.step == m_stage.step &&
               stage.span == m_stage.span && stage.required == m_stage.required &&
               stage.isFollowing == m_stage.isFollowing;
    }
    bool isEmpty() const { return m_open.empty(); }
    /// Whether a candidate of this rank would be kept; adding others is a waste.
    bool takes(double rank) const { return rank < m_limit; }
    /// Beyond eight times the width the less promising half goes, and nothing so bad is taken any more. Cost:
    /// O(log n), amortised.
    void add(const Candidate& candidate, std::int64_t width)
    {
        m_open.push_back(candidate);
        std::push_heap(m_open.begin(), m_open.end(), isWorse);
        const auto most = static_cast<std::size_t>(4 * width);
        if (m_open.size() < 2 * most)
            return;
        const auto better = [](const Candidate& a, const Candidate& b) { return isWorse(b, a); };
        std::nth_element(m_open.begin(), m_open.begin() + static_cast<std::ptrdiff_t>(most), m_open.end(),
                         better);
        m_limit = m_open[most].rank;
        m_open.resize(most);
        std::make_heap(m_open.begin(), m_open.end(), isWorse);
    }
    /// The most promising one, which goes. \pre It is not empty.
    Candidate take()
    {
        std::pop_heap(m_open.begin(), m_open.end(), isWorse);
        Candidate best = m_open.back();
        m_open.pop_back();
        return best;
    }

private:
    /// The best one comes last, as heaps have it.
    static bool isWorse(const Candidate& a, const Candidate& b)
    {
        return a.rank != b.rank ? a.rank > b.rank : a.order > b.order;
    }

    AutomatonState m_stage;
    int m_quarters;
    std::vector<Candidate> m_open;
    double m_limit = std::numeric_limits<double>::infinity();
};

/// States that have come about as far and were not looked at yet. Those that have met more of what is
/// asked and those that have met less do not compete: what is still to come is not in their costs.
template <typename Candidate>
class BeamFront
{
public:
    /// Made where there is none yet. Good until another is made.
    BeamLayer<Candidate>& layer(const AutomatonState& stage, int quarters)
    {
        for (BeamLayer<Candidate>& layer : m_layers) {
            if (layer.has(stage, quarters))
                return layer;
        }
        return m_layers.emplace_back(stage, quarters);
    }
    /// How many states are to be looked at: no fewer than asked for, and an eighth of them in each layer.
    std::int64_t width(std::int64_t least) const
    {
        const std::int64_t turns = std::max(std::int64_t{1}, least / 8);
        return std::max(least, turns * static_cast<std::int64_t>(m_layers.size()));
    }
    /// The best state of the layer whose turn it is. None where all layers are empty.
    std::optional<Candidate> take()
    {
        for (std::size_t tried = 0; tried < m_layers.size(); ++tried) {
            BeamLayer<Candidate>& layer = m_layers[m_next++ % m_layers.size()];
            if (!layer.isEmpty())
                return layer.take();
        }
        return std::nullopt;
    }

private:
    std::vector<BeamLayer<Candidate>> m_layers;
    std::size_t m_next = 0;
};

} // namespace quadrille
