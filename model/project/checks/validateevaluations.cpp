// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validateevaluations.h"

#include "model/core/contains.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/problemtexts.h"

#include <algorithm>
#include <set>

namespace quadrille {

namespace {

std::string listed(const std::vector<std::string>& names)
{
    std::string list;
    for (const std::string& name : names)
        list.append(list.empty() ? "" : ", ").append(quoted(name));
    return list;
}

/// The sequences of the graphs of the characters that an evaluation is about.
std::vector<std::string> sequencesOf(const Project& project, const EvaluationEntry& evaluation)
{
    if (!evaluation.character.empty() || project.characters.empty())
        return sequencesOfGraph(project, evaluation.character);
    std::vector<std::string> names;
    for (const CharacterEntry& character : project.characters) {
        const auto own = sequencesOfGraph(project, character.name);
        names.insert(names.end(), own.begin(), own.end());
    }
    return names;
}

bool isWithoutSpaces(const Project& project, const EvaluationEntry& evaluation)
{
    const std::size_t needed = neededMotionSpaces(evaluation.table);
    return needed > 0 && std::ranges::none_of(project.motionSpaces, [&](const MotionSpaceEntry& entry) {
               return steeredSpaces(project, characterNameOf(project, entry)) >= needed;
           });
}

void validateEvaluation(const Project& project, const EvaluationEntry& evaluation, const std::string& pointer,
                        ProjectProblems& problems)
{
    const auto invalid = [&](const std::string& key, std::string reason, std::string remedy) {
        problems.push_back(invalidAt(pointer + key, std::move(reason), std::move(remedy)));
    };
    const std::vector<std::string> tables(evaluationTables.begin(), evaluationTables.end());
    if (!contains(tables, evaluation.table))
        invalid("/table", "There is no table " + quoted(evaluation.table),
                meantOr(evaluation.table, tables, "Write one of " + listed(tables) + "."));
    const auto known = sequencesOf(project, evaluation);
    if (evaluation.table == "table1" &&
        std::all_of(known.begin(), known.end(), [&](const std::string& sequence) {
            return findSequence(project, sequence)->jointAngles.empty();
        }))
        invalid("", "No sequence has reference joint angles",
                "Name a BVH file as “joint_angles” of the sequences, or leave out “table1”.");
    if (needsVariations(evaluation.table) && project.variations.empty())
        problems.push_back(
            warningAt(pointer, "The project has no variations to evaluate",
                      "Add some under “variations”, or leave out " + quoted(evaluation.table) + "."));
    if (needsAppearance(evaluation.table) && project.appearances.empty())
        problems.push_back(
            warningAt(pointer, "The project has no model of appearance to evaluate",
                      "Add one under “appearance”, or leave out " + quoted(evaluation.table) + "."));
    const auto isUnknown = [](const TransferEntry& transfer) { return transfer.truth.empty(); };
    if (needsTruth(evaluation.table) && std::ranges::all_of(project.transfers, isUnknown))
        problems.push_back(warningAt(pointer, "No transfer of the project says what it ought to be",
                                     "Name a clip as “truth” of a transfer, or leave out " +
                                         quoted(evaluation.table) + "."));
    if (isWithoutSpaces(project, evaluation))
        problems.push_back(
            warningAt(pointer,
                      "No character has " +
                          std::string(neededMotionSpaces(evaluation.table) > 1 ? "two motion spaces"
                                                                               : "a motion space") +
                          " of several takes to evaluate",
                      "Add some under “motion_spaces”, or leave out " + quoted(evaluation.table) + "."));
    for (std::size_t i = 0; i < evaluation.sequences.size(); ++i) {
        if (!contains(known, evaluation.sequences[i]))
            invalid("/sequences/" + std::to_string(i),
                    "There is no sequence " + quoted(evaluation.sequences[i]) + " of the character",
                    meantOr(evaluation.sequences[i], known, "Correct the name."));
    }
    if (evaluation.needsAllSequences() && !evaluation.sequences.empty() && evaluation.sequences.size() != 2)
        invalid("/sequences", "Two sequences are needed here",
                "Name the one that is blended and the one that it is blended into.");
}

} // namespace

void validateEvaluations(const Project& project, ProjectProblems& problems)
{
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t i = 0; i < project.evaluations.size(); ++i) {
        const EvaluationEntry& evaluation = project.evaluations[i];
        const std::string pointer = "/evaluations/" + std::to_string(i);
        validateEvaluation(project, evaluation, pointer, problems);
        if (!seen.insert({evaluation.table, evaluation.character}).second)
            problems.push_back(invalidAt(pointer, "The table " + quoted(evaluation.table) + " is here twice",
                                         "Leave one of them out."));
    }
}

} // namespace quadrille
