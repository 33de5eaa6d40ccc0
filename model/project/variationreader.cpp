// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/projectkeys.h"
#include "model/project/variationjson.h"

#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr auto listOfWholeNumbers = "a list of whole numbers from zero";

/// A list of whole numbers that fit; nothing where one does not.
template <typename Number>
std::vector<Number> wholeNumbers(const ObjectReader& reader, std::string_view key)
{
    std::vector<Number> numbers;
    for (const double number : reader.numbers(key, 0, listOfWholeNumbers).value_or(std::vector<double>{})) {
        if (number < 0 || number != std::floor(number) ||
            number > static_cast<double>(std::numeric_limits<int>::max())) {
            reader.wrongType(key, listOfWholeNumbers);
            return {};
        }
        numbers.push_back(static_cast<Number>(number));
    }
    return numbers;
}

std::vector<VertexIndex> vertices(const ObjectReader& reader, std::string_view key)
{
    std::vector<VertexIndex> indices;
    for (const auto number : wholeNumbers<std::uint32_t>(reader, key))
        indices.emplace_back(number);
    return indices;
}

std::vector<std::string> names(const ObjectReader& reader, std::string_view key)
{
    std::vector<std::string> all;
    reader.each(key, [&](const Json& name, const std::string& pointer) {
        if (name.is_string())
            all.push_back(name.get<std::string>());
        else
            reader.invalid(pointer, "A name in quotes is expected here");
    });
    return all;
}

std::optional<NamedFrame> readNamedFrame(const ObjectReader& owner, std::string_view key)
{
    const Json* json = owner.find(key);
    if (json == nullptr)
        return std::nullopt;
    const ObjectReader reader(*json, owner.pointer(key), owner.problems());
    NamedFrame frame{reader.requiredText("sequence"), FrameIndex(reader.wholeNumber("frame").value_or(0))};
    reader.unknown(projectkeys::namedFrame);
    return frame;
}

PartCurveEntry readCurve(const ObjectReader& reader)
{
    PartCurveEntry entry;
    entry.curve.name = reader.requiredText("name");
    if (reader.find("vertices") == nullptr)
        reader.missing("vertices");
    entry.curve.vertices = vertices(reader, "vertices");
    entry.points = vertices(reader, "points");
    entry.unknown = reader.unknown(projectkeys::partCurve);
    return entry;
}

PartEntry readPart(const ObjectReader& reader)
{
    PartEntry entry;
    entry.part.name = reader.requiredText("name");
    entry.part.parent = reader.text("parent");
    entry.part.curves = names(reader, "curves");
    entry.unknown = reader.unknown(projectkeys::part);
    return entry;
}

/// "walk", or {"sequence": "walk", "range": [0, 40]}.
TrainingEntry readTraining(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    if (json.is_string())
        return {.sequence = json.get<std::string>(), .range = {}, .unknown = {}};
    const ObjectReader reader(json, pointer, problems);
    TrainingEntry entry;
    entry.sequence = reader.requiredText("sequence");
    entry.range = reader.range("range");
    entry.unknown = reader.unknown(projectkeys::training);
    return entry;
}

/// What both pairs of a blend have in common.
template <typename Pair>
void readPair(const ObjectReader& reader, Pair& pair)
{
    pair.from = reader.requiredText("from");
    pair.to = reader.requiredText("to");
    pair.weights = reader.numbers("weights", 0, "a list of numbers").value_or(pair.weights);
}

BlendEntry readBlend(const ObjectReader& reader)
{
    BlendEntry blend;
    readPair(reader, blend);
    if (const Json* json = reader.find("across")) {
        const ObjectReader across(*json, reader.pointer("across"), reader.problems());
        readPair(across, blend.across.emplace());
        blend.across->unknown = across.unknown(projectkeys::acrossBlend);
    }
    blend.unknown = reader.unknown(projectkeys::blend);
    return blend;
}

std::uint64_t readSeed(const ObjectReader& reader, std::uint64_t fallback)
{
    const auto seed = reader.wholeNumber("seed");
    if (seed && *seed < 0)
        reader.wrongType("seed", "a whole number from zero");
    return seed && *seed >= 0 ? static_cast<std::uint64_t>(*seed) : fallback;
}

int readCount(const ObjectReader& reader, std::string_view key, int fallback)
{
    const auto count = reader.wholeNumber(key);
    constexpr std::int64_t most = 1'000'000;
    if (count && (*count < 0 || *count > most)) {
        reader.wrongType(key, "a whole number from zero to a million");
        return fallback;
    }
    return static_cast<int>(count.value_or(fallback));
}

void readLearning(const ObjectReader& reader, VariationEntry& variation)
{
    GpdmSettings& learning = variation.learning;
    learning.dimensions = readCount(reader, "dimensions", learning.dimensions);
    learning.restarts = readCount(reader, "restarts", learning.restarts);
    learning.seed = readSeed(reader, learning.seed);
    learning.tolerance = reader.number("tolerance").value_or(learning.tolerance);
    learning.window = readCount(reader, "window", learning.window);
    learning.greatestIterations = readCount(reader, "iterations", learning.greatestIterations);
    variation.unknownOfLearning = reader.unknown(projectkeys::learning);
}

void readSampling(const ObjectReader& reader, VariationEntry& variation)
{
    HmcSettings& chain = variation.chain;
    chain.leapfrogSteps = readCount(reader, "leapfrog_steps", chain.leapfrogSteps);
    chain.burnIn = readCount(reader, "burn_in", chain.burnIn);
    chain.thinning = readCount(reader, "thinning", chain.thinning);
    if (const auto shares = reader.numbers("acceptance", 2, "two shares, [least, greatest]")) {
        chain.leastAcceptance = shares->at(0);
        chain.greatestAcceptance = shares->at(1);
    }
    TrajectoryLimits& extent = variation.extent;
    if (const Json* spread = reader.find("spread"); spread != nullptr && spread->is_string())
        reader.word("spread", extent.draw, {{"model", TrajectoryDraw::Model}});
    else
        extent.spread = reader.number("spread").value_or(extent.spread);
    extent.uncertainty = reader.number("uncertainty").value_or(extent.uncertainty);
    variation.unknownOfSampling = reader.unknown(projectkeys::sampling);
}

void readLimits(const ObjectReader& reader, VariationEntry& variation)
{
    VariationLimits& limits = variation.limits;
    if (const Json* distance = reader.find("pose_distance"); distance != nullptr && distance->is_string())
        reader.word("pose_distance", limits.poseDistance, {{"takes", std::nullopt}});
    else
        limits.poseDistance = reader.number("pose_distance");
    limits.skate = reader.number("skate").value_or(limits.skate);
    limits.intersections = reader.number("intersections").value_or(limits.intersections);
    limits.volumeChange = reader.number("volume_change").value_or(limits.volumeChange);
    limits.collapse = reader.number("collapse").value_or(limits.collapse);
    limits.sink = reader.number("sink").value_or(limits.sink);
    variation.unknownOfLimits = reader.unknown(projectkeys::variationLimits);
}

AcrossSamplesEntry readAcross(const ObjectReader& reader)
{
    AcrossSamplesEntry across;
    across.of = reader.requiredText("of");
    across.to = reader.requiredText("to");
    across.weight = reader.number("weight").value_or(across.weight);
    across.unknown = reader.unknown(projectkeys::acrossSamples);
    return across;
}

SamplesEntry readSamples(const ObjectReader& reader)
{
    SamplesEntry samples;
    samples.of = reader.requiredText("of");
    samples.to = reader.text("to");
    samples.weight = reader.number("weight").value_or(samples.weight);
    if (const Json* across = reader.find("across"))
        samples.across = readAcross({*across, reader.pointer("across"), reader.problems()});
    samples.count = readCount(reader, "count", samples.count);
    samples.seed = readSeed(reader, samples.seed);
    samples.discarded = wholeNumbers<int>(reader, "discarded");
    samples.unknown = reader.unknown(projectkeys::samples);
    return samples;
}

} // namespace

BodyPartsEntry readBodyParts(const ObjectReader& reader)
{
    BodyPartsEntry entry;
    entry.character = reader.text("character");
    entry.pose = readNamedFrame(reader, "pose");
    reader.each("curves", [&](const Json& json, const std::string& pointer) {
        entry.curves.push_back(readCurve({json, pointer, reader.problems()}));
    });
    reader.each("parts", [&](const Json& json, const std::string& pointer) {
        entry.parts.push_back(readPart({json, pointer, reader.problems()}));
    });
    entry.unknown = reader.unknown(projectkeys::bodyParts);
    return entry;
}

VariationEntry readVariation(const ObjectReader& reader)
{
    VariationEntry variation;
    variation.name = reader.requiredText("name");
    variation.character = reader.text("character");
    reader.each("sequences", [&](const Json& json, const std::string& pointer) {
        variation.training.push_back(readTraining(json, pointer, reader.problems()));
    });
    variation.reference = reader.text("reference");
    variation.templatePose = readNamedFrame(reader, "template");
    variation.cycles = reader.boolean("cycles", variation.cycles);
    reader.each("blends", [&](const Json& json, const std::string& pointer) {
        variation.blends.push_back(readBlend({json, pointer, reader.problems()}));
    });
    variation.displacementShare = reader.number("displacement_share").value_or(variation.displacementShare);
    if (const Json* learning = reader.find("learning"))
        readLearning({*learning, reader.pointer("learning"), reader.problems()}, variation);
    if (const Json* sampling = reader.find("sampling"))
        readSampling({*sampling, reader.pointer("sampling"), reader.problems()}, variation);
    reader.each("samples", [&](const Json& json, const std::string& pointer) {
        variation.samples.push_back(readSamples({json, pointer, reader.problems()}));
    });
    reader.word("poses", variation.draw, {{"mean", PoseDraw::Mean}, {"sample", PoseDraw::Sample}});
    variation.correctsContacts = reader.boolean("contact_correction", variation.correctsContacts);
    if (const Json* limits = reader.find("limits"))
        readLimits({*limits, reader.pointer("limits"), reader.problems()}, variation);
    variation.unknown = reader.unknown(projectkeys::variation);
    return variation;
}

} // namespace quadrille
