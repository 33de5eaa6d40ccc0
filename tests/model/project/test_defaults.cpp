// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/project/fields/pictureoptions.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"
#include "model/project/steps/walkrequest.h"
#include "tests/model/project/fullobjects.h"
#include "tests/model/project/fullproject.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <map>
#include <regex>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;

namespace {

/// Defaults by entry and key.
using Defaults = std::map<std::string, std::map<std::string, Json>>;

const FullObject* fullObject(const std::string& definition)
{
    const auto* found = std::ranges::find(fullObjects, definition, &FullObject::definition);
    return found == std::end(fullObjects) ? nullptr : found;
}

const Json& definitions()
{
    static const Json json = Json::parse(textOf(QUADRILLE_SCHEMA_FILE))["definitions"];
    return json;
}

Defaults ofSchema()
{
    Defaults defaults;
    for (const auto& [name, definition] : definitions().items()) {
        if (!definition.contains("properties"))
            continue;
        const FullObject* object = fullObject(name);
        const std::string entry = object != nullptr && object->entry != nullptr ? object->entry : name;
        for (const auto& [key, property] : definition["properties"].items())
            if (property.contains("default"))
                defaults[entry][key] = property["default"];
    }
    return defaults;
}

std::string manualPage(const std::string& language, const std::string& page)
{
    return textOf(std::filesystem::path(QUADRILLE_HELP_FOLDER) / language / page);
}

/// Rows of the table of defaults: | `entry` | `key: value`, … |
Defaults ofManual(const std::string& language)
{
    const std::string page = manualPage(language, "project.md");
    const std::regex row(R"(\n\| `([a-z_.]+)` \| (`[a-z_]+: [^|]+) \|)");
    const std::regex cell(R"re(`([a-z_]+): ([^`]+)`)re");
    Defaults defaults;
    for (std::sregex_iterator r(page.begin(), page.end(), row), end; r != end; ++r) {
        const std::string cells = (*r)[2];
        for (std::sregex_iterator c(cells.begin(), cells.end(), cell); c != end; ++c)
            defaults[(*r)[1]][(*c)[1]] = Json::parse((*c)[2].str());
    }
    return defaults;
}

/// The project with what code takes where nothing is written.
Project effective(const Json& document)
{
    ProjectProblems problems;
    Project project = projectFromJson(document, problems);
    EXPECT_TRUE(problems.empty()) << problems.front().toString() << problems.back().toString();
    for (GraphEntry& graph : project.graphs)
        graph.durations = graph.durations.value_or(usualDurations);
    for (EvaluationEntry& evaluation : project.evaluations)
        if (evaluation.alphas.empty())
            evaluation.alphas.assign(figure9Alphas.begin(), figure9Alphas.end());
    for (AnimationEntry& animation : project.animations) {
        for (ConstraintEntry& constraint : animation.constraints)
            if (auto* action = std::get_if<ActionEntry>(&constraint))
                action->leastShare = action->leastShare.value_or(Action().leastShare);
        SearchEntry& search = animation.search;
        constexpr double fps = 1000;
        search.isPaper = false;
        const SearchSettings settings = searchSettings(search, fps);
        search.budget = settings.budget;
        search.mu = settings.mu;
        search.dwell = settings.leastRun / fps;
        search.deadZone = settings.charging.deadZone;
        search.steering = std::round(settings.steering.perMetre * 180 / std::numbers::pi * 1e9) / 1e9;
    }
    for (ExportEntry& entry : project.exports)
        entry.picture = pictureToJson(pictureFromJson(entry.picture, "", problems));
    return project;
}

} // namespace

TEST(Defaults, OfTheSchemaAreThoseOfTheCode)
{
    const Json full = projectToJson(fullProject());
    for (const auto& [name, definition] : definitions().items()) {
        if (!definition.contains("properties"))
            continue;
        for (const auto& [key, property] : definition["properties"].items()) {
            if (!property.contains("default"))
                continue;
            const FullObject* object = fullObject(name);
            ASSERT_NE(object, nullptr) << name;
            const Json::json_pointer place(object->place);
            Json without = full;
            ASSERT_EQ(without[place].erase(key), 1U) << name << "." << key;
            Json with = without;
            with[place][key] = property["default"];
            EXPECT_EQ(effective(with), effective(without)) << name << "." << key;
        }
    }
}

TEST(Defaults, OfTheManualAreThoseOfTheSchema)
{
    const Defaults schema = ofSchema();
    EXPECT_GT(schema.size(), 20U);
    for (const char* language : {"en", "fr"})
        EXPECT_EQ(ofManual(language), schema) << language;
}

/// “`stretch_weight` (0.01)”, “`dwell` is the least time between two transitions (0.5 seconds)”.
TEST(Defaults, InTheTextOfTheManualAreThoseOfTheSchema)
{
    const std::regex stated(
        R"re(`([a-z_]+)`[^`()|]{0,60}\(([0-9.]+)( seconds?| secondes?| metres| mètres?)?\))re");
    const Defaults schema = ofSchema();
    int found = 0;
    for (const char* language : {"en", "fr"}) {
        for (const char* name : {"project.md", "animating.md", "variations.md", "graph.md"}) {
            const std::string page = manualPage(language, name);
            for (std::sregex_iterator match(page.begin(), page.end(), stated), end; match != end; ++match) {
                bool isKnown = false;
                bool isRight = false;
                for (const auto& [entry, keys] : schema) {
                    if (const auto key = keys.find((*match)[1]); key != keys.end()) {
                        isKnown = true;
                        isRight |= key->second == Json::parse((*match)[2].str());
                    }
                }
                EXPECT_TRUE(!isKnown || isRight) << language << "/" << name << ": " << match->str();
                found += isKnown ? 1 : 0;
            }
        }
    }
    EXPECT_GT(found, 8);
}

TEST(Defaults, OfBetaAreTenTimesAlphaEverywhere)
{
    EXPECT_EQ(betaPerAlpha, 10);
    EXPECT_FALSE(searchSettings({}, 25).beta);
    const std::string description = definitions()["search"]["properties"]["beta"]["description"];
    EXPECT_THAT(description, HasSubstr("ten times the graph's alpha"));
    EXPECT_THAT(manualPage("en", "project.md"), HasSubstr("`beta` is ten times the graph's `alpha`"));
    EXPECT_THAT(manualPage("fr", "project.md"), HasSubstr("`beta` vaut dix fois l’`alpha` du graphe"));
}

TEST(Defaults, OfTheStyleOfThePaperAreAsTheManualSays)
{
    SearchEntry paper;
    paper.isPaper = true;
    for (const char* language : {"en", "fr"})
        EXPECT_THAT(manualPage(language, "project.md"),
                    ::testing::ContainsRegex("`budget` (is|vaut) " +
                                             std::to_string(searchSettings(paper, 25).budget)));
}
