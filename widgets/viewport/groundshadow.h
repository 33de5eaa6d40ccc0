// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QVector3D>
#include <functional>
#include <memory>
#include <span>
#include <vector>

class vtkRenderer;

namespace quadrille::widgets {

/// How dark the ground is about a figure, on a grid of square cells; in the unit of the figure's positions.
struct GroundShadow
{
    QVector3D corner;            ///< outer corner of the first cell, in the figure's coordinates
    double cell = 0;             ///< side
    int columns = 0;             ///< along z where y is up, along x where z is up
    int rows = 0;                ///< along x, or y
    std::vector<float> darkness; ///< rows of 0 … 1
};

/// What a shadow is wanted of, in the unit of the positions.
struct ShadowWish
{
    int figure = 0;
    std::span<const float> positions; ///< vertices × 3
    UpAxis up = UpAxis::Y;
    float ground = 0;        ///< its height
    QVector3D toLight;       ///< length one, above the ground
    double coarseness = 1.0; ///< how many times larger cells may be, for the sake of speed
};

using ShadowMaker = std::function<GroundShadow(const ShadowWish&)>;

/// The shadow of one figure, lying on the ground.
class ShadowActor
{
public:
    explicit ShadowActor(vtkRenderer* renderer);
    ~ShadowActor();
    ShadowActor(const ShadowActor&) = delete;
    ShadowActor& operator=(const ShadowActor&) = delete;

    /// \param strength  share of the light that is missing where it is darkest.
    void show(const GroundShadow& shadow, UpAxis up, double strength);
    void setOffset(const QVector3D& offset);
    void setVisible(bool visible);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
