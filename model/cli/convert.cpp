// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/sequence/io/registry.h"

#include <memory>

namespace quadrille::cli {

namespace {

struct Arguments
{
    std::string in;
    std::string out;
    std::string mesh;
    std::string clip;
    std::optional<double> fps;
    std::optional<double> sourceFps;
    std::string range;
    AxesArguments from;
    AxesArguments to;
    bool noTextures = false;
};

MeshSequence chooseClip(ImportResult& imported, const std::string& file)
{
    if (imported.sequences.size() == 1)
        return std::move(imported.sequences.front());
    std::string names;
    for (const MeshSequence& sequence : imported.sequences)
        names.append(names.empty() ? "" : ", ").append(sequence.name);
    throwUsage("“" + file + "” holds several clips; choose one with --clip: " + names);
}

void convert(const Arguments& arguments, Session& session)
{
    ExportOptions out;
    if (!arguments.range.empty())
        out.range = parseRange(arguments.range);
    out.fps = arguments.fps;
    out.textures = !arguments.noTextures;
    ImportOptions in;
    in.mesh = arguments.mesh;
    in.clip = arguments.clip;
    in.fps = arguments.sourceFps.value_or(arguments.fps.value_or(in.fps));
    if (arguments.from.isGiven())
        in.from = arguments.from.toAxes();
    in.to = in.from.value_or(CoordinateSystem{});
    out.from = in.to;
    out.to = arguments.to.toAxes(in.to);
    exporterFor(arguments.out);

    const Progress progress = session.console.progress(session.cancel, "Converting");
    ImportResult imported = openSequences(arguments.in, in, progress.part(0, 0.1));
    for (const Issue& issue : imported.issues)
        session.console.tell(issue);
    const MeshSequence sequence = chooseClip(imported, arguments.in);
    const ExportResult written = exportSequence(sequence, arguments.out, out, progress.part(0.1, 1));
    session.console.endProgress();
    for (const Issue& issue : written.issues)
        session.console.tell(issue);
    const std::string first = written.files.empty() ? arguments.out : written.files.front().string();
    session.console.say(written.files.size() > 1 ? first + " … " + written.files.back().string() + " (" +
                                                       std::to_string(written.files.size()) + " files)"
                                                 : first);
}

} // namespace

void addConvert(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("convert", "Convert a sequence from one format to another");
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("IN", arguments->in, "A file, or a folder or pattern that holds a numbered series")
        ->required();
    command->add_option("OUT", arguments->out, "The file to write; its ending chooses the format")
        ->required();
    command->add_option("--mesh", arguments->mesh, "Mesh with the faces of a file that has positions only");
    command->add_option("--clip", arguments->clip, "One clip of a scene file");
    command
        ->add_option("--fps", arguments->fps, "Frames per second of OUT; resampled where IN has another rate")
        ->check(positiveNumber());
    command->add_option("--source-fps", arguments->sourceFps, "Frames per second of IN where it names none")
        ->check(positiveNumber());
    command->add_option("--range", arguments->range,
                        "A:B, frames of IN from A to B, zero-based, both included");
    command->add_option("--from-up-axis", arguments->from.up, "Axis of IN that points up: x, y or z");
    command->add_option("--from-unit", arguments->from.unit, "Unit of IN: m, cm, mm, km, in, ft or metres");
    command->add_option("--up-axis", arguments->to.up, "Axis of OUT that points up");
    command->add_option("--unit", arguments->to.unit, "Unit of OUT");
    command->add_flag("--no-textures", arguments->noTextures, "Write no textures");
    command->footer("For formats with one file per frame, OUT “DIR/NAME.ply” writes DIR/NAME_0000.ply, "
                    "DIR/NAME_0001.ply, …\n"
                    "Examples:\n"
                    "  quadrille convert walk.pc2 walk.glb --mesh man.obj --fps 30\n"
                    "  quadrille convert frames/ walk.pc2\n"
                    "  quadrille convert \"frames/walk_####.obj\" out/walk.ply --range 10:40\n"
                    "  quadrille convert fox.glb fox.usda --clip Walk --up-axis z --unit cm");
    command->callback([arguments, &session] { convert(*arguments, session); });
}

} // namespace quadrille::cli
