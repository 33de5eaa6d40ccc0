// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/groundview.h"
#include "widgets/tools/pathgeometry.h"

namespace quadrille::widgets {

/// Something of a path that can be taken hold of.
struct PathPart
{
    enum class Kind
    {
        None,
        Point, ///< or handle, by its index among all points
        StretchStart,
        StretchEnd,
        Obstacle,       ///< its middle
        ObstacleCorner, ///< of a polygon
        ObstacleRadius, ///< the edge of a disc
        Lift,           ///< the arrow that moves a point in space up and down
        Curve
    };
    Kind kind = Kind::None;
    int index = 0;
    int corner = 0; ///< of an obstacle

    /// What is selected by a press on it.
    PathPart owner() const;
    bool isPoint() const { return kind == Kind::Point || kind == Kind::Lift; }
    bool isStretchEnd() const { return kind == Kind::StretchStart || kind == Kind::StretchEnd; }
    std::size_t at() const { return static_cast<std::size_t>(index); }
    bool operator==(const PathPart&) const = default;
};

/// A path as it is shown.
struct PathContent
{
    PathShape shape;
    SampledCurve curve; ///< of the shape
    PathPart selected;
};

/// Where the parts of a path are in a view, and which one is under a pixel.
class PathLayout
{
public:
    /// \param content  outlives the layout.
    PathLayout(const PathContent& content, const GroundView& view) : m_content(content), m_view(view) {}
    const PathShape& shape() const { return m_content.shape; }
    const SampledCurve& curve() const { return m_content.curve; }
    const PathPart& selected() const { return m_content.selected; }
    const GroundView& view() const { return m_view; }

    /// All that have a handle, in the order in which keys walk over them.
    std::vector<PathPart> parts() const;
    /// None for a part that is not there.
    std::optional<QVector3D> placeOf(const PathPart& part) const;
    /// None also where it is not to be seen.
    std::optional<QPointF> pixelOf(const PathPart& part) const;
    /// The part that would be dragged from a pixel.
    PathPart partAt(const QPointF& pixel) const;
    /// The curve's length next to a pixel. \param distance  becomes the pixels to the curve.
    std::optional<double> lengthAt(const QPointF& pixel, double* distance = nullptr) const;

private:
    std::optional<QVector3D> placeOnObstacle(const PathPart& part) const;

    const PathContent& m_content;
    GroundView m_view;
};

/// How the pointer looks over a part.
Qt::CursorShape cursorFor(const PathPart& part);

/// The middle of an obstacle's corners.
QVector3D middleOf(const PathObstacle& obstacle);

} // namespace quadrille::widgets
