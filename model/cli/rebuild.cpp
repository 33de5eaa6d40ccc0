// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/rebuild.h"

#include "model/cli/commands.h"
#include "model/core/stagedfiles.h"
#include "model/project/file/projectfile.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/projectguard.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"

#include <array>
#include <cstdio>
#include <memory>

namespace quadrille::cli {

namespace {

struct RebuildArguments
{
    std::string project;
    RebuildOptions options;
    std::string json;
    std::string store;
};

std::string secondsText(double seconds)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f s", seconds);
    return text.data();
}

/// One line for a step that is done.
void sayStep(const StepReport& step, Console& console)
{
    for (const Issue& issue : step.issues)
        console.tell(issue);
    switch (step.state) {
    case StepState::Fresh:
        console.detail("up to date  " + step.step);
        return;
    case StepState::Stale:
        console.say("would compute  " + step.step + " (" + step.reason + ")");
        return;
    case StepState::Computed:
        console.say("computed  " + step.step + "  " + secondsText(step.seconds));
        for (const auto& file : step.files)
            console.detail("  " + file.string());
        return;
    case StepState::Failed:
        console.fail(step.step + ": " + (step.error ? step.error->what() : ""));
        return;
    case StepState::Skipped:
        console.warn(step.step + " was left out: what it needs failed");
        return;
    }
}

/// Where the files are that were written or stood already.
void sayFiles(const RebuildReport& report, Console& console)
{
    for (const StepReport& step : report.steps) {
        if (step.files.empty() || step.state == StepState::Failed)
            continue;
        const std::string more =
            step.files.size() > 1 ? " (" + std::to_string(step.files.size()) + " files)" : "";
        console.say(step.step + ": " + step.files.front().string() + more);
    }
}

/// Where results are, when they are not where they should be.
void sayPlace(const std::string& project, Session& session)
{
    const ResultPlaces places = resultPlaces(project);
    if (places.isElsewhere)
        session.console.warn("The folder of results cannot be written; they are in " +
                             places.written.string() + ".");
    const auto unstored = unstoredResults();
    for (const std::string& step : unstored)
        session.console.fail(step + ": the result could not be stored in any folder and is lost");
    if (!unstored.empty())
        session.status = 1;
}

void runRebuild(const RebuildArguments& arguments, Session& session)
{
    Console& console = session.console;
    if (!arguments.store.empty())
        chooseResultFolder(arguments.project, arguments.store);
    const Progress progress = console.progress(session.cancel, "Rebuilding");
    const Project project = loadProject(arguments.project, console);
    const RebuildReport report = rebuild(project, arguments.project, arguments.options, progress,
                                         [&console](const StepReport& step) { sayStep(step, console); });
    console.endProgress();
    if (arguments.options.dryRun) {
        for (const StepReport& step : report.steps)
            sayStep(step, console);
    }
    if (!arguments.options.dryRun)
        sayPlace(arguments.project, session);
    if (!arguments.json.empty()) {
        const auto guard =
            projectGuard(project, arguments.project,
                         {.overwrite = arguments.options.permissions.overwrite, .outside = true});
        const WrittenNote note(*guard, arguments.project);
        writeGuarded(arguments.json, writeJson(toJson(report)), guard.get());
    }
    if (!arguments.options.dryRun)
        sayFiles(report, console);
    const auto number = [&report](StepState state) { return std::to_string(report.count(state)); };
    std::string sum = arguments.project + ": ";
    sum += arguments.options.dryRun ? number(StepState::Stale) + " to compute, "
                                    : number(StepState::Computed) + " computed, ";
    sum += number(StepState::Fresh) + " up to date";
    if (report.hasFailures())
        sum += ", " + number(StepState::Failed) + " failed";
    console.say(sum);
    if (report.hasFailures())
        session.status = 1;
}

} // namespace

void addRebuild(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("rebuild", "Bring results and exports up to date");
    const auto arguments = std::make_shared<RebuildArguments>();
    RebuildOptions& options = arguments->options;
    command->add_option("PROJECT", arguments->project, "The project file, NAME.quadrille")->required();
    command->add_option("TARGET", options.targets,
                        "Sections or entries: sequences, sequences/NAME, exports/NAME, …; all by default");
    command->add_option("-j,--jobs", options.jobs, "Threads; all by default")->check(CLI::Range(1, 1024));
    command->add_flag("-f,--force", options.force, "Compute what is up to date, too");
    command->add_flag("-n,--dry-run", options.dryRun, "Only say what would be computed");
    command->add_option("--store", arguments->store,
                        "Folder of the results, in place of PROJECT.cache beside the project");
    command->add_option("--json", arguments->json, "Write a report to this file");
    addOverwrite(*command, options.permissions.overwrite);
    addAllowOutside(*command, options.permissions.outside);
    command->footer(
        "What is up to date is told by the content of its inputs, not by times.\n"
        "Results lie beside the project in PROJECT.cache; where nothing can be written there, in\n"
        "a folder of the user's cache, ~/.cache/quadrille/results.\n"
        "Examples:\n"
        "  quadrille rebuild dance.quadrille\n"
        "  quadrille rebuild dance.quadrille exports/walk-glb --jobs 4\n"
        "  quadrille rebuild dance.quadrille --dry-run --json report.json");
    command->callback([arguments, &session] { runRebuild(*arguments, session); });
}

} // namespace quadrille::cli
