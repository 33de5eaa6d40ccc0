// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/appearanceresult.h"

#include "model/appearance/appearancefile.h"
#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/store/resultstore.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr auto completionsName = "completions";
constexpr auto textureCoefficientsName = "completed-coefficients";
constexpr auto warpCoefficientsName = "completed-warp-coefficients";
constexpr auto posesName = "poses";
constexpr auto poseVerticesName = "pose-vertices";
constexpr auto poseFramesName = "pose-frames";
constexpr auto poseScalesName = "pose-scales";

const DataTable* findTable(const Result& result, const char* name)
{
    const auto found = std::ranges::find(result.tables, name, &DataTable::name);
    return found == result.tables.end() ? nullptr : &*found;
}

DataArray coefficientArray(const char* name, std::span<const CompletedFrame> frames,
                           std::vector<float> AppearanceCoefficients::*member)
{
    const std::size_t count = frames.empty() ? 0 : (frames.front().coefficients.*member).size();
    std::vector<double> values;
    for (const CompletedFrame& frame : frames)
        values.insert(values.end(), (frame.coefficients.*member).begin(), (frame.coefficients.*member).end());
    return {.name = name,
            .description = "Frames × components: where the completed textures lie in the model.",
            .shape = {static_cast<std::int64_t>(frames.size()), static_cast<std::int64_t>(count)},
            .values = std::move(values)};
}

std::vector<float> coefficientRow(const Result& result, const char* name, std::size_t row)
{
    const auto found = std::ranges::find(result.arrays, name, &DataArray::name);
    const auto count = static_cast<std::size_t>(found->shape[1]);
    const auto& values = std::get<std::vector<double>>(found->values);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * count);
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

/// All components, k × n.
SharedTable<float> componentTable(const QuantisedSpace& space)
{
    Table<float> table(space.count, space.size);
    for (std::int64_t c = 0; c < space.count; ++c) {
        for (std::int64_t i = 0; i < space.size; ++i)
            table(c, i) = space.component(c, i);
    }
    return SharedTable<float>(std::move(table));
}

/// Adds the textures that were completed, and still are to be.
void addCompletions(FrameAppearances& appearances, const Result& result, const fs::path& folder,
                    const AppearanceEntry& entry)
{
    const DataTable* table = findTable(result, completionsName);
    if (table == nullptr)
        return;
    const auto& sequences = columnNamed<TextColumn>(*table, "sequence");
    const auto& frames = columnNamed<std::vector<std::int64_t>>(*table, "frame");
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FrameAppearances::Key key(sequences[i], FrameIndex(frames[i]));
        const fs::path file = resolvePath(result.files[i].path, folder);
        const bool isWanted = std::ranges::any_of(entry.completions, [&](const CompletionEntry& each) {
            return each.frame == NamedFrame{sequences[i], FrameIndex(frames[i])};
        });
        if (!isWanted || !fs::exists(file))
            continue;
        appearances.completed[key] = {.file = file};
        appearances.coefficients[key] = {coefficientRow(result, textureCoefficientsName, i),
                                         coefficientRow(result, warpCoefficientsName, i)};
    }
}

template <typename Values>
const Values& valuesNamed(const Result& result, const char* name)
{
    return std::get<Values>(std::ranges::find(result.arrays, name, &DataArray::name)->values);
}

/// Adds how appearance varies with poses, where that is of the model's frames.
void addPoses(FrameAppearances& appearances, const Result& result)
{
    const DataTable* frames = findTable(result, poseFramesName);
    if (frames == nullptr)
        return;
    const auto& sequences = columnNamed<TextColumn>(*frames, "sequence");
    const auto& numbers = columnNamed<std::vector<std::int64_t>>(*frames, "frame");
    const AppearanceModel& model = *appearances.model;
    Eigen::MatrixXd textures(std::ssize(numbers), model.textures.count);
    Eigen::MatrixXd warps(std::ssize(numbers), model.warps.count);
    const auto put = [](const std::vector<float>& from, auto row) {
        row = Eigen::Map<const Eigen::VectorXf>(from.data(), std::ssize(from)).cast<double>();
    };
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto known = appearances.coefficients.find({sequences[i], FrameIndex(numbers[i])});
        if (known == appearances.coefficients.end())
            return;
        put(known->second.textures, textures.row(static_cast<Eigen::Index>(i)));
        put(known->second.warps, warps.row(static_cast<Eigen::Index>(i)));
    }
    PosePlaces places{.positions = valuesNamed<std::vector<float>>(result, posesName)};
    for (const std::int64_t vertex : valuesNamed<std::vector<std::int64_t>>(result, poseVerticesName))
        places.vertices.push_back(static_cast<std::uint32_t>(vertex));
    const DataTable& scales = *findTable(result, poseScalesName);
    const auto& lengths = columnNamed<std::vector<double>>(scales, "length");
    const auto& trusts = columnNamed<std::vector<double>>(scales, "trust");
    appearances.poses = std::make_shared<const PoseAppearance>(
        places, textures, warps,
        PoseScales{.textures = {lengths[0], trusts[0]}, .warps = {lengths[1], trusts[1]}});
}

} // namespace

std::string appearanceModelStep(const std::string& name)
{
    return "appearance/" + name + "/model";
}

std::string appearanceCompletionsStep(const std::string& name)
{
    return "appearance/" + name + "/completions";
}

std::string appearancePosesStep(const std::string& name)
{
    return "appearance/" + name + "/poses";
}

bool learnsPoses(const Project& project, const AppearanceEntry& entry)
{
    return entry.varied == VariedTextures::Learned &&
           !learnedVariations(project, characterNameOf(project, entry)).empty();
}

std::vector<std::string> appearanceSteps(const Project& project, const std::string& character)
{
    const AppearanceEntry* entry = appearanceOf(project, character);
    if (entry == nullptr)
        return {};
    std::vector<std::string> steps{appearanceModelStep(entry->name)};
    if (!entry->completions.empty())
        steps.push_back(appearanceCompletionsStep(entry->name));
    if (learnsPoses(project, *entry))
        steps.push_back(appearancePosesStep(entry->name));
    return steps;
}

fs::path appearanceFolder(const fs::path& results, const std::string& name)
{
    return results / "appearance" / name / "files";
}

DataTable rowsTable(std::span<const AppearanceRow> rows)
{
    TableBuilder table("frames", "The frames that were learned from, and their rows in “coefficients”.");
    table.text("sequence").whole("frame", "frame").whole("row");
    for (const AppearanceRow& each : rows)
        table.add({each.sequence, each.frame.value, each.row});
    return std::move(table).table();
}

std::vector<AppearanceRow> appearanceRows(const Result& result)
{
    const DataTable& table = *findTable(result, "frames");
    const auto& sequences = columnNamed<TextColumn>(table, "sequence");
    const auto& frames = columnNamed<std::vector<std::int64_t>>(table, "frame");
    const auto& rows = columnNamed<std::vector<std::int64_t>>(table, "row");
    std::vector<AppearanceRow> all;
    for (std::size_t i = 0; i < rows.size(); ++i)
        all.push_back({sequences[i], FrameIndex(frames[i]), rows[i]});
    return all;
}

fs::path modelFileOf(const Result& model, const fs::path& folder)
{
    return resolvePath(model.files.front().path, folder);
}

std::vector<DataArray> appearanceArrays(const AppearanceModel& model)
{
    const WarpGrid& grid = model.grid;
    DataArray texels = columnOf(
        "texels", "", std::vector<std::int64_t>(model.texels.texels.begin(), model.texels.texels.end()));
    texels.description = "The texels that are used, of " + std::to_string(model.texels.width) + " × " +
                         std::to_string(model.texels.height) + ": row · width + column, from the top left.";
    return {{.name = "components",
             .description = "Eigen textures: R, G and B of each of “texels”, of length 1.",
             .shape = {model.textures.count, model.textures.size},
             .values = componentTable(model.textures)},
            {.name = "warps",
             .description = "Eigen warps, of length 1: x and y at each of " + std::to_string(grid.width) +
                            " × " + std::to_string(grid.height) + " nodes, row by row, " +
                            std::to_string(grid.spacing) + " texels apart.",
             .shape = {model.warps.count, model.warps.size},
             .values = componentTable(model.warps)},
            std::move(texels)};
}

Result completionsResult(std::span<const CompletedFrame> frames)
{
    TableBuilder table(completionsName, "Textures that were completed, and their pictures.");
    table.text("sequence").whole("frame", "frame").text("file");
    for (const CompletedFrame& each : frames)
        table.add({each.sequence, each.frame.value, each.file.filename().string()});
    Result result;
    result.tables = {std::move(table).table()};
    result.arrays = {coefficientArray(textureCoefficientsName, frames, &AppearanceCoefficients::textures),
                     coefficientArray(warpCoefficientsName, frames, &AppearanceCoefficients::warps)};
    return result;
}

Result posesResult(const LearnedPoses& poses, const std::string& unit)
{
    TableBuilder frames(poseFramesName, "The frames that have the poses that appearance was learned from.");
    frames.text("sequence").whole("frame", "frame");
    for (const auto& [sequence, frame] : poses.frames)
        frames.add({sequence, frame.value});
    TableBuilder scales(poseScalesName,
                        "How coefficients are regressed on poses: the length of the kernel, by which poses "
                        "count as near, and how much of their variance poses explain, in variances of what "
                        "they do not; 0: nothing, they are the mean.");
    scales.text("coefficients").real("length", unit).real("trust");
    scales.add({"textures", poses.scales.textures.length, poses.scales.textures.trust});
    scales.add({"warps", poses.scales.warps.length, poses.scales.warps.trust});
    DataArray vertices =
        columnOf(poseVerticesName, "",
                 std::vector<std::int64_t>(poses.places.vertices.begin(), poses.places.vertices.end()));
    vertices.description = "The vertices of which “poses” has the positions.";
    Result result;
    result.arrays = {{.name = posesName,
                      .description = "Poses that appearance was learned from, laid on the first by a rigid "
                                     "motion.",
                      .unit = unit,
                      .shape = {poses.places.count(), std::ssize(poses.places.vertices), 3},
                      .values = poses.places.positions},
                     std::move(vertices)};
    result.tables = {std::move(frames).table(), std::move(scales).table()};
    return result;
}

std::optional<FrameAppearances> readAppearances(const fs::path& results, const fs::path& folder,
                                                const AppearanceEntry& entry)
{
    const std::string& name = entry.name;
    try {
        const ResultStore store(results);
        const ResultPointer model = store.load(appearanceModelStep(name), {}).result;
        if (model->files.empty())
            return std::nullopt;
        FrameAppearances appearances{.model = std::make_shared<const AppearanceModel>(
                                         readAppearanceFile(modelFileOf(*model, folder)))};
        for (const AppearanceRow& each : appearanceRows(*model))
            appearances.coefficients[{each.sequence, each.frame}] =
                coefficientsOf(*appearances.model, static_cast<std::size_t>(each.row));
        if (entry.varied == VariedTextures::Learned)
            addPoses(appearances, *store.load(appearancePosesStep(name), {}).result);
        addCompletions(appearances, *store.load(appearanceCompletionsStep(name), {}).result, folder, entry);
        return appearances;
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace quadrille
