// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/patheditor.h"
#include "widgets/viewport/pathgeometry.h"
#include "widgets/viewport/viewport.h"

namespace quadrille::widgets {

/// What the mouse is doing.
struct PathDrag
{
    enum class Kind
    {
        None,
        Part,   ///< moves something that is there
        Stroke, ///< draws points
        Pull,   ///< draws a point of a Bézier path with its handles
        Radius  ///< draws a disc
    };
    Kind kind = Kind::None;
    PathPart part;
    bool moved = false;
    QPointF pressedAt;
    PathShape before;
    QVector3D start;        ///< of the part
    QVector3D grabbed;      ///< the place under the pointer at the press, in the part's plane
    bool isLifting = false; ///< up and down instead of along the ground
    std::vector<QVector3D> stroke;
};

struct PathEditor::Private
{
    explicit Private(PathEditor& editor, Viewport& shown) : owner(editor), viewport(shown) {}

    PathEditor& owner;
    Viewport& viewport;
    PathSampler sampler;
    PathShape shape;
    SampledCurve curve;
    Mode mode = Mode::Edit;
    bool active = true;
    PathPart selected;
    PathPart hovered;
    PathDrag drag;
    float usualHeight = 0.9F;
    std::optional<QVector3D> firstPoint;   ///< of a path that has no other yet
    std::vector<QVector3D> corners;        ///< of the polygon that is being drawn
    std::optional<QVector3D> pointer;      ///< where a click would draw
    std::optional<QPointF> clickOnNothing; ///< where a press was left to the camera
    bool isMenuPress = false;              ///< the right button is down on a part

    const Ruler& ruler() const { return viewport.ruler(); }
    QVector3D up() const;
    int upIndex() const;
    /// Those of the path, or the first of a path that has no other yet.
    std::vector<QVector3D> drawnPoints() const;
    std::optional<QPointF> project(const QVector3D& point) const;
    QVector3D onGround(QVector3D point) const;
    /// Where the ray through a pixel meets the level plane of a height.
    std::optional<QVector3D> placeAt(const QPointF& pixel, float height) const;
    /// The height at which the pointer's ray passes an upright line.
    float heightAt(const QPointF& pixel, const QVector3D& foot) const;
    QVector3D constrained(const QVector3D& from, QVector3D place, Qt::KeyboardModifiers modifiers) const;
    /// The place for a new point under a pixel.
    std::optional<QVector3D> newPlace(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;
    std::optional<QVector3D> placeOf(const PathPart& part) const;
    float unitsPerPixel(const QVector3D& near) const;
    /// The curve's length next to a pixel. \param distance  pixels to the curve.
    std::optional<double> lengthAt(const QPointF& pixel, double* distance) const;
    std::vector<PathPart> parts() const;
    PathDrag startOf(const PathPart& part, const QMouseEvent& event) const;
    /// The drawing as it would be with a point at the pointer.
    std::vector<QVector3D> preview() const;
    /// All that can be dragged, but for the handles of Bézier points.
    std::vector<QVector3D> handles() const;
    /// Where on a stretch its words are farthest from all that can be dragged.
    QVector3D clearPlace(const PathStretch& stretch) const;
    void paintSpace(QPainter& painter) const;
    void paintHandles(QPainter& painter) const;
    void paintDrawing(QPainter& painter) const;
    /// What mouse and keys do now.
    QString hint() const;
    static Qt::CursorShape cursorFor(const PathPart& part, Mode mode);
};

} // namespace quadrille::widgets
