// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/measuredgraphs.h"
#include "model/graph/transitioncosts.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/buildstep.h"
#include "model/transition/characterframes.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// The sequences of one character that its graph is made of, and what the steps about them have in common.
struct CharacterInputs
{
    std::shared_ptr<SequenceOpener> opener;
    GraphEntry graph;
    std::string character;
    std::string prefix;                 ///< of the names of the graph's steps
    std::vector<std::string> sequences; ///< in project order
    std::string settings;               ///< of all sequences

    /// \throws Error what opening the sequences throws, CharacterTopologyMismatch.
    CharacterFrames open(const Progress& progress) const;
    /// A step about the character; "PREFIX/NAME".
    BuildStep step(const std::string& name) const;
    std::string stepName(const std::string& name) const { return prefix + "/" + name; }
    /// The files of all sequences, for BuildStep::files.
    std::vector<std::filesystem::path> files(const Progress& progress) const;
};

/// The steps' names, for CharacterInputs::stepName.
namespace graphstep {
inline constexpr auto poseDistance = "pose-distance";
inline constexpr auto euclideanDistance = "euclidean-distance";
inline constexpr auto transitions = "transitions";
inline constexpr auto drifts = "foot-drifts";
inline constexpr auto liveliness = "liveliness";
inline constexpr auto overview = "cost-overview"; ///< what is seen first; nothing else needs it
inline constexpr auto graphs = "graphs";
inline constexpr auto edges = "edges"; ///< told by name and cost; nothing else needs them
inline constexpr auto rootPoses = "root-poses";
} // namespace graphstep

/// The section “graph”, and the usual settings for characters that only other sections are about.
std::vector<GraphEntry> graphsOf(const Project& project);

/// Whether settings are those of a character.
bool isGraphOf(const Project& project, const GraphEntry& graph, const std::string& character);
/// The graph settings of a character: those of the project, or the usual ones.
GraphEntry graphOf(const Project& project, const std::string& character);

CharacterInputs characterWork(const std::shared_ptr<SequenceOpener>& opener, const GraphEntry& graph);

/// \pre There is one.
const DataArray& arrayOf(const Result& result, const std::string& name);

/// A square or other table as data.
template <typename Value>
DataArray matrixOf(std::string name, std::string description, std::string unit, SharedTable<Value> table)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.unit = std::move(unit);
    array.shape = {table->rows(), table->cols()};
    array.values = std::move(table);
    return array;
}
template <typename Value>
DataArray matrixOf(std::string name, std::string description, std::string unit, Table<Value> table)
{
    return matrixOf(std::move(name), std::move(description), std::move(unit),
                    SharedTable<Value>(std::move(table)));
}

/// A matrix of single precision, or of counts; shared with the result. \pre The array is of that type.
template <typename Value>
SharedTable<Value> sharedTableOf(const DataArray& array)
{
    return std::get<SharedTable<Value>>(array.values);
}

/// A matrix of a result, to be changed: without a copy where nobody else has the result.
template <typename Value>
Table<Value> takeTable(ResultPointer result, const std::string& name)
{
    SharedTable<Value> table = sharedTableOf<Value>(arrayOf(*result, name));
    result.reset();
    return std::move(table).take();
}

/// A copy of a matrix of single precision.
template <typename Value>
Table<Value> tableOf(const DataArray& array)
{
    return sharedTableOf<float>(array)->template cast<Value>();
}

/// Frames of each sequence of a layout, in the order of the project.
std::vector<std::int64_t> lengthsOf(const FrameLayout& layout);
/// \param distances  the result of the step of pose distances.
FrameLayout layoutOf(const Result& distances);
/// The largest of these distances; 0 where there are none.
float greatestOf(const Result& distances);

/// Whether costs know how far feet are dragged, by the step of drifts.
bool knowsDrifts(const GraphEntry& graph);
/// Looks at results on the way: of pose distances, then of transitions.
struct CostLooks
{
    std::function<void(const Result& distances)> distances;
    std::function<void(const Result& transitions)> transitions;
};
/// What the graphs are made of, from the results of the steps that costInputs names; shared by all who want
/// the same. \param looks  at results that are read anyway, as large as they are; not called where the
/// costs are there already.
std::shared_ptr<const TransitionCosts> costsOf(const CharacterInputs& work, const StepContext& context,
                                               const CostLooks& looks = {});
/// The transitions of the motion graph.
using CostMinima = std::vector<FramePair>;
/// Both graphs at an α, shared by all who want them of the same costs. \param make  called where there are
/// none. \throws Error Cancelled, what `make` throws.
std::shared_ptr<const MeasuredGraphs>
sharedGraphs(const CharacterInputs& work, double alpha, const StepContext& context,
             const std::function<MeasuredGraphs(std::shared_ptr<const CostMinima>)>& make,
             const Progress& progress = {});
/// Both graphs at an α, and what is known of them, made once for the step of graphs and all who try this α.
/// \param edges  receives the graphs before their paths are measured, where they were not yet, and before
/// that what is certain of them; from this thread. \throws Error BadArgument (α), Cancelled.
std::shared_ptr<const MeasuredGraphs> graphsAt(const CharacterInputs& work, double alpha,
                                               const StepContext& context, const Progress& progress = {},
                                               const GraphsTaker& edges = {});
/// Pose distances, transitions, and what else their costs depend on.
std::vector<std::string> costInputs(const CharacterInputs& work);
/// The settings of `costsOf` that no step before knows, for BuildStep::settings.
JsonLine costSettings(const GraphEntry& graph);

} // namespace quadrille
