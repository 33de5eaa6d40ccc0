// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/exportsteps.h"

#include "model/core/contenthash.h"
#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"
#include "model/project/exports/exportclaims.h"
#include "model/project/exports/exportentry.h"
#include "model/project/exports/playerexport.h"
#include "model/project/fields/writefields.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/projectguard.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"

namespace quadrille {

namespace {

/// The entry as the file has it.
std::string entryText(const ExportEntry& entry)
{
    Project project;
    project.exports = {entry};
    return writeJson(projectToJson(project)["exports"][0]);
}

/// Counts up whenever a format is written in another way.
int writerVersion(const ExportEntry& entry)
{
    try {
        constexpr int withPictures = 4;
        constexpr int asH264 = 3;
        constexpr int inSrgb = 2;
        const std::string& format = exporterOf(entry).format().id;
        return format == "gltf" ? withPictures : format == "mp4" ? asH264 : inSrgb;
    } catch (const Error&) {
        return 1; // of a format that is not known: the step says so
    }
}

/// What an export takes from its animation beside the frames.
void addSoundAndCamera(BuildStep& step, const SequenceOpener& opener, const ExportEntry& entry)
{
    const Project& project = opener.project();
    AnimationEntry beside;
    try {
        if (const AudioEntry* audio = soundOf(project, entry)) {
            beside.audio = *audio;
            step.files = [file = resolvePath(audio->file, opener.folder())](const Progress&) {
                return std::vector{file};
            };
        }
        for (const CameraKey& key : cameraKeysOf(project, entry))
            beside.camera.push_back({.key = key});
    } catch (const Error&) {
        return; // of a format that is not known: the step says so when it computes
    }
    if (beside != AnimationEntry())
        step.settings += writeFields(beside, project.settings.axes.up).dump();
}

BuildStep exportStep(const std::shared_ptr<SequenceOpener>& opener, const ExportEntry& entry,
                     const std::shared_ptr<WriteGuard>& guard)
{
    const Project& project = opener->project();
    const std::string clip = entry.what;
    BuildStep step;
    step.name = "exports/" + entry.name;
    step.dataPrefix = step.name;
    step.settings = entryText(entry);
    step.version = writerVersion(entry);
    step.inputs = stepsOf(project, entry);
    if (clip.starts_with("animations/"))
        addSoundAndCamera(step, *opener, entry);
    if (const auto sequence = nameOfClip(clip, "sequences"); sequence && findSequence(project, *sequence)) {
        step.settings += sequenceSettings(project, *findSequence(project, *sequence));
        step.files = [opener, name = *sequence](const Progress& progress) {
            return opener->filesOf(name, progress);
        };
    }
    if (const std::vector<std::string> takes = shownByPlayer(project, entry); !takes.empty()) {
        step.files = [opener, takes](const Progress& progress) {
            std::vector<std::filesystem::path> files;
            for (const std::string& take : takes) {
                const std::vector<std::filesystem::path> own = opener->filesOf(take, progress);
                files.insert(files.end(), own.begin(), own.end());
            }
            return files;
        };
    }
    step.files = [before = step.files, opener, entry, guard](const Progress& progress) {
        checkOutputs(opener->project(), entry, opener->project().exports, opener->folder(), *guard);
        return before ? before(progress) : std::vector<std::filesystem::path>();
    };
    step.compute = [opener, entry, guard](const StepContext& context, const Progress& progress) {
        const auto written = writeExport(entry, opener, context, *guard, progress.part(0, 0.95));
        for (const Issue& issue : written.issues)
            context.tell(issue);
        Result result;
        for (const auto& file : written.files)
            result.files.push_back({storedPath(file, opener->folder()), hashFile(file, progress)});
        return result;
    };
    return step;
}

} // namespace

std::vector<BuildStep> exportSteps(const std::shared_ptr<SequenceOpener>& opener,
                                   const std::shared_ptr<WriteGuard>& guard)
{
    std::vector<BuildStep> steps;
    for (const ExportEntry& entry : opener->project().exports)
        steps.push_back(exportStep(opener, entry, guard));
    return steps;
}

std::vector<BuildStep> makeExportSteps(const StepMaking& making)
{
    if (making.opener->project().exports.empty())
        return {};
    return exportSteps(making.opener, projectGuard(making.opener->project(), making.projectFile));
}

} // namespace quadrille
