// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/appearancework.h"

#include "model/project/document/findentry.h"
#include "model/project/store/appearanceresult.h"
#include "model/project/store/resultplaces.h"

namespace quadrille {

namespace {

constexpr double computed = 0.95; ///< of the work, before the model is read

OpenedAppearancePointer openedFrom(const AppearanceJob& job, const ProjectResults& results,
                                   const Progress& progress)
{
    const AppearanceEntry& entry = *findAppearance(job.working.project, job.name);
    const std::string model = appearanceModelStep(job.name);
    const std::string completions = appearanceCompletionsStep(job.name);
    std::vector<std::string> steps{model};
    const std::string poses = appearancePosesStep(job.name);
    const bool hasPoses = learnsPoses(job.working.project, entry);
    if (!entry.completions.empty())
        steps.push_back(completions);
    if (hasPoses)
        steps.push_back(poses);
    const FreshResults fresh = results.freshOf(results.bring(steps, progress, {.dryRun = true}));
    OpenedAppearance opened;
    if (job.before != nullptr)
        opened = *job.before;
    const bool isModelFresh = fresh.has(model);
    const bool arePosesFresh = hasPoses && fresh.has(poses);
    opened.isFresh = isModelFresh && (arePosesFresh || !hasPoses);
    opened.areCompletionsFresh = !entry.completions.empty() && fresh.has(completions);
    std::string keys = isModelFresh ? fresh.keyOf(model) : std::string();
    if (opened.areCompletionsFresh)
        keys += " " + fresh.keyOf(completions);
    if (arePosesFresh)
        keys += " " + fresh.keyOf(poses);
    const bool isRead = opened.decoder != nullptr && (!isModelFresh || keys == opened.keys);
    if (!isRead) {
        const std::filesystem::path& file = job.working.file;
        auto known = readAppearances(cacheFolder(file), file.parent_path(), entry);
        opened.decoder = known ? std::make_shared<const AppearanceDecoder>(known->model) : nullptr;
        opened.known = known ? std::move(*known) : FrameAppearances();
        opened.keys = std::move(keys);
        opened.isFresh = opened.isFresh && opened.decoder != nullptr; // its file may have been removed
    }
    return std::make_shared<const OpenedAppearance>(std::move(opened));
}

OpenedAppearancePointer brought(const AppearanceJob& job, const std::string& step, const Progress& progress)
{
    const ProjectResults results(job.working);
    std::vector<std::string> steps{step};
    if (learnsPoses(job.working.project, *findAppearance(job.working.project, job.name)))
        steps.push_back(appearancePosesStep(job.name));
    results.get(steps, progress.part(0, computed));
    return openedFrom(job, results, progress.part(computed, 1));
}

} // namespace

OpenedAppearancePointer openAppearance(const AppearanceJob& job, const Progress& progress)
{
    return openedFrom(job, ProjectResults(job.working), progress);
}

OpenedAppearancePointer buildAppearanceModel(const AppearanceJob& job, const Progress& progress)
{
    return brought(job, appearanceModelStep(job.name), progress);
}

OpenedAppearancePointer completeAppearance(const AppearanceJob& job, const Progress& progress)
{
    return brought(job, appearanceCompletionsStep(job.name), progress);
}

} // namespace quadrille
