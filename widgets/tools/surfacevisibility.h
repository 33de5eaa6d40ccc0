// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/figureshape.h"
#include "widgets/viewport/turntable.h"

namespace quadrille::widgets {

/// Which vertices can be seen: not behind the camera, and no triangle that does not touch them is in front.
/// Cost: one projection per vertex of the figure, and for each triangle the asked vertices near it on the
/// view (about 1 ms at 20,000 vertices).
/// \return one per asked vertex.
std::vector<bool> visibleVertices(const FigureShape& figure, const Turntable& camera, const QSizeF& view,
                                  std::span<const std::uint32_t> vertices);

} // namespace quadrille::widgets
