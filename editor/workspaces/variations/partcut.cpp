// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcut.h"

#include "editor/workspaces/variations/partedits.h"
#include "widgets/theme/theme.h"

#include <algorithm>
#include <set>

namespace quadrille {

using widgets::Theme;

namespace {

/// The body without what something is wrong with: what hangs on a part that goes, goes as well.
BodyPartsEntry sound(BodyPartsEntry body, const std::vector<PartProblem>& problems)
{
    std::set<std::string> curves;
    std::set<std::string> parts;
    for (const PartProblem& problem : problems) {
        if (!problem.part.empty())
            parts.insert(problem.part);
        else
            curves.insert(problem.curve);
    }
    for (std::size_t before = parts.size() + 1; before != parts.size();) {
        before = parts.size();
        for (const PartEntry& entry : body.parts) {
            const bool isBroken =
                parts.contains(entry.part.parent) ||
                std::any_of(entry.part.curves.begin(), entry.part.curves.end(),
                            [&](const std::string& curve) { return curves.contains(curve); });
            if (isBroken)
                parts.insert(entry.part.name);
        }
    }
    std::erase_if(body.curves,
                  [&](const PartCurveEntry& entry) { return curves.contains(entry.curve.name); });
    std::erase_if(body.parts, [&](const PartEntry& entry) { return parts.contains(entry.part.name); });
    return body;
}

QColor lighter(const QColor& color)
{
    constexpr float share = 0.55F;
    const auto mix = [](float from) { return from + share * (1.0F - from); };
    return QColor::fromRgbF(mix(color.redF()), mix(color.greenF()), mix(color.blueF()));
}

} // namespace

const PartProblem* PartCut::problemOfCurve(const std::string& name) const
{
    const auto found = std::find_if(problems.begin(), problems.end(), [&](const PartProblem& problem) {
        return problem.curve == name && problem.part.empty();
    });
    return found == problems.end() ? nullptr : &*found;
}

const PartProblem* PartCut::problemOfPart(const std::string& name) const
{
    const auto found = std::find_if(problems.begin(), problems.end(),
                                    [&](const PartProblem& problem) { return problem.part == name; });
    return found == problems.end() ? nullptr : &*found;
}

const BodyPart* PartCut::part(const std::string& name) const
{
    const auto found = std::find_if(parts.parts.begin(), parts.parts.end(),
                                    [&](const BodyPart& part) { return part.name == name; });
    return found == parts.parts.end() ? nullptr : &*found;
}

std::string PartCut::partOf(std::span<const VertexIndex> vertices) const
{
    std::string best;
    std::ptrdiff_t most = 0;
    // Children come after their parents, and share less: of equals the last one is meant.
    for (const BodyPart& part : parts.parts) {
        const auto count = std::count_if(vertices.begin(), vertices.end(), [&](VertexIndex vertex) {
            return std::binary_search(part.vertices.begin(), part.vertices.end(), vertex);
        });
        if (count > 0 && count >= most) {
            most = count;
            best = part.name;
        }
    }
    return best;
}

PartCut cutBody(const SurfaceGraph& graph, const BodyPartsEntry& body)
{
    PartCut cut;
    const std::vector<PartCurve> curves = curvesOf(body);
    const std::vector<PartDescription> parts = partsOf(body);
    cut.problems = partProblems(graph.topology(), curves, parts);
    const BodyPartsEntry left = cut.problems.empty() ? body : sound(body, cut.problems);
    if (left.parts.empty())
        return cut;
    try {
        cut.parts = cutIntoParts(graph.topology(), graph.pose(), curvesOf(left), partsOf(left));
    } catch (const Error&) {
        // What is left hangs together no more; the problems say why.
        cut.parts = {};
    }
    return cut;
}

QColor partColor(const BodyPartsEntry& body, const std::string& part)
{
    const auto found = std::find_if(body.parts.begin(), body.parts.end(),
                                    [&](const PartEntry& entry) { return entry.part.name == part; });
    return Theme::categorical(static_cast<int>(found - body.parts.begin()));
}

PartColors partColors(const PartCut& cut, const BodyPartsEntry& body, std::size_t triangleCount,
                      const QString& title, const QString& overlap)
{
    PartColors colors;
    if (cut.parts.parts.size() < 2)
        return colors;
    colors.key.title = title;
    colors.triangles.assign(triangleCount, Theme::color(widgets::ColorRole::Clay).rgb());
    for (const BodyPart& part : cut.parts.parts) {
        const QColor color = partColor(body, part.name);
        colors.key.items.push_back({QString::fromStdString(part.name), color});
        for (const TriangleIndex triangle : part.triangles)
            colors.triangles[triangle.value] = color.rgb();
        // Children come after their parents, so overlaps are the child's.
        for (const TriangleIndex triangle : part.overlapTriangles)
            colors.triangles[triangle.value] = lighter(color).rgb();
    }
    const QColor last = partColor(body, cut.parts.parts.back().name);
    colors.key.items.push_back({overlap, lighter(last)});
    return colors;
}

} // namespace quadrille
