// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/framepair.h"

#include <QString>

namespace quadrille {

class GraphExplorer;

/// "walk 12". \pre There is a character; so below.
QString frameName(const GraphExplorer& explorer, NodeIndex frame);
/// Where a transition leads from and where to: "walk 12 › jog 3".
QString pairName(const GraphExplorer& explorer, const FramePair& pair);

} // namespace quadrille
