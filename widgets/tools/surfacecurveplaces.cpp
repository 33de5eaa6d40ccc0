// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Where on the view and on the surface things are.
#include "widgets/tools/surfacecurveeditorprivate.h"
#include "widgets/viewport/surfacepick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::widgets {

std::optional<FigureShape> SurfaceCurveEditor::Private::shape() const
{
    const auto found = viewport.figureShape(figure);
    if (!found || found->positions.empty())
        return std::nullopt;
    return found;
}

std::optional<QPointF> SurfaceCurveEditor::Private::project(std::uint32_t vertex) const
{
    const auto figureShape = shape();
    QPointF pixel;
    if (!figureShape || !owner.camera().project(figureShape->place(vertex), owner.viewSize(), &pixel))
        return std::nullopt;
    return pixel;
}

bool SurfaceCurveEditor::Private::isThere(const SurfaceCurvePart& part) const
{
    if (part.kind == SurfaceCurvePart::Kind::None || part.curve < 0 ||
        part.curve >= static_cast<int>(curves.size()))
        return false;
    const ShownCurve& curve = curves[static_cast<std::size_t>(part.curve)];
    if (part.kind == SurfaceCurvePart::Kind::Curve)
        return !curve.vertices.empty();
    return part.point >= 0 && part.point < static_cast<int>(curve.points.size());
}

std::uint32_t SurfaceCurveEditor::Private::vertexOf(const SurfaceCurvePart& part) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(part.curve)];
    return part.kind == SurfaceCurvePart::Kind::Point
               ? curve.vertices[curve.points[static_cast<std::size_t>(part.point)]]
               : curve.vertices.front();
}

const ShownCurve* SurfaceCurveEditor::Private::drawnCurve() const
{
    return drawn >= 0 && drawn < static_cast<int>(curves.size()) ? &curves[static_cast<std::size_t>(drawn)]
                                                                 : nullptr;
}

const std::vector<std::vector<bool>>& SurfaceCurveEditor::Private::seen() const
{
    if (seenCache)
        return *seenCache;
    std::vector<std::uint32_t> all;
    for (const ShownCurve& curve : curves)
        all.insert(all.end(), curve.vertices.begin(), curve.vertices.end());
    std::vector<bool> visible(all.size());
    if (const auto figureShape = shape(); figureShape && owner.viewSize().isValid())
        visible = visibleVertices(*figureShape, owner.camera(), owner.viewSize(), all);
    seenCache.emplace();
    auto next = visible.begin();
    for (const ShownCurve& curve : curves) {
        const auto end = next + static_cast<std::ptrdiff_t>(curve.vertices.size());
        seenCache->emplace_back(next, end);
        next = end;
    }
    return *seenCache;
}

std::optional<SurfacePlace> SurfaceCurveEditor::Private::placeAt(const QPointF& pixel,
                                                                 Qt::KeyboardModifiers modifiers) const
{
    const auto figureShape = shape();
    if (!figureShape)
        return std::nullopt;
    const auto hit = pickSurface(figureShape->mesh, figureShape->positions, figureShape->shift,
                                 owner.camera().rayThrough(pixel, owner.viewSize()));
    if (!hit)
        return std::nullopt;
    return SurfacePlace{.pick = {figure, hit->triangle, hit->vertex, hit->barycentric, hit->point},
                        .snaps = !modifiers.testFlag(Qt::AltModifier)};
}

std::optional<SurfacePlace> SurfaceCurveEditor::Private::placeAt(std::uint32_t vertex,
                                                                 Qt::KeyboardModifiers modifiers) const
{
    const auto figureShape = shape();
    if (!figureShape)
        return std::nullopt;
    const auto& triangles = figureShape->mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto corner = std::find(triangles[t].begin(), triangles[t].end(), vertex);
        if (corner == triangles[t].end())
            continue;
        SurfacePlace place;
        place.pick.figure = figure;
        place.pick.triangle = static_cast<std::uint32_t>(t);
        place.pick.vertex = vertex;
        place.pick.barycentric[static_cast<std::size_t>(corner - triangles[t].begin())] = 1.0F;
        place.pick.point = figureShape->place(vertex);
        place.snaps = !modifiers.testFlag(Qt::AltModifier);
        return place;
    }
    return std::nullopt;
}

std::uint32_t SurfaceCurveEditor::Private::neighbourAt(std::uint32_t vertex, const QPointF& direction,
                                                       int steps)
{
    const auto figureShape = shape();
    if (!figureShape)
        return vertex;
    if (neighbours.empty()) {
        neighbours.resize(figureShape->mesh.vertexCount);
        for (const auto& triangle : figureShape->mesh.triangles)
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (const std::size_t other : {(corner + 1) % 3, (corner + 2) % 3})
                    neighbours[triangle[corner]].push_back(triangle[other]);
    }
    for (int step = 0; step < steps; ++step) {
        const auto from = project(vertex);
        std::uint32_t best = vertex;
        double bestCosine = 0.3;
        for (const std::uint32_t next : neighbours[vertex]) {
            const auto to = project(next);
            const double length = from && to ? distanceBetween(*from, *to) : 0.0;
            if (length <= 0.0)
                continue;
            if (const double cosine = QPointF::dotProduct(*to - *from, direction) / length;
                cosine > bestCosine) {
                bestCosine = cosine;
                best = next;
            }
        }
        vertex = best;
    }
    return vertex;
}

std::optional<std::uint32_t> SurfaceCurveEditor::Private::firstCursor() const
{
    if (const ShownCurve* curve = drawnCurve(); curve != nullptr && !curve->points.empty())
        return curve->vertices[curve->points.back()];
    const QPointF middle(owner.viewSize().width() / 2.0, owner.viewSize().height() / 2.0);
    if (const auto place = placeAt(middle, {}))
        return place->pick.vertex;
    const auto figureShape = shape();
    std::optional<std::uint32_t> nearest;
    double least = std::numeric_limits<double>::max();
    for (std::uint32_t vertex = 0; figureShape && vertex < figureShape->mesh.vertexCount; ++vertex) {
        const auto pixel = project(vertex);
        if (const double distance = pixel ? distanceBetween(*pixel, middle) : least; distance < least) {
            least = distance;
            nearest = vertex;
        }
    }
    return nearest;
}

bool SurfaceCurveEditor::Private::closesAt(const QPointF& pixel) const
{
    const ShownCurve* curve = drawnCurve();
    if (curve == nullptr || curve->points.empty())
        return false;
    const auto first = project(curve->vertices[curve->points.front()]);
    return first && distanceBetween(*first, pixel) < surfacePointReach;
}

int SurfaceCurveEditor::Private::pointBefore(int index, const QPointF& pixel) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(index)];
    const std::size_t count = curve.vertices.size();
    std::size_t place = 0;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = project(curve.vertices[i]);
        const auto b = project(curve.vertices[(i + 1) % count]);
        if (!seen()[static_cast<std::size_t>(index)][i] || !a || !b)
            continue;
        if (const double distance = distanceToSegment(pixel, *a, *b); distance < nearest) {
            nearest = distance;
            place = i;
        }
    }
    const auto after = std::upper_bound(curve.points.begin(), curve.points.end(), place);
    const auto before = static_cast<int>(after - curve.points.begin()) - 1;
    return before >= 0 ? before : static_cast<int>(curve.points.size()) - 1;
}

std::vector<SurfaceCurvePart> SurfaceCurveEditor::Private::points() const
{
    std::vector<SurfaceCurvePart> all;
    for (int c = 0; c < static_cast<int>(curves.size()); ++c)
        for (int p = 0; p < static_cast<int>(curves[static_cast<std::size_t>(c)].points.size()); ++p)
            all.push_back({SurfaceCurvePart::Kind::Point, c, p});
    return all;
}

QVector3D SurfaceCurveEditor::Private::normalAt(std::uint32_t vertex) const
{
    const auto figureShape = shape();
    QVector3D sum;
    for (const auto& triangle : figureShape->mesh.triangles)
        if (std::find(triangle.begin(), triangle.end(), vertex) != triangle.end())
            sum += QVector3D::crossProduct(figureShape->place(triangle[1]) - figureShape->place(triangle[0]),
                                           figureShape->place(triangle[2]) - figureShape->place(triangle[0]));
    return sum.normalized();
}

} // namespace quadrille::widgets
