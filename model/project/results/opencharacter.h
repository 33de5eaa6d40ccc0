// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/projectresults.h"
#include "model/project/steps/charactergraph.h"

#include <functional>
#include <memory>
#include <string>

namespace quadrille {

/// The graph of a character with its frames, as they are worked with while a project is open.
struct OpenedCharacter
{
    CharacterFrames frames;
    CharacterGraph graph;
};

enum class GraphOpening
{
    Compute, ///< brings the results of the graph up to date first
    IfFresh, ///< nothing where they are not up to date
};

/// Takes what is seen of a graph's costs from afar, before their tables are read.
using OverviewTaker = std::function<void(std::shared_ptr<const CostOverview>)>;

/// Opens the graph of a character from the results of a project.
/// \param overview  is called first, from this thread, where the store has one that is up to date; with it,
/// an overview is brought up to date as well. May be empty. \return null where there are no sequences, or
/// results are missing that were not to be computed. \throws Error of the step that failed, of opening
/// sequences, Cancelled.
std::shared_ptr<const OpenedCharacter> openCharacter(WorkingProject working, const std::string& character,
                                                     GraphOpening opening, const Progress& progress = {},
                                                     const OverviewTaker& overview = {});
/// \overload of a character that the project has steps for.
std::shared_ptr<const OpenedCharacter> openCharacter(const ProjectResults& results,
                                                     const std::string& character, GraphOpening opening,
                                                     const Progress& progress = {},
                                                     const OverviewTaker& overview = {});

} // namespace quadrille
