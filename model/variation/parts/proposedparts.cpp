// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/proposedparts.h"

#include "model/geometry/curveedits.h"
#include "model/variation/parts/limbcurves.h"

#include <array>
#include <string>

namespace quadrille {

namespace {

using Loop = std::vector<VertexIndex>;

constexpr std::array sideNames{"left", "right"};

[[noreturn]] void fail(ErrorCode code, const std::string& limb)
{
    throw Error(code, {.file = {}, .place = {}, .values = {{"limb", limb}}});
}

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
            LimbCurves curves(m_graph, m_body, m_body.hands[side], m_body.hands[1 - side], m_taken,
                              nameOf(side, " arm"));
            loops[side] = curves.slantingLoop(curves.armpit(m_body.feet[side], part));
            take(loops[side]);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            progress.report(0.8 + 0.05 * static_cast<double>(side));
            LimbCurves curves(m_graph, m_body, m_body.feet[side], m_body.feet[1 - side], m_taken,
                              nameOf(side, " leg"));
            loops[2 + side] = curves.slantingLoop(curves.crotch());
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
