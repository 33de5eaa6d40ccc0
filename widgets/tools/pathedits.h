// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathlayout.h"

namespace quadrille::widgets {

// What is made of a path where one of its parts is edited.

/// \param part  a point or of an obstacle.
/// \param mirrored  whether a handle takes the one across its point along, where they lie on one line.
PathShape withPartAt(PathShape shape, const PathPart& part, const QVector3D& place, bool mirrored,
                     const Ruler& ruler);
/// The end of a stretch at a length; it stays five centimetres from the other end.
PathShape withStretchEndAt(PathShape shape, const PathPart& part, double length, const Ruler& ruler);
/// The selected part a step of the ruler further, as an arrow or Page Up and Down want it in the view.
/// \return none where the key has nothing to move.
std::optional<PathShape> nudgedSelection(const PathLayout& layout, int key, Qt::KeyboardModifiers modifiers);
/// The selected disc with another radius; none where none is selected. It is five centimetres at least.
/// \param by  added to the radius, in the view's unit.
std::optional<PathShape> resizedSelection(const PathLayout& layout, float by);

/// Between which anchor and the next a length of the curve is.
std::size_t anchorBefore(const PathLayout& layout, double length);
/// Half of the curve's way from a point to the next anchor, or of the last piece. \pre two anchors.
double lengthAfter(const PathLayout& layout, std::size_t point);
/// A metre further than the last of some points on their way. \pre not empty.
QVector3D nextPlace(const std::vector<QVector3D>& points, const GroundView& view);

} // namespace quadrille::widgets
