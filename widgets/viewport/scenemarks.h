// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>
#include <QVector3D>
#include <vector>

namespace quadrille::widgets {

/// A line in the world that keeps its width on the screen. Figures in front of it hide it.
struct SceneCurve
{
    std::vector<QVector3D> points; ///< in the view, whose unit all lengths here are in
    QColor color;
    /// One for each point, in place of `color`; or none.
    std::vector<QColor> colors;
    float width = 2.5F; ///< logical pixels
    /// Length of dashes and of the gaps between them, along the line; 0: drawn through. What colours
    /// mean must be told by dashes or labels too.
    float dash = 0.0F;
    bool pairs = false; ///< each two points are a line of their own

    bool operator==(const SceneCurve&) const = default;
};

/// A flat shape on the ground: filled, outlined, hatched.
struct SceneArea
{
    std::vector<QVector3D> outline; ///< ≥ 3 corners of a polygon without crossings
    QColor color;                   ///< of the outline; the fill is a faint one of it
    bool hatched = false;

    bool operator==(const SceneArea&) const = default;
};

/// Words at a place.
struct SceneLabel
{
    QVector3D place;
    QString text;
    QColor color; ///< of a dot before the words; invalid: none
    /// Belongs to a place where a figure stands, and keeps clear of it. Other labels stay where they are
    /// while figures pass.
    bool beside = false;

    bool operator==(const SceneLabel&) const = default;
};

/// What is drawn beside the figures.
struct SceneMarks
{
    std::vector<SceneCurve> curves;
    std::vector<SceneArea> areas;
    std::vector<SceneLabel> labels;
    std::vector<QVector3D> handles; ///< what can be dragged: labels keep clear of it

    bool isEmpty() const { return curves.empty() && areas.empty() && labels.empty() && handles.empty(); }
    bool operator==(const SceneMarks&) const = default;
};

/// Corners of a circle on the ground. \param up  length one.
std::vector<QVector3D> circleOnGround(const QVector3D& centre, float radius, const QVector3D& up,
                                      int corners = 48);

/// Triangles of a polygon without crossings, as indices of its corners; either way round. There are three for
/// each triangle. Ears are cut off; cost: O(corners³) at worst.
/// \param up  normal of the plane that it is seen in.
std::vector<int> triangulate(const std::vector<QVector3D>& outline, const QVector3D& up);

/// Lines across a polygon, each as two points, at 45 degrees. None for fewer than three corners. \param
/// spacing  between them, in the unit of the outline, > 0.
std::vector<QVector3D> hatchLines(const std::vector<QVector3D>& outline, const QVector3D& up, float spacing);

} // namespace quadrille::widgets
