// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/projectdata.h"

#include "model/appearance/appearancefile.h"
#include "model/project/document/paths.h"
#include "model/project/results/makesteps.h"
#include "model/project/results/stepstate.h"
#include "model/project/store/appearanceresult.h"
#include "model/project/store/resultplaces.h"

#include <algorithm>

namespace quadrille {

namespace {

std::string dataName(const BuildStep& step, const std::string& name)
{
    return step.dataPrefix.empty() ? name : step.dataPrefix + "/" + name;
}

/// What lies in the file of a model of appearance, where a step has made such a one.
std::vector<DataArray> arraysOfModel(const Project& project, const BuildStep& step, const Result& result,
                                     const std::filesystem::path& folder, const std::string& wanted)
{
    const bool isModel = std::ranges::any_of(project.appearances, [&](const AppearanceEntry& entry) {
        return step.name == appearanceModelStep(entry.name);
    });
    const std::vector<std::string> names{"components", "warps", "texels"};
    const bool isWanted = wanted.empty() || std::ranges::any_of(names, [&](const std::string& name) {
                              return dataName(step, name) == wanted;
                          });
    if (!isModel || !isWanted || result.files.empty() || !exists(modelFileOf(result, folder)))
        return {};
    return appearanceArrays(readAppearanceFile(modelFileOf(result, folder)));
}

} // namespace

std::vector<DataItem> projectData(const Project& project, const std::filesystem::path& projectFile,
                                  const Progress& progress, const std::string& wanted)
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
        for (DataArray& array : arraysOfModel(project, steps[i], *entry.result, folder, wanted))
            items.push_back({dataName(steps[i], array.name), steps[i].character, fresh, std::move(array)});
    }
    return items;
}

} // namespace quadrille
