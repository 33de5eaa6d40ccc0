// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/runexports.h"

#include "model/project/exportentry.h"
#include "model/project/paths.h"
#include "model/project/rebuild.h"

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
    std::vector<ExportResult> results;
    const auto count = static_cast<double>(entries.size());
    for (const ExportEntry& entry : entries) {
        const double at = 0.5 + 0.5 * static_cast<double>(results.size()) / count;
        const Progress part = progress.part(at, at + 0.5 / count);
        const auto opened = opener.openClip(entry.what, part.part(0, 0.1));
        results.push_back(writeExport(entry, opened->sequence, project, folder, part.part(0.1, 1)));
    }
    return results;
}

} // namespace quadrille
