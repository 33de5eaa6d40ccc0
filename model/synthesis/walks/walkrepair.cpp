// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/walkrepair.h"

#include "model/synthesis/walks/walkexchanges.h"
#include "model/synthesis/walks/walktask.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

std::optional<std::size_t> findTransition(const Walk& walk, const FramePair& pair)
{
    for (std::size_t i = 0; i < walk.transitionCount(); ++i) {
        if (walk.transition(i) == pair)
            return i;
    }
    return std::nullopt;
}

/// The transition of a walk that is nearest to another between the same takes.
std::optional<std::size_t> nearestTransition(const Walk& walk, const FramePair& pair,
                                             const FrameLayout& layout, const std::vector<FramePair>& kept)
{
    std::optional<std::size_t> nearest;
    NodeIndex least = 0;
    for (std::size_t i = 0; i < walk.transitionCount(); ++i) {
        const FramePair now = walk.transition(i);
        if (layout.sequenceOf(now.source) != layout.sequenceOf(pair.source) ||
            layout.sequenceOf(now.destination) != layout.sequenceOf(pair.destination) ||
            std::ranges::find(kept, now) != kept.end())
            continue;
        const NodeIndex away =
            std::abs(now.source - pair.source) + std::abs(now.destination - pair.destination);
        if (!nearest || away < least) {
            nearest = i;
            least = away;
        }
    }
    return nearest;
}

class Repair
{
public:
    Repair(const WalkMaterial& material, const WalkConstraints& constraints, const SearchSettings& settings,
           const Progress& progress)
        : m_material(material), m_settings(settings), m_progress(progress), m_decided(constraints)
    {
    }

    /// \return whether the walk keeps to all decisions now.
    bool run()
    {
        const Junctions all = m_decided.junctions;
        m_decided.junctions = {.spans = all.spans, .walk = all.walk};
        // What the walk keeps already is not to be undone by what comes.
        for (const FramePair& pair : all.banned) {
            if (!findTransition(walk(), pair))
                m_decided.junctions.banned.push_back(pair);
        }
        for (const FramePair& pair : all.required) {
            if (findTransition(walk(), pair))
                m_decided.junctions.required.push_back(pair);
        }
        for (const FramePair& pair : all.banned) {
            const bool isNew = findTransition(walk(), pair).has_value();
            while (const auto place = findTransition(walk(), pair)) {
                if (!exchange(*place, {}))
                    return false;
            }
            if (isNew)
                m_decided.junctions.banned.push_back(pair);
        }
        for (const FramePair& pair : all.required) {
            if (std::ranges::find(m_decided.junctions.required, pair) != m_decided.junctions.required.end())
                continue;
            const FrameLayout& layout = m_material.costs.layout();
            const auto place = nearestTransition(walk(), pair, layout, m_decided.junctions.required);
            m_decided.junctions.required.push_back(pair);
            if (!place || !exchange(*place, pair))
                return false;
        }
        return true;
    }

    const Walk& walk() const { return m_decided.junctions.walk; }

private:
    bool exchange(std::size_t place, const std::optional<FramePair>& instead)
    {
        const WalkTask task(m_material, m_decided, m_settings);
        WalkCourse course(task, 0);
        const WalkExchanges exchanges(task.graph, walk(), place, instead, m_settings.leastRun);
        const auto best = bestExchange(course.followed(), exchanges, unreachable, m_progress);
        if (best)
            m_decided.junctions.walk = task.graph.walk(best->route);
        return best.has_value();
    }

    const WalkMaterial& m_material;
    const SearchSettings& m_settings;
    const Progress& m_progress;
    WalkConstraints m_decided;
};

} // namespace

std::optional<WalkSolution> repairedWalk(const WalkMaterial& material, const WalkConstraints& constraints,
                                         const SearchSettings& settings, const Progress& progress)
{
    if (constraints.junctions.walk.isEmpty())
        return std::nullopt;
    Repair repair(material, constraints, settings, progress);
    if (!repair.run())
        return std::nullopt;
    const WalkTask task(material, constraints, settings);
    WalkCourse course(task, 0);
    const std::optional<FoundRoute> route = followWalk(course.followed(), repair.walk());
    return route ? std::optional(course.solution(*route)) : std::nullopt;
}

} // namespace quadrille
