// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/evaluations/evaluationsteps.h"

#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/evaluations/appearanceevaluations.h"

#include <map>

namespace quadrille {

namespace {

using MakeStep = BuildStep (*)(const CharacterInputs&, const EvaluationEntry&);

MakeStep makerOf(const std::string& table)
{
    static const std::map<std::string, MakeStep> makers{{"fig4", fig4Step},
                                                        {"fig7", fig7Step},
                                                        {"fig9", fig9Step},
                                                        {"fig11", fig11Step},
                                                        {"fig12", fig12Step},
                                                        {"junctions", junctionsStep},
                                                        {"density", densityStep},
                                                        {"walks", walksStep},
                                                        {"table1", table1Step},
                                                        {"table2", table2Step},
                                                        {"cvs-fig4", cvsFig4Step},
                                                        {"cvs-fig7", cvsFig7Step},
                                                        {"variations", variationsStep},
                                                        {"transfer-error", transferErrorStep},
                                                        {"ia4d-table1", ia4dTable1Step},
                                                        {"ia4d-fig4", ia4dFig4Step},
                                                        {"ia4d-table2", ia4dTable2Step},
                                                        {"ia4d-table3", ia4dTable3Step}};
    const auto found = makers.find(table);
    return found == makers.end() ? nullptr : found->second;
}

using MakeAppearanceStep = BuildStep (*)(const AppearanceInputs&, const EvaluationEntry&);

/// \pre needsAppearance(table).
MakeAppearanceStep appearanceMakerOf(const std::string& table)
{
    static const std::map<std::string, MakeAppearanceStep> makers{
        {"fig17", compactnessStep},
        {"fig18", compactnessStep},
        {"fig19", generalisationStep},
        {"fig20", generalisationStep},
        {"fig22", fig22Step},
        {"appearance-interpolation", appearanceInterpolationStep},
        {"appearance-shape", appearanceShapeStep},
        {"appearance-rates", appearanceRatesStep}};
    return makers.at(table);
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

bool isPossible(const std::string& table, const CharacterInputs& work)
{
    if (table == "table1")
        return !sequencesWithAngles(work).empty();
    if (needsAppearance(table))
        return appearanceOf(work.opener->project(), work.character) != nullptr;
    if (needsTruth(table))
        return !transfersWithTruth(work.opener->project(), work.character).empty();
    if (const std::size_t needed = neededMotionSpaces(table); needed > 0)
        return steeredSpaces(work.opener->project(), work.character) >= needed;
    return !needsVariations(table) || !learnedVariations(work.opener->project(), work.character).empty();
}

} // namespace

BuildStep evaluationStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step;
    step.name = "evaluations/" + evaluation.table;
    if (work.opener->project().characters.size() > 1)
        step.name += "/" + work.character;
    step.dataPrefix = "evaluation";
    step.character = work.character;
    return step;
}

std::vector<BuildStep> makeEvaluationSteps(const StepMaking& making)
{
    const Project& project = making.opener->project();
    std::vector<BuildStep> steps;
    if (project.evaluations.empty())
        return steps;
    for (const GraphEntry& graph : graphsOf(project)) {
        const CharacterInputs work = characterWork(making.opener, graph);
        for (const std::string_view table : evaluationTables) {
            const std::string name(table);
            const EvaluationEntry* entry = entryOf(project, name, work.character);
            if (entry == nullptr || work.sequences.empty() || !isPossible(name, work))
                continue;
            if (needsAppearance(name))
                steps.push_back(appearanceMakerOf(name)(
                    {work, {making.opener, *appearanceOf(project, work.character), making.projectFile}},
                    *entry));
            else
                steps.push_back(makerOf(name)(work, *entry));
        }
    }
    return steps;
}

} // namespace quadrille
