// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"
#include "widgets/viewport/groundshadow.h"

namespace quadrille {

/// The shadow of a figure on the ground, as pictures that are exported have it.
/// \param height of the figure over all its frames, in the unit of positions: what is soft and what is sharp
/// goes by it; 0: its height now.
widgets::GroundShadow figureShadow(const widgets::ShadowWish& wish, const Topology& topology, double height);

} // namespace quadrille
