// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/check.h"

#include "model/cli/commands.h"
#include "model/project/store/resultplaces.h"

#include <memory>

namespace quadrille::cli {

namespace {

void check(const std::string& file, const std::string& store, bool allowsOutside, Session& session)
{
    if (!store.empty())
        chooseResultFolder(file, store);
    const Progress progress = session.console.progress(session.cancel, "Checking");
    const CheckReport report = checkProject(file, progress, allowsOutside);
    session.console.endProgress();
    for (const ProjectProblem& problem : report.problems) {
        if (problem.severity == ProjectProblem::Severity::Error)
            session.console.fail(problem.toString());
        else
            session.console.warn(problem.toString());
    }
    if (hasErrors(report.problems)) {
        session.status = 1;
        return;
    }
    session.console.say(file + ": no errors, " + std::to_string(report.freshResults) +
                        " results up to date, " + std::to_string(report.staleResults) + " to compute");
}

} // namespace

void addCheck(CLI::App& app, Session& session)
{
    auto* command =
        app.add_subcommand("check", "Validate a project, its inputs and its results; compute nothing");
    const auto file = std::make_shared<std::string>();
    const auto allowsOutside = std::make_shared<bool>(false);
    command->add_option("PROJECT", *file, "The project file, NAME.quadrille")->required();
    const auto store = std::make_shared<std::string>();
    command->add_option("--store", *store,
                        "Folder of the results, in place of PROJECT.cache beside the project");
    addAllowOutside(*command, *allowsOutside);
    command->footer("Every error names line and column. Example:\n"
                    "  quadrille check dance.quadrille");
    command->callback(
        [file, store, allowsOutside, &session] { check(*file, *store, *allowsOutside, session); });
}

} // namespace quadrille::cli
