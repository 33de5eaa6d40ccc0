// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/project/file/projectfile.h"
#include "model/project/media/projectguard.h"
#include "model/project/results/projectdata.h"
#include "model/project/store/dataitem.h"
#include "model/project/store/resultplaces.h"

#include <algorithm>
#include <memory>

namespace quadrille::cli {

namespace {

struct DataArguments
{
    std::string project;
    std::string name;
    std::string out;
    std::string character;
    bool overwrite = false;
    std::string store;
};

std::string shapeText(const DataItem& item)
{
    std::string text;
    for (const std::int64_t extent : item.shape())
        text.append(text.empty() ? "" : " × ").append(std::to_string(extent));
    return text;
}

void list(const std::vector<DataItem>& items, Session& session)
{
    if (items.empty())
        session.console.warn("nothing is computed yet; run “quadrille rebuild”");
    for (const DataItem& item : items) {
        std::string line = item.name;
        line += "\t" + shapeText(item) + "\t" + (item.unit().empty() ? "–" : item.unit());
        line += "\t" + item.description();
        if (!item.character.empty())
            line += "\t[" + item.character + "]";
        if (!item.isFresh)
            line += "\t(out of date)";
        session.console.output(line);
    }
}

const DataItem& choose(const std::vector<DataItem>& items, const DataArguments& arguments)
{
    std::vector<const DataItem*> found;
    std::string known;
    for (const DataItem& item : items) {
        if (item.name == arguments.name)
            found.push_back(&item);
        known.append(known.empty() ? "" : ", ").append(item.name);
    }
    if (found.empty()) {
        throw Error(ErrorCode::ProjectUnknownData,
                    {arguments.project,
                     {},
                     {{"what", arguments.name},
                      {"known", known.empty() ? "nothing yet; run “quadrille rebuild”" : known}}});
    }
    if (found.size() > 1)
        throwUsage("several characters have “" + arguments.name + "”; choose one with --character");
    return *found.front();
}

void runData(const DataArguments& arguments, Session& session)
{
    if (!arguments.store.empty())
        chooseResultFolder(arguments.project, arguments.store);
    const Project project = loadProject(arguments.project, session.console);
    const bool known =
        std::any_of(project.characters.begin(), project.characters.end(),
                    [&](const CharacterEntry& character) { return character.name == arguments.character; });
    if (!arguments.character.empty() && !known)
        throwUsage("--character: there is no character “" + arguments.character + "”");
    const Progress progress(session.cancel);
    auto items = projectData(project, arguments.project, progress, arguments.name);
    const auto isMeant = [&](const DataItem& item) { return item.name == arguments.name; };
    if (!arguments.name.empty() && std::ranges::none_of(items, isMeant))
        items = projectData(project, arguments.project, progress); // for the names that there are
    if (!arguments.character.empty()) {
        std::erase_if(items, [&](const DataItem& item) {
            return !item.character.empty() && item.character != arguments.character;
        });
    }
    if (arguments.name.empty()) {
        list(items, session);
        return;
    }
    const DataItem& item = choose(items, arguments);
    if (!item.isFresh)
        session.console.warn("“" + item.name + "” is out of date; run “quadrille rebuild”");
    if (arguments.out.empty()) {
        std::string csv = dataAsCsv(item);
        csv.pop_back(); // the console ends the last line
        session.console.output(csv);
        return;
    }
    const auto guard =
        projectGuard(project, arguments.project, {.overwrite = arguments.overwrite, .outside = true});
    const WrittenNote note(*guard, arguments.project);
    writeData(item, arguments.out, guard.get());
    session.console.say(arguments.out);
}

} // namespace

void addData(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand(
        "data", "List computed data, or write one: as .npy, .csv or .json, or to standard output");
    const auto arguments = std::make_shared<DataArguments>();
    command->add_option("PROJECT", arguments->project, "The project file, NAME.quadrille")->required();
    command->add_option("NAME", arguments->name, "What to print or write; the list has the names");
    command->add_option("-o,--output", arguments->out,
                        "File to write, its ending gives the format; without it NAME is printed as CSV");
    command->add_option("--character", arguments->character, "Whose data, in a project with several");
    addOverwrite(*command, arguments->overwrite);
    command->add_option("--store", arguments->store,
                        "Folder of the results, in place of PROJECT.cache beside the project");
    command->footer("The list has one line each: name, shape, unit, description, separated by tabs.\n"
                    "Examples:\n"
                    "  quadrille data dance.quadrille\n"
                    "  quadrille data dance.quadrille frames\n"
                    "  quadrille data dance.quadrille frames -o frames.npy\n"
                    "  quadrille data dance.quadrille sequences/walk/bounds -o bounds.npy");
    command->callback([arguments, &session] { runData(*arguments, session); });
}

} // namespace quadrille::cli
