// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animationjson.h"
#include "model/project/brokenentry.h"
#include "model/project/framenote.h"
#include "model/project/jsonmembers.h"
#include "model/project/lengthunit.h"
#include "model/project/projectjson.h"
#include "model/project/projectkeys.h"
#include "model/project/variationjson.h"

#include <algorithm>

namespace quadrille {

namespace {

void addAxes(Json& json, const char* upKey, const char* unitKey, const CoordinateSystem& axes)
{
    json[upKey] = toString(axes.up);
    if (const auto name = unitName(axes.metresPerUnit))
        json[unitKey] = *name;
    else
        json[unitKey] = axes.metresPerUnit;
}

void addTexture(Json& json, const TextureReference& texture)
{
    switch (texture.kind) {
    case TextureReference::Kind::None:
        return;
    case TextureReference::Kind::Single:
        if (!texture.paths.empty())
            json["texture"] = texture.paths.front();
        return;
    case TextureReference::Kind::PerFrame:
        json["texture"]["per_frame"] = texture.paths.empty() ? "" : texture.paths.front();
        break;
    case TextureReference::Kind::PerMaterial:
        json["texture"]["per_material"] = texture.paths;
        break;
    }
    addUnknown(json["texture"], texture.unknown);
}

Json settingsToJson(const ProjectSettings& settings)
{
    Json json = Json::object();
    json["fps"] = settings.fps;
    addAxes(json, "up_axis", "unit", settings.axes);
    json["cache_megabytes"] = settings.cacheMegabytes;
    addUnknown(json, settings.unknown);
    return json;
}

Json characterToJson(const CharacterEntry& character)
{
    Json json = Json::object();
    json["name"] = character.name;
    addText(json, "mesh", character.mesh);
    addTexture(json, character.texture);
    addText(json, "notes", character.notes);
    addUnknown(json, character.unknown);
    return json;
}

/// \param withUnknown spans as they were read, with their unknown keys; a span that still stands gets them
/// back.
template <typename Span>
void addSpans(Json& json, const char* list, const std::vector<Span>& spans, std::string Span::*text,
              const char* textKey, const UnknownKeys& withUnknown)
{
    if (spans.empty())
        return;
    json[list] = Json::array();
    for (const Span& span : spans) {
        Json item = Json::object();
        item[textKey] = span.*text;
        item["frames"] = rangeToJson(span.frames);
        if (withUnknown.is_object() && withUnknown.contains(list)) {
            for (const Json& read : withUnknown[list]) {
                if (read[textKey] == item[textKey] && read["frames"] == item["frames"])
                    addUnknown(item, read);
            }
        }
        json[list].push_back(std::move(item));
    }
}

Json sequenceToJson(const SequenceEntry& sequence)
{
    Json json = Json::object();
    json["name"] = sequence.name;
    addText(json, "character", sequence.character);
    json["source"] = sequence.source;
    addText(json, "clip", sequence.clip);
    addRange(json, "range", sequence.range);
    addOptional(json, "source_fps", sequence.sourceFps);
    if (sequence.sourceAxes)
        addAxes(json, "source_up_axis", "source_unit", *sequence.sourceAxes);
    addTexture(json, sequence.texture);
    addSpans(json, "labels", sequence.labels, &LabelSpan::label, "label", sequence.unknownOfSpans);
    addSpans(json, "contacts", sequence.contacts, &ContactSpan::foot, "foot", sequence.unknownOfSpans);
    addText(json, "joint_angles", sequence.jointAngles);
    addNotes(json, sequence.unknown);
    addUnknown(json, sequence.unknown);
    return json;
}

Json graphToJson(const GraphEntry& graph)
{
    const GraphEntry usual;
    Json json = Json::object();
    addText(json, "character", graph.character);
    if (graph.pose.metric == PoseMetric::Euclidean)
        json["metric"] = "euclidean";
    addUnless(json, "stretch_weight", graph.pose.stretchWeight, usual.pose.stretchWeight);
    if (graph.cost == TransitionCost::Sum)
        json["cost"] = "sum";
    if (graph.costScale == CostScale::None)
        json["cost_scale"] = "none";
    if (graph.length == TransitionLength::Path)
        json["length"] = "path";
    addUnless(json, "contact_weight", graph.steps.contacts, usual.steps.contacts);
    addUnless(json, "velocity_weight", graph.steps.velocity, usual.steps.velocity);
    addUnless(json, "slope", graph.slope, usual.slope);
    if (graph.durations)
        json["durations"] = Json::array({graph.durations->first, graph.durations->second});
    json["alpha"] = graph.alpha;
    if (graph.smoothing != usual.smoothing)
        json["smoothing"] = graph.smoothing == CostSmoothing::Mean3 ? "3x3" : "5x5";
    addOptional(json, "d_max", graph.greatestDistance);
    addUnknown(json, graph.unknown);
    return json;
}

/// Entries of one for each character; without a list where there is one and it names none.
template <typename Entry>
void addOneOrEach(Json& json, const char* key, const std::vector<Entry>& entries,
                  Json (*toJson)(const Entry& entry))
{
    if (entries.size() == 1 && entries.front().character.empty()) {
        json[key] = toJson(entries.front());
        return;
    }
    for (const Entry& entry : entries)
        json[key].push_back(toJson(entry));
}

/// The name of the table alone where nothing else is given.
Json evaluationToJson(const EvaluationEntry& evaluation)
{
    Json json = Json::object();
    json["table"] = evaluation.table;
    addText(json, "character", evaluation.character);
    addFilled(json, "sequences", evaluation.sequences);
    addFilled(json, "alphas", evaluation.alphas);
    addOptional(json, "count", evaluation.count);
    addUnless(json, "seed", evaluation.seed, EvaluationEntry().seed);
    addUnknown(json, evaluation.unknown);
    return json.size() == 1 ? json["table"] : json;
}

Json exportToJson(const ExportEntry& entry)
{
    Json json = Json::object();
    json["name"] = entry.name;
    json["what"] = entry.what;
    json["path"] = entry.path;
    addText(json, "format", entry.format);
    addRange(json, "range", entry.range);
    addOptional(json, "fps", entry.fps);
    if (entry.axes)
        addAxes(json, "up_axis", "unit", *entry.axes);
    addUnless(json, "textures", entry.textures, true);
    if (!entry.picture.is_null())
        json["picture"] = entry.picture;
    addUnknown(json, entry.unknown);
    return json;
}

/// Puts broken entries back to where they stood.
void addBroken(Json& json, const std::vector<BrokenEntry>& broken)
{
    for (const BrokenEntry& entry : broken) {
        Json& section = json[entry.section];
        if (!entry.place && (section.empty() || entry.section == "settings")) {
            section = entry.json;
            continue;
        }
        if (!section.is_array())
            section = section.is_null() ? Json::array() : Json::array({section});
        const auto place = std::min(entry.place.value_or(0), section.size());
        section.insert(section.begin() + static_cast<std::ptrdiff_t>(place), entry.json);
    }
}

/// The keys in the order in which they are written.
Json inOrder(Json json)
{
    Json ordered = Json::object();
    for (const std::string_view known : projectkeys::document) {
        const std::string key(known);
        if (const auto found = json.find(key); found != json.end())
            ordered[key] = std::move(*found);
    }
    for (auto& [key, value] : json.items()) {
        if (!ordered.contains(key))
            ordered[key] = std::move(value);
    }
    return ordered;
}

} // namespace

Json projectToJson(const Project& project, WrittenEntries entries)
{
    Json json = Json::object();
    json["format"] = "quadrille-project";
    json["version"] = Project::currentVersion;
    json["settings"] = settingsToJson(project.settings);
    json["characters"] = Json::array();
    for (const CharacterEntry& character : project.characters)
        json["characters"].push_back(characterToJson(character));
    json["sequences"] = Json::array();
    for (const SequenceEntry& sequence : project.sequences)
        json["sequences"].push_back(sequenceToJson(sequence));
    addOneOrEach(json, "body_parts", project.bodyParts, bodyPartsToJson);
    addOneOrEach(json, "graph", project.graphs, graphToJson);
    for (const AnimationEntry& animation : project.animations)
        json["animations"].push_back(animationToJson(animation, project.settings.axes.up));
    for (const VariationEntry& variation : project.variations)
        json["variations"].push_back(variationToJson(variation));
    for (const EvaluationEntry& evaluation : project.evaluations)
        json["evaluations"].push_back(evaluationToJson(evaluation));
    json["exports"] = Json::array();
    for (const ExportEntry& entry : project.exports)
        json["exports"].push_back(exportToJson(entry));
    addUnknown(json, unknownKeys(project));
    const std::vector<BrokenEntry> broken = brokenEntries(project);
    if (entries == WrittenEntries::Usable || broken.empty())
        return json;
    addBroken(json, broken);
    return inOrder(std::move(json));
}

} // namespace quadrille
