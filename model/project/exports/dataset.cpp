// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/dataset.h"

#include "model/core/seriesname.h"
#include "model/core/stagedfiles.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/json/jsontext.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/steps/variate.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/dataitem.h"
#include "model/project/store/resultstore.h"

#include <algorithm>

namespace quadrille {

namespace {

namespace fs = std::filesystem;

/// One variation of the set.
struct Member
{
    int number = 0;
    std::size_t candidate = 0; ///< among those of all sets of samples
    std::size_t row = 0;       ///< in the report
};

fs::path besidePath(const fs::path& path, const std::string& ending)
{
    fs::path beside = path.parent_path() / seriesStem(path);
    beside += ending;
    return beside;
}

/// Row of the report in which a variation stands.
std::size_t rowOf(const DataTable& report, int number)
{
    const auto& numbers = std::get<std::vector<std::int64_t>>(report.columns.front().values);
    return static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), number) - numbers.begin());
}

std::vector<Member> membersOf(const VariationEntry& variation, const Result& selection)
{
    std::vector<Member> members;
    std::size_t before = 0;
    for (int number = 1; number <= variationCount(variation); ++number) {
        const SamplePlace place = *placeOfVariation(variation, number);
        if (place.index == 0 && place.set > 0)
            before += static_cast<std::size_t>(candidatesFor(variation.samples[place.set - 1].count));
        if (isDiscarded(variation, number))
            continue;
        if (const auto candidate = candidateOf(selection, number))
            members.push_back({number, before + static_cast<std::size_t>(*candidate),
                               rowOf(selection.tables.front(), number)});
    }
    return members;
}

Json cellOf(const DataArray& column, std::size_t row)
{
    return std::visit([row](const auto& values) { return Json(values[row]); }, column.values);
}

Json rowJson(const DataTable& table, std::size_t row)
{
    Json json = Json::object();
    for (const DataArray& column : table.columns)
        json[column.name] = cellOf(column, row);
    return json;
}

/// The frames that a clip follows, one object of columns.
Json framesJson(const Result& clip)
{
    Json json = Json::object();
    for (const DataArray& column : clip.tables.front().columns)
        json[column.name] = std::visit([](const auto& values) { return Json(values); }, column.values);
    return json;
}

/// Latent trajectories of the members, one after the other.
DataItem latentsItem(const Result& samples, const std::vector<Member>& members)
{
    const DataArray& all = arrayOf(samples, "samples");
    const auto& values = std::get<std::vector<double>>(all.values);
    const auto size = static_cast<std::size_t>(all.shape[1] * all.shape[2]);
    DataArray array = all;
    array.name = "latents";
    array.shape[0] = static_cast<std::int64_t>(members.size());
    std::vector<double> chosen;
    for (const Member& member : members) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(member.candidate * size);
        chosen.insert(chosen.end(), at, at + static_cast<std::ptrdiff_t>(size));
    }
    array.values = std::move(chosen);
    return {.name = "latents", .character = {}, .isFresh = true, .content = std::move(array)};
}

} // namespace

fs::path dataSetMember(const fs::path& out, int number)
{
    fs::path numbered = out.parent_path() / out.stem();
    numbered += "_" + std::to_string(number);
    numbered += out.extension();
    return numbered;
}

fs::path dataSetLatents(const fs::path& out, const std::string& part)
{
    return besidePath(out, "_" + part + "_latents.npy");
}

fs::path dataSetDescription(const fs::path& out)
{
    return besidePath(out, ".json");
}

std::vector<std::string> dataSetSteps(const Project& project, const std::string& variation)
{
    std::vector<std::string> steps = clipStepsOf(project, "variations/" + variation);
    steps.push_back(selectionStepOf(variation));
    const VariationEntry* entry = findVariation(project, variation);
    for (const std::string& part : entry ? partNamesOf(project, *entry) : std::vector<std::string>())
        steps.push_back(samplesStepOf(variation, part));
    return steps;
}

ExportResult writeDataSet(const ExportEntry& entry, SequenceOpener& opener, const StepContext& context,
                          WriteGuard* guard, const Progress& progress)
{
    const Project& project = opener.project();
    const auto named = variationOfClip(entry.what);
    const VariationEntry& variation = *findVariation(project, named->variation);
    const auto selection = context.resultOf(selectionStepOf(variation.name));
    const std::vector<Member> members = membersOf(variation, *selection);
    ExportResult written;
    Json json = Json::object();
    json["variations"] = Json::array();
    for (std::size_t m = 0; m < members.size(); ++m) {
        const int number = members[m].number;
        const double share = 0.9 / static_cast<double>(members.size());
        const double at = share * static_cast<double>(m);
        const std::string clip = variationClip(variation.name, number);
        const auto opened = opener.openClip(clip, Progress(progress.token()));
        ExportEntry own = entry;
        own.path = dataSetMember(entry.path, number).generic_string();
        const ExportResult files = writeExport(own, opened->sequence, project, opener.folder(), guard,
                                               progress.part(at, at + share));
        Json item = rowJson(selection->tables.front(), members[m].row);
        item["file"] = fs::path(own.path).filename().generic_string();
        item["frames"] = framesJson(*context.resultOf(clipStepOf(clip)));
        json["variations"].push_back(std::move(item));
        written.files.insert(written.files.end(), files.files.begin(), files.files.end());
        written.issues.insert(written.issues.end(), files.issues.begin(), files.issues.end());
    }
    const fs::path out = resolvePath(entry.path, opener.folder());
    json["fps"] = entry.fps.value_or(project.settings.fps);
    json["latents"] = Json::object();
    for (const std::string& part : partNamesOf(project, variation)) {
        const fs::path file = dataSetLatents(out, part);
        writeData(latentsItem(*context.resultOf(samplesStepOf(variation.name, part)), members), file, guard);
        json["latents"][part] = file.filename().generic_string();
        written.files.push_back(file);
    }
    const fs::path description = dataSetDescription(out);
    writeGuarded(description, writeJson(json), guard);
    written.files.push_back(description);
    progress.report(1);
    return written;
}

} // namespace quadrille
