// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationbasis.h"
#include "editor/documents/variationresult.h"
#include "model/project/steps/variate.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace quadrille {

struct DrawnDraft;

/// Variations as jobs see them: the project as it was, and the file that results lie beside.
struct VariationJob
{
    Project project;
    std::filesystem::path file;
    std::string name;
};

/// A movement with its models, as it is drawn from.
struct LearnedVariation
{
    std::vector<GpdmLearning> models; ///< of each part
    std::vector<PartProgress> parts;  ///< the same, as it is shown
    std::shared_ptr<const LearnedMovement> movement;
};

/// The takes of variations, aligned.
struct OpenedVariation
{
    std::shared_ptr<VariationWork> work;
    std::shared_ptr<const Movement> movement;
    std::vector<MeshSequence> takes; ///< that variations take their textures and contacts from
    /// Null where they are not learned as the project says.
    std::shared_ptr<const LearnedVariation> learned;
    /// Null where they are not drawn of these models as the project says.
    std::shared_ptr<const std::vector<DrawnSet>> drawn;
    VariationDrawing drawing; ///< what the project said
};

/// Variations as they are shown, and what of them is kept beside the project.
struct Drawing
{
    std::shared_ptr<const std::vector<DrawnSet>> sets;
    std::shared_ptr<const DrawnDraft> draft;
};

/// \throws Error as VariationWork::movement, of reading results, Cancelled.
OpenedVariation openVariation(const VariationJob& job, const Progress& progress);

/// Learns all parts and keeps the result beside the project, so that it need not be learned again; the best
/// so far, once it is cancelled, is not kept there. \throws Error of writing results.
std::shared_ptr<const LearnedVariation> learnVariation(const VariationJob& job, const OpenedVariation& opened,
                                                       const Progress& progress, const PartWatch& watch);

/// Draws all variations of the entry as the project says now. \throws Error Cancelled.
Drawing drawVariations(const VariationJob& job, const OpenedVariation& opened,
                       const LearnedVariation& learned, const Progress& progress);

} // namespace quadrille
