// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/runexports.h"

#include "model/project/exportentry.h"
#include "model/project/paths.h"
#include "model/project/rebuild.h"
#include "model/project/resultstore.h"

namespace quadrille {

namespace {

void computeClips(const Project& project, const std::filesystem::path& projectFile,
                  const std::vector<ExportEntry>& entries, const Progress& progress)
{
    RebuildOptions options;
    for (const ExportEntry& entry : entries) {
        const auto stages = stagesOf(project, entry);
        options.targets.insert(options.targets.end(), stages.begin(), stages.end());
    }
    if (options.targets.empty())
        return;
    for (const StageReport& stage : rebuild(project, projectFile, options, progress).stages) {
        if (stage.error)
            throw *stage.error;
    }
}

} // namespace

std::vector<ExportResult> runExports(const Project& project, const std::filesystem::path& projectFile,
                                     const std::vector<ExportEntry>& entries, const Progress& progress)
{
    computeClips(project, projectFile, entries, progress.part(0, 0.5));
    const auto folder = projectFolder(projectFile);
    SequenceOpener opener(project, folder, cacheFolder(projectFile));
    const ResultStore store(cacheFolder(projectFile));
    std::vector<ExportResult> results;
    const auto count = static_cast<double>(entries.size());
    for (const ExportEntry& entry : entries) {
        const double at = 0.5 + 0.5 * static_cast<double>(results.size()) / count;
        const Progress part = progress.part(at, at + 0.5 / count);
        results.push_back(writeExport(
            entry, opener, [&](const std::string& stage) { return store.load(stage, {}).result; }, part));
    }
    return results;
}

} // namespace quadrille
