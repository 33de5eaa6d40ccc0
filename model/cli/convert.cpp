// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/core/seriesname.h"
#include "model/core/writeguard.h"
#include "model/sequence/io/ratebeside.h"
#include "model/sequence/io/registry.h"

#include <memory>

namespace quadrille::cli {

namespace {

struct ConvertArguments
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
    bool noNormals = false;
    bool overwrite = false;
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

/// Refuses before minutes of work what would be refused after them.
void checkOut(const FormatInfo& format, const ConvertArguments& arguments, WriteGuard& guard)
{
    const std::filesystem::path out = arguments.out;
    const SeriesName name = seriesName(out);
    const auto first = format.onePerFrame ? out.parent_path() / name.numbered(0) : out;
    if (format.onePerFrame)
        guard.checkSeries({out.parent_path(), name.before, name.after});
    guard.checkPlace(first);
    if (!arguments.overwrite && guard.isForeign(first))
        refuseExisting(first);
}

/// Where the file names no rate: that of the command line, else of what lies beside it, else a guess.
void findRate(MeshSequence& sequence, const ConvertArguments& arguments, Console& console)
{
    if (arguments.sourceFps || sequence.frameCount() < 2)
        return;
    if (const auto beside = rateBeside(arguments.in, sequence.frameCount())) {
        sequence.fps = beside->fps;
        console.say(arguments.in + ": " + beside->toString());
    } else if (!arguments.fps) {
        console.warn(arguments.in + ": the rate is not known; 25 fps is taken. Give it as --source-fps.");
    }
}

void convert(const ConvertArguments& arguments, Session& session)
{
    ExportOptions out;
    if (!arguments.range.empty())
        out.range = parseRange(arguments.range);
    out.fps = arguments.fps;
    out.textures = !arguments.noTextures;
    out.normals = !arguments.noNormals;
    ImportOptions in;
    in.mesh = arguments.mesh;
    in.clip = arguments.clip;
    in.fps = arguments.sourceFps.value_or(arguments.fps.value_or(in.fps));
    if (arguments.from.isGiven())
        in.from = arguments.from.toAxes();
    in.to = in.from.value_or(CoordinateSystem{});
    out.from = in.to;
    out.to = arguments.to.toAxes(in.to);
    const FormatInfo& format = exporterFor(arguments.out).format();
    checkOutputName(format, arguments.out);
    WriteGuard guard({.overwrite = arguments.overwrite});
    out.guard = &guard;
    for (const auto& file : findSource(arguments.in).files)
        guard.protect({file, "IN"});
    if (!arguments.mesh.empty())
        guard.protect({arguments.mesh, "--mesh"});
    checkOut(format, arguments, guard);

    const Progress progress = session.console.progress(session.cancel, "Converting");
    ImportResult imported = openSequences(arguments.in, in, progress.part(0, 0.1));
    for (const Issue& issue : imported.issues) {
        if (issue.code != Issue::Code::FpsAssumed)
            session.console.tell(issue);
    }
    MeshSequence sequence = chooseClip(imported, arguments.in);
    if (!imported.hasOwnFps)
        findRate(sequence, arguments, session.console);
    for (const Texture& texture : sequence.textures.textures()) {
        if (!texture.file.empty())
            guard.protect({texture.file, "IN"});
    }
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
    const auto arguments = std::make_shared<ConvertArguments>();
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
    command->add_flag("--no-normals", arguments->noNormals,
                      "Write no normals into GLB, which is half as large then; viewers shade it flat");
    addOverwrite(*command, arguments->overwrite);
    command->footer("For formats with one file per frame, OUT “DIR/NAME.ply” writes DIR/NAME_0000.ply, "
                    "DIR/NAME_0001.ply, …; “DIR/NAME_###.ply” DIR/NAME_000.ply, …\n"
                    "Examples:\n"
                    "  quadrille convert walk.pc2 walk.glb --mesh man.obj --fps 30\n"
                    "  quadrille convert frames/ walk.pc2\n"
                    "  quadrille convert \"frames/walk_####.obj\" out/walk.ply --range 10:40\n"
                    "  quadrille convert fox.glb fox.usda --clip Walk --up-axis z --unit cm");
    command->callback([arguments, &session] { convert(*arguments, session); });
}

} // namespace quadrille::cli
