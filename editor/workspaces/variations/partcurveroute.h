// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvetool.h"

#include <optional>
#include <string>

namespace quadrille {

struct PartCurveTool::Route
{
    std::string name;
    SurfaceCurve curve;
    BodyPartsEntry before;           ///< the body as it was when the edit began
    std::vector<VertexIndex> taken;  ///< by other curves
    std::optional<VertexIndex> last; ///< where the moved point is now
};

} // namespace quadrille
