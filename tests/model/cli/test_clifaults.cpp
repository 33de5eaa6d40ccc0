// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"
#include "tests/model/cli/clifixture.h"

#include <cstdlib>
#include <sys/stat.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Cli, AMissingSectionIsSaidPlainlyWithItsPlace)
{
    importSeries();
    std::string text = textOf(folder / "p.quadrille");
    text.replace(text.find("\"sequences\""), std::string_view("\"sequences\"").size(), "\"sequnces\"");
    const std::string_view empty = "\"exports\": []";
    text.replace(
        text.find(empty), empty.size(),
        "\"animations\": [ { \"name\": \"dance\", \"constraints\": "
        "[ { \"kind\": \"path\", \"points\": [ [0, 0], [1, 1] ] } ] } ],\n"
        "  \"exports\": [ { \"name\": \"e\", \"what\": \"animations/dance\", \"path\": \"e.obj\" } ]");
    folder.write("p.quadrille", text);
    for (const char* command : {"check", "rebuild"}) {
        const Outcome outcome = run({command, "p.quadrille"});
        EXPECT_EQ(outcome.status, 1) << command;
        EXPECT_THAT(outcome.err,
                    HasSubstr("The key “sequnces” is not known here and has no effect. Did you mean "
                              "“sequences”? (line "))
            << command;
        EXPECT_THAT(outcome.err, HasSubstr("The section “sequences” is missing")) << command;
        EXPECT_THAT(outcome.err, Not(HasSubstr("map::at"))) << command;
    }
}

TEST_F(Cli, WhatIsMadeFromTakesThatAreNotThereFailsWithASentence)
{
    folder.write("p.quadrille", R"({ "format": "quadrille-project", "version": 1, "sequences": [],
  "animations": [ { "name": "dance", "constraints": [ { "kind": "path", "points": [ [0, 0], [1, 1] ] } ] } ],
  "exports": [ { "name": "e", "what": "animations/dance", "path": "e.obj" } ] })");
    const Outcome outcome = run({"rebuild", "p.quadrille"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("There are no takes that “exports/e” could be made from"));
}

TEST_F(Cli, APipeAsTakeIsRefusedAndNotWaitedFor)
{
    writeObjSeries(folder);
    ASSERT_EQ(::mkfifo((folder / "take.pc2").c_str(), 0600), 0);
    folder.write("p.quadrille", R"({ "format": "quadrille-project", "version": 1,
  "characters": [ { "name": "c", "mesh": "frames/up_8.obj" } ],
  "sequences": [ { "name": "a", "source": "take.pc2" } ] })");
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"check", "p.quadrille"},
                                                      {"info", "take.pc2"},
                                                      {"rebuild", "p.quadrille"},
                                                      {"info", "/dev/zero"}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments[0];
        EXPECT_THAT(outcome.err, HasSubstr(", not a file. Choose a file")) << arguments[0];
    }
}

TEST_F(Cli, AKeyAfterADayIsRefusedBeforeAnythingIsSought)
{
    importSeries();
    Project project = loadProject(folder / "p.quadrille");
    AnimationEntry animation{.name = "dance"};
    animation.constraints = {KeyEntry{.sequence = "rise", .time = 1e5}};
    project.animations = {animation};
    saveProject(project, folder / "p.quadrille");
    for (const char* command : {"check", "rebuild"}) {
        const Outcome outcome = run({command, "p.quadrille"});
        EXPECT_EQ(outcome.status, 1) << command;
        EXPECT_THAT(outcome.err, HasSubstr("An animation lasts at most an hour")) << command;
        EXPECT_THAT(outcome.err, HasSubstr("(line ")) << command;
    }
}

TEST_F(Cli, ResultsGoElsewhereWhereTheProjectsFolderCannotBeWritten)
{
    importSeries();
    ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    folder.write("p.quadrille.cache", "in the way");
    const Outcome rebuilt = run({"rebuild", "p.quadrille"});
    EXPECT_EQ(rebuilt.status, 0) << rebuilt.err;
    EXPECT_THAT(rebuilt.err, HasSubstr("The folder of results cannot be written; they are in " +
                                       (folder / "cache/quadrille/results").string()));
    EXPECT_THAT(run({"rebuild", "p.quadrille"}).out, HasSubstr("0 computed"));
    EXPECT_THAT(run({"data", "p.quadrille"}).out, HasSubstr("sequences/rise/"));
    // A folder of the user's choice needs no word.
    const Outcome chosen = run({"rebuild", "p.quadrille", "--store", "mine"});
    EXPECT_EQ(chosen.status, 0) << chosen.err;
    EXPECT_EQ(chosen.err, "");
    EXPECT_TRUE(fs::exists(folder / "mine"));
    // Without any place nothing is computed.
    folder.write("nowhere", "in the way, too");
    ::setenv("XDG_CACHE_HOME", (folder / "nowhere").c_str(), 1);
    const Outcome none = run({"rebuild", "p.quadrille", "--force"});
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.err, HasSubstr("p.quadrille.cache"));
    EXPECT_THAT(none.out, Not(HasSubstr("computed  ")));
    ::unsetenv("XDG_CACHE_HOME");
}

TEST_F(Cli, TheRateOfATakeIsWhatLiesBesideItSays)
{
    writeObjSeries(folder);
    writeBvh("frames.bvh", 6, "0.0333333");
    const Json list = info({"frames"});
    EXPECT_EQ(list[0]["fps"], 30);
    EXPECT_EQ(list[0]["fps_source"], (folder / "frames.bvh").string());
    EXPECT_DOUBLE_EQ(list[0]["duration"].get<double>(), 0.2);
    EXPECT_THAT(run({"info", "frames"}).out, HasSubstr("6 frames at 30 fps (from frames.bvh), 0.20 s"));
    const Outcome imported = run({"import", "p.quadrille", "frames"});
    EXPECT_THAT(imported.out, HasSubstr("has 30 fps, as in frames.bvh beside it"));
    EXPECT_EQ(loadProject(folder / "p.quadrille").settings.fps, 30);
    EXPECT_THAT(run({"convert", "frames", "a.mdd"}).out, HasSubstr("30 fps, as in frames.bvh"));
    EXPECT_EQ(info({"a.mdd", "--mesh", "frames/up_8.obj"})[0]["fps"], 30);
    const Outcome given = run({"import", "q.quadrille", "frames", "--fps", "60"});
    EXPECT_EQ(loadProject(folder / "q.quadrille").settings.fps, 60);
    EXPECT_THAT(given.out, Not(HasSubstr("30 fps")));
}

TEST_F(Cli, ARateThatNothingSaysIsUnknown)
{
    writeObjSeries(folder);
    EXPECT_THAT(run({"info", "frames"}).out, HasSubstr("6 frames, rate unknown"));
    const Outcome imported = run({"import", "p.quadrille", "frames"});
    EXPECT_EQ(imported.status, 0);
    EXPECT_THAT(imported.err, HasSubstr("The rate of “up” is not known"));
    EXPECT_THAT(imported.err, HasSubstr("25 fps is taken. Give it as --fps."));
    EXPECT_THAT(run({"convert", "frames", "a.mdd"}).err, HasSubstr("the rate is not known; 25 fps is taken"));
}
