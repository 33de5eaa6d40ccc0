// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace quadrille::widgets {

/// Places for labels along an axis so that none covers another, each as near as can be to where it belongs:
/// the least sum of squared displacements (isotonic regression, pool adjacent violators). \param wanted where
/// labels belong, ascending, pixels. \param apart   from the middle of a label to that of the next, > 0.
/// \param length  of the axis; labels lie within it.
/// \param needed  a label that is kept, in the place of the nearest one, if some are left out.
/// \return their middles; nothing for labels that are left out because there is no room for all: those that
/// are kept are spread evenly among all.
std::vector<std::optional<double>> spreadLabels(std::span<const double> wanted, double apart, double length,
                                                std::optional<std::size_t> needed = {});

} // namespace quadrille::widgets
