// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationbasis.h"
#include "editor/documents/variationresult.h"
#include "model/project/results/projectresults.h"
#include "model/project/steps/variate.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// Variations as jobs see them. Copies, for a thread of its own; so all of this header is called on threads
/// of jobs. \pre (of all functions) The project has a variation of this name.
struct VariationJob
{
    WorkingProject working;
    std::string name;
};

/// The models of all parts of a movement.
struct LearnedVariation
{
    std::vector<GpdmLearning> models; ///< of each part
    std::vector<PartProgress> parts;  ///< the same, as it is shown

    /// They are the best before learning was stopped.
    bool isStopped() const;
};

/// The takes of variations, aligned.
struct OpenedVariation
{
    std::shared_ptr<const Movement> movement;
    std::vector<MeshSequence> takes; ///< that variations take their textures and contacts from
    /// Null where they are not learned as the project says.
    std::shared_ptr<const LearnedVariation> learned;
    /// Null where they are not drawn of these models as the project says.
    std::shared_ptr<const std::vector<DrawnSet>> drawn;
    VariationDrawing drawing; ///< what the project said
};

/// \throws Error as VariationWork::movement, of reading results, Cancelled.
OpenedVariation openVariation(const VariationJob& job, const Progress& progress);

/// Learns all parts that are not learned as the project says; the best so far once it is cancelled, which no
/// result keeps. \param watch  receives how far all parts are, from any thread, one call at a time.
/// \throws Error of the step that failed.
std::shared_ptr<const LearnedVariation>
learnVariation(const VariationJob& job, const OpenedVariation& opened, const Progress& progress,
               const std::function<void(const std::vector<PartProgress>&)>& watch);

/// Draws all variations of the entry as the project says now: from the results of its steps; where learning
/// was stopped, of the models that were there then, which no result keeps.
/// \throws Error of the step that failed, Cancelled.
std::shared_ptr<const std::vector<DrawnSet>> drawVariations(const VariationJob& job,
                                                            const OpenedVariation& opened,
                                                            const LearnedVariation& learned,
                                                            const Progress& progress);

} // namespace quadrille
