// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animationjson.h"
#include "model/project/framenote.h"
#include "model/project/pictureoptions.h"
#include "model/project/projectjson.h"
#include "model/project/projectkeys.h"
#include "model/project/variationjson.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

ProjectSettings readSettings(const ObjectReader& reader)
{
    ProjectSettings settings;
    settings.fps = reader.number("fps").value_or(settings.fps);
    settings.axes = reader.axes("up_axis", "unit", settings.axes).value_or(settings.axes);
    if (const auto megabytes = reader.number("cache_megabytes")) {
        if (*megabytes >= 1 && *megabytes <= 1e9)
            settings.cacheMegabytes = static_cast<std::int64_t>(*megabytes);
        else
            reader.wrongType("cache_megabytes", "a positive number of megabytes");
    }
    settings.unknown = reader.unknown(projectkeys::settings);
    return settings;
}

/// "a.png", {"per_frame": "folder"} or {"per_material": ["a.png", …]}.
TextureReference readTexture(const ObjectReader& owner, ProjectProblems& problems)
{
    TextureReference texture;
    const Json* value = owner.find("texture");
    if (value == nullptr)
        return texture;
    if (value->is_string()) {
        if (!value->get<std::string>().empty())
            texture = {TextureReference::Kind::Single, {value->get<std::string>()}, {}};
        return texture;
    }
    if (!value->is_object()) {
        owner.wrongType("texture", "a file, or {\"per_frame\": …} or {\"per_material\": […]}");
        return texture;
    }
    const ObjectReader reader(*value, owner.pointer("texture"), problems);
    if (reader.find("per_frame") != nullptr) {
        texture.kind = TextureReference::Kind::PerFrame;
        texture.paths = {reader.text("per_frame")};
    } else if (reader.find("per_material") != nullptr) {
        texture.kind = TextureReference::Kind::PerMaterial;
        reader.each("per_material", [&](const Json& path, const std::string& pointer) {
            if (path.is_string())
                texture.paths.push_back(path.get<std::string>());
            else
                reader.invalid(pointer, "A texture file in quotes is expected here");
        });
    } else {
        reader.invalid(owner.pointer("texture"), "“per_frame” or “per_material” is missing here");
    }
    texture.unknown = reader.unknown(projectkeys::texture);
    return texture;
}

CharacterEntry readCharacter(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    const ObjectReader reader(json, pointer, problems);
    CharacterEntry character;
    character.name = reader.requiredText("name");
    character.mesh = reader.text("mesh");
    character.texture = readTexture(reader, problems);
    character.notes = reader.text("notes");
    character.unknown = reader.unknown(projectkeys::character);
    return character;
}

/// Spans of one list. Unknown keys go, with the span that they belong to, into `unknownOfSpans[list]`.
template <typename Span>
std::vector<Span> readSpans(const ObjectReader& owner, const char* list, std::string Span::*text,
                            const char* textKey, ObjectReader::Keys known, UnknownKeys& unknownOfSpans,
                            ProjectProblems& problems)
{
    std::vector<Span> spans;
    owner.each(list, [&](const Json& json, const std::string& pointer) {
        const ObjectReader reader(json, pointer, problems);
        Span span;
        span.*text = reader.requiredText(textKey);
        if (reader.find("frames") == nullptr)
            reader.invalid(reader.pointer("frames"), "“frames” is missing here");
        span.frames = reader.range("frames").value_or(FrameRange{});
        if (!reader.unknown(known).is_null())
            unknownOfSpans[list].push_back(json);
        spans.push_back(std::move(span));
    });
    return spans;
}

SequenceEntry readSequence(const Json& json, const std::string& pointer, const ProjectSettings& settings,
                           ProjectProblems& problems)
{
    const ObjectReader reader(json, pointer, problems);
    SequenceEntry sequence;
    sequence.name = reader.requiredText("name");
    sequence.character = reader.text("character");
    sequence.source = reader.requiredText("source");
    sequence.clip = reader.text("clip");
    sequence.range = reader.range("range");
    sequence.sourceFps = reader.number("source_fps");
    sequence.sourceAxes = reader.axes("source_up_axis", "source_unit", settings.axes);
    sequence.texture = readTexture(reader, problems);
    sequence.labels = readSpans(reader, "labels", &LabelSpan::label, "label", projectkeys::label,
                                sequence.unknownOfSpans, problems);
    sequence.contacts = readSpans(reader, "contacts", &ContactSpan::foot, "foot", projectkeys::contact,
                                  sequence.unknownOfSpans, problems);
    sequence.jointAngles = reader.text("joint_angles");
    sequence.unknown = reader.unknown(projectkeys::sequence);
    readNotes(reader, sequence.unknown);
    return sequence;
}

GraphEntry readGraph(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    const ObjectReader reader(json, pointer, problems);
    GraphEntry graph;
    graph.character = reader.text("character");
    reader.word("metric", graph.pose.metric,
                {{"surface", PoseMetric::Surface}, {"euclidean", PoseMetric::Euclidean}});
    graph.pose.stretchWeight = reader.number("stretch_weight").value_or(graph.pose.stretchWeight);
    reader.word("cost", graph.cost, {{"sum", TransitionCost::Sum}, {"mean", TransitionCost::Mean}});
    reader.word("cost_scale", graph.costScale,
                {{"none", CostScale::None}, {"liveliness", CostScale::Liveliness}});
    reader.word("length", graph.length,
                {{"path", TransitionLength::Path}, {"windows", TransitionLength::Windows}});
    graph.steps.contacts = reader.number("contact_weight").value_or(graph.steps.contacts);
    graph.steps.velocity = reader.number("velocity_weight").value_or(graph.steps.velocity);
    graph.slope = static_cast<int>(reader.wholeNumber("slope").value_or(graph.slope));
    if (const auto seconds = reader.numbers("durations", 2, "two numbers of seconds, [shortest, longest]"))
        graph.durations = {seconds->at(0), seconds->at(1)};
    graph.alpha = reader.number("alpha").value_or(graph.alpha);
    reader.word(
        "smoothing", graph.smoothing,
        {{"none", CostSmoothing::None}, {"3x3", CostSmoothing::Mean3}, {"5x5", CostSmoothing::Mean5}});
    graph.greatestDistance = reader.number("d_max");
    graph.unknown = reader.unknown(projectkeys::graph);
    return graph;
}

/// "fig7" or {"table": "fig7", …}.
EvaluationEntry readEvaluation(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    EvaluationEntry evaluation;
    if (json.is_string()) {
        evaluation.table = json.get<std::string>();
        return evaluation;
    }
    const ObjectReader reader(json, pointer, problems);
    evaluation.table = reader.requiredText("table");
    evaluation.character = reader.text("character");
    reader.each("sequences", [&](const Json& name, const std::string& place) {
        if (name.is_string())
            evaluation.sequences.push_back(name.get<std::string>());
        else
            reader.invalid(place, "The name of a sequence in quotes is expected here");
    });
    evaluation.alphas = reader.numbers("alphas", 0, "a list of numbers").value_or(std::vector<double>{});
    evaluation.count = reader.wholeNumber("count");
    evaluation.seed = reader.wholeNumber("seed").value_or(evaluation.seed);
    evaluation.unknown = reader.unknown(projectkeys::evaluation);
    return evaluation;
}

ExportEntry readExport(const Json& json, const std::string& pointer, const ProjectSettings& settings,
                       ProjectProblems& problems)
{
    const ObjectReader reader(json, pointer, problems);
    ExportEntry entry;
    entry.name = reader.requiredText("name");
    entry.what = reader.requiredText("what");
    entry.path = reader.requiredText("path");
    entry.format = reader.text("format");
    entry.range = reader.range("range");
    entry.fps = reader.number("fps");
    entry.axes = reader.axes("up_axis", "unit", settings.axes);
    entry.textures = reader.boolean("textures", entry.textures);
    if (const Json* picture = reader.find("picture")) {
        pictureFromJson(*picture, reader.pointer("picture"), problems);
        entry.picture = *picture;
    }
    entry.unknown = reader.unknown(projectkeys::exportEntry);
    return entry;
}

/// One character's may stand without a list.
template <typename Read>
void eachOrOne(const ObjectReader& reader, const char* key, const Read& read)
{
    const Json* one = reader.find(key);
    if (one != nullptr && one->is_object())
        read(*one, reader.pointer(key));
    else
        reader.each(key, read);
}

/// A section that others speak of must be there, if only to say that it is empty: one that is misspelt would
/// otherwise leave them without what they name.
void requireSequences(const ObjectReader& reader)
{
    if (reader.find("sequences") != nullptr)
        return;
    for (const char* section : {"animations", "variations"}) {
        const Json* entries = reader.find(section);
        if (entries == nullptr || entries->empty())
            continue;
        auto problem =
            invalidAt(reader.pointer(section),
                      "The section “sequences” is missing, which “" + std::string(section) + "” needs",
                      "Write \"sequences\": […] with one entry for each take.");
        problem.atKey = true;
        reader.problems().push_back(std::move(problem));
        return;
    }
}

} // namespace

Project projectFromJson(const Json& document, ProjectProblems& problems)
{
    const ObjectReader reader(document, "", problems);
    requireSequences(reader);
    Project project;
    if (const Json* settings = reader.find("settings"))
        project.settings = readSettings(ObjectReader(*settings, "/settings", problems));
    reader.each("characters", [&](const Json& json, const std::string& pointer) {
        project.characters.push_back(readCharacter(json, pointer, problems));
    });
    reader.each("sequences", [&](const Json& json, const std::string& pointer) {
        project.sequences.push_back(readSequence(json, pointer, project.settings, problems));
    });
    eachOrOne(reader, "body_parts", [&](const Json& json, const std::string& pointer) {
        project.bodyParts.push_back(readBodyParts({json, pointer, problems}));
    });
    eachOrOne(reader, "graph", [&](const Json& json, const std::string& pointer) {
        project.graphs.push_back(readGraph(json, pointer, problems));
    });
    reader.each("animations", [&](const Json& json, const std::string& pointer) {
        project.animations.push_back(readAnimation({json, pointer, problems}, project.settings.axes.up));
    });
    reader.each("variations", [&](const Json& json, const std::string& pointer) {
        project.variations.push_back(readVariation({json, pointer, problems}));
    });
    reader.each("evaluations", [&](const Json& json, const std::string& pointer) {
        project.evaluations.push_back(readEvaluation(json, pointer, problems));
    });
    reader.each("exports", [&](const Json& json, const std::string& pointer) {
        project.exports.push_back(readExport(json, pointer, project.settings, problems));
    });
    project.unknown = reader.unknown(projectkeys::document);
    return project;
}

} // namespace quadrille
