// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvecontent.h"
#include "model/core/progress.h"
#include "model/geometry/symmetry.h"
#include "model/variation/parts/proposedparts.h"

#include <functional>
#include <map>
#include <optional>

namespace quadrille {

// What may take long: bodies with curves that were computed. Each gives what becomes of a body, needs nothing
// else, and runs on any thread.

/// For a figure in the pose of a surface. Overlaps count as shares of the figure's height there. \param
/// overlap  metres.
ProposalSettings proposalSettings(const SurfaceGraph& graph, UpAxis up, double overlap);
/// All curves and parts give way to those that proposeParts finds. \throws Error as that.
BodyPartsEntry withProposedParts(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                                 const std::shared_ptr<const Topology>& topology,
                                 const ProposalSettings& settings, const Progress& progress);

/// With a curve beside another: towards the end of the limb, or on its other side where there is no room. It
/// comes behind all others, under `name`, which is to be free.
/// \param metres  between the two. \throws Error as parallelCurve.
BodyPartsEntry withSecondCurve(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                               const PartCurveEntry& first, const std::string& name, double metres);

/// A part that is to be made, and the curve that it has already.
struct NewPart
{
    std::string name;
    std::string root;   ///< what the part is called that all others hang on, where there is none yet
    std::string parent; ///< empty: the root
    PartCurveEntry curve;
};
/// With a part of that curve and a second one. \throws Error as parallelCurve.
BodyPartsEntry withNewPart(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                           const NewPart& part, double metres);

/// What is mirrored, and what the other side is called.
struct MirrorPlan
{
    std::map<std::string, std::string> names; ///< of curves, from one side to the other
    std::optional<PartEntry> part;            ///< as it is on the other side; none where a curve is mirrored
    PartSelection selection;                  ///< the curve or part on the other side
};
/// None where nothing is selected that has curves.
/// \param mirrored  what a name becomes that says no side.
std::optional<MirrorPlan> mirrorPlan(const PartCurveContent& content,
                                     const std::function<std::string(const std::string&)>& mirrored);
/// What has the names of the other side already gives way. \throws Error as mirroredCurve.
BodyPartsEntry withMirrored(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                            const Symmetry& symmetry, const MirrorPlan& plan);

/// With a curve of the body where the limb is thinnest nearby. \param travel  see shortenedCurve.
/// \pre the body has the curve. \throws Error as shortenedCurve.
BodyPartsEntry withShortenedCurve(BodyPartsEntry body, const std::shared_ptr<const SurfaceGraph>& graph,
                                  const std::string& name, double travel);

} // namespace quadrille
