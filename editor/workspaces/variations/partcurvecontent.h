// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/settings.h"
#include "editor/workspaces/variations/partcut.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// A curve or a part, by name.
struct PartSelection
{
    enum class Kind
    {
        None,
        Curve,
        Part
    };
    Kind kind = Kind::None;
    std::string name;

    bool operator==(const PartSelection&) const = default;
};

/// The curves and parts of a body while they are worked on.
struct PartCurveContent
{
    std::shared_ptr<const SurfaceGraph> graph; ///< null until it is there
    BodyPartsEntry body;                       ///< as the project has it
    PartCut cut;                               ///< of the body; empty without a graph
    PartSelection selected;
    Settings::CurveDrawing drawing;

    /// Null for none.
    const PartCurveEntry* curveAt(int index) const;
    /// −1 for none.
    int indexOf(const std::string& curve) const;
    /// Null where no curve, or no part, is selected.
    const PartCurveEntry* selectedCurve() const;
    const PartEntry* selectedPart() const;
    /// Curves that bound no part.
    std::vector<std::string> looseCurves() const;
    /// The loose curves that a new part is made of: the selected one, else the first, and the one nearest to
    /// it; only one where there is no other.
    std::vector<std::string> curvesForPart() const;
    /// Metres; 0 without a graph, and where it is no closed curve on it.
    double lengthOfCurve(const std::string& name) const;
};

/// Whether vertices are a closed curve over the edges of a surface.
bool isWholeCurve(const SurfaceGraph& graph, std::span<const VertexIndex> vertices);

} // namespace quadrille
