// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QVector3D>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille::widgets {

/// The room that a figure needs over all its frames.
struct LaneBox
{
    QVector3D lower;
    QVector3D upper;
};

/// How far each figure moves so that all stand side by side, each in a lane of its own, in their order. Lanes
/// lie along the first axis, or along the other one on the ground where that takes far less room; their
/// middles are level. Half a metre lies between neighbours. One alone does not move.
/// \param metre  in the unit of the boxes.
/// \param anchor  the figure that stays where it is: what is drawn about it stays right. \pre It is one.
std::vector<QVector3D> laneOffsets(std::span<const LaneBox> boxes, std::size_t anchor, UpAxis up,
                                   float metre = 1.0F);

} // namespace quadrille::widgets
