// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exportentry.h"

#include "model/project/clipresult.h"
#include "model/project/paths.h"
#include "model/project/pictureoptions.h"
#include "model/project/stage.h"
#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

const Exporter& exporterOf(const ExportEntry& entry)
{
    if (entry.format.empty())
        return exporterFor(entry.path);
    const auto all = exporters();
    const auto found = std::find_if(all.begin(), all.end(), [&](const std::unique_ptr<Exporter>& exporter) {
        return exporter->format().id == entry.format;
    });
    if (found == all.end())
        throw Error(ErrorCode::FormatUnknown, {entry.path, {}, {}});
    return **found;
}

std::vector<std::string> stagesOf(const Project& project, const ExportEntry& entry)
{
    if (const auto animation = nameOfClip(entry.what, "animations"))
        return {clipStageOf(*animation)};
    const auto sequence = nameOfClip(entry.what, "sequences");
    return sequence ? clipInputs(project, {*sequence}) : std::vector<std::string>();
}

ExportResult writeExport(const ExportEntry& entry, const MeshSequence& sequence,
                         const ProjectSettings& settings, const std::filesystem::path& folder,
                         const Progress& progress)
{
    const Exporter& exporter = exporterOf(entry);
    ExportOptions options;
    options.range = entry.range;
    options.fps = entry.fps;
    options.from = settings.axes;
    options.to = entry.axes.value_or(settings.axes);
    options.textures = entry.textures;
    ProjectProblems problems;
    options.render = pictureFromJson(entry.picture, "/picture", problems);
    if (hasErrors(problems))
        throw Error(problems.front().code, problems.front().context);
    options.render.look.axes = options.to;
    MeshSequence prepared = entry.range ? sequence.cutTo(*entry.range) : sequence;
    if (entry.fps)
        prepared = resampled(prepared, *entry.fps);
    prepared = transformed(prepared, conversionMatrix(options.from, options.to));
    return exporter.write(prepared, resolvePath(entry.path, folder), options, progress);
}

} // namespace quadrille
