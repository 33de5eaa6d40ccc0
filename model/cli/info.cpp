// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"
#include "model/cli/sequenceinfo.h"
#include "model/project/json/jsontext.h"
#include "model/sequence/io/registry.h"

#include <memory>

namespace quadrille::cli {

namespace {

struct InfoArguments
{
    std::vector<std::string> paths;
    std::string mesh;
    bool json = false;
};

void runInfo(const InfoArguments& arguments, Session& session)
{
    Json all = Json::array();
    const auto count = static_cast<double>(arguments.paths.size());
    const Progress progress = session.console.progress(session.cancel, "Reading");
    for (std::size_t i = 0; i < arguments.paths.size(); ++i) {
        const auto at = static_cast<double>(i);
        const Progress part = progress.part(at / count, (at + 1) / count);
        try {
            ImportOptions options;
            options.mesh = arguments.mesh;
            const ImportResult imported = openSequences(arguments.paths[i], options, part.part(0, 0.2));
            for (const MeshSequence& sequence : imported.sequences) {
                const Json info = sequenceInfo(arguments.paths[i], sequence, imported, part.part(0.2, 1));
                if (arguments.json)
                    all.push_back(info);
                else
                    session.console.output(infoText(info));
            }
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled)
                throw;
            session.console.fail(error.what());
            session.status = 1;
        }
    }
    session.console.endProgress();
    if (arguments.json) {
        std::string text = writeJson(all);
        text.pop_back();
        session.console.output(text);
    }
}

} // namespace

void addInfo(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("info", "Say what files or series of meshes hold");
    const auto arguments = std::make_shared<InfoArguments>();
    command->add_option("PATH", arguments->paths, "Files, or folders or patterns that hold numbered series")
        ->required();
    command->add_option("--mesh", arguments->mesh, "Mesh with the faces of files that have positions only");
    command->add_flag("--json", arguments->json, "Write JSON: a list with an object for each sequence");
    command->footer(
        "Keys of --json: path, name, vertices, triangles, frames, fps (null where nothing says it), "
        "fps_source "
        "(the file that says it: the take's own, or one beside it), duration (seconds, or null), "
        "components, edges, boundary_edges, boundary_loops, non_manifold_edges, non_manifold_vertices, "
        "zero_area_triangles (of the first frame), euler, uvs, materials, textures {kind, count, files}, "
        "bounds {min, max} over all frames, up_axis and metres_per_unit of the file, problems (sentences).\n"
        "Examples:\n"
        "  quadrille info walk.pc2 --mesh man.obj\n"
        "  quadrille info frames/ fox.glb --json");
    command->callback([arguments, &session] { runInfo(*arguments, session); });
}

} // namespace quadrille::cli
