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

/// Columns of the table “frames”.
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
    TableBuilder table("frames", "Where each frame of the clip comes from: a captured frame, or the weight "
                                 "lambda of the second of two.");
    table.whole("frame", "frame").text("sequence").whole("source-frame", "frame");
    table.text("destination-sequence").whole("destination-frame", "frame").real("lambda").text("mirrored");
    table.real("centre-x", unit).real("centre-y", unit).real("centre-z", unit);
    if (!variations.empty())
        table.text("variation").text("destination-variation");
    const auto variationOf = [&](std::int32_t number) {
        return number == 0 ? std::string() : variations[static_cast<std::size_t>(number) - 1];
    };
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const FrameProvenance& origin = clip.origins[static_cast<std::size_t>(f)];
        const int source = layout.sequenceOf(origin.source);
        const int destination = layout.sequenceOf(origin.destination);
        const Vec3d centre = centroid(clip.frame(f));
        std::vector<TableBuilder::Cell> cells{f,
                                              sequences[static_cast<std::size_t>(source)],
                                              std::int64_t{origin.source - layout.firstOf(source)},
                                              sequences[static_cast<std::size_t>(destination)],
                                              std::int64_t{origin.destination - layout.firstOf(destination)},
                                              origin.lambda,
                                              origin.mirrored ? "yes" : "no",
                                              centre.x(),
                                              centre.y(),
                                              centre.z()};
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
    const auto frames = [&](Column which) -> const std::vector<std::int64_t>& {
        return std::get<std::vector<std::int64_t>>(column(result, which).values);
    };
    const auto& lambdas = std::get<std::vector<double>>(column(result, LambdaColumn).values);
    for (std::size_t f = 0; f < lambdas.size(); ++f) {
        const auto source =
            nodeOf(texts(SequenceColumn)[f], frames(SourceColumn)[f], sequences, character.layout());
        const auto destination = nodeOf(texts(OtherSequenceColumn)[f], frames(DestinationColumn)[f],
                                        sequences, character.layout());
        if (!source || !destination)
            return std::nullopt;
        clip.origins.push_back({.source = *source,
                                .destination = *destination,
                                .lambda = lambdas[f],
                                .mirrored = texts(MirroredColumn)[f] == "yes"});
    }
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
