// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"
#include "model/project/file/projectjson.h"
#include "model/project/file/usableproject.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/importsequences.h"
#include "tests/model/project/fullproject.h"

#include <gmock/gmock.h>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

/// A project with three sequences, the second of which has a name that no file may have, and what needs it.
constexpr std::string_view withSlash = R"({
  "format": "quadrille-project",
  "version": 1,
  "settings": {"fps": 30},
  "characters": [{"name": "ada", "mesh": "ada.obj"}],
  "sequences": [
    {"name": "walk", "source": "walk.pc2"},
    {"name": "take 1/2", "source": "take.pc2", "wish": {"kept": [1, 2.5, null]}},
    {"name": "jump", "source": "jump.pc2"}
  ],
  "animations": [
    {"name": "waltz", "constraints": [{"kind": "key", "sequence": "take 1/2", "frame": 3, "time": 0}]},
    {"name": "polka", "constraints": [{"kind": "key", "sequence": "jump", "frame": 3, "time": 0}]}
  ],
  "exports": [
    {"name": "a", "what": "animations/waltz", "path": "a.glb"},
    {"name": "b", "what": "sequences/walk", "path": "b.glb"}
  ]
}
)";

std::vector<std::string> namesOf(const auto& entries)
{
    std::vector<std::string> names;
    for (const auto& entry : entries)
        names.push_back(entry.name);
    return names;
}

/// Problems have another place in a text that is laid out otherwise.
Project withoutProblems(Project project)
{
    std::vector<BrokenEntry> broken = brokenEntries(project);
    for (BrokenEntry& entry : broken)
        entry.problem = {};
    setBrokenEntries(project, broken);
    return project;
}

} // namespace

TEST(UsableProject, WhatCannotBeReadIsKeptWithItsPlaceAndTheRestIsThere)
{
    const ProjectReading reading = readUsableProject(withSlash, "p.quadrille");
    const Project& project = reading.project;
    EXPECT_THAT(namesOf(project.sequences), ElementsAre("walk", "jump"));
    EXPECT_THAT(namesOf(project.animations), ElementsAre("polka"));
    EXPECT_THAT(namesOf(project.exports), ElementsAre("b"));
    const std::vector<BrokenEntry> broken = brokenEntries(project);
    EXPECT_THAT(titlesOf(broken), ElementsAre("sequences/take 1/2", "animations/waltz", "exports/a"));
    const BrokenEntry& take = broken[0];
    EXPECT_EQ(take.place, 1U);
    EXPECT_THAT(take.problem.toString(), HasSubstr("slashes"));
    EXPECT_EQ(take.problem.context.place.line, 8);
    EXPECT_EQ(take.problem.context.place.column, 14);
    EXPECT_TRUE(problemsWhenSaved(project).empty());
}

TEST(UsableProject, WhatCannotBeReadIsSavedBackUnchangedWhereItStood)
{
    const Project project = readUsableProject(withSlash, "p.quadrille").project;
    const Json before = Json::parse(withSlash);
    const Json after = projectToJson(project);
    EXPECT_EQ(after["sequences"][1], before["sequences"][1]);
    EXPECT_EQ(after["sequences"][1].dump(), before["sequences"][1].dump()) << "with its keys in their order";
    EXPECT_EQ(after["animations"][0], before["animations"][0]);
    EXPECT_EQ(after["exports"][0], before["exports"][0]);
    EXPECT_EQ(withoutProblems(readUsableProject(writeJson(after), "p").project), withoutProblems(project));
}

TEST(UsableProject, ACorrectedEntryBringsBackWhatNeedsIt)
{
    Project project = readUsableProject(withSlash, "p.quadrille").project;
    std::vector<BrokenEntry> broken = brokenEntries(project);
    broken[0].json.set("name", "take 1");
    Json constraints = broken[1].json.json()["constraints"];
    constraints[0]["sequence"] = "take 1";
    broken[1].json.set("constraints", constraints);
    setBrokenEntries(project, broken);
    const Project corrected = withBrokenReadAgain(project, "p.quadrille");
    EXPECT_TRUE(brokenEntries(corrected).empty());
    EXPECT_THAT(namesOf(corrected.sequences), ElementsAre("walk", "take 1", "jump"));
    EXPECT_THAT(namesOf(corrected.exports), ElementsAre("a", "b"));
}

TEST(UsableProject, AnySectionMayBeBrokenAndIsKept)
{
    const std::string head = R"({"format": "quadrille-project", "version": 1, )";
    for (const char* section :
         {R"("settings": {"fps": -1, "cache_megabytes": 64})", R"("settings": 7)", R"("sequences": 5)",
          R"("characters": {"name": "a"})", R"("graph": {"slope": 9})",
          R"("graph": [{"slope": 9}, {"slope": 3}])", R"("body_parts": {"parts": [{"name": "a/b"}]})",
          R"("sequences": [], "animations": ["waltz"])", R"("evaluations": ["fig99", "fig7"])",
          R"("exports": [{"name": "x"}, {"name": "x"}, null])"}) {
        const std::string text = head + section + "}";
        const Project project = readUsableProject(text, "p.quadrille").project;
        const std::vector<BrokenEntry> broken = brokenEntries(project);
        ASSERT_FALSE(broken.empty()) << section;
        const Json before = Json::parse(text);
        const Json after = projectToJson(project);
        const std::string key = broken.front().section;
        if (!before[key].is_array() || broken.size() == before[key].size()) {
            EXPECT_EQ(after[key], before[key]) << section;
        }
        EXPECT_EQ(withoutProblems(readUsableProject(writeJson(after), "p").project), withoutProblems(project))
            << section;
    }
}

TEST(UsableProject, OnlyWhatIsNoProjectIsRefused)
{
    EXPECT_THROW(readUsableProject("{", "p"), Error);
    EXPECT_THROW(readUsableProject(R"({"format": "other"})", "p"), Error);
    EXPECT_THROW(readUsableProject(R"({"format": "quadrille-project", "version": 99})", "p"), Error);
}

TEST(UsableProject, WhatAFileCannotHoldIsAProblemBeforeItIsSaved)
{
    EXPECT_TRUE(problemsWhenSaved(fullProject()).empty());
    const auto isRefused = [](const std::function<void(Project&)>& edit) {
        Project project = fullProject();
        edit(project);
        return !problemsWhenSaved(project).empty();
    };
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(isRefused([](Project& p) { p.sequences[0].name = ".."; }));
    EXPECT_TRUE(isRefused([](Project& p) { p.sequences[0].source = "walk\xff.pc2"; }));
    EXPECT_TRUE(isRefused([&](Project& p) { p.sequences[0].sourceFps = infinite; }));
    EXPECT_TRUE(isRefused([&](Project& p) { p.settings.axes.metresPerUnit = -1; }));
    EXPECT_TRUE(isRefused([&](Project& p) { p.settings.cacheMegabytes = 0; }));
    EXPECT_TRUE(isRefused([&](Project& p) {
        p.sequences[0].range = FrameRange{FrameIndex(-1), FrameIndex(3)};
    }));
}

TEST(UsableProject, AFileCalledLikeAClipIsNoClip)
{
    const TemporaryFolder folder;
    folder.write("clip:a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    importSequences(folder / "p.quadrille", {.sources = {folder / "clip:a.obj"}});
    const Project project = loadProject(folder / "p.quadrille");
    ASSERT_EQ(project.sequences.size(), 1U);
    EXPECT_EQ(project.sequences[0].source, "./clip:a.obj");
}

TEST(UsableProject, ASecondCharacterLeavesTheEntriesOfTheFirstToIt)
{
    const TemporaryFolder folder;
    const auto mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto file = folder / "p.quadrille";
    importSequences(file, {.sources = {mesh}, .character = "ada"});
    Project project = loadProject(file);
    project.graphs.emplace_back();
    project.animations = {{.name = "waltz"}};
    saveProject(project, file);
    importSequences(file, {.sources = {mesh}, .name = "other", .character = "bo"});
    project = loadProject(file);
    EXPECT_EQ(project.graphs[0].character, "ada");
    EXPECT_EQ(project.animations[0].character, "ada");
}
