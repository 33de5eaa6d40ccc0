// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/steps/charactergraph.h"
#include "model/project/store/result.h"
#include "model/synthesis/finishing/repeats.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A variation that repeats are drawn from, see clipsDrawnFrom; nothing where too few were good enough for it
/// to be there. \param clip  its name. \param result  of the step of its clip. \throws Error ProjectInvalid
/// (its take is not in the graph, or is another by now).
std::optional<TakeVariation> takeVariation(const std::string& clip, const Result& result,
                                           const CharacterGraph& graph);

/// Those of some clips that are there. \param clips  of clipsDrawnFrom. \throws Error as takeVariation.
std::shared_ptr<const std::vector<TakeVariation>> takeVariations(const std::vector<std::string>& clips,
                                                                 const CharacterGraph& graph,
                                                                 const StepContext& context);

/// What each span of an animation is drawn from, as the table “variations”.
DataTable repeatsTable(std::span<const SpanDraw> spans, std::span<const TakeVariation> variations,
                       const CharacterGraph& graph);

/// That variations were to be drawn from which are not there, in one English sentence; nothing where all are.
/// \param wanted  of clipsDrawnFrom. \param found  those that are there.
std::optional<std::string> problemWithMissing(const std::vector<std::string>& wanted,
                                              const std::vector<std::string>& found);

/// Why an animation shows frames again as they were captured, or that it shows none again, in one English
/// sentence; nothing where all is as it should be.
std::optional<std::string> problemWithRepeats(std::span<const SpanDraw> spans, const CharacterGraph& graph);

} // namespace quadrille
