// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/walkexchanges.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr std::size_t mostTried = 256; ///< of each kind of exchange

template <typename Ranked>
void keepBest(std::vector<Ranked>& all)
{
    std::stable_sort(all.begin(), all.end(),
                     [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
    all.resize(std::min(all.size(), mostTried));
}

bool isIn(NodeIndex node, const WalkSpan& span)
{
    return node >= span.first && node <= span.last;
}

} // namespace

WalkExchanges::WalkExchanges(const WalkGraph& graph, const Walk& walk, std::size_t place,
                             const std::optional<FramePair>& instead, int leastRun)
    : m_graph(graph), m_walk(walk), m_place(place), m_instead(instead), m_leastRun(std::max(1, leastRun))
{
}

std::vector<WalkExchange> WalkExchanges::all() const
{
    const std::vector<Alternative> own =
        m_instead ? std::vector<Alternative>{{*m_instead}} : alternatives(m_walk.transition(m_place));
    std::vector<WalkExchange> all;
    all.reserve(own.size());
    for (const Alternative& alternative : own)
        all.push_back({m_place, 1, {alternative.pair}, alternative.rank});
    if (!m_instead)
        addDetours(all);
    if (m_place > 0)
        addBoth(m_place - 1, alternatives(m_walk.transition(m_place - 1)), own, all);
    if (m_place + 1 < m_walk.transitionCount()) {
        addBoth(m_place, own, alternatives(m_walk.transition(m_place + 1)), all);
        if (!m_instead)
            addShortcut(m_place, all);
    }
    return all;
}

std::optional<Walk> WalkExchanges::changed(const WalkExchange& exchange) const
{
    const std::size_t behind = exchange.first + exchange.count;
    Walk walk;
    const auto& spans = m_walk.spans;
    walk.spans.assign(spans.begin(), spans.begin() + static_cast<std::ptrdiff_t>(exchange.first) + 1);
    for (const FramePair& pair : exchange.pairs) {
        walk.spans.back().last = pair.source;
        walk.spans.push_back({pair.destination, spans[behind].last});
    }
    for (std::size_t s = exchange.first; s < walk.spans.size(); ++s) {
        const WalkSpan& span = walk.spans[s];
        NodeIndex least = m_leastRun;
        if (s == exchange.first)
            least = leastAtEnd(spans[exchange.first]);
        else if (s + 1 == walk.spans.size())
            least = leastAtEnd(spans[behind]);
        if (!isOneTake(span) || span.frameCount() < least)
            return std::nullopt;
    }
    walk.spans.insert(walk.spans.end(), spans.begin() + static_cast<std::ptrdiff_t>(behind) + 1, spans.end());
    return walk;
}

bool WalkExchanges::isOneTake(const WalkSpan& span) const
{
    const FrameLayout& layout = m_graph.layout();
    return span.first <= span.last && layout.sequenceOf(span.first) == layout.sequenceOf(span.last);
}

/// Of a span that is left or come to in another frame than before.
NodeIndex WalkExchanges::leastAtEnd(const WalkSpan& before) const
{
    return m_instead ? 1 : std::min<NodeIndex>(before.frameCount(), m_leastRun);
}

WalkSpan WalkExchanges::takeOf(NodeIndex node) const
{
    const FrameLayout& layout = m_graph.layout();
    const int sequence = layout.sequenceOf(node);
    return {layout.firstOf(sequence), layout.lastOf(sequence)};
}

/// Weights, and how far frames are from those that are played now.
double WalkExchanges::rankOf(const WalkMove& move, const FramePair& now) const
{
    const NodeIndex away = std::abs(move.from - now.source) + std::abs(move.to - now.destination);
    return move.weight + m_graph.alpha() * away;
}

std::vector<WalkExchanges::Alternative> WalkExchanges::alternatives(const FramePair& now) const
{
    const WalkSpan from = takeOf(now.source);
    const WalkSpan to = takeOf(now.destination);
    std::vector<Alternative> all;
    for (const WalkMove& move : m_graph.moves()) {
        const FramePair pair{move.from, move.to};
        const bool isOther = pair != now && !isLeft(pair);
        if (move.kind == EdgeKind::Transition && isOther && isIn(move.from, from) && isIn(move.to, to))
            all.push_back({pair, rankOf(move, now)});
    }
    keepBest(all);
    return all;
}

void WalkExchanges::addDetours(std::vector<WalkExchange>& all) const
{
    const FramePair now = m_walk.transition(m_place);
    const WalkSpan from{m_walk.spans[m_place].first, takeOf(now.source).last};
    const WalkSpan to{takeOf(now.destination).first, m_walk.spans[m_place + 1].last};
    std::vector<Alternative> out;
    std::vector<Alternative> in;
    for (const WalkMove& move : m_graph.moves()) {
        if (move.kind != EdgeKind::Transition || isLeft({move.from, move.to}))
            continue;
        if (isIn(move.from, from))
            out.push_back({{move.from, move.to}, rankOf(move, {now.source, move.to})});
        if (isIn(move.to, to))
            in.push_back({{move.from, move.to}, rankOf(move, {move.from, now.destination})});
    }
    keepBest(out);
    keepBest(in);
    std::vector<WalkExchange> detours;
    for (const Alternative& first : out) {
        for (const Alternative& second : in) {
            const WalkSpan between{first.pair.destination, second.pair.source};
            if (isOneTake(between) && between.frameCount() >= m_leastRun)
                detours.push_back({m_place,
                                   1,
                                   {first.pair, second.pair},
                                   first.rank + second.rank + m_graph.alpha() * (between.frameCount() - 1)});
        }
    }
    keepBest(detours);
    all.insert(all.end(), detours.begin(), detours.end());
}

void WalkExchanges::addBoth(std::size_t place, const std::vector<Alternative>& first,
                            const std::vector<Alternative>& second, std::vector<WalkExchange>& all) const
{
    std::vector<WalkExchange> both;
    for (const Alternative& a : first) {
        for (const Alternative& b : second) {
            if (b.pair.source - a.pair.destination + 1 >= m_leastRun)
                both.push_back({place, 2, {a.pair, b.pair}, a.rank + b.rank});
        }
    }
    keepBest(both);
    all.insert(all.end(), both.begin(), both.end());
}

void WalkExchanges::addShortcut(std::size_t place, std::vector<WalkExchange>& all) const
{
    const FramePair now{m_walk.transition(place).source, m_walk.transition(place + 1).destination};
    for (const Alternative& alternative : alternatives(now))
        all.push_back({place, 2, {alternative.pair}, alternative.rank});
}

std::optional<FoundRoute> bestExchange(const FollowedCourse& course, const WalkExchanges& exchanges,
                                       double limit, const Progress& progress)
{
    std::vector<Walk> walks;
    std::vector<MoveIndex> moves;
    for (const WalkExchange& exchange : exchanges.all()) {
        std::optional<Walk> walk = exchanges.changed(exchange);
        if (!walk)
            continue;
        walks.push_back(*std::move(walk));
        for (std::size_t i = 0; i < walks.back().transitionCount(); ++i) {
            if (const MoveIndex move = course.graph.transition(walks.back().transition(i)); move != noMove)
                moves.push_back(move);
        }
    }
    if (course.path != nullptr)
        course.path->motions.prepare(std::move(moves));
    std::vector<double> costs(walks.size(), unreachable);
    tbb::parallel_for(std::size_t{0}, walks.size(), [&](std::size_t i) {
        progress.report(0);
        if (const auto route = followWalk(course, walks[i], limit))
            costs[i] = route->cost;
    });
    const auto least = std::min_element(costs.begin(), costs.end());
    if (least == costs.end() || *least == unreachable)
        return std::nullopt;
    return followWalk(course, walks[static_cast<std::size_t>(least - costs.begin())]);
}

} // namespace quadrille
