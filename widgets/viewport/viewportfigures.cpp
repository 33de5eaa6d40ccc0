// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What a viewport knows of its figures.
#include "widgets/viewport/figurelanes.h"
#include "widgets/viewport/viewportprivate.h"

#include <algorithm>

namespace quadrille::widgets {

int Viewport::addFigure(FigureMesh mesh, const QString& name)
{
    const int id = d->nextId++;
    d->scene.add(id, std::move(mesh), name);
    arrange();
    return id;
}

void Viewport::removeFigure(int figure)
{
    d->scene.remove(figure);
    if (d->followed == figure)
        d->followed.reset();
    arrange();
}

void Viewport::setFigureName(int figure, const QString& name)
{
    if (SceneFigure* found = d->find(figure))
        found->name = name;
    redraw();
}

void Viewport::clear()
{
    for (const int figure : figures())
        d->scene.remove(figure);
    d->followed.reset();
    clearMeasurement();
}

std::vector<int> Viewport::figures() const
{
    std::vector<int> ids;
    for (const auto& [id, figure] : d->scene.figures())
        ids.push_back(id);
    return ids;
}

std::optional<FigureShape> Viewport::figureShape(int figure) const
{
    const SceneFigure* found = d->find(figure);
    if (found == nullptr)
        return std::nullopt;
    return FigureShape{found->actor->mesh(), found->actor->positions(), found->shift()};
}

void Viewport::setPositions(int figure, std::span<const float> positions)
{
    SceneFigure* found = d->find(figure);
    if (found == nullptr)
        return;
    found->actor->setPositions(positions);
    d->scene.shadows().changed(figure);
    const bool isFirst = !found->firstPose;
    if (isFirst) {
        found->firstPose.emplace(found->actor->lowerBound(), found->actor->upperBound());
        arrange();
    }
    if (d->followed == figure) {
        const QVector3D centroid = found->actor->centroid();
        QVector3D step = centroid - d->followedCentroid;
        // Only along the ground: a view that bobs with every step is hard to watch.
        step[d->gestures->camera().upAxis == UpAxis::Y ? 1 : 2] = 0.0F;
        d->followedCentroid = centroid;
        if (!isFirst)
            d->gestures->carry(step);
    }
    redraw();
    emit figureChanged(figure);
}

void Viewport::setTexture(int figure, const QImage& texture, int material)
{
    if (SceneFigure* found = d->find(figure))
        found->actor->setTexture(texture, material);
    redraw();
}

void Viewport::setFigureColor(int figure, const QColor& color)
{
    if (SceneFigure* found = d->find(figure)) {
        found->color = color;
        d->scene.refresh(*found);
    }
    redraw();
}

void Viewport::setFigureOffset(int figure, const QVector3D& offset)
{
    if (SceneFigure* found = d->find(figure)) {
        found->offset = offset;
        d->scene.refresh(*found);
    }
    redraw();
}

void Viewport::setFigureVisible(int figure, bool visible)
{
    if (SceneFigure* found = d->find(figure))
        found->visible = visible;
    arrange();
}

void Viewport::setFigureExtent(int figure, const QVector3D& lower, const QVector3D& upper)
{
    if (SceneFigure* found = d->find(figure)) {
        found->extent.emplace(lower, upper);
        arrange();
    }
}

void Viewport::setFigureOrder(const std::vector<int>& figures)
{
    if (d->order == figures)
        return;
    d->order = figures;
    arrange();
}

void Viewport::setAnchor(int figure)
{
    if (d->anchor == figure)
        return;
    d->anchor = figure;
    arrange();
}

/// Those that stand in lanes, from left to right. One that has no positions yet needs no room.
std::vector<SceneFigure*> Viewport::Private::lanes()
{
    std::vector<std::pair<std::ptrdiff_t, SceneFigure*>> placed;
    for (auto& [id, figure] : scene.figures()) {
        if (figure.visible && figure.firstPose)
            placed.emplace_back(std::ranges::find(order, id) - order.begin(), &figure);
    }
    std::ranges::stable_sort(placed, {}, [](const auto& each) { return each.first; });
    std::vector<SceneFigure*> sorted;
    sorted.reserve(placed.size());
    for (const auto& [place, figure] : placed)
        sorted.push_back(figure);
    return sorted;
}

void Viewport::arrange()
{
    const std::vector<SceneFigure*> lanes = d->lanes();
    std::vector<LaneBox> boxes;
    std::size_t anchor = 0;
    for (const SceneFigure* figure : lanes) {
        if (figure == d->find(d->anchor))
            anchor = boxes.size();
        const auto& [lower, upper] = figure->extent ? *figure->extent : *figure->firstPose;
        boxes.push_back({lower, upper});
    }
    std::vector<QVector3D> offsets(lanes.size());
    if (d->layout == Layout::SideBySide)
        offsets = laneOffsets(boxes, anchor, d->gestures->camera().upAxis, d->scene.ruler().of(1.0F));
    // The figure that goes back to its own place does so in the world, not in the view.
    if (!lanes.empty())
        d->gestures->carry(-lanes[anchor]->layoutOffset);
    for (auto& [id, figure] : d->scene.figures())
        figure.layoutOffset = {};
    for (std::size_t i = 0; i < lanes.size(); ++i)
        lanes[i]->layoutOffset = offsets[i];
    for (auto& [id, figure] : d->scene.figures())
        d->scene.refresh(figure);
    redraw();
}

void Viewport::setFigureOpacity(int figure, double opacity)
{
    if (SceneFigure* found = d->find(figure)) {
        found->opacity = opacity;
        found->actor->setOpacity(opacity);
    }
    redraw();
}

void Viewport::setScalars(int figure, std::span<const float> values, ScalarPlace place,
                          const ScalarRange& range)
{
    if (SceneFigure* found = d->find(figure)) {
        found->scalarRange = range;
        found->colorKey.reset();
        found->actor->setScalars(values, place, range);
    }
    redraw();
}

void Viewport::setTriangleColors(int figure, std::span<const QRgb> colors, const ColorKey& key)
{
    if (SceneFigure* found = d->find(figure)) {
        found->colorKey = colors.empty() ? std::nullopt : std::optional(key);
        found->actor->setTriangleColors(colors);
    }
    redraw();
}

void Viewport::setGhosts(int figure, const std::vector<Ghost>& ghosts)
{
    if (SceneFigure* found = d->find(figure))
        d->scene.setGhosts(*found, ghosts);
    redraw();
}

void Viewport::setTrajectory(int figure, const std::vector<QVector3D>& points, const QColor& color)
{
    if (d->find(figure) != nullptr)
        d->scene.setTrajectory(figure, points, color);
    redraw();
}

} // namespace quadrille::widgets
