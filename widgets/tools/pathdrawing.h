// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathlayout.h"

namespace quadrille::widgets {

/// What a press on the view begins.
enum class PathMode
{
    Edit,
    Draw,
    Disc,   ///< drag from its middle
    Polygon ///< corner by corner
};

/// What is done to the points of a path.
enum class PathEdit
{
    Add,
    Move,
    Insert,
    Delete,
    Draw ///< a stroke by a free hand
};

/// Understands presses, moves and releases while a path or an obstacle is drawn. It knows what is not yet of
/// the shape, and changes no shape.
class PathDrawing
{
public:
    enum class Gesture
    {
        None,
        Stroke, ///< draws points
        Pull,   ///< draws a point of a Bézier path with its handles
        Radius  ///< draws a disc
    };
    /// What a gesture comes to.
    struct Outcome
    {
        std::vector<QVector3D> points; ///< of the path from now on; empty where they stay
        PathEdit edit = PathEdit::Add;
        std::optional<PathObstacle> obstacle;
        bool isDone = false; ///< what was to be drawn is complete
    };

    PathMode mode() const { return m_mode; }
    /// Forgets what was begun, but for a gesture.
    void setMode(PathMode mode);
    bool isDrawing() const { return m_mode != PathMode::Edit; }
    Gesture gesture() const { return m_gesture; }
    /// Whether the gesture is more than a click.
    bool hasMoved() const { return m_moved; }
    void dropGesture() { m_gesture = Gesture::None; }
    /// The first point of a path that has no other yet.
    const std::optional<QVector3D>& firstPoint() const { return m_firstPoint; }
    void forgetFirstPoint() { m_firstPoint.reset(); }
    /// The corners of the polygon so far.
    const std::vector<QVector3D>& corners() const { return m_corners; }
    /// Where the gesture began.
    const QVector3D& start() const { return m_start; }
    const std::vector<QVector3D>& stroke() const { return m_stroke; }
    /// Where a click would draw.
    const std::optional<QVector3D>& pointer() const { return m_pointer; }
    void hover(const PathLayout& layout, const QPointF& pixel, Qt::KeyboardModifiers modifiers);
    void leave() { m_pointer.reset(); }
    /// The height above the ground that the first point gets in space.
    void setUsualHeight(float height) { m_usualHeight = height; }
    float usualHeight() const { return m_usualHeight; }

    /// \pre isDrawing(). \return whether that was a click on the first corner, and the polygon is complete.
    bool press(const PathLayout& layout, const QPointF& pixel, Qt::KeyboardModifiers modifiers);
    void move(const PathLayout& layout, const QPointF& pixel);
    /// Ends the gesture. \param commit  false: as if it had not been.
    Outcome release(const PathLayout& layout, bool commit);
    /// Ends drawing without a gesture: a polygon of three corners or more is complete.
    std::optional<PathObstacle> polygon() const;
    /// Adds a point as by a click there.
    Outcome added(const PathLayout& layout, const QVector3D& place);

    /// Those of the path, or the first of a path that has no other yet.
    std::vector<QVector3D> drawnPoints(const PathShape& shape) const;
    /// The points as they would be with one at the pointer; empty where that adds none.
    std::vector<QVector3D> preview(const PathShape& shape) const;

private:
    std::optional<QVector3D> newPlace(const PathLayout& layout, const QPointF& pixel,
                                      Qt::KeyboardModifiers modifiers) const;
    Outcome finishPoint(const PathLayout& layout);
    PathObstacle disc(const Ruler& ruler) const;

    PathMode m_mode = PathMode::Edit;
    float m_usualHeight = 0.9F;
    std::optional<QVector3D> m_firstPoint;
    std::vector<QVector3D> m_corners;
    std::optional<QVector3D> m_pointer;
    Gesture m_gesture = Gesture::None;
    bool m_moved = false;
    QPointF m_pressedAt;
    QVector3D m_start;
    std::vector<QVector3D> m_stroke;
};

/// An obstacle that keys put at a place: a disc or, in that mode, a polygon of four corners.
PathObstacle usualObstacle(PathMode mode, const QVector3D& middle, const GroundView& view);

} // namespace quadrille::widgets
