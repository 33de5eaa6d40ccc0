// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/ranks.h"
#include "model/project/steps/charactergraph.h"
#include "model/variation/alignment.h"
#include "model/variation/cycles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// Frames of some sequences, and those whose poses are as near to theirs as the sequences are to each other.
std::vector<bool> framesLike(const std::vector<int>& sequences, TableView<float> distances,
                             const FrameLayout& layout)
{
    constexpr double share = 0.9; // of the sequences' own frames that would be found among the others
    const auto nearestIn = [&](NodeIndex node) {
        float nearest = std::numeric_limits<float>::infinity();
        for (const int s : sequences)
            if (s != layout.sequenceOf(node))
                nearest = std::min(
                    nearest, distances.row(node).segment(layout.firstOf(s), layout.countOf(s)).minCoeff());
        return static_cast<double>(nearest);
    };
    std::vector<bool> isLike(static_cast<std::size_t>(layout.frameCount()), false);
    std::vector<double> between;
    for (const int s : sequences) {
        for (NodeIndex node = layout.firstOf(s); node <= layout.lastOf(s); ++node) {
            isLike[static_cast<std::size_t>(node)] = true;
            between.push_back(nearestIn(node));
        }
    }
    if (sequences.size() < 2)
        return isLike;
    const double limit = quantile(std::move(between), share);
    for (NodeIndex node = 0; node < layout.frameCount(); ++node)
        if (nearestIn(node) <= limit)
            isLike[static_cast<std::size_t>(node)] = true;
    return isLike;
}

/// Whether no foot stands for longer than a running figure flies.
bool jumps(const Stances& stances, NodeIndex first, NodeIndex last, double fps)
{
    constexpr double flight = 0.25; // seconds
    NodeIndex inAir = 0;
    for (NodeIndex node = first; stances.isKnown() && node <= last; ++node) {
        inAir = stances.at(node) == 0 ? inAir + 1 : 0;
        if (inAir > flight * fps)
            return true;
    }
    return false;
}

/// What lies in a take between two stretches of locomotion is locomotion, such as a turn; a take with little
/// of it, or with a jump, has none.
void settleTake(std::vector<bool>::iterator begin, std::vector<bool>::iterator end, bool isJump)
{
    constexpr double leastShare = 0.5;
    const auto first = std::find(begin, end, true);
    const auto last = std::find(std::reverse_iterator(end), std::reverse_iterator(first), true).base();
    const bool isLocomotion =
        !isJump && static_cast<double>(last - first) >= leastShare * static_cast<double>(end - begin);
    std::fill(begin, end, false);
    if (isLocomotion)
        std::fill(first, last, true);
}

} // namespace

std::vector<bool> CharacterGraph::locomotion() const
{
    constexpr double leastPace = 0.15; // heights of the figure a second
    const double greatestReturn = AlignmentSettings().greatestReturnBeside;
    const std::vector<double> paces = pacesOf(roots(), layout(), fps());
    const auto getsOn = [&](NodeIndex node) {
        return paces[static_cast<std::size_t>(node)] > leastPace * roots().stances.height;
    };
    std::vector<int> cyclic;
    for (int s = 0; s < layout().sequenceCount(); ++s) {
        const NodeIndex first = layout().firstOf(s);
        const NodeIndex count = layout().countOf(s);
        const Table<float> own = distances().block(first, first, count, count);
        bool alwaysGetsOn = true;
        for (NodeIndex node = first; node <= layout().lastOf(s); ++node)
            alwaysGetsOn = alwaysGetsOn && getsOn(node);
        if (alwaysGetsOn && findPeriod(own, greatestReturn))
            cyclic.push_back(s);
    }
    std::vector<bool> isLocomotion = framesLike(cyclic, distances(), layout());
    for (NodeIndex node = 0; node < layout().frameCount(); ++node)
        if (!getsOn(node))
            isLocomotion[static_cast<std::size_t>(node)] = false;
    for (int s = 0; s < layout().sequenceCount(); ++s) {
        const NodeIndex first = layout().firstOf(s);
        const NodeIndex last = layout().lastOf(s);
        if (std::ranges::find(cyclic, s) == cyclic.end())
            settleTake(isLocomotion.begin() + first, isLocomotion.begin() + last + 1,
                       jumps(roots().stances, first, last, fps()));
    }
    return isLocomotion;
}

} // namespace quadrille
