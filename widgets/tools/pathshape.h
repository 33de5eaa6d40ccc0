// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QVector3D>
#include <functional>
#include <vector>

namespace quadrille::widgets {

enum class PathKind
{
    CatmullRom, ///< through all points
    Polyline,
    Bezier ///< point, handle, handle, point, …
};

/// A stretch of a path of which more is asked.
struct PathStretch
{
    double from = 0; ///< along the curve
    double to = 0;
    QString text; ///< what is asked

    bool operator==(const PathStretch&) const = default;
};

/// A disc or a polygon on the ground.
struct PathObstacle
{
    std::vector<QVector3D> corners; ///< of the polygon; of a disc, its centre alone
    float radius = 0;               ///< of the disc
    QString problem;                ///< what is wrong with it; empty when nothing is

    bool isDisc() const { return corners.size() == 1; }
    bool operator==(const PathObstacle&) const = default;
};

/// What a path editor shows. All points and lengths are in the coordinates of the view.
struct PathShape
{
    PathKind kind = PathKind::CatmullRom;
    bool inSpace = false; ///< else all lies on the ground
    std::vector<QVector3D> points;
    std::vector<PathStretch> stretches;
    std::vector<PathObstacle> obstacles;
    float clearance = 0; ///< kept from obstacles

    bool operator==(const PathShape&) const = default;
};

/// Close points of the curve that goes by given points. The curve's ends are points of it, and those that it
/// passes.
using PathSampler =
    std::function<std::vector<QVector3D>(PathKind kind, const std::vector<QVector3D>& points)>;

} // namespace quadrille::widgets
