// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/projectdata.h"

#include "model/project/paths.h"
#include "model/project/stagestate.h"

namespace quadrille {

namespace {

std::string dataName(const ResultStage& stage, const std::string& name)
{
    return stage.dataPrefix.empty() ? name : stage.dataPrefix + "/" + name;
}

} // namespace

std::vector<std::int64_t> DataItem::shape() const
{
    if (const auto* array = std::get_if<DataArray>(&content))
        return array->shape;
    const auto& columns = std::get<DataTable>(content).columns;
    const std::int64_t rows = columns.empty() ? 0 : columns.front().shape.front();
    return {rows, static_cast<std::int64_t>(columns.size())};
}

std::string DataItem::unit() const
{
    if (const auto* array = std::get_if<DataArray>(&content))
        return array->unit;
    return "table";
}

std::string DataItem::description() const
{
    return std::visit([](const auto& data) { return data.description; }, content);
}

std::vector<DataItem> projectData(const Project& project, const std::filesystem::path& projectFile,
                                  const Progress& progress)
{
    const auto folder = projectFolder(projectFile);
    const auto stages = makeStages({std::make_shared<SequenceOpener>(project, folder), projectFile});
    const ResultStore store(cacheFolder(projectFile));
    FileHashes hashes(cacheFolder(projectFile) / "hashes.json");
    const auto status = stageStatus(stages, store, folder, hashes, progress);
    std::vector<DataItem> items;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const bool fresh = status[i].isFresh;
        Result result = fresh ? status[i].result : store.load(stages[i].name, status[i].key).result;
        for (DataArray& array : result.arrays)
            items.push_back({dataName(stages[i], array.name), stages[i].character, fresh, std::move(array)});
        for (DataTable& table : result.tables)
            items.push_back({dataName(stages[i], table.name), stages[i].character, fresh, std::move(table)});
    }
    return items;
}

} // namespace quadrille
