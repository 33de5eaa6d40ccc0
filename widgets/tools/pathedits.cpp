// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathedits.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

double shortestStretch(const Ruler& ruler)
{
    constexpr double metres = 0.05;
    return ruler.of(metres);
}

float smallestRadius(const Ruler& ruler)
{
    constexpr float metres = 0.05F;
    return ruler.of(metres);
}

/// Ends that came too near to each other, or to the start of the curve, are moved apart.
void moveStretchEnd(PathStretch& stretch, bool isStart, double by, const Ruler& ruler)
{
    (isStart ? stretch.from : stretch.to) += by;
    stretch.to = std::max(stretch.to, shortestStretch(ruler));
    stretch.from = std::clamp(stretch.from, 0.0, stretch.to - shortestStretch(ruler));
}

} // namespace

PathShape withPartAt(PathShape shape, const PathPart& part, const QVector3D& place, bool mirrored,
                     const Ruler& ruler)
{
    if (part.isPoint()) {
        const bool keepsOpposite = mirrored && isHandle(shape.kind, part.at()) &&
                                   isSmooth(shape.points, anchorOf(shape.kind, part.at()));
        shape.points = movedPoint(shape.kind, std::move(shape.points), part.at(), place, keepsOpposite);
        return shape;
    }
    PathObstacle& obstacle = shape.obstacles[part.at()];
    if (part.kind == PathPart::Kind::ObstacleCorner) {
        obstacle.corners[static_cast<std::size_t>(part.corner)] = place;
    } else if (part.kind == PathPart::Kind::ObstacleRadius) {
        obstacle.radius = std::max(smallestRadius(ruler), (place - obstacle.corners.front()).length());
    } else {
        const QVector3D shift = place - middleOf(obstacle);
        for (QVector3D& corner : obstacle.corners)
            corner += shift;
    }
    return shape;
}

PathShape withStretchEndAt(PathShape shape, const PathPart& part, double length, const Ruler& ruler)
{
    PathStretch& stretch = shape.stretches[part.at()];
    if (part.kind == PathPart::Kind::StretchStart)
        stretch.from = std::clamp(length, 0.0, stretch.to - shortestStretch(ruler));
    else
        stretch.to = std::max(length, stretch.from + shortestStretch(ruler));
    return shape;
}

std::optional<PathShape> nudgedSelection(const PathLayout& layout, int key, Qt::KeyboardModifiers modifiers)
{
    const PathPart& part = layout.selected();
    const Ruler& ruler = layout.view().ruler;
    const auto place = layout.placeOf(part);
    if (!place)
        return std::nullopt;
    const auto step = static_cast<float>(modifiers.testFlag(Qt::ShiftModifier)     ? ruler.coarse()
                                         : modifiers.testFlag(Qt::ControlModifier) ? ruler.fine()
                                                                                   : ruler.middle());
    const bool isBackwards = key == Qt::Key_Left || key == Qt::Key_Down || key == Qt::Key_PageDown;
    if (part.isStretchEnd()) {
        PathShape shape = layout.shape();
        moveStretchEnd(shape.stretches[part.at()], part.kind == PathPart::Kind::StretchStart,
                       static_cast<double>(isBackwards ? -step : step), ruler);
        return shape;
    }
    const bool isLift = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    if (isLift && !(part.isPoint() && layout.shape().inSpace))
        return std::nullopt;
    // The axis that lies nearest to the arrow as the view is turned now.
    const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
    const QVector3D right = layout.view().camera.right();
    const QVector3D wanted = isSideways ? right : QVector3D::crossProduct(layout.view().up(), right);
    const int up = layout.view().upIndex();
    const int axis = isLift ? up : std::abs(wanted[0]) >= std::abs(wanted[3 - up]) ? 0 : 3 - up;
    QVector3D shift;
    shift[axis] = isLift || wanted[axis] > 0.0F ? step : -step;
    return withPartAt(layout.shape(), part, *place + (isBackwards ? -shift : shift), true, ruler);
}

std::optional<PathShape> resizedSelection(const PathLayout& layout, float by)
{
    const PathPart& part = layout.selected();
    PathShape shape = layout.shape();
    if (part.kind != PathPart::Kind::Obstacle || part.at() >= shape.obstacles.size() ||
        !shape.obstacles[part.at()].isDisc())
        return std::nullopt;
    float& radius = shape.obstacles[part.at()].radius;
    radius = std::max(smallestRadius(layout.view().ruler), radius + by);
    return shape;
}

std::size_t anchorBefore(const PathLayout& layout, double length)
{
    const SampledCurve& curve = layout.curve();
    const auto samples = anchorSamples(layout.shape().kind, layout.shape().points, curve.points());
    std::size_t anchor = 0;
    while (anchor + 2 < samples.size() && curve.lengthAt(samples[anchor + 1]) <= length)
        ++anchor;
    return anchor;
}

double lengthAfter(const PathLayout& layout, std::size_t point)
{
    const PathShape& shape = layout.shape();
    const auto samples = anchorSamples(shape.kind, shape.points, layout.curve().points());
    const std::size_t anchor =
        std::min(anchorOf(shape.kind, point), anchorCount(shape.kind, shape.points.size()) - 2);
    return (layout.curve().lengthAt(samples[anchor]) + layout.curve().lengthAt(samples[anchor + 1])) / 2.0;
}

QVector3D nextPlace(const std::vector<QVector3D>& points, const GroundView& view)
{
    QVector3D direction = view.camera.forward();
    if (points.size() > 1)
        direction = points.back() - points[points.size() - 2];
    direction[view.upIndex()] = 0.0F;
    if (direction.isNull())
        direction = QVector3D(1, 0, 0);
    return points.back() + view.ruler.of(1.0F) * direction.normalized();
}

} // namespace quadrille::widgets
