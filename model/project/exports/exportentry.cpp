// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/exportentry.h"

#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/exports/dataset.h"
#include "model/project/exports/playerexport.h"
#include "model/project/fields/pictureoptions.h"
#include "model/project/media/opensequence.h"
#include "model/project/store/appearanceresult.h"
#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

namespace {

const AnimationEntry* animationOf(const Project& project, const ExportEntry& entry)
{
    const auto name = nameOfClip(entry.what, "animations");
    return name ? findAnimation(project, *name) : nullptr;
}

} // namespace

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

bool isDataSet(const ExportEntry& entry)
{
    return variationOfClip(entry.what).value_or(VariationNumber{{}, 1}).number == 0;
}

std::vector<std::string> stepsOf(const Project& project, const ExportEntry& entry)
{
    if (isPlayer(entry))
        return playerSteps(project, entry);
    std::vector<std::string> steps = isDataSet(entry)
                                         ? dataSetSteps(project, variationOfClip(entry.what)->variation)
                                         : clipStepsOf(project, entry.what);
    if (!steps.empty() && entry.textures) {
        const std::vector<std::string> looks = appearanceSteps(project, characterOfClip(project, entry.what));
        steps.insert(steps.end(), looks.begin(), looks.end());
    }
    return steps;
}

const AudioEntry* soundOf(const Project& project, const ExportEntry& entry)
{
    const AnimationEntry* animation =
        exporterOf(entry).format().id == "mp4" ? animationOf(project, entry) : nullptr;
    return animation != nullptr && animation->audio ? &*animation->audio : nullptr;
}

std::vector<CameraKey> cameraKeysOf(const Project& project, const ExportEntry& entry)
{
    const std::string& format = exporterOf(entry).format().id;
    const bool namesCamera = entry.picture.contains("camera") || entry.picture.contains("view");
    std::vector<CameraKey> keys;
    if (const auto* animation = animationOf(project, entry);
        animation != nullptr && !namesCamera && (format == "mp4" || format == "png")) {
        for (const CameraKeyEntry& key : animation->camera)
            keys.push_back(key.key);
    }
    return keys;
}

ExportResult writeExport(const ExportEntry& entry, const MeshSequence& sequence, const Project& project,
                         const std::filesystem::path& folder, WriteGuard* guard, const Progress& progress)
{
    const Exporter& exporter = exporterOf(entry);
    ExportOptions options;
    options.range = entry.range;
    options.fps = entry.fps;
    options.from = project.settings.axes;
    options.to = entry.axes.value_or(options.from);
    options.textures = entry.textures;
    options.guard = guard;
    ProjectProblems problems;
    options.render = pictureFromJson(entry.picture, "/picture", problems);
    if (hasErrors(problems))
        throw Error(problems.front().code, problems.front().context);
    options.render.look.axes = options.to;
    const double start = entry.range ? static_cast<double>(entry.range->first.value) / sequence.fps : 0;
    options.render.keys = cameraKeysOf(project, entry);
    for (CameraKey& key : options.render.keys) {
        key = converted(key, options.from, options.to);
        key.time -= start;
    }
    if (const AudioEntry* audio = soundOf(project, entry))
        options.sound = SoundTrack{resolvePath(audio->file, folder), audio->offset - start, audio->gain};
    MeshSequence prepared = entry.range ? sequence.cutTo(*entry.range) : sequence;
    if (entry.fps)
        prepared = resampled(prepared, *entry.fps);
    prepared = transformed(prepared, conversionMatrix(options.from, options.to));
    return exporter.write(prepared, resolvePath(entry.path, folder), options, progress);
}

ExportResult writeExport(const ExportEntry& entry, const std::shared_ptr<SequenceOpener>& opener,
                         const StepContext& context, WriteGuard& guard, const Progress& progress)
{
    if (isDataSet(entry))
        return writeDataSet(entry, *opener, context, &guard, progress);
    if (isPlayer(entry))
        return writePlayer(entry, opener, context, &guard, progress);
    const auto opened = opener->openClip(entry.what, progress.part(0, 0.1));
    return writeExport(entry, opened->sequence, opener->project(), opener->folder(), &guard,
                       progress.part(0.1, 1));
}

} // namespace quadrille
