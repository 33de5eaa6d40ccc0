// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/runexports.h"

#include "model/project/document/paths.h"
#include "model/project/exports/exportclaims.h"
#include "model/project/exports/exportentry.h"
#include "model/project/media/projectguard.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/resultstore.h"

#include <algorithm>

namespace quadrille {

namespace {

/// The steps of what is exported.
std::vector<std::string> stepsOf(const Project& project, const std::vector<ExportEntry>& entries)
{
    std::vector<std::string> steps;
    for (const ExportEntry& entry : entries) {
        const auto own = stepsOf(project, entry);
        steps.insert(steps.end(), own.begin(), own.end());
    }
    return steps;
}

/// The files of a claim that are there.
std::vector<std::filesystem::path> filesThere(const OutputClaim& claim)
{
    namespace fs = std::filesystem;
    std::error_code error;
    std::vector<fs::path> files;
    const fs::path file = claim.names.folder / claim.names.before;
    if (!claim.isNumbered && fs::exists(fs::symlink_status(file, error)))
        files.push_back(file);
    if (!claim.isNumbered)
        return files;
    for (fs::directory_iterator entry(claim.names.folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (claim.names.contains(entry->path().filename().string()))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

OutputQuestions outputQuestions(const Project& project, const std::filesystem::path& projectFile,
                                const std::vector<ExportEntry>& entries, const Progress& progress)
{
    const auto folder = projectFolder(projectFile);
    const auto guard = projectGuard(project, projectFile, {.outside = true});
    OutputQuestions questions;
    for (const ExportEntry& entry : entries) {
        checkOutputs(project, entry, entries, folder, *guard);
        for (const OutputClaim& claim : claimsOf(project, entry, folder)) {
            progress.report(0);
            const auto& place = claim.names.folder;
            auto& outside = questions.outside;
            if (!claim.isCompanion && guard->isOutside(place / claim.names.before) &&
                std::find(outside.begin(), outside.end(), place) == outside.end())
                outside.push_back(place);
            for (const auto& file : filesThere(claim)) {
                questions.existing.push_back(file);
                if (guard->isForeign(file))
                    questions.foreign.push_back(file);
            }
        }
    }
    return questions;
}

std::vector<ExportResult> runExports(const WorkingProject& working, const std::vector<ExportEntry>& entries,
                                     const Progress& progress, WritePermissions permissions)
{
    const ProjectResults project(working);
    const auto folder = projectFolder(working.file);
    const auto guard = projectGuard(working.project, working.file, permissions);
    for (const ExportEntry& entry : entries)
        checkOutputs(working.project, entry, entries, folder, *guard);
    const FreshResults fresh =
        project.get(stepsOf(working.project, entries), progress.part(0, 0.5), {.permissions = permissions});
    std::vector<ExportResult> results;
    const auto count = static_cast<double>(entries.size());
    const WrittenNote note(*guard, working.file);
    for (const ExportEntry& entry : entries) {
        const double at = 0.5 + 0.5 * static_cast<double>(results.size()) / count;
        const Progress part = progress.part(at, at + 0.5 / count);
        results.push_back(writeExport(entry, project.opener(), fresh.context(), *guard, part));
    }
    return results;
}

} // namespace quadrille
