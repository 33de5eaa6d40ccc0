// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/project/media/importsequences.h"

#include <memory>

namespace quadrille::cli {

namespace {

struct ImportArguments
{
    std::string project;
    std::vector<std::string> sources;
    std::string mesh;
    std::string name;
    std::string character;
    std::optional<double> fps;
    AxesArguments axes;
    bool force = false;
};

void runImport(const ImportArguments& arguments, Session& session)
{
    if (!arguments.name.empty() && arguments.sources.size() > 1)
        throwUsage("--name is for one source");
    ImportRequest request;
    request.sources.assign(arguments.sources.begin(), arguments.sources.end());
    request.mesh = arguments.mesh;
    request.name = arguments.name;
    request.character = arguments.character;
    request.sourceFps = arguments.fps;
    if (arguments.axes.isGiven())
        request.sourceAxes = arguments.axes.toAxes();
    request.ignoresLock = arguments.force;
    const Progress progress = session.console.progress(session.cancel, "Importing");
    const ImportReport report = importSequences(arguments.project, request, progress);
    session.console.endProgress();
    for (const Issue& issue : report.issues)
        session.console.tell(issue);
    if (report.isNewProject)
        session.console.say("new project " + arguments.project);
    for (const TakenRate& rate : report.rates) {
        if (!rate.isGuess())
            session.console.say(rate.toString());
        else
            session.console.warn(rate.toString() + ". Give it as --fps.");
    }
    for (const std::string& name : report.names)
        session.console.say("sequences/" + name);
}

} // namespace

void addImport(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("import", "Add sequences to a project; make it where there is none");
    const auto arguments = std::make_shared<ImportArguments>();
    command->add_option("PROJECT", arguments->project, "The project file, NAME.quadrille")->required();
    command
        ->add_option("SOURCE", arguments->sources, "Files, or folders or patterns that hold numbered series")
        ->required();
    command->add_option("--mesh", arguments->mesh, "The character's mesh, for files with positions only");
    command->add_option("--name", arguments->name, "Name of the sequence; the file's by default");
    command->add_option("--character", arguments->character, "Whose performance it is; added where missing");
    command
        ->add_option("--fps", arguments->fps,
                     "Frames per second of sources that name none; else what lies beside them says it")
        ->check(positiveNumber());
    command->add_option("--up-axis", arguments->axes.up, "Axis of the sources that points up: x, y or z");
    command->add_option("--unit", arguments->axes.unit,
                        "Unit of the sources: m, cm, mm, km, in, ft or metres");
    command->add_flag("--force", arguments->force, "Write although the project is open in an editor");
    command->footer(
        "A new project takes the rate of its first source. Files stay where they are.\n"
        "Where a file names no rate (PC2, NumPy, series of OBJ or PLY), that of the BVH or JSON file\n"
        "of its name is taken, of other BVHs, a read-me or other takes in its folder, or of the\n"
        "character's other takes, and the program says so.\n"
        "Examples:\n"
        "  quadrille import man.quadrille takes/*.pc2 --mesh man.obj --fps 30\n"
        "  quadrille import man.quadrille scans/walk_####.obj --name walk --character liam");
    command->callback([arguments, &session] { runImport(*arguments, session); });
}

} // namespace quadrille::cli
