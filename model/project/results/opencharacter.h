// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/projectresults.h"
#include "model/project/steps/charactergraph.h"

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

/// Opens the graph of a character from the results of a project.
/// \return null where there are no sequences, or results are missing that were not to be computed.
/// \throws Error of the step that failed, of opening sequences, Cancelled.
std::shared_ptr<const OpenedCharacter> openCharacter(WorkingProject working, const std::string& character,
                                                     GraphOpening opening, const Progress& progress = {});
/// \overload of a character that the project has steps for.
std::shared_ptr<const OpenedCharacter> openCharacter(const ProjectResults& results,
                                                     const std::string& character, GraphOpening opening,
                                                     const Progress& progress = {});

} // namespace quadrille
