// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/projectdata.h"

#include "model/project/document/paths.h"
#include "model/project/results/makesteps.h"
#include "model/project/results/stepstate.h"
#include "model/project/store/resultplaces.h"

namespace quadrille {

namespace {

std::string dataName(const BuildStep& step, const std::string& name)
{
    return step.dataPrefix.empty() ? name : step.dataPrefix + "/" + name;
}

} // namespace

std::vector<DataItem> projectData(const Project& project, const std::filesystem::path& projectFile,
                                  const Progress& progress)
{
    const auto folder = projectFolder(projectFile);
    const auto steps = makeSteps({std::make_shared<SequenceOpener>(project, folder), projectFile});
    const ResultStore store(cacheFolder(projectFile));
    FileHashes hashes(cacheFolder(projectFile) / "hashes.json");
    const auto keys = stepKeys(steps, hashes, progress);
    std::vector<DataItem> items;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const ResultStore::Entry entry = store.load(steps[i].name, keys[i].key);
        const bool fresh = entry.state == ResultStore::State::Fresh;
        Result result = *entry.result;
        for (DataArray& array : result.arrays)
            items.push_back({dataName(steps[i], array.name), steps[i].character, fresh, std::move(array)});
        for (DataTable& table : result.tables)
            items.push_back({dataName(steps[i], table.name), steps[i].character, fresh, std::move(table)});
    }
    return items;
}

} // namespace quadrille
