// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// Nearly all edges that walks come to lower nothing. What a node would have to be reached for to be of any
// use to some of the sources is kept in one number, by which most of them are left out before the sources are
// looked at one by one.
#include "model/graph/edgewalks.h"

#include "model/core/simd.h"

#include <algorithm>
#include <bit>
#include <span>

namespace quadrille {
namespace {

constexpr auto sources = static_cast<std::size_t>(EdgeWalks::lanes);
constexpr std::size_t groups = EdgeWalks::groups;
constexpr std::size_t inGroup = sources / groups;
/// By these single precision is on the safe side, whatever it rounded; negative values do not matter.
constexpr float roundedUp = 1 + 0x1p-21F;
constexpr float roundedDown = 1 - 0x1p-21F;

/// Lowers the walks of some sources to a node by those that come by an edge. \return whether any became
/// cheaper.
template <std::size_t Count>
[[gnu::always_inline]] inline bool lower(const double* costs, double weight, double* known)
{
    int isLower = 0;
#pragma omp simd reduction(| : isLower)
    for (std::size_t l = 0; l < Count; ++l) {
        const double sum = costs[l] + weight;
        isLower |= sum < known[l];
        known[l] = sum < known[l] ? sum : known[l];
    }
    return isLower != 0;
}

/// The edges of one node that may make a difference. \param least  what walks to the node cost. \param rooms
/// what walks may cost more than they must to make a difference, by node. \param found  out: their positions.
/// \return their number.
[[gnu::always_inline]] inline std::size_t edgesThatMatter(std::span<const EdgeExcess> edges, float least,
                                                          const float* rooms, std::uint32_t* found)
{
    std::size_t size = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        // No jump: few are told apart before.
        found[size] = static_cast<std::uint32_t>(e);
        size += edges[e].excess <= rooms[edges[e].to] - least ? 1 : 0;
    }
    return size;
}

/// Follows them. \param least  by group of sources, then of all. \param rooms  by node, of all sources.
/// \param groupRooms  by node and group. \param lowered  in: scratch; out: the nodes that became cheaper.
/// \return their number.
QUADRILLE_SIMD_CLONES
std::size_t followEdges(const OutEdge* edges, std::span<const EdgeExcess> excesses, const double* costs,
                        const float* least, const float* rooms, const float* groupRooms, double* detours,
                        std::uint32_t* lowered)
{
    const std::size_t mattering = edgesThatMatter(excesses, least[groups], rooms, lowered);
    std::size_t found = 0;
    for (std::size_t m = 0; m < mattering; ++m) {
        const std::uint32_t e = lowered[m];
        const auto node = static_cast<std::size_t>(edges[e].to);
        lowered[found] = static_cast<std::uint32_t>(node);
        int isLower = 0;
        for (std::size_t g = 0; g < groups; ++g) {
            if (excesses[e].excess <= groupRooms[node * groups + g] - least[g])
                isLower |= static_cast<int>(lower<inGroup>(costs + g * inGroup, edges[e].weight,
                                                           detours + node * sources + g * inGroup));
        }
        found += isLower != 0 ? 1 : 0;
    }
    return found;
}

/// Lowers the walks to the frame after a node.
QUADRILLE_SIMD_CLONES
bool lowerOne(const double* costs, double weight, double* known)
{
    return lower<sources>(costs, weight, known);
}

/// Whether what comes of walks to a node may count, for any source from which they are nearer than others.
QUADRILLE_SIMD_CLONES
bool isWorthPassing(const EdgeWalks::Limits& limits, const double* costs, const double* others)
{
    int isAny = 0;
#pragma omp simd reduction(| : isAny)
    for (std::size_t l = 0; l < sources; ++l)
        isAny |= static_cast<int>(costs[l] < others[l]) & static_cast<int>(costs[l] <= limits.reaches[l]) &
                 static_cast<int>(costs[l] + limits.leaving <= limits.bounds[l]);
    if (isAny || !limits.nextCaps)
        return isAny != 0;
#pragma omp simd reduction(| : isAny)
    for (std::size_t l = 0; l < sources; ++l)
        isAny |= static_cast<int>(costs[l] < others[l]) &
                 static_cast<int>(costs[l] + limits.alpha <= static_cast<double>(limits.nextCaps[l]));
    return isAny != 0;
}

/// The costs of walks to a node for the sources from which they have become cheaper since they were passed
/// on; unreachable for the others.
QUADRILLE_SIMD_CLONES
void takeCheaper(const double* direct, const double* detours, double* passed, double* costs)
{
#pragma omp simd
    for (std::size_t l = 0; l < sources; ++l) {
        const double cost = std::min(direct[l], detours[l]);
        costs[l] = cost < passed[l] ? cost : unreachable;
        passed[l] = std::min(passed[l], cost);
    }
}

/// Keeps the costs of those walks that may go on by a transition. \param least  out: by group, then of all,
/// or a little less. \return what transitions may cost more than they must.
QUADRILLE_SIMD_CLONES
float keepOnward(const EdgeWalks::Limits& limits, double* costs, float* least)
{
    double most = -unreachable;
    for (std::size_t g = 0; g < groups; ++g) {
        double leastHere = unreachable;
#pragma omp simd reduction(min : leastHere) reduction(max : most)
        for (std::size_t l = g * inGroup; l < (g + 1) * inGroup; ++l) {
            const bool isOnward =
                costs[l] <= limits.reaches[l] && costs[l] + limits.leaving <= limits.bounds[l];
            costs[l] = isOnward ? costs[l] : unreachable;
            leastHere = std::min(leastHere, costs[l]);
            most = std::max(most, limits.reaches[l] - costs[l]);
        }
        least[g] = static_cast<float>(leastHere) * roundedDown;
    }
    least[groups] = *std::min_element(least, least + groups);
    return static_cast<float>(most) * roundedUp;
}

/// \param rooms  out: what walks to a node may cost more than `arriving` to make a difference, by group, or a
/// little more. \return of all groups.
QUADRILLE_SIMD_CLONES
float setRooms(const double* detours, const float* caps, double arriving, float* rooms)
{
    for (std::size_t g = 0; g < groups; ++g) {
        double worst = -unreachable;
#pragma omp simd reduction(max : worst)
        for (std::size_t l = g * inGroup; l < (g + 1) * inGroup; ++l) {
            const double known = std::min(detours[l], static_cast<double>(caps[l]));
            worst = std::max(worst, known);
        }
        rooms[g] = static_cast<float>(worst - arriving) * roundedUp;
    }
    return *std::max_element(rooms, rooms + groups);
}

/// The caps of one node. \param caps  in: of undecided edges to it; out: all. \param playing  in: what is
/// left of the caps of the frames after it, once one has played on to there; out: of this one, too.
QUADRILLE_SIMD_CLONES
void setCapsOf(float* caps, double* playing, const double* bounds, const double* reaches, double leaving,
               double alpha, double least)
{
#pragma omp simd
    for (std::size_t l = 0; l < sources; ++l) {
        playing[l] = std::max(playing[l] - alpha, static_cast<double>(caps[l]));
        const double onward = std::min(reaches[l], bounds[l] - leaving);
        const double cap = std::max(std::max(playing[l], onward), least);
        caps[l] = static_cast<float>(cap) * roundedUp;
    }
}

/// What an undecided edge is compared with counts up to so much.
double limitOf(const OutEdge& edge)
{
    return edge.weight * (1 + 2 * edgeTie);
}

} // namespace

OutEdgeGraph::OutEdgeGraph(const FrameLayout& layout, double weight)
    : alpha(weight)
    , edges(static_cast<std::size_t>(layout.frameCount()))
    , excesses(edges.size())
    , leaving(edges.size(), unreachable)
    , arriving(edges.size(), unreachable)
    , isLast(edges.size(), 0)
{
    for (int s = 0; s < layout.sequenceCount(); ++s)
        if (layout.countOf(s) > 0)
            isLast[static_cast<std::size_t>(layout.lastOf(s))] = 1;
}

void OutEdgeGraph::sort(NodeIndex node)
{
    OutEdges& own = from(node);
    const auto excessOf = [this](const OutEdge& edge) {
        return edge.weight - arriving[static_cast<std::size_t>(edge.to)];
    };
    std::sort(own.begin(), own.end(), [&](const OutEdge& a, const OutEdge& b) {
        const double excess = excessOf(a);
        const double other = excessOf(b);
        return excess != other ? excess < other : a.to < b.to;
    });
    std::vector<EdgeExcess>& all = excesses[static_cast<std::size_t>(node)];
    all.reserve(own.size());
    for (const OutEdge& edge : own)
        all.push_back({static_cast<float>(excessOf(edge)) * roundedDown, edge.to});
}

EdgeWalks::EdgeWalks(NodeIndex nodes)
    : m_direct(static_cast<std::size_t>(nodes) * sources, unreachable)
    , m_detours(m_direct.size(), unreachable)
    , m_passed(m_direct.size(), unreachable)
    , m_caps(m_direct.size())
    , m_rooms(static_cast<std::size_t>(nodes))
    , m_groupRooms(m_rooms.size() * groups)
    , m_isTouched(static_cast<std::size_t>(nodes), 0)
    , m_waiting((static_cast<std::size_t>(nodes) + 63) / 64, 0)
    , m_lowered(static_cast<std::size_t>(nodes) + 1)
{
}

void EdgeWalks::touch(NodeIndex node)
{
    if (!m_isTouched[static_cast<std::size_t>(node)]) {
        m_isTouched[static_cast<std::size_t>(node)] = 1;
        m_touched.push_back(node);
    }
}

void EdgeWalks::clear()
{
    for (const NodeIndex node : m_touched) {
        const auto at = static_cast<std::ptrdiff_t>(node) * lanes;
        std::fill_n(m_direct.begin() + at, lanes, unreachable);
        std::fill_n(m_detours.begin() + at, lanes, unreachable);
        std::fill_n(m_passed.begin() + at, lanes, unreachable);
        m_isTouched[static_cast<std::size_t>(node)] = 0;
    }
    m_touched.clear();
}

bool EdgeWalks::run(const OutEdgeGraph& graph, NodeIndex first)
{
    clear();
    m_first = first;
    m_end = std::min(first + lanes, static_cast<NodeIndex>(graph.edges.size()));
    if (!setBounds(graph))
        return false;
    setCaps(graph);
    // The cheapest first, so that what comes later makes no difference.
    for (const auto& [cost, node] : start(graph))
        pass(graph, node);
    // From then on in order, so that runs of original edges are done in one sweep.
    for (bool isAny = true; isAny;) {
        isAny = false;
        for (std::size_t word = 0; word < m_waiting.size(); ++word) {
            while (m_waiting[word] != 0) {
                isAny = true;
                const int bit = std::countr_zero(m_waiting[word]);
                pass(graph, static_cast<NodeIndex>(word * 64) + bit);
            }
        }
    }
    return true;
}

bool EdgeWalks::setBounds(const OutEdgeGraph& graph)
{
    const double least = graph.nearlyFree > 0 ? graph.nearlyFree : -1;
    bool isAny = graph.nearlyFree > 0;
    m_bounds.fill(-1);
    m_reaches.fill(-1);
    for (NodeIndex i = m_first; i < m_end; ++i) {
        double& bound = m_bounds[static_cast<std::size_t>(i - m_first)];
        double& reach = m_reaches[static_cast<std::size_t>(i - m_first)];
        bound = reach = least;
        for (const OutEdge& edge : graph.from(i)) {
            if (edge.state != EdgeState::Undecided)
                continue;
            isAny = true;
            bound = std::max(bound, limitOf(edge));
            // Any walk that takes a transition yet pays for the last one.
            reach = std::max(reach, limitOf(edge) - graph.arriving[static_cast<std::size_t>(edge.to)]);
        }
    }
    return isAny;
}

void EdgeWalks::setCaps(const OutEdgeGraph& graph)
{
    std::fill(m_caps.begin(), m_caps.end(), -1.0F);
    for (NodeIndex i = m_first; i < m_end; ++i)
        for (const OutEdge& edge : graph.from(i))
            if (edge.state == EdgeState::Undecided)
                m_caps[static_cast<std::size_t>(edge.to) * sources + static_cast<std::size_t>(i - m_first)] =
                    static_cast<float>(limitOf(edge));
    const double least = graph.nearlyFree > 0 ? graph.nearlyFree : -1;
    Lanes playing{};
    for (std::size_t node = graph.edges.size(); node-- > 0;) {
        if (graph.isLast[node])
            playing.fill(-unreachable);
        float* const caps = m_caps.data() + node * sources;
        setCapsOf(caps, playing.data(), m_bounds.data(), m_reaches.data(), graph.leaving[node], graph.alpha,
                  least);
        m_rooms[node] = setRooms(m_detours.data() + node * sources, caps, graph.arriving[node],
                                 m_groupRooms.data() + node * groups);
    }
}

/// \return the nodes that the sources' own edges lead to, with the least of their weights; as far as what
/// comes of them may count, by weight.
std::vector<std::pair<double, NodeIndex>> EdgeWalks::start(const OutEdgeGraph& graph)
{
    for (NodeIndex i = m_first; i < m_end; ++i) {
        const auto lane = static_cast<std::size_t>(i - m_first);
        for (const OutEdge& edge : graph.from(i)) {
            if (edge.weight > m_bounds[lane])
                continue;
            m_direct[static_cast<std::size_t>(edge.to) * sources + lane] = edge.weight;
            touch(edge.to);
        }
    }
    Lanes unknown{};
    unknown.fill(unreachable);
    std::vector<std::pair<double, NodeIndex>> nodes;
    for (const NodeIndex node : m_touched) {
        const double* const own = m_direct.data() + static_cast<std::size_t>(node) * sources;
        if (isWorthPassing(limitsOf(graph, node), own, unknown.data()))
            nodes.emplace_back(*std::min_element(own, own + sources), node);
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

EdgeWalks::Limits EdgeWalks::limitsOf(const OutEdgeGraph& graph, NodeIndex node) const
{
    const auto at = static_cast<std::size_t>(node);
    return {.nextCaps = graph.isLast[at] ? nullptr : m_caps.data() + (at + 1) * sources,
            .bounds = m_bounds.data(),
            .reaches = m_reaches.data(),
            .leaving = graph.leaving[at],
            .alpha = graph.alpha};
}

/// Follows the edges of a node for those sources from which it has become cheaper.
void EdgeWalks::pass(const OutEdgeGraph& graph, NodeIndex node)
{
    m_waiting[static_cast<std::size_t>(node) / 64] &= ~(std::uint64_t{1} << (node % 64));
    const std::size_t at = static_cast<std::size_t>(node) * sources;
    Lanes costs{};
    takeCheaper(m_direct.data() + at, m_detours.data() + at, m_passed.data() + at, costs.data());
    if (node >= m_first && node < m_end)
        costs[static_cast<std::size_t>(node - m_first)] = unreachable;
    const Limits limits = limitsOf(graph, node);
    if (limits.nextCaps && lowerOne(costs.data(), graph.alpha, m_detours.data() + at + sources))
        take(graph, node + 1);
    std::array<float, groups + 1> least{};
    const float most = keepOnward(limits, costs.data(), least.data());
    const auto index = static_cast<std::size_t>(node);
    const std::vector<EdgeExcess>& all = graph.excesses[index];
    const auto end = std::upper_bound(all.begin(), all.end(), most, [](float limit, const EdgeExcess& edge) {
        return limit < edge.excess;
    });
    const std::size_t count =
        followEdges(graph.edges[index].data(), {all.begin(), end}, costs.data(), least.data(), m_rooms.data(),
                    m_groupRooms.data(), m_detours.data(), m_lowered.data());
    for (std::size_t n = 0; n < count; ++n)
        take(graph, static_cast<NodeIndex>(m_lowered[n]));
}

/// Notes that walks to a node have become cheaper.
void EdgeWalks::take(const OutEdgeGraph& graph, NodeIndex node)
{
    touch(node);
    const std::size_t at = static_cast<std::size_t>(node) * sources;
    const auto index = static_cast<std::size_t>(node);
    m_rooms[index] = setRooms(m_detours.data() + at, m_caps.data() + at, graph.arriving[index],
                              m_groupRooms.data() + index * groups);
    if (isWorthPassing(limitsOf(graph, node), m_detours.data() + at, m_direct.data() + at))
        m_waiting[static_cast<std::size_t>(node) / 64] |= std::uint64_t{1} << (node % 64);
}

} // namespace quadrille
