// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/lengthunit.h"
#include "model/project/pictureoptions.h"
#include "model/project/projectjson.h"
#include "model/project/projectkeys.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

using Keys = std::span<const std::string_view>;

/// Reads the members of one object, each with a type check.
class ObjectReader
{
public:
    ObjectReader(const Json& json, std::string pointer, ProjectProblems& problems)
        : m_json(json), m_pointer(std::move(pointer)), m_problems(problems)
    {
        if (!json.is_object())
            invalid(m_pointer, "An object in braces is expected here");
    }

    const Json* find(std::string_view key) const
    {
        if (!m_json.is_object())
            return nullptr;
        const auto found = m_json.find(std::string(key));
        return found == m_json.end() ? nullptr : &*found;
    }
    std::string pointer(std::string_view key) const { return m_pointer + "/" + escapePointer(key); }
    void invalid(const std::string& pointer, std::string reason, std::string remedy = {}) const
    {
        m_problems.push_back(invalidAt(pointer, std::move(reason), std::move(remedy)));
    }
    void wrongType(std::string_view key, const std::string& expected) const
    {
        invalid(pointer(key), "“" + std::string(key) + "” must be " + expected);
    }

    std::string text(std::string_view key) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return {};
        if (value->is_string())
            return value->get<std::string>();
        wrongType(key, "text in quotes");
        return {};
    }
    std::string requiredText(std::string_view key) const
    {
        if (m_json.is_object() && find(key) == nullptr)
            invalid(pointer(key), "“" + std::string(key) + "” is missing here");
        return text(key);
    }
    std::optional<double> number(std::string_view key) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return std::nullopt;
        if (value->is_number())
            return value->get<double>();
        wrongType(key, "a number");
        return std::nullopt;
    }
    bool truth(std::string_view key, bool otherwise) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return otherwise;
        if (value->is_boolean())
            return value->get<bool>();
        wrongType(key, "true or false");
        return otherwise;
    }
    std::optional<FrameRange> range(std::string_view key) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return std::nullopt;
        const auto isFrame = [](const Json& item) {
            return item.is_number_integer() && item.get<double>() >= 0 && item.get<double>() < 1e15;
        };
        if (value->is_array() && value->size() == 2 && isFrame((*value)[0]) && isFrame((*value)[1]))
            return FrameRange{FrameIndex((*value)[0].get<std::int64_t>()),
                              FrameIndex((*value)[1].get<std::int64_t>())};
        wrongType(key, "two frame numbers, [first, last]");
        return std::nullopt;
    }
    std::optional<UpAxis> upAxis(std::string_view key) const
    {
        if (find(key) == nullptr)
            return std::nullopt;
        const auto axis = upAxisFromString(text(key));
        if (!axis && find(key)->is_string())
            wrongType(key, "\"x\", \"y\" or \"z\"");
        return axis;
    }
    std::optional<double> unit(std::string_view key) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return std::nullopt;
        if (value->is_number() && value->get<double>() > 0 && std::isfinite(value->get<double>()))
            return value->get<double>();
        if (value->is_string()) {
            if (const auto metres = metresPerUnit(value->get<std::string>()))
                return metres;
        }
        wrongType(key, "\"m\", \"cm\", \"mm\", \"km\", \"in\", \"ft\" or the metres that one unit has");
        return std::nullopt;
    }
    /// Both keys are optional; what is not given is as in `otherwise`.
    std::optional<CoordinateSystem> axes(std::string_view upKey, std::string_view unitKey,
                                         const CoordinateSystem& otherwise) const
    {
        const auto up = upAxis(upKey);
        const auto metres = unit(unitKey);
        if (!up && !metres)
            return std::nullopt;
        return CoordinateSystem{up.value_or(otherwise.up), metres.value_or(otherwise.metresPerUnit)};
    }

    /// Calls `read(item, pointer)` for each item of an array member.
    template <typename Read>
    void each(std::string_view key, const Read& read) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        if (!value->is_array()) {
            wrongType(key, "a list in brackets");
            return;
        }
        for (std::size_t i = 0; i < value->size(); ++i)
            read((*value)[i], pointer(key) + "/" + std::to_string(i));
    }

    /// The members that are not among the known keys; null when there are none.
    UnknownKeys unknown(Keys known) const
    {
        UnknownKeys rest;
        if (!m_json.is_object())
            return rest;
        for (const auto& [key, value] : m_json.items()) {
            if (std::find(known.begin(), known.end(), key) != known.end())
                continue;
            rest[key] = value;
            if (const auto meant = projectkeys::closestWord(key, known); meant && find(*meant) == nullptr) {
                auto warning = warningAt(pointer(key), "The key “" + key + "” is not known and has no effect",
                                         "Did you mean “" + *meant + "”?");
                warning.atKey = true;
                m_problems.push_back(std::move(warning));
            }
        }
        return rest;
    }

private:
    const Json& m_json;
    std::string m_pointer;
    ProjectProblems& m_problems;
};

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
                            const char* textKey, Keys known, UnknownKeys& unknownOfSpans,
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
    return sequence;
}

/// One of some words; what is given otherwise is a problem and leaves the default.
template <typename Value>
void readWord(const ObjectReader& reader, std::string_view key, Value& value,
              std::initializer_list<std::pair<const char*, Value>> words)
{
    if (reader.find(key) == nullptr)
        return;
    const std::string given = reader.text(key);
    std::string known;
    for (const auto& [word, meant] : words) {
        if (given == word) {
            value = meant;
            return;
        }
        known += (known.empty() ? "\"" : " or \"") + std::string(word) + "\"";
    }
    if (reader.find(key)->is_string())
        reader.wrongType(key, known);
}

GraphEntry readGraph(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    const ObjectReader reader(json, pointer, problems);
    GraphEntry graph;
    graph.character = reader.text("character");
    readWord(reader, "metric", graph.pose.metric,
             {{"surface", PoseMetric::Surface}, {"euclidean", PoseMetric::Euclidean}});
    graph.pose.stretchWeight = reader.number("stretch_weight").value_or(graph.pose.stretchWeight);
    readWord(reader, "cost", graph.cost, {{"sum", TransitionCost::Sum}, {"mean", TransitionCost::Mean}});
    if (const auto slope = reader.number("slope")) {
        graph.slope = static_cast<int>(*slope);
        if (*slope != graph.slope)
            reader.wrongType("slope", "a whole number");
    }
    if (const Json* value = reader.find("durations")) {
        if (value->is_array() && value->size() == 2 && (*value)[0].is_number() && (*value)[1].is_number())
            graph.durations = {(*value)[0].get<double>(), (*value)[1].get<double>()};
        else
            reader.wrongType("durations", "two numbers of seconds, [shortest, longest]");
    }
    graph.alpha = reader.number("alpha").value_or(graph.alpha);
    graph.greatestDistance = reader.number("d_max");
    graph.unknown = reader.unknown(projectkeys::graph);
    return graph;
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
    entry.textures = reader.truth("textures", entry.textures);
    if (const Json* picture = reader.find("picture")) {
        pictureFromJson(*picture, reader.pointer("picture"), problems);
        entry.picture = *picture;
    }
    entry.unknown = reader.unknown(projectkeys::exportEntry);
    return entry;
}

} // namespace

Project projectFromJson(const Json& document, ProjectProblems& problems)
{
    const ObjectReader reader(document, "", problems);
    Project project;
    if (const Json* settings = reader.find("settings"))
        project.settings = readSettings(ObjectReader(*settings, "/settings", problems));
    reader.each("characters", [&](const Json& json, const std::string& pointer) {
        project.characters.push_back(readCharacter(json, pointer, problems));
    });
    reader.each("sequences", [&](const Json& json, const std::string& pointer) {
        project.sequences.push_back(readSequence(json, pointer, project.settings, problems));
    });
    // One character's may stand without a list.
    if (const Json* graph = reader.find("graph"); graph != nullptr && graph->is_object()) {
        project.graphs.push_back(readGraph(*graph, "/graph", problems));
    } else {
        reader.each("graph", [&](const Json& json, const std::string& pointer) {
            project.graphs.push_back(readGraph(json, pointer, problems));
        });
    }
    reader.each("exports", [&](const Json& json, const std::string& pointer) {
        project.exports.push_back(readExport(json, pointer, project.settings, problems));
    });
    project.unknown = reader.unknown(projectkeys::document);
    return project;
}

} // namespace quadrille
