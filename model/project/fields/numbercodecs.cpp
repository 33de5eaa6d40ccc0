// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/codecs.h"
#include "model/project/json/jsonmembers.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace quadrille {

namespace {

/// Two numbers in a list.
Json pairSchema(const char* help, double greatest, bool isBelowGreatest, std::pair<double, double> usual)
{
    return {{"description", help},
            {"type", "array"},
            {"items",
             {{"type", "number"},
              {"exclusiveMinimum", 0},
              {isBelowGreatest ? "exclusiveMaximum" : "maximum", greatest}}},
            {"minItems", 2},
            {"maxItems", 2},
            {"default", {usual.first, usual.second}}};
}

/// A number, or a word in its place.
Json numberOrWordSchema(const char* help, Json number, const char* word, Json usual)
{
    number["type"] = "number";
    return {{"description", help},
            {"oneOf", {std::move(number), {{"enum", {word}}}}},
            {"default", std::move(usual)}};
}

} // namespace

void readValue(const ObjectReader& reader, const std::string& key, Durations& durations, const FieldContext&)
{
    if (const auto seconds = reader.numbers(key, 2, "two numbers of seconds, [shortest, longest]"))
        durations = {seconds->at(0), seconds->at(1)};
}

void writeValue(Json& json, const std::string& key, const Durations& durations, const FieldContext&)
{
    if (durations)
        json[key] = {durations->first, durations->second};
}

void valueSchema(Json& properties, const std::string& key, Type<Durations>)
{
    properties[key] =
        pairSchema("[shortest, longest] window of a transition, seconds; where it is left out, in short "
                   "takes three tenths of them. Published: a third of a second and two.",
                   longestWindow, false, usualDurations);
}

void readValue(const ObjectReader& reader, const std::string& key, HmcSettings& chain, const FieldContext&)
{
    if (const auto shares = reader.numbers(key, 2, "two shares, [least, greatest]")) {
        chain.leastAcceptance = shares->at(0);
        chain.greatestAcceptance = shares->at(1);
    }
}

void writeValue(Json& json, const std::string& key, const HmcSettings& chain, const FieldContext&)
{
    const HmcSettings usual;
    if (chain.leastAcceptance != usual.leastAcceptance ||
        chain.greatestAcceptance != usual.greatestAcceptance)
        json[key] = {chain.leastAcceptance, chain.greatestAcceptance};
}

void valueSchema(Json& properties, const std::string& key, Type<HmcSettings>)
{
    properties[key] = pairSchema("[least, greatest] share that the step size is tuned to.", 1, true,
                                 {HmcSettings().leastAcceptance, HmcSettings().greatestAcceptance});
}

void readValue(const ObjectReader& reader, const std::string& key, std::vector<TrianglePair>& pairs,
               const FieldContext&)
{
    reader.each(key, [&](const Json& item, const std::string& pointer) {
        const bool isPair =
            item.is_array() && item.size() == 2 && std::ranges::all_of(item, [](const Json& triangle) {
                return triangle.is_number_unsigned() &&
                       triangle.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
            });
        if (!isPair) {
            reader.invalid(pointer, "A pair must be two triangles, counted from 0",
                           "Write [triangle of the template, triangle of the target].");
            return;
        }
        pairs.push_back(
            {TriangleIndex(item[0].get<std::uint32_t>()), TriangleIndex(item[1].get<std::uint32_t>())});
    });
}

void writeValue(Json& json, const std::string& key, const std::vector<TrianglePair>& pairs,
                const FieldContext&)
{
    if (pairs.empty())
        return;
    Json& list = json[key] = Json::array();
    for (const TrianglePair& pair : pairs)
        list.push_back({pair.onTemplate.value, pair.onTarget.value});
}

void valueSchema(Json& properties, const std::string& key, Type<std::vector<TrianglePair>>)
{
    properties[key] = {
        {"description",
         "Triangles of the template and of the target that turn alike, counted from 0; where they are left "
         "out, pairs are proposed by arms, legs and head."},
        {"type", "array"},
        {"items",
         {{"type", "array"},
          {"items", {{"type", "integer"}, {"minimum", 0}}},
          {"minItems", 2},
          {"maxItems", 2}}}};
}

void readValue(const ObjectReader& reader, const std::string& key, TrajectoryLimits& extent,
               const FieldContext&)
{
    if (const Json* spread = reader.find(key); spread != nullptr && spread->is_string())
        reader.word(key, extent.draw, {{"model", TrajectoryDraw::Model}});
    else
        extent.spread = reader.number(key).value_or(extent.spread);
}

void writeValue(Json& json, const std::string& key, const TrajectoryLimits& extent, const FieldContext&)
{
    if (extent.draw == TrajectoryDraw::Model)
        json[key] = "model";
    else
        addUnless(json, key, extent.spread, TrajectoryLimits().spread);
}

void valueSchema(Json& properties, const std::string& key, Type<TrajectoryLimits>)
{
    properties[key] =
        numberOrWordSchema("How far variations are apart, as a share of how far the captured takes of "
                           "the same movement are; or the model's own trajectories as they are drawn.",
                           {{"minimum", 0}, {"maximum", greatestSpread}}, "model", TrajectoryLimits().spread);
}

void readValue(const ObjectReader& reader, const std::string& key, VariationLimits& limits,
               const FieldContext&)
{
    if (const Json* distance = reader.find(key); distance != nullptr && distance->is_string())
        reader.word(key, limits.poseDistance, {{"takes", std::nullopt}});
    else
        limits.poseDistance = reader.number(key);
}

void writeValue(Json& json, const std::string& key, const VariationLimits& limits, const FieldContext&)
{
    addOptional(json, key, limits.poseDistance);
}

void valueSchema(Json& properties, const std::string& key, Type<VariationLimits>)
{
    properties[key] =
        numberOrWordSchema("Distance of the worst frame from the nearest pose learned from, sizes of the "
                           "figure; or as far as takes of the same movement are from each other.",
                           {{"exclusiveMinimum", 0}}, "takes", "takes");
}

void readValue(const ObjectReader& reader, const std::string& key, SamplesEntry& samples, const FieldContext&)
{
    samples.weight = reader.number(key).value_or(samples.weight);
}

void writeValue(Json& json, const std::string& key, const SamplesEntry& samples, const FieldContext&)
{
    if (!samples.to.empty() || samples.weight != 0)
        json[key] = samples.weight;
}

void valueSchema(Json& properties, const std::string& key, Type<SamplesEntry>)
{
    properties[key] = {{"description", "Of the second take."},
                       {"type", "number"},
                       {"minimum", 0},
                       {"maximum", 1},
                       {"default", SamplesEntry().weight}};
}

} // namespace quadrille
