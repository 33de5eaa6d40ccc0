// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/schema.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"
#include "tests/model/project/fullobjects.h"
#include "tests/model/project/fullproject.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

using namespace quadrille;
using namespace quadrille::test;

namespace {

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

/// The keys of an object in their order.
std::vector<std::string> keysOf(const Json& object)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items())
        keys.push_back(key);
    return keys;
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

TEST(Schema, IsInTheFileAsTheFieldsAreDescribed)
{
    const std::string made = writeJson(projectSchema());
    if (std::getenv("QUADRILLE_UPDATE_SCHEMA") != nullptr)
        std::ofstream(QUADRILLE_SCHEMA_FILE) << made;
    EXPECT_EQ(textOf(QUADRILLE_SCHEMA_FILE), made)
        << "Run this test with QUADRILLE_UPDATE_SCHEMA=1 to write the file anew.";
}

TEST(Schema, KeysAreWrittenInTheirOrder)
{
    const Json json = projectToJson(fullProject());
    const Json schema = projectSchema();
    EXPECT_EQ(keysOf(json), keysOf(schema["properties"]));
    for (const FullObject& object : fullObjects) {
        const std::vector<std::string> keys = keysOf(json[Json::json_pointer(object.place)]);
        std::vector<std::string> expected = keysOf(schema["definitions"][object.definition]["properties"]);
        if (!object.hasAllKeys)
            std::erase_if(expected, [&](const std::string& key) { return !std::ranges::count(keys, key); });
        EXPECT_EQ(keys, expected) << object.definition;
    }
}

TEST(Schema, LongSeedsAreReadToTheLastDigit)
{
    Project project = fullProject();
    project.variations[0].samples[0].seed = 9007199254740991;
    project.variations[0].learning.seed = 9007199254740990;
    project.evaluations[0].seed = 3'000'000'001;
    ProjectProblems problems;
    const Project read = readDocument(projectToJson(project), problems);
    EXPECT_EQ(read.variations, project.variations);
    EXPECT_EQ(read.evaluations, project.evaluations);
}

/// What the reader says of a number just beyond a limit of the schema, and at it.
TEST(Schema, LimitsAreThoseOfTheReader)
{
    const Json full = projectToJson(fullProject());
    const Json schema = projectSchema();
    int limits = 0;
    for (const FullObject& object : fullObjects) {
        const std::string place = object.place;
        for (const auto& [key, property] : schema["definitions"][object.definition]["properties"].items()) {
            for (const char* limit : {"minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"}) {
                if (!property.is_object() || !property.contains(limit))
                    continue;
                const double step = (std::string_view(limit).ends_with("inimum") ? -1 : 1);
                Json changed = full;
                const std::string pointer = place + "/" + key;
                changed[Json::json_pointer(pointer)] = property[limit].get<double>() + step;
                ProjectProblems problems;
                readDocument(changed, problems);
                EXPECT_TRUE(std::ranges::any_of(problems,
                                                [&](const ProjectProblem& problem) {
                                                    return problem.pointer == pointer ||
                                                           place == problem.pointer;
                                                }))
                    << object.definition << "." << key << ": " << limit;
                ++limits;
            }
        }
    }
    EXPECT_GT(limits, 60);
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
        {R"(, "evaluations": [{"table": "fig4", "seed": 9007199254740991}])", true},
        {R"(, "evaluations": [{"table": "fig4", "seed": 9007199254740992}])", false},
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
