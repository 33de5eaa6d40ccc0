// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/filehashes.h"
#include "model/project/opensequence.h"
#include "model/project/result.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// What a computing stage may use.
struct StageContext
{
    /// The result of a stage that this one lists as its input.
    std::function<Result(const std::string& stage)> resultOf;
    /// Something worth telling the user.
    std::function<void(Issue)> tell;
};

/// One step of the rebuild: makes one result out of files, settings and results of other stages. The same
/// inputs give the same result, for any number of threads.
struct ResultStage
{
    /// Unique; its beginnings are targets: "sequences/walk/statistics" is rebuilt by `sequences`,
    /// `sequences/walk` and its full name.
    std::string name;
    /// What stands before the names of its data: "sequences/walk" + "/bounds"; may be empty.
    std::string dataPrefix;
    /// The character that its data are about, where a name alone would not say.
    std::string character;
    /// Counts up whenever the algorithm gives another result.
    int version = 1;
    /// All else that the result depends on, as text.
    std::string settings;
    /// The files that it reads, in a fixed order; called once, may throw what opening them throws.
    std::function<std::vector<std::filesystem::path>(const Progress&)> files;
    /// About how many bytes its result takes; unset where that is little, or not known before.
    std::function<std::uint64_t(const Progress&)> bytes;
    /// Names of the stages whose results it uses.
    std::vector<std::string> inputs;
    std::function<Result(const StageContext&, const Progress&)> compute;
};

/// The stages of the clips that some sequences show: their inputs.
std::vector<std::string> clipInputs(const Project& project, const std::vector<std::string>& sequences);

/// The folder into which a project's results go: NAME.quadrille.cache beside the project as a rule, see
/// resultplaces.h.
std::filesystem::path cacheFolder(const std::filesystem::path& projectFile);

/// What the stages of one rebuild share.
struct StageMaking
{
    std::shared_ptr<SequenceOpener> opener;
    std::filesystem::path projectFile;
};

/// All stages of a project, each after its inputs. New capabilities add theirs here.
std::vector<ResultStage> makeStages(const StageMaking& making);

/// A stage that needs what nothing makes fails with a sentence; its inputs are those that there are.
void refuseMissingInputs(std::vector<ResultStage>& stages);

std::vector<ResultStage> makeSequenceStages(const StageMaking& making);
/// Pose distances, transitions and graphs of the characters that the section “graph” names, or that others
/// need them for.
std::vector<ResultStage> makeGraphStages(const StageMaking& making);
/// The papers' tables that the section “evaluations” names.
std::vector<ResultStage> makeEvaluationStages(const StageMaking& making);
/// Walks and clips of the section “animations”.
std::vector<ResultStage> makeAnimationStages(const StageMaking& making);
/// Models, variations and their clips of the section “variations”.
std::vector<ResultStage> makeVariationStages(const StageMaking& making);
std::vector<ResultStage> makeExportStages(const StageMaking& making);
/// One picture of the project's sequences, contact-sheet.png among the results.
std::vector<ResultStage> makeSheetStages(const StageMaking& making);

} // namespace quadrille
