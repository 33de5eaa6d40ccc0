// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathshape.h"

#include <cstddef>

namespace quadrille::widgets {

/// A curve as close points, with the length at each.
class SampledCurve
{
public:
    SampledCurve() = default;
    /// Cost: O(points); so for `part`, while `at` takes O(log points).
    explicit SampledCurve(std::vector<QVector3D> points);

    const std::vector<QVector3D>& points() const { return m_points; }
    bool isEmpty() const { return m_points.size() < 2; }
    double length() const { return m_lengths.empty() ? 0.0 : m_lengths.back(); }
    double lengthAt(std::size_t point) const { return m_lengths[point]; }
    /// The place at a length, in the unit of the points. Beyond the ends: the ends. \pre not empty.
    QVector3D at(double metres) const;
    /// The part between two lengths. Empty for an empty curve and where `to` is not behind `from`.
    std::vector<QVector3D> part(double from, double to) const;

private:
    std::vector<QVector3D> m_points;
    std::vector<double> m_lengths;
};

/// Where a path passes: its points without the handles between them. \param points  their number, with
/// handles.
std::size_t anchorCount(PathKind kind, std::size_t points);
/// The index of an anchor among all points.
std::size_t anchorIndex(PathKind kind, std::size_t anchor);
/// Whether a point is a handle of a Bézier path. Handles lie at 3k + 1 and 3k + 2 among the points.
bool isHandle(PathKind kind, std::size_t point);
/// The anchor that a point is, or that a handle belongs to.
std::size_t anchorOf(PathKind kind, std::size_t point);
/// The handle across the anchor from a handle; the handle itself where there is none.
std::size_t oppositeHandle(std::size_t handle, std::size_t points);
/// For each anchor the place among samples where it is passed. One that is not among them has the place of
/// the anchor before.
std::vector<std::size_t> anchorSamples(PathKind kind, const std::vector<QVector3D>& points,
                                       const std::vector<QVector3D>& samples);

/// Moves a point: an anchor takes its handles along, a handle its mirror image.
/// \param mirrored  whether the opposite handle keeps opposite.
std::vector<QVector3D> movedPoint(PathKind kind, std::vector<QVector3D> points, std::size_t point,
                                  const QVector3D& place, bool mirrored);
/// Adds a point at the end; handles are put where they make a smooth curve.
std::vector<QVector3D> appendedPoint(PathKind kind, std::vector<QVector3D> points, const QVector3D& place);
/// Adds a point on the curve between an anchor and the next, t = 0 … 1 of the way. A Bézier curve keeps its
/// form. \param place  where the curve is there.
std::vector<QVector3D> insertedPoint(PathKind kind, std::vector<QVector3D> points, std::size_t anchor,
                                     float t, const QVector3D& place);
/// Where a Bézier curve comes nearest to a place, t = 0 … 1 between an anchor and the next. It is found among
/// 64 steps, then by halving them, to 1e-5.
float nearestParameter(const std::vector<QVector3D>& points, std::size_t anchor, const QVector3D& place);
/// Whether the handles of an anchor lie on one line, so that the curve has no corner there. Corners of less
/// than a degree do not count. False at the ends.
bool isSmooth(const std::vector<QVector3D>& points, std::size_t anchor);
/// A Bézier path without a corner at an anchor. Its handles keep their lengths and take the mean of their
/// directions. Ends stay as they are.
std::vector<QVector3D> smoothedAnchor(std::vector<QVector3D> points, std::size_t anchor);
/// Takes an anchor away. \return none when fewer than two are left.
std::vector<QVector3D> removedAnchor(PathKind kind, std::vector<QVector3D> points, std::size_t anchor);
/// The same anchors for another kind of curve; handles are made, or left out.
std::vector<QVector3D> convertedPoints(const std::vector<QVector3D>& points, PathKind from, PathKind to);
/// The line that keeps a distance from an obstacle all round; corners are rounded. \param up  length one.
std::vector<QVector3D> widenedOutline(const PathObstacle& obstacle, float distance, const QVector3D& up);
/// Runs the other way.
std::vector<QVector3D> reversedPoints(std::vector<QVector3D> points);
/// Few points that a smooth curve leads along a stroke of the hand (Douglas and Peucker 1973).
/// \param tolerance  how far the stroke may be from lines between the points, in their unit.
std::vector<QVector3D> simplifiedStroke(const std::vector<QVector3D>& stroke, float tolerance);

} // namespace quadrille::widgets
