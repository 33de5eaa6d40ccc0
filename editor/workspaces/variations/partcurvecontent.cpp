// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvecontent.h"

#include "editor/workspaces/variations/partedits.h"
#include "model/geometry/surfacecurve.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

Vec3f middleOf(const SurfaceGraph& graph, std::span<const VertexIndex> curve)
{
    Vec3f sum = Vec3f::Zero();
    for (const VertexIndex vertex : curve)
        if (vertex.value < graph.vertexCount())
            sum += graph.pose()[vertex.value];
    return sum / static_cast<float>(std::max<std::size_t>(curve.size(), 1));
}

} // namespace

bool isWholeCurve(const SurfaceGraph& graph, std::span<const VertexIndex> vertices)
{
    const std::size_t count = vertices.size();
    if (count < 3)
        return false;
    for (std::size_t i = 0; i < count; ++i)
        if (vertices[i].value >= graph.vertexCount() ||
            vertices[(i + 1) % count].value >= graph.vertexCount() ||
            !graph.haveEdge(vertices[i], vertices[(i + 1) % count]))
            return false;
    return true;
}

const PartCurveEntry* PartCurveContent::curveAt(int index) const
{
    return index >= 0 && index < static_cast<int>(body.curves.size())
               ? &body.curves[static_cast<std::size_t>(index)]
               : nullptr;
}

int PartCurveContent::indexOf(const std::string& curve) const
{
    const auto found = std::find_if(body.curves.begin(), body.curves.end(),
                                    [&](const PartCurveEntry& entry) { return entry.curve.name == curve; });
    return found == body.curves.end() ? -1 : static_cast<int>(found - body.curves.begin());
}

const PartCurveEntry* PartCurveContent::selectedCurve() const
{
    return selected.kind == PartSelection::Kind::Curve ? findCurve(body, selected.name) : nullptr;
}

const PartEntry* PartCurveContent::selectedPart() const
{
    return selected.kind == PartSelection::Kind::Part ? findPart(body, selected.name) : nullptr;
}

std::vector<std::string> PartCurveContent::looseCurves() const
{
    return unusedCurves(curvesOf(body), partsOf(body));
}

std::vector<std::string> PartCurveContent::curvesForPart() const
{
    const std::vector<std::string> loose = looseCurves();
    if (loose.empty() || !graph)
        return {};
    const bool isChosen =
        selectedCurve() != nullptr && std::find(loose.begin(), loose.end(), selected.name) != loose.end();
    std::vector<std::string> curves{isChosen ? selected.name : loose.front()};
    const Vec3f middle = middleOf(*graph, findCurve(body, curves.front())->curve.vertices);
    std::string second;
    float nearest = std::numeric_limits<float>::max();
    for (const std::string& name : loose) {
        const float distance = (middleOf(*graph, findCurve(body, name)->curve.vertices) - middle).norm();
        if (name != curves.front() && distance < nearest) {
            nearest = distance;
            second = name;
        }
    }
    if (!second.empty())
        curves.push_back(second);
    return curves;
}

double PartCurveContent::lengthOfCurve(const std::string& name) const
{
    const PartCurveEntry* entry = findCurve(body, name);
    return graph && entry != nullptr && isWholeCurve(*graph, entry->curve.vertices)
               ? lengthOf(*graph, entry->curve.vertices)
               : 0.0;
}

} // namespace quadrille
