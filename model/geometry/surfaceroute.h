// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacedistances.h"

#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

/// What a way over edges keeps to.
struct RouteRules
{
    /// Vertices that it must not touch, its ends apart; all are free where there is none.
    const std::vector<bool>* blocked = nullptr;
    double creases = 0; ///< as CurveSettings::creases
};

/// The way over edges that is short and near to where it should be. \param deviation  of a place of the
/// surface, squared distance from where the way should be, square metres; may be infinite.
/// \return with both ends; nothing where no way leads, or it would meet itself.
std::optional<std::vector<VertexIndex>> routeNear(const OpenedSurface& surface, SheetVertex from,
                                                  SheetVertex to,
                                                  const std::function<float(std::size_t)>& deviation,
                                                  const RouteRules& rules);

/// The way over edges that follows the shortest way over the surface. \param forward  distances from the one
/// end, grown as far as you like. \return as routeNear.
std::optional<std::vector<VertexIndex>> shortestRoute(const OpenedSurface& surface, SurfaceDistances& forward,
                                                      SheetVertex from, SheetVertex to,
                                                      const RouteRules& rules);

} // namespace quadrille
