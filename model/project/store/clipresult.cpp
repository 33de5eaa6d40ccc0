// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/clipresult.h"

#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/project/document/madeclips.h"
#include "model/project/store/resultstore.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr const char* looksName = "textures";

/// Columns of the table “frames”; that of textures has the same ones up to the weight.
enum Column : std::size_t
{
    FrameColumn,
    SequenceColumn,
    SourceColumn,
    OtherSequenceColumn,
    DestinationColumn,
    LambdaColumn,
    MirroredColumn,
    CentreColumns,
    VariationColumn = CentreColumns + 3, ///< where anything is drawn from variations
    OtherVariationColumn,
};

const DataArray& column(const Result& result, Column which)
{
    return result.tables.front().columns[which];
}

TableBuilder provenanceTable(const char* name, const char* description)
{
    TableBuilder table(name, description);
    table.whole("frame", "frame").text("sequence").whole("source-frame", "frame");
    table.text("destination-sequence").whole("destination-frame", "frame").real("lambda");
    return table;
}

/// Cells of its columns.
std::vector<TableBuilder::Cell> provenanceCells(std::int64_t frame, const FrameProvenance& origin,
                                                const FrameLayout& layout,
                                                const std::vector<std::string>& sequences)
{
    const int source = layout.sequenceOf(origin.source);
    const int destination = layout.sequenceOf(origin.destination);
    return {frame,
            sequences[static_cast<std::size_t>(source)],
            std::int64_t{origin.source - layout.firstOf(source)},
            sequences[static_cast<std::size_t>(destination)],
            std::int64_t{origin.destination - layout.firstOf(destination)},
            origin.lambda};
}

/// The frame of a character that a sequence and a frame of it are; nothing where there is none.
std::optional<NodeIndex> nodeOf(const std::string& sequence, std::int64_t frame,
                                std::span<const MeshSequence> sequences, const FrameLayout& layout)
{
    for (std::size_t s = 0; s < sequences.size(); ++s) {
        const int index = static_cast<int>(s);
        if (sequences[s].name == sequence && frame >= 0 && frame < layout.countOf(index))
            return layout.firstOf(index) + static_cast<NodeIndex>(frame);
    }
    return std::nullopt;
}

/// What a table of provenances says; nothing where it names a frame that is not there.
std::optional<std::vector<FrameProvenance>>
provenancesIn(const DataTable& table, std::span<const MeshSequence> sequences, const FrameLayout& layout)
{
    const auto texts = [&](Column which) -> const TextColumn& {
        return std::get<TextColumn>(table.columns[which].values);
    };
    const auto frames = [&](Column which) -> const std::vector<std::int64_t>& {
        return std::get<std::vector<std::int64_t>>(table.columns[which].values);
    };
    const auto& lambdas = std::get<std::vector<double>>(table.columns[LambdaColumn].values);
    std::vector<FrameProvenance> origins;
    origins.reserve(lambdas.size());
    for (std::size_t f = 0; f < lambdas.size(); ++f) {
        const auto source = nodeOf(texts(SequenceColumn)[f], frames(SourceColumn)[f], sequences, layout);
        const auto destination =
            nodeOf(texts(OtherSequenceColumn)[f], frames(DestinationColumn)[f], sequences, layout);
        if (!source || !destination)
            return std::nullopt;
        origins.push_back({.source = *source, .destination = *destination, .lambda = lambdas[f]});
    }
    return origins;
}

/// The variations that origins of a clip count, as their numbers do not matter: each once.
std::vector<std::string> variationsIn(const Result& result)
{
    if (result.tables.empty() || result.tables.front().columns.size() <= OtherVariationColumn)
        return {};
    std::vector<std::string> names;
    for (const Column each : {VariationColumn, OtherVariationColumn}) {
        for (const std::string& name : std::get<TextColumn>(column(result, each).values).words()) {
            if (!name.empty() && std::ranges::find(names, name) == names.end())
                names.push_back(name);
        }
    }
    return names;
}

} // namespace

Result clipResult(const Clip& clip, const FrameLayout& layout, const std::vector<std::string>& sequences,
                  const std::string& unit, std::span<const std::string> variations)
{
    TableBuilder table =
        provenanceTable("frames", "Where each frame of the clip comes from: a captured frame, or the weight "
                                  "lambda of the second of two.");
    table.text("mirrored");
    table.real("centre-x", unit).real("centre-y", unit).real("centre-z", unit);
    if (!variations.empty())
        table.text("variation").text("destination-variation");
    const auto variationOf = [&](std::int32_t number) {
        return number == 0 ? std::string() : variations[static_cast<std::size_t>(number) - 1];
    };
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const FrameProvenance& origin = clip.origins[static_cast<std::size_t>(f)];
        const Vec3d centre = centroid(clip.frame(f));
        std::vector<TableBuilder::Cell> cells = provenanceCells(f, origin, layout, sequences);
        cells.emplace_back(origin.mirrored ? "yes" : "no");
        for (const double coordinate : centre)
            cells.emplace_back(coordinate);
        if (!variations.empty()) {
            cells.emplace_back(variationOf(origin.sourceVariation));
            cells.emplace_back(variationOf(origin.destinationVariation));
        }
        table.add(cells);
    }
    DataArray positions;
    positions.name = "positions";
    positions.description = "Positions of all vertices in each frame of the clip.";
    positions.unit = unit;
    const auto vertexCount = static_cast<std::int64_t>(clip.topology->vertexCount());
    positions.shape = {clip.frameCount(), vertexCount, 3};
    std::vector<float> values(clip.positions.size() * 3);
    for (std::size_t v = 0; v < clip.positions.size(); ++v)
        std::copy_n(clip.positions[v].data(), 3, values.begin() + static_cast<std::ptrdiff_t>(3 * v));
    positions.values = std::move(values);
    Result result;
    result.arrays = {std::move(positions)};
    result.tables = {std::move(table).table()};
    if (clip.looks.empty())
        return result;
    TableBuilder looks =
        provenanceTable(looksName, "Where the texture of each frame comes from: a captured frame's, or what "
                                   "lies at the weight lambda of the second between two.");
    for (std::size_t f = 0; f < clip.looks.size(); ++f)
        looks.add(provenanceCells(static_cast<std::int64_t>(f), clip.looks[f], layout, sequences));
    result.tables.push_back(std::move(looks).table());
    return result;
}

std::optional<Clip> clipOf(const Result& result, std::span<const MeshSequence> sequences, double fps,
                           std::span<const std::string> variations)
{
    if (result.arrays.empty() || result.tables.empty() || sequences.empty())
        return std::nullopt;
    const CharacterFrames character(sequences);
    const DataArray& positions = result.arrays.front();
    Clip clip{.topology = sequences.front().topology, .fps = fps};
    if (positions.shape.size() != 3 || positions.shape[1] != clip.topology->vertexCount())
        return std::nullopt;
    const auto& values = std::get<std::vector<float>>(positions.values);
    clip.positions.resize(values.size() / 3);
    for (std::size_t v = 0; v < clip.positions.size(); ++v)
        clip.positions[v] = Vec3f(values[3 * v], values[3 * v + 1], values[3 * v + 2]);
    const auto texts = [&](Column which) -> const TextColumn& {
        return std::get<TextColumn>(column(result, which).values);
    };
    auto origins = provenancesIn(result.tables.front(), sequences, character.layout());
    if (!origins)
        return std::nullopt;
    clip.origins = std::move(*origins);
    for (std::size_t f = 0; f < clip.origins.size(); ++f)
        clip.origins[f].mirrored = texts(MirroredColumn)[f] == "yes";
    const auto looks = std::ranges::find(result.tables, looksName, &DataTable::name);
    if (looks != result.tables.end())
        clip.looks = provenancesIn(*looks, sequences, character.layout()).value_or(clip.origins);
    if (variations.empty())
        return clip;
    const auto numberOf = [&](const std::string& name) {
        return static_cast<std::int32_t>(
            name.empty() ? 0 : std::ranges::find(variations, name) - variations.begin() + 1);
    };
    for (std::size_t f = 0; f < clip.origins.size(); ++f) {
        clip.origins[f].sourceVariation = numberOf(texts(VariationColumn)[f]);
        clip.origins[f].destinationVariation = numberOf(texts(OtherVariationColumn)[f]);
    }
    return clip;
}

std::optional<MeshSequence> readClip(const std::filesystem::path& results, const std::string& name,
                                     std::span<const MeshSequence> sequences, double fps)
{
    if (results.empty())
        return std::nullopt;
    const ResultPointer stored = ResultStore(results).load(clipStepOf(name), {}).result;
    auto clip = clipOf(*stored, sequences, fps, variationsIn(*stored));
    if (!clip)
        return std::nullopt;
    if (variationOfClip(name))
        clip = shownAsVariation(std::move(*clip));
    return toSequence(name.substr(name.find('/') + 1), std::move(*clip), CharacterFrames(sequences));
}

} // namespace quadrille
