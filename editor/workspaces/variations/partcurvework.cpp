// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvework.h"

#include "editor/workspaces/variations/partedits.h"
#include "model/geometry/curveedits.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

/// Height of a pose, metres.
double heightOf(Positions pose, UpAxis up)
{
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();
    for (const Vec3f& point : pose) {
        lowest = std::min(lowest, point[static_cast<int>(up)]);
        highest = std::max(highest, point[static_cast<int>(up)]);
    }
    return static_cast<double>(highest - lowest);
}

std::vector<VertexIndex> obstaclesIn(const BodyPartsEntry& body, const std::string& without)
{
    std::vector<VertexIndex> vertices;
    for (const PartCurveEntry& entry : body.curves)
        if (entry.curve.name != without)
            vertices.insert(vertices.end(), entry.curve.vertices.begin(), entry.curve.vertices.end());
    return vertices;
}

/// Puts a curve in the place of one of the same name, or behind the others.
void putCurve(BodyPartsEntry& body, PartCurveEntry curve)
{
    if (PartCurveEntry* before = findCurve(body, curve.curve.name)) {
        curve.unknown = before->unknown;
        *before = std::move(curve);
    } else {
        body.curves.push_back(std::move(curve));
    }
}

} // namespace

ProposalSettings proposalSettings(const SurfaceGraph& graph, UpAxis up, double overlap)
{
    ProposalSettings settings;
    settings.up = up;
    if (const double height = heightOf(graph.pose(), up); height > 0)
        settings.overlap = overlap / height;
    return settings;
}

BodyPartsEntry withProposedParts(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                                 const std::shared_ptr<const Topology>& topology,
                                 const ProposalSettings& settings, const Progress& progress)
{
    const ProposedParts proposed = proposeParts(topology, graph->pose(), settings, progress);
    body.curves.clear();
    body.parts.clear();
    for (const PartCurve& curve : proposed.curves)
        body.curves.push_back({.curve = curve, .points = guidesOf(graph, curve.vertices), .unknown = {}});
    for (const PartDescription& part : proposed.parts)
        body.parts.push_back({.part = part, .unknown = {}});
    return body;
}

BodyPartsEntry withSecondCurve(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                               const PartCurveEntry& first, const std::string& name, double metres)
{
    const std::vector<VertexIndex> obstacles = obstaclesIn(body, first.curve.name);
    PartCurveEntry second;
    second.curve.name = name;
    try {
        second.curve.vertices =
            parallelCurve(*graph, first.curve.vertices, metres, CurveSide::Smaller, obstacles);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::CurveNoParallel)
            throw;
        second.curve.vertices =
            parallelCurve(*graph, first.curve.vertices, metres, CurveSide::Larger, obstacles);
    }
    second.points = guidesOf(graph, second.curve.vertices);
    body.curves.push_back(std::move(second));
    return body;
}

BodyPartsEntry withNewPart(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                           const NewPart& part, double metres)
{
    const std::string first = part.curve.curve.name;
    const std::string second = freeCurveName(body, first);
    body = withSecondCurve(std::move(body), graph, part.curve, second, metres);
    addPart(body, part.name, part.root, part.parent, {first, second});
    return body;
}

std::optional<MirrorPlan> mirrorPlan(const PartCurveContent& content,
                                     const std::function<std::string(const std::string&)>& mirrored)
{
    const auto otherName = [&mirrored](const std::string& name) {
        const std::string other = otherSideName(name);
        return other.empty() ? mirrored(name) : other;
    };
    const PartEntry* part = content.selectedPart();
    std::vector<std::string> curves;
    if (part != nullptr)
        curves = part->part.curves;
    else if (content.selectedCurve() != nullptr)
        curves = {content.selected.name};
    if (curves.empty())
        return std::nullopt;
    MirrorPlan plan;
    plan.selection = {content.selected.kind, otherName(content.selected.name)};
    for (const std::string& curve : curves)
        plan.names[curve] = otherName(curve);
    if (part == nullptr)
        return plan;
    plan.part = *part;
    plan.part->part.name = plan.selection.name;
    if (const std::string parent = otherSideName(part->part.parent);
        findPart(content.body, parent) != nullptr)
        plan.part->part.parent = parent;
    for (std::string& curve : plan.part->part.curves)
        curve = plan.names[curve];
    return plan;
}

BodyPartsEntry withMirrored(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                            const Symmetry& symmetry, const MirrorPlan& plan)
{
    for (const auto& [from, to] : plan.names) {
        const PartCurveEntry* own = findCurve(body, from);
        if (own == nullptr)
            continue;
        GuidedCurve mirrored =
            mirroredCurve(graph, symmetry, {.points = own->points, .vertices = own->curve.vertices});
        putCurve(body, {.curve = {.name = to, .vertices = std::move(mirrored.vertices)},
                        .points = std::move(mirrored.points),
                        .unknown = {}});
    }
    if (!plan.part)
        return body;
    if (PartEntry* before = findPart(body, plan.part->part.name))
        before->part = plan.part->part;
    else
        body.parts.push_back(*plan.part);
    return body;
}

BodyPartsEntry withShortenedCurve(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                                  const std::string& name, double travel)
{
    PartCurveEntry& own = *findCurve(body, name);
    own.curve.vertices = shortenedCurve(*graph, own.curve.vertices, travel, obstaclesIn(body, name));
    own.points = guidesOf(graph, own.curve.vertices);
    return body;
}

} // namespace quadrille
