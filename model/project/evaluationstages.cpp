// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/evaluationstages.h"

#include "model/project/madeclips.h"

#include <map>

namespace quadrille {

namespace {

using MakeStage = ResultStage (*)(const CharacterWork&, const EvaluationEntry&);

MakeStage makerOf(const std::string& table)
{
    static const std::map<std::string, MakeStage> makers{{"fig4", fig4Stage},
                                                         {"fig7", fig7Stage},
                                                         {"fig9", fig9Stage},
                                                         {"fig11", fig11Stage},
                                                         {"fig12", fig12Stage},
                                                         {"junctions", junctionsStage},
                                                         {"density", densityStage},
                                                         {"walks", walksStage},
                                                         {"table1", table1Stage},
                                                         {"table2", table2Stage},
                                                         {"cvs-fig4", cvsFig4Stage},
                                                         {"cvs-fig7", cvsFig7Stage},
                                                         {"variations", variationsStage}};
    const auto found = makers.find(table);
    return found == makers.end() ? nullptr : found->second;
}

/// The entry that holds for a table of a character: that which names it, or one for all.
const EvaluationEntry* entryOf(const Project& project, const std::string& table, const std::string& character)
{
    const EvaluationEntry* found = nullptr;
    for (const EvaluationEntry& entry : project.evaluations) {
        if (entry.table == table &&
            (entry.character == character || (entry.character.empty() && found == nullptr)))
            found = &entry;
    }
    return found;
}

bool isPossible(const std::string& table, const CharacterWork& work)
{
    if (table == "table1")
        return !sequencesWithAngles(work).empty();
    return !needsVariations(table) || !learnedVariations(work.opener->project(), work.character).empty();
}

} // namespace

ResultStage evaluationStage(const CharacterWork& work, const EvaluationEntry& evaluation)
{
    ResultStage stage;
    stage.name = "evaluations/" + evaluation.table;
    if (work.opener->project().characters.size() > 1)
        stage.name += "/" + work.character;
    stage.dataPrefix = "evaluation";
    stage.character = work.character;
    return stage;
}

std::vector<ResultStage> makeEvaluationStages(const StageMaking& making)
{
    const Project& project = making.opener->project();
    std::vector<ResultStage> stages;
    if (project.evaluations.empty())
        return stages;
    for (const GraphEntry& graph : graphsOf(project)) {
        const CharacterWork work = characterWork(making.opener, graph);
        for (const std::string_view table : evaluationTables) {
            const std::string name(table);
            const EvaluationEntry* entry = entryOf(project, name, work.character);
            if (entry != nullptr && !work.sequences.empty() && isPossible(name, work))
                stages.push_back(makerOf(name)(work, *entry));
        }
    }
    return stages;
}

} // namespace quadrille
