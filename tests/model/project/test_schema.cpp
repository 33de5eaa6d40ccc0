// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/jsontext.h"
#include "model/project/projectjson.h"
#include "model/project/projectkeys.h"
#include "tests/model/project/fullproject.h"

#include <gmock/gmock.h>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

using namespace quadrille;
using namespace quadrille::test;

namespace {

using Keys = std::set<std::string>;

nlohmann::json schemaJson()
{
    return nlohmann::json::parse(textOf(QUADRILLE_SCHEMA_FILE));
}

bool isValid(const std::string& text)
{
    static const auto json = schemaJson();
    valijson::Schema schema;
    valijson::SchemaParser parser;
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(json), schema);
    const auto document = nlohmann::json::parse(text);
    valijson::Validator validator;
    return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

Keys propertiesOf(const nlohmann::json& definition)
{
    Keys keys;
    for (const auto& [key, value] : definition["properties"].items())
        keys.insert(key);
    return keys;
}

Keys keysOf(std::span<const std::string_view> keys)
{
    return {keys.begin(), keys.end()};
}

std::vector<std::string> written(const Json& object)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items())
        keys.push_back(key);
    return keys;
}

std::vector<std::string> listOf(std::span<const std::string_view> keys)
{
    return {keys.begin(), keys.end()};
}

std::string withRest(const std::string& rest)
{
    std::string text = R"({"format": "quadrille-project", "version": 1)";
    return text.append(rest).append("}");
}

/// An export with this "picture".
std::string picture(const std::string& json)
{
    std::string text = R"(, "sequences": [{"name": "s", "source": "s"}], "exports": [{"name": "e", )";
    return text.append(R"("what": "sequences/s", "path": "e.png", "picture": )").append(json).append("}]");
}

/// An animation with these members.
std::string animation(const std::string& members)
{
    std::string text = R"(, "sequences": [{"name": "s", "source": "s"}], "graph": {}, "animations": [{)";
    return text.append(R"("name": "a", )").append(members).append("}]");
}

/// An animation of a walk, with these members beside it.
std::string walkAnd(const std::string& members)
{
    return animation(R"("walk": {"spans": [{"sequence": "s", "frames": [0, 3]}]}, )" + members);
}

} // namespace

TEST(Schema, KnowsTheKeysThatTheCodeKnows)
{
    const auto schema = schemaJson();
    const auto& definitions = schema["definitions"];
    EXPECT_EQ(propertiesOf(schema), keysOf(projectkeys::document));
    EXPECT_EQ(propertiesOf(definitions["settings"]), keysOf(projectkeys::settings));
    EXPECT_EQ(propertiesOf(definitions["character"]), keysOf(projectkeys::character));
    EXPECT_EQ(propertiesOf(definitions["sequence"]), keysOf(projectkeys::sequence));
    EXPECT_EQ(propertiesOf(definitions["graph"]), keysOf(projectkeys::graph));
    EXPECT_EQ(propertiesOf(definitions["evaluation"]), keysOf(projectkeys::evaluation));
    EXPECT_EQ(propertiesOf(definitions["animation"]), keysOf(projectkeys::animation));
    EXPECT_EQ(propertiesOf(definitions["frame_choice"]), keysOf(projectkeys::frameChoice));
    EXPECT_EQ(propertiesOf(definitions["key"]), keysOf(projectkeys::key));
    EXPECT_EQ(propertiesOf(definitions["path"]), keysOf(projectkeys::path));
    EXPECT_EQ(propertiesOf(definitions["path_span"]), keysOf(projectkeys::pathSpan));
    EXPECT_EQ(propertiesOf(definitions["obstacle"]), keysOf(projectkeys::obstacle));
    EXPECT_EQ(propertiesOf(definitions["action"]), keysOf(projectkeys::action));
    EXPECT_EQ(propertiesOf(definitions["search"]), keysOf(projectkeys::search));
    EXPECT_EQ(propertiesOf(definitions["junctions"]), keysOf(projectkeys::junctions));
    EXPECT_EQ(propertiesOf(definitions["walk"]), keysOf(projectkeys::walk));
    EXPECT_EQ(propertiesOf(definitions["post"]), keysOf(projectkeys::post));
    EXPECT_EQ(propertiesOf(definitions["varied_repeats"]), keysOf(projectkeys::variedRepeats));
    EXPECT_EQ(propertiesOf(definitions["loop"]), keysOf(projectkeys::loop));
    EXPECT_EQ(propertiesOf(definitions["contact_correction"]), keysOf(projectkeys::contactCorrection));
    EXPECT_EQ(propertiesOf(definitions["retime"]), keysOf(projectkeys::retime));
    EXPECT_EQ(propertiesOf(definitions["audio"]), keysOf(projectkeys::audio));
    EXPECT_EQ(propertiesOf(definitions["camera_key"]), keysOf(projectkeys::cameraKey));
    EXPECT_EQ(propertiesOf(definitions["note"]), keysOf(projectkeys::note));
    EXPECT_EQ(propertiesOf(definitions["body_parts"]), keysOf(projectkeys::bodyParts));
    EXPECT_EQ(propertiesOf(definitions["part_curve"]), keysOf(projectkeys::partCurve));
    EXPECT_EQ(propertiesOf(definitions["part"]), keysOf(projectkeys::part));
    EXPECT_EQ(propertiesOf(definitions["named_frame"]), keysOf(projectkeys::namedFrame));
    EXPECT_EQ(propertiesOf(definitions["variation"]), keysOf(projectkeys::variation));
    EXPECT_EQ(propertiesOf(definitions["training"]), keysOf(projectkeys::training));
    EXPECT_EQ(propertiesOf(definitions["blend"]), keysOf(projectkeys::blend));
    EXPECT_EQ(propertiesOf(definitions["across_blend"]), keysOf(projectkeys::acrossBlend));
    EXPECT_EQ(propertiesOf(definitions["learning"]), keysOf(projectkeys::learning));
    EXPECT_EQ(propertiesOf(definitions["sampling"]), keysOf(projectkeys::sampling));
    EXPECT_EQ(propertiesOf(definitions["variation_limits"]), keysOf(projectkeys::variationLimits));
    EXPECT_EQ(propertiesOf(definitions["samples"]), keysOf(projectkeys::samples));
    EXPECT_EQ(propertiesOf(definitions["across_samples"]), keysOf(projectkeys::acrossSamples));
    EXPECT_EQ(propertiesOf(definitions["export"]), keysOf(projectkeys::exportEntry));
    EXPECT_EQ(propertiesOf(definitions["picture"]), keysOf(projectkeys::picture));
    EXPECT_EQ(propertiesOf(definitions["view"]), keysOf(projectkeys::view));
    EXPECT_EQ(propertiesOf(definitions["texture_files"]), keysOf(projectkeys::texture));
    EXPECT_EQ(propertiesOf(definitions["label"]), keysOf(projectkeys::label));
    EXPECT_EQ(propertiesOf(definitions["contact"]), keysOf(projectkeys::contact));
}

TEST(Schema, TheCodeWritesItsKeysInTheirOrder)
{
    const Json json = projectToJson(fullProject());
    EXPECT_EQ(written(json), listOf(projectkeys::document));
    EXPECT_EQ(written(json["settings"]), listOf(projectkeys::settings));
    EXPECT_EQ(written(json["characters"][0]), listOf(projectkeys::character));
    EXPECT_EQ(written(json["sequences"][0]), listOf(projectkeys::sequence));
    EXPECT_EQ(written(json["sequences"][0]["labels"][0]), listOf(projectkeys::label));
    EXPECT_EQ(written(json["sequences"][0]["contacts"][0]), listOf(projectkeys::contact));
    EXPECT_EQ(written(json["graph"][0]), listOf(projectkeys::graph));
    EXPECT_EQ(written(json["evaluations"][0]), listOf(projectkeys::evaluation));
    const Json& animation = json["animations"][0];
    EXPECT_EQ(written(animation), listOf(projectkeys::animation));
    EXPECT_EQ(written(animation["constraints"][0]), listOf(projectkeys::path));
    EXPECT_EQ(written(animation["constraints"][1]), listOf(projectkeys::key));
    EXPECT_EQ(written(animation["search"]), listOf(projectkeys::search));
    EXPECT_EQ(written(animation["junctions"]), listOf(projectkeys::junctions));
    EXPECT_EQ(written(animation["walk"]), listOf(projectkeys::walk));
    EXPECT_EQ(written(animation["post"]), listOf(projectkeys::post));
    EXPECT_EQ(written(animation["post"]["variations"]), listOf(projectkeys::variedRepeats));
    EXPECT_EQ(written(animation["post"]["loop"]), listOf(projectkeys::loop));
    EXPECT_EQ(written(animation["post"]["contact_correction"]), listOf(projectkeys::contactCorrection));
    EXPECT_EQ(written(animation["audio"]), listOf(projectkeys::audio));
    EXPECT_EQ(written(animation["camera"][0]), listOf(projectkeys::cameraKey));
    EXPECT_EQ(written(animation["notes"][0]), listOf(projectkeys::note));
    EXPECT_EQ(written(json["sequences"][0]["notes"][0]), listOf(projectkeys::note));
    EXPECT_EQ(written(json["body_parts"][0]), listOf(projectkeys::bodyParts));
    EXPECT_EQ(written(json["body_parts"][0]["curves"][0]), listOf(projectkeys::partCurve));
    EXPECT_EQ(written(json["body_parts"][0]["parts"][1]), listOf(projectkeys::part));
    const Json& variation = json["variations"][0];
    EXPECT_EQ(written(variation), listOf(projectkeys::variation));
    EXPECT_EQ(written(variation["sequences"][0]), listOf(projectkeys::training));
    EXPECT_EQ(written(variation["template"]), listOf(projectkeys::namedFrame));
    EXPECT_EQ(written(variation["blends"][0]), listOf(projectkeys::blend));
    EXPECT_EQ(written(variation["blends"][0]["across"]), listOf(projectkeys::acrossBlend));
    EXPECT_EQ(written(variation["learning"]), listOf(projectkeys::learning));
    EXPECT_EQ(written(variation["sampling"]), listOf(projectkeys::sampling));
    EXPECT_EQ(written(variation["limits"]), listOf(projectkeys::variationLimits));
    EXPECT_EQ(written(variation["samples"][0]), listOf(projectkeys::samples));
    EXPECT_EQ(written(variation["samples"][0]["across"]), listOf(projectkeys::acrossSamples));
    EXPECT_EQ(written(json["exports"][0]), listOf(projectkeys::exportEntry));
    EXPECT_EQ(written(json["exports"][0]["picture"]), listOf(projectkeys::picture));
    EXPECT_EQ(written(json["exports"][0]["picture"]["view"]), listOf(projectkeys::view));
}

TEST(Schema, AcceptsWhatSaveProjectWrites)
{
    const TemporaryFolder folder;
    saveProject(fullProject(), folder / "full.quadrille");
    EXPECT_TRUE(isValid(textOf(folder / "full.quadrille")));
    saveProject({}, folder / "empty.quadrille");
    EXPECT_TRUE(isValid(textOf(folder / "empty.quadrille")));
}

TEST(Schema, AgreesWithTheReaderOnHandWrittenFiles)
{
    const std::pair<std::string, bool> cases[] = {
        {"", true},
        {R"(, "settings": {"fps": 30, "up_axis": "Z", "unit": 0.0254, "mine": true})", true},
        {R"(, "settings": {"fps": 0})", false},
        {R"(, "settings": {"fps": "30"})", false},
        {R"(, "settings": {"up_axis": "up"})", false},
        {R"(, "settings": {"unit": -1})", false},
        {R"(, "settings": {"cache_megabytes": 0})", false},
        {R"(, "characters": [{"name": "a", "texture": {"per_material": ["a.png"]}}])", true},
        {R"(, "characters": [{"name": "a", "texture": {"colour": "red"}}])", false},
        {R"(, "characters": [{"name": "a/b"}])", false},
        {R"(, "characters": [{"mesh": "a.obj"}])", false},
        {R"(, "sequences": [{"name": "s", "source": "s.pc2", "range": [0, 5], "section": "later"}])", true},
        {R"(, "sequences": [{"name": "s", "source": "s.pc2", "range": [0, 5, 9]}])", false},
        {R"(, "sequences": [{"name": "s", "source": "s.pc2", "range": [0, 5.5]}])", false},
        {R"(, "sequences": [{"name": "s", "source": "s.pc2", "labels": [{"label": "x"}]}])", false},
        {R"(, "sequences": [{"name": "s"}])", false},
        {R"(, "sequences": {})", false},
        {R"(, "exports": [{"name": "e", "what": "sequences/s", "path": "e.obj", "textures": "no"}])", false},
        {R"(, "evaluations": ["fig7", {"table": "fig9", "alphas": [0, 0.1], "mine": true}])", true},
        {R"(, "evaluations": ["fig8"])", false},
        {R"(, "evaluations": "fig7")", false},
        {R"(, "evaluations": [{"alphas": [0.1]}])", false},
        {R"(, "evaluations": [{"table": "fig9", "alphas": [-0.1]}])", false},
        {R"(, "evaluations": [{"table": "fig9", "alphas": 0.1}])", false},
        {R"(, "evaluations": [7])", false},
        {R"(, "evaluations": [{"table": "fig4", "count": 5, "seed": 0}])", true},
        {R"(, "evaluations": [{"table": "fig4", "count": 0}])", false},
        {R"(, "evaluations": [{"table": "fig4", "count": 1.5}])", false},
        {R"(, "evaluations": [{"table": "fig4", "seed": -1}])", false},
        {R"(, "evaluations": [{"table": "fig4", "seed": "x"}])", false},
        {R"(, "evaluations": [{"table": "fig11", "sequences": [1, 2]}])", false},
        {animation(R"("constraints": [{"kind": "path", "points": [[0, 0], [1, 2]]}])"), true},
        {animation(R"("constraints": [{"kind": "path", "points": [[0, 0, 1], [1, 2, 1]]}])"), true},
        {animation(R"("constraints": [{"kind": "path", "points": [[0, 0], [1]]}])"), false},
        {animation(R"("constraints": [{"kind": "path", "points": [[0, 0], [20000000, 2]]}])"), false},
        {R"(, "settings": {"unit": "mm"})" +
             animation(R"("constraints": [{"kind": "path", "points": [[0, 0], [5000000, 2]]}])"),
         true}, // five kilometres
        {animation(R"("constraints": [{"kind": "path", "points": [[0, 0]]}])"), false},
        {animation(R"("constraints": [{"kind": "key", "sequence": "s", "frame": 3, "time": 2}])"), true},
        {animation(R"("constraints": [{"kind": "key", "sequence": "s", "frame": 3}])"), false},
        {animation(R"("constraints": [{"kind": "key", "sequence": "s", "frame": 0.5, "time": 2}])"), false},
        {animation(R"("constraints": [{"kind": "action", "sequence": "s", "repeat": 2}])"), true},
        {animation(R"("constraints": [{"kind": "action", "repeat": 2}])"), false},
        {animation(R"("constraints": [{"kind": "action", "sequence": "s", "repeat": 0}])"), false},
        {animation(R"("constraints": [{"kind": "dance"}])"), false},
        {animation(R"("walk": {"spans": [{"sequence": "s", "frames": [0, 3]}]})"), true},
        {animation(R"("walk": {"spans": [{"sequence": "s"}]})"), false},
        {animation(R"("walk": {"spans": []})"), false},
        {walkAnd(R"("post": {"loop": true, "repeats": 2, "retime": {"factor": 2}})"), true},
        {walkAnd(R"("post": {"loop": {"in_place": true}, "contact_correction": true})"), true},
        {walkAnd(R"("post": {"variations": true})"), true},
        {walkAnd(R"("post": {"variations": {"ease": 0}})"), true},
        {walkAnd(R"("post": {"variations": {"ease": -1}})"), false},
        {walkAnd(R"("post": {"variations": "chat"})"), false},
        {walkAnd(R"("post": {"retime": {"factor": 0}})"), false},
        {walkAnd(R"("post": {"retime": {"curve": [[0, 0]]}})"), false},
        {walkAnd(R"("post": {"loop": "yes"})"), false},
        {walkAnd(R"("junctions": {"banned": [[["s", 1], ["s", 2]]]})"), true},
        {walkAnd(R"("junctions": {"banned": [["s", 1, "s", 2]]})"), false},
        {walkAnd(R"("junctions": {"walk": [{"sequence": "s", "frames": [1, 4]}]})"), true},
        {walkAnd(R"("junctions": {"walk": [{"sequence": "s"}]})"), false},
        {walkAnd(R"("search": {"budget": 0})"), false},
        {walkAnd(R"("interpolation": "cubic")"), false},
        {animation(R"("constraints": [])"), true}, // not finished
        {walkAnd(R"("audio": {"file": "a.wav", "offset": -2, "gain": 3})"), true},
        {walkAnd(R"("audio": {"offset": 1})"), false},
        {walkAnd(R"("audio": "a.wav")"), false},
        {walkAnd(R"("audio": {"file": "a.wav", "gain": 41})"), false},
        {walkAnd(R"("camera": [{"time": 0, "target": [0, 1, 0], "distance": 3}])"), true},
        {walkAnd(R"("camera": [{"time": 0, "target": [0, 1], "distance": 3}])"), false},
        {walkAnd(R"("camera": [{"time": 0, "target": [0, 1, 0], "distance": 0}])"), false},
        {walkAnd(R"("camera": [{"time": -1, "target": [0, 1, 0], "distance": 3}])"), false},
        {walkAnd(R"("camera": [{"time": 0, "target": [0, 1, 0], "distance": 3, "elevation": 91}])"), false},
        {walkAnd(R"("camera": [{"time": 0, "target": [0, 1, 0], "distance": 3, "fov": 0}])"), false},
        {walkAnd(R"("camera": [{"target": [0, 1, 0], "distance": 3}])"), false},
        {walkAnd(R"("notes": [{"frame": 3, "text": "slips", "by": "me"}])"), true},
        {walkAnd(R"("notes": [{"frame": -3, "text": "slips"}])"), false},
        {walkAnd(R"("notes": [{"text": "slips"}])"), false},
        {walkAnd(R"("notes": ["slips"])"), false},
        {walkAnd(R"("notes": "slips")"), false},
        {picture(R"({"camera": "fixed", "view": {"eye": [0, 1, 4]}, "mine": 1})"), true},
        {picture(R"({"camera": "drone"})"), false},
        {picture(R"({"width": 0})"), false},
        {picture(R"({"height": "tall"})"), false},
        {picture(R"({"grid": 1})"), false},
        {picture(R"({"view": {"eye": [1, 2]}})"), false},
        {picture(R"({"view": {"fov": 0}})"), false},
        {picture(R"([])"), false},
    };
    for (const auto& [rest, expected] : cases) {
        const std::string text = withRest(rest);
        EXPECT_EQ(isValid(text), expected) << text;
        const auto reading = readProject(text, "p.quadrille");
        EXPECT_EQ(!hasErrors(reading.problems), expected) << text;
    }
}
