// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace quadrille {

/// A dense table in rows, such as a value for each pair of frames; rows and columns count from zero.
template <typename Value>
using Table = Eigen::Array<Value, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

} // namespace quadrille
