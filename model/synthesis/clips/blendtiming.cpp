// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/blendtiming.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille {

namespace {

/// Poses that are so far apart from their match, in lengths of the transition, are as bad as a pace that is
/// off by one.
constexpr double reachShare = 0.5;

/// The weight of the destination at each cell, as BlendEasing::Smooth has it: what of each window shows.
std::vector<double> shownShares(std::size_t cells)
{
    std::vector<double> shares;
    shares.reserve(cells);
    for (std::size_t t = 0; t < cells; ++t) {
        const double even = static_cast<double>(t) / static_cast<double>(cells - 1);
        shares.push_back(even * even * (3 - 2 * even));
    }
    return shares;
}

/// How many frames the source is ahead of the destination at each cell, against both playing on at one frame
/// a cell from their shown ends.
std::vector<double> leadsOf(const std::vector<FramePair>& path)
{
    const auto last = static_cast<double>(path.size() - 1);
    std::vector<double> leads;
    leads.reserve(path.size());
    for (const FramePair& cell : path)
        leads.push_back((cell.source - path.front().source) -
                        (cell.destination - path.back().destination + last));
    return leads;
}

/// A symmetric tridiagonal system with positive diagonal that dominates.
struct Chain
{
    std::vector<double> diagonal;
    std::vector<double> coupling; ///< of each with the next, taken from both sides

    std::vector<double> solved(std::vector<double> right) const
    {
        std::vector<double> pivots = diagonal;
        for (std::size_t t = 1; t < pivots.size(); ++t) {
            const double factor = coupling[t - 1] / pivots[t - 1];
            pivots[t] -= factor * coupling[t - 1];
            right[t] += factor * right[t - 1];
        }
        right.back() /= pivots.back();
        for (std::size_t t = pivots.size() - 1; t-- > 0;)
            right[t] = (right[t] + coupling[t] * right[t + 1]) / pivots[t];
        return right;
    }
};

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// A balance between the pace of what is shown and how well the poses of the windows match. Each window plays
/// at one frame a cell where it is all that shows; a change of lead is borne by each in the share in which
/// the other one shows, and what is missing in the end, since both come to their shown ends, by both alike,
/// most of it in the middle.
class Balance
{
public:
    explicit Balance(const std::vector<FramePair>& path) : m_shares(shownShares(path.size()))
    {
        for (std::size_t t = 0; t + 1 < m_shares.size(); ++t) {
            const double share = (m_shares[t] + m_shares[t + 1]) / 2;
            m_between.push_back(share);
            m_waves.push_back(share * (1 - share));
        }
        const double total = std::accumulate(m_waves.begin(), m_waves.end(), 0.0);
        for (double& wave : m_waves)
            wave /= total;
        m_leads = balanced(leadsOf(path));
    }

    /// How far each window goes from cell to cell, frames.
    struct Paces
    {
        std::vector<double> source;
        std::vector<double> destination;
    };
    Paces paces() const
    {
        const double missing = dot(missingOf(), m_leads);
        Paces paces;
        for (std::size_t t = 0; t < m_between.size(); ++t) {
            const double change = m_leads[t + 1] - m_leads[t];
            const double common = 1 + missing * m_waves[t];
            paces.source.push_back(common + m_between[t] * change);
            paces.destination.push_back(common - (1 - m_between[t]) * change);
        }
        return paces;
    }
    const std::vector<double>& shares() const { return m_shares; }

private:
    /// What of each lead is missing in the end.
    std::vector<double> missingOf() const
    {
        std::vector<double> missing{m_between.front()};
        for (std::size_t t = 1; t < m_between.size(); ++t)
            missing.push_back(m_between[t] - m_between[t - 1]);
        missing.push_back(1 - m_between.back());
        return missing;
    }

    /// The leads of the least sum of squares: of the paces against one frame a cell, each window by how much
    /// of it shows, and of the differences from the leads of the path, where both show.
    std::vector<double> balanced(const std::vector<double>& leads) const
    {
        constexpr double least = 1e-3; // so that ends without a say follow their neighbours
        const auto weight = [](double share) { return share * (1 - share) + least; };
        const std::size_t count = leads.size();
        const double reach = reachShare * static_cast<double>(count);
        Chain chain{.diagonal = std::vector<double>(count), .coupling = {}};
        std::vector<double> right;
        for (std::size_t t = 0; t < count; ++t) {
            const double near = weight(m_shares[t]) / (reach * reach);
            chain.diagonal[t] += near;
            right.push_back(near * leads[t]);
            if (t + 1 == count)
                break;
            chain.coupling.push_back(weight(m_between[t]));
            chain.diagonal[t] += chain.coupling[t];
            chain.diagonal[t + 1] += chain.coupling[t];
        }
        // What is missing adds a square of one sum of leads (Sherman and Morrison).
        const std::vector<double> missing = missingOf();
        const double price = dot(m_waves, m_waves);
        std::vector<double> found = chain.solved(std::move(right));
        const std::vector<double> against = chain.solved(missing);
        const double factor = price * dot(missing, found) / (1 + price * dot(missing, against));
        for (std::size_t t = 0; t < count; ++t)
            found[t] -= factor * against[t];
        return found;
    }

    std::vector<double> m_shares;  ///< of the destination in what shows, at each cell
    std::vector<double> m_between; ///< and between them
    std::vector<double> m_waves;   ///< in which part each step bears what is missing
    std::vector<double> m_leads;
};

/// How far from its shown end a sequence is at each cell, frames. Where its steps lead further than the
/// window reaches they are slowed, the more, the less of it shows. \param paces  from that end on. \param
/// hidden  how little of it shows, likewise.
std::vector<double> offsetsOf(std::vector<double> paces, const std::vector<double>& hidden, double reach)
{
    double sum = 0;
    double late = 0;
    for (std::size_t t = 0; t < paces.size(); ++t) {
        paces[t] = std::max(paces[t], 0.0);
        sum += paces[t];
        late += paces[t] * hidden[t];
    }
    const double slower = sum > reach ? std::min((sum - reach) / late, 1.0) : 0;
    std::vector<double> offsets{0};
    for (std::size_t t = 0; t < paces.size(); ++t)
        offsets.push_back(std::min(offsets.back() + paces[t] * (1 - slower * hidden[t]), reach));
    return offsets;
}

FrameTime timeAt(NodeIndex first, double offset)
{
    // A sum of speeds that should be whole is not left a rounding error below.
    const double rounded = std::round(offset * 0x1p30) / 0x1p30;
    const double whole = std::floor(rounded);
    return {.frame = first + static_cast<NodeIndex>(whole), .part = rounded - whole};
}

} // namespace

std::vector<BlendTimes> blendTimes(const Transition& transition, BlendTiming timing)
{
    const std::vector<FramePair>& path = transition.path;
    std::vector<BlendTimes> times;
    if (timing == BlendTiming::Cells) {
        for (const FramePair& cell : path)
            times.push_back({.source = {.frame = cell.source}, .destination = {.frame = cell.destination}});
        return times;
    }
    if (path.size() == 1)
        return {
            {.source = {.frame = path.front().source}, .destination = {.frame = path.front().destination}}};
    const Balance balance(path);
    Balance::Paces paces = balance.paces();
    std::ranges::reverse(paces.destination);
    // The steps of the destination, from its end, lie in the shares of the source.
    const std::vector<double> hidden(balance.shares().begin() + 1, balance.shares().end());
    const std::vector<double> fromSource =
        offsetsOf(paces.source, hidden, path.back().source - path.front().source);
    const std::vector<double> toDestination =
        offsetsOf(paces.destination, hidden, path.back().destination - path.front().destination);
    for (std::size_t t = 0; t < path.size(); ++t) {
        times.push_back(
            {.source = timeAt(path.front().source, fromSource[t]),
             .destination = timeAt(path.back().destination, -toDestination[path.size() - 1 - t])});
    }
    return times;
}

} // namespace quadrille
