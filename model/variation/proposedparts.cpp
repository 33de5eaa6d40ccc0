// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/proposedparts.h"

#include "model/geometry/curveedits.h"
#include "model/geometry/surfaceroute.h"
#include "model/variation/bodylimbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace quadrille {

namespace {

using Loop = std::vector<VertexIndex>;

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::array sideNames{"left", "right"};

[[noreturn]] void fail(ErrorCode code, const std::string& limb)
{
    throw Error(code, {.file = {}, .place = {}, .values = {{"limb", limb}}});
}

/// A way without shortcuts: no vertex shares an edge with a later one but the next.
Loop withoutChords(const SurfaceGraph& graph, const Loop& way)
{
    Loop kept{way.front()};
    for (std::size_t i = 0; i + 1 < way.size();) {
        std::size_t next = way.size() - 1;
        while (!graph.haveEdge(way[i], way[next]))
            --next;
        kept.push_back(way[next]);
        i = next;
    }
    return kept;
}

/// Finds the curves of one limb, which end where no curve of another limb is.
class LimbCurves
{
public:
    LimbCurves(const SurfaceGraph& graph, const BodyLimbs& body, std::vector<bool>& taken, std::string name)
        : m_graph(graph), m_body(body), m_taken(taken), m_name(std::move(name))
    {
    }

    /// Along the shortest way from the limb's tip to another one, loops around the limb grow slowly up to its
    /// root, and beyond as fast as they have to lead back to it: the last point before.
    VertexIndex inside(const Limb& limb, const Limb& other, const Progress& progress)
    {
        openBetween(limb, other);
        constexpr float fastest = 1.2F;
        const auto height = static_cast<float>(m_body.height);
        const float first = 0.15F * height;
        const float step = 0.008F * height;
        const float longest = 0.36F * height;
        std::optional<VertexIndex> best;
        float most = -infinite;
        float last = 0;
        for (const VertexIndex p : m_cut->path()) {
            const float here = limb.distances[p.value];
            if (here < first || here < last + step || m_taken[p.value])
                continue;
            progress.report(static_cast<double>(here / limb.distances[other.tip.value]));
            last = here;
            const float length = loopLength(p, longest);
            if (length > longest && best)
                break;
            if (fastest * here - length > most) {
                most = fastest * here - length;
                best = p;
            }
        }
        return found(best);
    }

    /// The last point of the limb before the middle of the way to another one like it.
    VertexIndex insideOfTwo(const Limb& limb, const Limb& other)
    {
        openBetween(limb, other);
        constexpr float margin = 0.015F;
        std::optional<VertexIndex> best;
        for (const VertexIndex p : m_cut->path()) {
            const float ahead = other.distances[p.value] - limb.distances[p.value];
            if (ahead < 2 * margin * static_cast<float>(m_body.height))
                break;
            if (!m_taken[p.value])
                best = p;
        }
        return found(best);
    }

    /// Leads through the point on the inside, and on the outside nearer to the body, as an armhole does.
    Loop slantingLoop(const Limb& limb, VertexIndex inside) const
    {
        return loopThrough({inside, beyondOutside(limb, loopThrough({inside}), inside)});
    }

private:
    void openBetween(const Limb& limb, const Limb& other)
    {
        const OpenedSurface surface{&m_graph};
        SurfaceDistances distances(surface);
        distances.add({limb.tip, 0}, 0);
        const auto way = shortestRoute(surface, distances, {limb.tip, 0}, {other.tip, 0}, {});
        if (!way)
            fail(ErrorCode::PartsNotCut, m_name);
        m_cut.emplace(m_graph, withoutChords(m_graph, *way));
    }

    float loopLength(VertexIndex through, float limit) const
    {
        SurfaceDistances distances(OpenedSurface{&m_graph, &*m_cut});
        distances.add({through, 0}, 0);
        return distances.growUntil({through, 1}, limit);
    }

    /// The shortest loop around the limb through one or two vertices.
    Loop loopThrough(const std::vector<VertexIndex>& points) const
    {
        const OpenedSurface surface{&m_graph, &*m_cut};
        const SheetVertex start{points.front(), 0};
        const SheetVertex end{points.front(), 1};
        SurfaceDistances forward(surface);
        forward.add(start, 0);
        if (points.size() == 1)
            return routed(surface, forward, start, end, m_taken);
        SurfaceDistances backward(surface);
        backward.add(end, 0);
        forward.growTo(infinite);
        backward.growTo(infinite);
        SheetVertex through{points[1], 0};
        for (const int sheet : {-1, 1, 2}) {
            const SheetVertex v{points[1], sheet};
            if (forward.at(v) + backward.at(v) < forward.at(through) + backward.at(through))
                through = v;
        }
        Loop loop = routed(surface, forward, start, through, m_taken);
        std::vector<bool> blocked = m_taken;
        for (const VertexIndex v : loop)
            blocked[v.value] = true;
        SurfaceDistances onward(surface);
        onward.add(through, 0);
        const Loop rest = routed(surface, onward, through, end, blocked);
        loop.insert(loop.end(), rest.begin(), rest.end());
        return loop;
    }

    Loop routed(const OpenedSurface& surface, SurfaceDistances& forward, SheetVertex from, SheetVertex to,
                const std::vector<bool>& blocked) const
    {
        auto way = shortestRoute(surface, forward, from, to, {.blocked = &blocked});
        if (!way)
            fail(ErrorCode::PartsNotCut, m_name);
        way->pop_back();
        return std::move(*way);
    }

    VertexIndex found(const std::optional<VertexIndex>& v) const
    {
        if (!v)
            fail(ErrorCode::PartsNotCut, m_name);
        return *v;
    }

    /// Farthest from the tip near the place of a loop that lies opposite to one of its vertices.
    VertexIndex beyondOutside(const Limb& limb, const Loop& loop, VertexIndex inside) const
    {
        constexpr float rise = 0.05F;
        const auto place = [&](VertexIndex v) { return m_graph.pose()[v.value]; };
        const VertexIndex outside = *std::ranges::max_element(
            loop, {}, [&](VertexIndex v) { return (place(v) - place(inside)).norm(); });
        SurfaceDistances distances(m_graph);
        distances.add({outside, 0}, 0);
        VertexIndex best = outside;
        while (const auto reached = distances.next()) {
            const VertexIndex v = reached->vertex;
            if (distances.at(*reached) > rise * static_cast<float>(m_body.height))
                break;
            if (!m_taken[v.value] && limb.distances[v.value] > limb.distances[best.value])
                best = v;
        }
        return best;
    }

    const SurfaceGraph& m_graph;
    const BodyLimbs& m_body;
    std::vector<bool>& m_taken;
    std::string m_name;
    std::optional<CrossCut> m_cut;
};

class Proposal
{
public:
    Proposal(const SurfaceGraph& graph, const BodyLimbs& body, const ProposalSettings& settings)
        : m_graph(graph), m_body(body), m_settings(settings), m_taken(graph.vertexCount())
    {
        m_parts.parts.push_back({.name = "torso", .parent = {}, .curves = {}});
    }

    ProposedParts run(const Progress& progress)
    {
        std::array<Loop, 4> loops;
        for (std::size_t side = 0; side < 2; ++side) {
            const Progress part =
                progress.part(0.4 * static_cast<double>(side), 0.4 * static_cast<double>(side) + 0.4);
            LimbCurves curves(m_graph, m_body, m_taken, nameOf(side, " arm"));
            const VertexIndex armpit = curves.inside(m_body.hands[side], m_body.feet[side], part);
            loops[side] = curves.slantingLoop(m_body.hands[side], armpit);
            take(loops[side]);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            progress.report(0.8 + 0.05 * static_cast<double>(side));
            LimbCurves curves(m_graph, m_body, m_taken, nameOf(side, " leg"));
            const VertexIndex crotch = curves.insideOfTwo(m_body.feet[side], m_body.feet[1 - side]);
            loops[2 + side] = curves.slantingLoop(m_body.feet[side], crotch);
            take(loops[2 + side]);
        }
        for (std::size_t limb = 0; limb < loops.size(); ++limb) {
            progress.report(0.9 + 0.025 * static_cast<double>(limb));
            addPart(nameOf(limb % 2, limb < 2 ? " arm" : " leg"), loops[limb]);
        }
        return std::move(m_parts);
    }

private:
    static std::string nameOf(std::size_t side, const char* limb)
    {
        return sideNames[side] + std::string(limb);
    }

    void take(const Loop& loop)
    {
        for (const VertexIndex v : loop)
            m_taken[v.value] = true;
    }

    void addPart(const std::string& name, const Loop& root)
    {
        std::vector<VertexIndex> obstacles;
        for (std::uint32_t v = 0; v < m_taken.size(); ++v) {
            if (m_taken[v])
                obstacles.emplace_back(v);
        }
        Loop outer;
        try {
            outer = parallelCurve(m_graph, root, m_settings.overlap * m_body.height, CurveSide::Smaller,
                                  obstacles);
        } catch (const Error& error) {
            fail(error.code() == ErrorCode::CurveBoundsNothing ? ErrorCode::PartsLimbGrown
                                                               : ErrorCode::PartsNotCut,
                 name);
        }
        take(outer);
        m_parts.curves.push_back({name + " root", root});
        m_parts.curves.push_back({name + " outer", outer});
        m_parts.parts.push_back({name, "torso", {name + " root", name + " outer"}});
    }

    const SurfaceGraph& m_graph;
    const BodyLimbs& m_body;
    const ProposalSettings& m_settings;
    std::vector<bool> m_taken; ///< vertices of curves
    ProposedParts m_parts;
};

} // namespace

ProposedParts proposeParts(const std::shared_ptr<const Topology>& topology, Positions pose,
                           const ProposalSettings& settings, const Progress& progress)
{
    const SurfaceGraph graph(topology, pose);
    const BodyLimbs body = findLimbs(graph, settings.up, progress.part(0, 0.2));
    return Proposal(graph, body, settings).run(progress.part(0.2, 1));
}

} // namespace quadrille
