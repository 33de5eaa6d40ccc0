// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What a viewport knows of its figures.
#include "widgets/viewport/viewportprivate.h"

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
    const bool isFirst = found->firstSize.isNull();
    if (isFirst) {
        found->firstSize = found->actor->upperBound() - found->actor->lowerBound();
        found->firstMiddle = (found->actor->upperBound() + found->actor->lowerBound()) / 2.0F;
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
    if (SceneFigure* found = d->find(figure))
        found->extent.emplace(lower, upper);
}

void Viewport::setFigureOpacity(int figure, double opacity)
{
    if (SceneFigure* found = d->find(figure))
        found->actor->setOpacity(opacity);
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
