// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/transitioncosts.h"
#include "model/project/stage.h"
#include "model/transition/characterframes.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace quadrille {

/// The sequences of one character that its graph is made of, and what the stages about them have in common.
struct CharacterWork
{
    std::shared_ptr<SequenceOpener> opener;
    GraphEntry graph;
    std::string character;
    std::string prefix;                 ///< of the names of the graph's stages
    std::vector<std::string> sequences; ///< in project order
    std::string settings;               ///< of all sequences

    /// \throws Error what opening the sequences throws, CharacterTopologyMismatch.
    CharacterFrames open(const Progress& progress) const;
    /// A stage about the character; "PREFIX/NAME".
    ResultStage stage(const std::string& name) const;
    std::string stageName(const std::string& name) const { return prefix + "/" + name; }
    /// The files of all sequences, for ResultStage::files.
    std::vector<std::filesystem::path> files(const Progress& progress) const;
};

/// The stages' names, for CharacterWork::stageName.
namespace graphstage {
inline constexpr auto poseDistance = "pose-distance";
inline constexpr auto euclideanDistance = "euclidean-distance";
inline constexpr auto transitions = "transitions";
inline constexpr auto drifts = "foot-drifts";
inline constexpr auto liveliness = "liveliness";
inline constexpr auto graphs = "graphs";
inline constexpr auto edges = "edges"; ///< told by name and cost; nothing else needs them
inline constexpr auto rootPoses = "root-poses";
} // namespace graphstage

/// The section “graph”, and the usual settings for characters that only other sections are about.
std::vector<GraphEntry> graphsOf(const Project& project);

/// Whether settings are those of a character.
bool isGraphOf(const Project& project, const GraphEntry& graph, const std::string& character);
/// The graph settings of a character: those of the project, or the usual ones.
GraphEntry graphOf(const Project& project, const std::string& character);

CharacterWork characterWork(const std::shared_ptr<SequenceOpener>& opener, const GraphEntry& graph);

/// A square or other table as data.
template <typename Value>
DataArray matrixOf(std::string name, std::string description, std::string unit, const Table<Value>& table)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.unit = std::move(unit);
    array.shape = {table.rows(), table.cols()};
    array.values = std::vector<float>(table.data(), table.data() + table.size());
    return array;
}

/// \pre There is one.
const DataArray& arrayOf(const Result& result, const std::string& name);

/// A matrix of single precision.
template <typename Value>
Table<Value> tableOf(const DataArray& array)
{
    const auto& values = std::get<std::vector<float>>(array.values);
    return Eigen::Map<const Table<float>>(values.data(), array.shape[0], array.shape[1])
        .template cast<Value>();
}

/// \param distances  the result of the stage of pose distances.
FrameLayout layoutOf(const Result& distances);

/// Whether costs know how far feet are dragged, by the stage of drifts.
bool knowsDrifts(const GraphEntry& graph);
/// What the graphs are made of, from the results of the stages that costInputs names.
TransitionCosts costsOf(const CharacterWork& work, const StageContext& context);
/// Pose distances, transitions, and what else their costs depend on.
std::vector<std::string> costInputs(const CharacterWork& work);
/// The settings of `costsOf` that no stage before knows, for ResultStage::settings.
nlohmann::json costSettings(const GraphEntry& graph);

} // namespace quadrille
