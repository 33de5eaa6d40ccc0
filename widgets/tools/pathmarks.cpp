// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathmarks.h"

#include "widgets/theme/theme.h"

#include <algorithm>
#include <limits>

namespace quadrille::widgets {

namespace {

/// All that can be dragged, but for the handles of Bézier points.
std::vector<QVector3D> handlesOf(const PathShape& shape, const SampledCurve& curve)
{
    std::vector<QVector3D> all;
    for (std::size_t i = 0; i < shape.points.size(); ++i)
        if (!isHandle(shape.kind, i))
            all.push_back(shape.points[i]);
    for (const PathStretch& stretch : shape.stretches) {
        if (curve.isEmpty())
            break;
        all.push_back(curve.at(stretch.from));
        all.push_back(curve.at(std::min(stretch.to, curve.length())));
    }
    for (const PathObstacle& obstacle : shape.obstacles)
        all.insert(all.end(), obstacle.corners.begin(), obstacle.corners.end());
    return all;
}

/// Where on a stretch its words are farthest from all handles.
QVector3D clearPlace(const PathStretch& stretch, const SampledCurve& curve,
                     const std::vector<QVector3D>& handles)
{
    const double to = std::min(stretch.to, curve.length());
    constexpr int places = 40;
    QVector3D best = curve.at((stretch.from + to) / 2.0);
    float widest = -1.0F;
    // From the middle to both sides: of places that are as good, the one nearest to the middle is taken.
    for (int i = 0; i < places; ++i) {
        const int away = (i + 1) / 2;
        const double aside = (i % 2 == 0 ? 1.0 : -1.0) * away / places;
        const QVector3D place = curve.at(stretch.from + (to - stretch.from) * (0.5 + aside));
        float nearest = std::numeric_limits<float>::max();
        for (const QVector3D& handle : handles)
            nearest = std::min(nearest, (place - handle).length());
        if (nearest > widest * 1.02F) {
            widest = nearest;
            best = place;
        }
    }
    return best;
}

void addObstacle(SceneMarks& marks, const PathObstacle& obstacle, float clearance, const GroundView& view)
{
    const QColor color = Theme::color(obstacle.problem.isEmpty() ? ColorRole::Line : ColorRole::Error);
    const auto outline = obstacle.isDisc() ? circleOnGround(obstacle.corners[0], obstacle.radius, view.up())
                                           : obstacle.corners;
    marks.areas.push_back({.outline = outline, .color = color, .hatched = true});
    if (clearance > 0.0F) {
        auto around = widenedOutline(obstacle, clearance, view.up());
        around.push_back(around.front());
        marks.curves.push_back(
            {.points = around, .color = color, .colors = {}, .width = 1.5F, .dash = view.ruler.of(0.08F)});
    }
    if (!obstacle.problem.isEmpty())
        marks.labels.push_back({obstacle.corners[0], obstacle.problem, color});
}

} // namespace

SceneMarks pathMarks(const PathLayout& layout)
{
    const SampledCurve& curve = layout.curve();
    SceneMarks marks;
    marks.handles = handlesOf(layout.shape(), curve);
    if (!curve.isEmpty()) {
        const QColor demanded = Theme::color(ColorRole::Demanded);
        for (const PathStretch& stretch : layout.shape().stretches) {
            marks.curves.push_back({.points = curve.part(stretch.from, stretch.to),
                                    .color = demanded,
                                    .colors = {},
                                    .width = 9.0F});
            marks.labels.push_back({clearPlace(stretch, curve, marks.handles), stretch.text, demanded});
        }
        marks.curves.push_back({.points = curve.points(),
                                .color = Theme::color(ColorRole::ViewportText),
                                .colors = {},
                                .width = 2.5F});
    }
    for (const PathObstacle& obstacle : layout.shape().obstacles)
        addObstacle(marks, obstacle, layout.shape().clearance, layout.view());
    return marks;
}

} // namespace quadrille::widgets
