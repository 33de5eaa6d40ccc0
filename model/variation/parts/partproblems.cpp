// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/curveregions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace quadrille {

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

Error errorOf(ErrorCode code, Values values)
{
    ErrorContext context;
    context.values = std::move(values);
    return Error(code, std::move(context));
}

class CurveCheck
{
public:
    CurveCheck(const Topology& topology, const VertexTriangles& around, std::vector<PartProblem>& problems)
        : m_topology(topology), m_around(around), m_problems(problems), m_owner(topology.vertexCount())
    {
    }

    void check(const PartCurve& curve)
    {
        m_curve = &curve;
        if (!m_names.insert(curve.name).second)
            report(ErrorCode::CurveNameTaken, {}, curve.vertices);
        if (!isInRange())
            return;
        if (curve.vertices.size() < 3) {
            report(ErrorCode::CurveShort, {{"found", std::to_string(curve.vertices.size())}}, curve.vertices);
            return;
        }
        const bool isSimple = checkItself();
        const bool isAlone = checkOthers();
        const bool isClosed = checkEdges();
        if (isSimple && isAlone && isClosed && !curveSides(m_topology, m_around, curve.vertices))
            report(ErrorCode::CurveDoesNotSeparate, {}, curve.vertices);
    }

private:
    void report(ErrorCode code, Values values, std::vector<VertexIndex> at)
    {
        values.insert(values.begin(), {"curve", m_curve->name});
        std::erase_if(at, [&](VertexIndex v) { return v.value >= m_topology.vertexCount(); });
        m_problems.push_back({errorOf(code, std::move(values)), m_curve->name, {}, std::move(at)});
    }

    bool isInRange()
    {
        const auto outside = std::ranges::find_if(
            m_curve->vertices, [&](VertexIndex v) { return v.value >= m_topology.vertexCount(); });
        if (outside == m_curve->vertices.end())
            return true;
        report(ErrorCode::CurveVertexOutside,
               {{"vertex", std::to_string(outside->value)},
                {"vertices", std::to_string(m_topology.vertexCount())}},
               m_curve->vertices);
        return false;
    }

    bool checkItself()
    {
        std::set<VertexIndex> seen;
        std::vector<VertexIndex> twice;
        for (const VertexIndex v : m_curve->vertices) {
            if (!seen.insert(v).second)
                twice.push_back(v);
        }
        if (!twice.empty())
            report(ErrorCode::CurveMeetsItself, {{"vertex", std::to_string(twice.front().value)}}, twice);
        return twice.empty();
    }

    bool checkOthers()
    {
        std::vector<const PartCurve*> met;
        for (const VertexIndex v : m_curve->vertices) {
            const PartCurve*& owner = m_owner[v.value];
            if (owner && owner != m_curve && std::ranges::find(met, owner) == met.end())
                met.push_back(owner);
        }
        for (const PartCurve* other : met) {
            std::vector<VertexIndex> shared;
            for (const VertexIndex v : m_curve->vertices) {
                if (m_owner[v.value] == other)
                    shared.push_back(v);
            }
            report(ErrorCode::CurveMeetsOther,
                   {{"other", other->name}, {"vertex", std::to_string(shared.front().value)}}, shared);
        }
        for (const VertexIndex v : m_curve->vertices) {
            if (!m_owner[v.value])
                m_owner[v.value] = m_curve;
        }
        return met.empty();
    }

    bool checkEdges()
    {
        const std::vector<VertexIndex>& curve = m_curve->vertices;
        std::vector<VertexIndex> gaps;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const VertexIndex to = curve[(i + 1) % curve.size()];
            if (curve[i] != to && !haveEdge(m_topology, m_around, curve[i], to))
                gaps.insert(gaps.end(), {curve[i], to});
        }
        if (!gaps.empty())
            report(ErrorCode::CurveOpen,
                   {{"from", std::to_string(gaps[0].value)}, {"to", std::to_string(gaps[1].value)}}, gaps);
        return gaps.empty();
    }

    const Topology& m_topology;
    const VertexTriangles& m_around;
    std::vector<PartProblem>& m_problems;
    std::vector<const PartCurve*> m_owner; ///< per vertex the first curve there
    std::set<std::string> m_names;
    const PartCurve* m_curve = nullptr;
};

/// What can be told from the descriptions alone.
class TreeCheck
{
public:
    TreeCheck(std::span<const PartDescription> parts, std::span<const PartCurve> curves,
              std::vector<PartProblem>& problems)
        : m_parts(parts), m_curves(curves), m_problems(problems)
    {
    }

    void check()
    {
        const PartDescription* root = nullptr;
        std::set<std::string> names;
        for (const PartDescription& part : m_parts) {
            if (!names.insert(part.name).second)
                report(ErrorCode::PartNameTaken, part, {});
            if (part.parent.empty() && root)
                report(ErrorCode::PartRootTwice, *root, {{"other", part.name}});
            else if (part.parent.empty())
                root = &part;
            else
                checkParent(part);
            checkCurves(part);
        }
        if (!root && !m_parts.empty())
            m_problems.push_back({errorOf(ErrorCode::PartRootMissing, {}), {}, {}, {}});
    }

private:
    void report(ErrorCode code, const PartDescription& part, Values values, const std::string& curve = {})
    {
        values.insert(values.begin(), {"part", part.name});
        const auto index = indexOf(m_curves, curve);
        m_problems.push_back({errorOf(code, std::move(values)), curve, part.name,
                              index ? m_curves[*index].vertices : std::vector<VertexIndex>()});
    }

    void checkParent(const PartDescription& part)
    {
        const PartDescription* above = &part;
        for (std::size_t steps = 0; !above->parent.empty(); ++steps) {
            const auto parent = indexOf(m_parts, above->parent);
            if (!parent) {
                if (above == &part)
                    report(ErrorCode::PartParentUnknown, part, {{"parent", part.parent}});
                return;
            }
            above = &m_parts[*parent];
            if (above == &part || steps > m_parts.size()) {
                if (above == &part)
                    report(ErrorCode::PartCycle, part, {});
                return;
            }
        }
    }

    void checkCurves(const PartDescription& part)
    {
        const std::size_t needed = part.parent.empty() ? 0 : 2;
        // One that is named twice is one.
        const std::set<std::string> curves(part.curves.begin(), part.curves.end());
        if (curves.size() != needed || part.curves.size() != needed)
            report(ErrorCode::PartCurveCount, part,
                   {{"found", std::to_string(curves.size() == needed ? part.curves.size() : curves.size())},
                    {"needed", std::to_string(needed)}});
        for (const std::string& curve : curves) {
            if (!indexOf(m_curves, curve))
                report(ErrorCode::PartCurveUnknown, part, {{"curve", curve}}, curve);
            const auto [user, isFirst] = m_users.emplace(curve, &part);
            if (!isFirst)
                report(ErrorCode::PartCurveShared, *user->second, {{"other", part.name}, {"curve", curve}},
                       curve);
        }
    }

    std::span<const PartDescription> m_parts;
    std::span<const PartCurve> m_curves;
    std::vector<PartProblem>& m_problems;
    std::map<std::string, const PartDescription*> m_users;
};

std::vector<VertexIndex> verticesOf(const PartDescription& part, std::span<const PartCurve> curves)
{
    std::vector<VertexIndex> found;
    for (const std::string& name : part.curves) {
        const std::vector<VertexIndex>& curve = curves[*indexOf(curves, name)].vertices;
        found.insert(found.end(), curve.begin(), curve.end());
    }
    return found;
}

PartProblem placeProblem(ErrorCode code, const PartDescription& part, std::span<const PartCurve> curves)
{
    Values values{{"part", part.name}, {"parent", part.parent}};
    if (part.curves.size() == 2)
        values.insert(values.end(), {{"curve", part.curves[0]}, {"other", part.curves[1]}});
    return {errorOf(code, std::move(values)), {}, part.name, verticesOf(part, curves)};
}

} // namespace

std::vector<PartCurve> usedCurves(std::span<const PartCurve> curves,
                                  std::span<const PartDescription> descriptions)
{
    std::vector<PartCurve> used;
    for (const PartCurve& curve : curves) {
        if (std::ranges::any_of(descriptions, [&](const PartDescription& part) {
                return std::ranges::find(part.curves, curve.name) != part.curves.end();
            }))
            used.push_back(curve);
    }
    return used;
}

std::vector<std::string> unusedCurves(std::span<const PartCurve> curves,
                                      std::span<const PartDescription> descriptions)
{
    const std::vector<PartCurve> used = usedCurves(curves, descriptions);
    std::vector<std::string> names;
    for (const PartCurve& curve : curves) {
        if (!indexOf(std::span(used), curve.name))
            names.push_back(curve.name);
    }
    return names;
}

std::vector<PartProblem> partProblems(const Topology& topology, std::span<const PartCurve> curves,
                                      std::span<const PartDescription> descriptions)
{
    std::vector<PartProblem> problems;
    const VertexTriangles around(topology);
    CurveCheck curveCheck(topology, around, problems);
    for (const PartCurve& curve : curves)
        curveCheck.check(curve);
    TreeCheck(descriptions, curves, problems).check();
    const std::vector<PartCurve> used = usedCurves(curves, descriptions);
    const bool isUnclear = std::ranges::any_of(problems, [&](const PartProblem& problem) {
        return !problem.part.empty() || problem.curve.empty() || indexOf(std::span(used), problem.curve);
    });
    if (isUnclear)
        return problems;
    const CurveRegions regions = curveRegions(topology, around, used);
    const std::vector<double> areas(static_cast<std::size_t>(regions.count));
    const PartRegions found = partRegions(regions, used, descriptions, areas);
    for (const PartRegions::Fault& fault : found.faults)
        problems.push_back(placeProblem(fault.code, descriptions[fault.part], used));
    if (found.faults.empty()) {
        for (const std::size_t part : emptyParts(topology, regions, found))
            problems.push_back(placeProblem(ErrorCode::PartEmpty, descriptions[part], used));
    }
    return problems;
}

} // namespace quadrille
