// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"
#include "model/project/document/variationentry.h"
#include "widgets/theme/colormap.h"

#include <QRgb>
#include <string>
#include <vector>

namespace quadrille {

/// What becomes of a body with the curves and parts that it has now.
struct PartCut
{
    std::vector<PartProblem> problems;
    /// Without the curves and parts that something is wrong with; none where nothing is left to cut.
    BodyParts parts;

    /// The first that concerns a curve, or a part; null where nothing does.
    const PartProblem* problemOfCurve(const std::string& name) const;
    const PartProblem* problemOfPart(const std::string& name) const;
    /// Null where it cannot be cut.
    const BodyPart* part(const std::string& name) const;
    /// The part that most of some vertices belong to, the one that an overlap ends in; empty without parts.
    /// Of several with as many the last, which is nearest to the end of the limb.
    std::string partOf(std::span<const VertexIndex> vertices) const;
};

/// Never throws: where what is left hangs together no more, there are no parts. Cost: that of partProblems
/// and cutIntoParts; it is called on the interface thread with each edit.
PartCut cutBody(const SurfaceGraph& graph, const BodyPartsEntry& body);

/// The colour that a part has in view and tree, by its place in the project.
QColor partColor(const BodyPartsEntry& body, const std::string& part);

/// How parts are coloured on the body: each has a colour of its own; what a part shares with its parent is
/// lighter.
struct PartColors
{
    std::vector<QRgb> triangles; ///< one per triangle; empty where there are no parts to tell apart
    widgets::ColorKey key;
};

/// \param title, overlap  words of the key, translated. \param triangleCount  of the body's topology.
PartColors partColors(const PartCut& cut, const BodyPartsEntry& body, std::size_t triangleCount,
                      const QString& title, const QString& overlap);

} // namespace quadrille
