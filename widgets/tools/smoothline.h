// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QVector3D>
#include <vector>

namespace quadrille::widgets {

/// A line from vertex to vertex of a mesh as it is meant: without the zigzag of the edges that it runs along.
/// For drawing alone.
/// \param fixed  places in `line` that stay where they are, ascending.
/// \return as many places, each beside its own.
std::vector<QVector3D> withoutZigzag(std::vector<QVector3D> line, const std::vector<std::size_t>& fixed,
                                     bool isClosed);

/// A place between line[index] (share 0) and the next one (share 1), on a smooth line through all of them
/// (Catmull–Rom).
QVector3D smoothPlace(const std::vector<QVector3D>& line, std::size_t index, float share, bool isClosed);

} // namespace quadrille::widgets
