// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/graph/alternatives.h"
#include "model/project/document/findentry.h"
#include "model/project/file/projectfile.h"
#include "model/project/results/opencharacter.h"
#include "model/project/store/resultplaces.h"

#include <array>
#include <cstdio>
#include <memory>

namespace quadrille::cli {

namespace {

struct TransitionArguments
{
    std::string project;
    std::string from;
    std::string to;
    std::string character;
    std::string store;
    int count = 10;
};

/// The place of a sequence in the layout of its character's graph.
int placeOf(const CharacterGraph& graph, const std::string& sequence)
{
    return graph.layout().sequenceOf(graph.span(sequence, std::nullopt).first);
}

std::string rowOf(const CharacterGraph& graph, const FramePair& pair)
{
    const TransitionCosts& costs = graph.costs();
    const auto [i, j] = pair;
    const CostParts parts = graph.partsOf(pair);
    std::array<char, 256> row{};
    std::snprintf(row.data(), row.size(), "%lld,%lld,%.6g,%.6g,%d,%.6g,%.6g,%.6g,%s",
                  static_cast<long long>(graph.nameOf(i).frame.value),
                  static_cast<long long>(graph.nameOf(j).frame.value), costs.weight(i, j, graph.alpha()),
                  static_cast<double>(costs.cost()(i, j)), static_cast<int>(costs.length()(i, j)), parts.pose,
                  parts.contacts, parts.velocity, graph.graph().find(i, j) != nullptr ? "yes" : "no");
    return row.data();
}

void list(const TransitionArguments& arguments, Session& session)
{
    if (!arguments.store.empty())
        chooseResultFolder(arguments.project, arguments.store);
    const Project project = loadProject(arguments.project, session.console);
    const SequenceEntry* from = findSequence(project, arguments.from);
    if (from == nullptr)
        throwUsage("there is no sequence “" + arguments.from + "”");
    const CharacterEntry* character = characterOf(project, *from);
    const Progress progress = session.console.progress(session.cancel, "Computing");
    const auto opened =
        openCharacter({project, arguments.project}, character == nullptr ? "" : character->name,
                      GraphOpening::Compute, progress);
    session.console.endProgress();
    if (!opened)
        throwUsage("the character of “" + arguments.from + "” has no graph");
    const CharacterGraph& graph = opened->graph;
    const auto best = bestTransitions(graph.costs(), graph.alpha(), placeOf(graph, arguments.from),
                                      placeOf(graph, arguments.to), {.most = arguments.count});
    const std::string unit = graph.work().graph.pose.metric == PoseMetric::Surface ? "rad" : "m";
    session.console.output("from-frame,to-frame,weight,cost (" + unit + "),frames,pose-cost (" + unit +
                           "),contact-cost (" + unit + "),velocity-cost (" + unit + "),essential");
    for (const FramePair& pair : best)
        session.console.output(rowOf(graph, pair));
    if (best.empty())
        session.console.warn("no transition leads from “" + arguments.from + "” to “" + arguments.to + "”");
}

} // namespace

void addTransitions(CLI::App& app, Session& session)
{
    auto* command =
        app.add_subcommand("transitions", "List the best transitions from one sequence to another");
    const auto arguments = std::make_shared<TransitionArguments>();
    command->add_option("PROJECT", arguments->project, "The project file, NAME.quadrille")->required();
    command->add_option("FROM", arguments->from, "The sequence that is left")->required();
    command->add_option("TO", arguments->to, "The sequence that is entered; may be the same")->required();
    command->add_option("-n,--count", arguments->count, "How many; those next to a better one do not count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--store", arguments->store,
                        "Folder of the results, in place of PROJECT.cache beside the project");
    command->footer("Computes the graph of the character where it is not up to date. Comma-separated, the "
                    "cheapest first:\nboth frames, the weight in the graph, the cost and what it is made of, "
                    "how many frames it lasts,\nand whether the Essential graph has it. Example:\n"
                    "  quadrille transitions dance.quadrille walk jog -n 5");
    command->callback([arguments, &session] { list(*arguments, session); });
}

} // namespace quadrille::cli
