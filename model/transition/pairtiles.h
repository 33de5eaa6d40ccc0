// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/framelayout.h"

#include <span>
#include <vector>

namespace quadrille {

/// A rectangle of pairs of frames: rows × columns, where the two runs are the same or the rows come first.
struct PairTile
{
    NodeIndex firstRow = 0;
    NodeIndex rows = 0;
    NodeIndex firstColumn = 0;
    NodeIndex columns = 0;
};

/// The upper half of a table of pairs in square tiles. Tiles that follow each other share frames, so that few
/// are read again where the media cache does not hold all.
/// \param size  frames along a tile, at least 1.
std::vector<PairTile> pairTiles(NodeIndex frameCount, NodeIndex size);

/// The tile among the values of a symmetric table; its diagonal stays as it is.
/// \param values  rows × columns.
void storeSymmetric(const PairTile& tile, std::span<const float> values, Table<float>& table);

} // namespace quadrille
