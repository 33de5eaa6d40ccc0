// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/file/migration.h"
#include "model/project/file/projectfile.h"
#include "model/project/json/jsontext.h"
#include "tests/model/project/fullproject.h"
#include "tests/model/withoutroot.h"

#include <csignal>
#include <gmock/gmock.h>
#include <sys/resource.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

namespace {

Error errorOf(std::string_view text)
{
    const TemporaryFolder folder;
    try {
        loadProject(folder.write("p.quadrille", text));
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "accepted: " << text;
    return Error(ErrorCode::Cancelled);
}

std::string document(const std::string& rest)
{
    std::string text = "{\n  \"format\": \"quadrille-project\",\n  \"version\": 1,\n";
    return text.append(rest).append("\n}\n");
}

} // namespace

TEST(ProjectFile, AFullProjectComesBackEqual)
{
    const TemporaryFolder folder;
    const Project project = fullProject();
    saveProject(project, folder / "p.quadrille");
    EXPECT_EQ(loadProject(folder / "p.quadrille"), project);
    ProjectProblems problems;
    const RenderSettings settings = pictureFromJson(project.exports[0].picture, "", problems);
    EXPECT_EQ(pictureToJson(settings), project.exports[0].picture);
    EXPECT_TRUE(problems.empty());
}

TEST(ProjectFile, IsWrittenInFixedOrderWithTwoSpaces)
{
    const TemporaryFolder folder;
    Project project;
    project.characters = {characterOf("a", "a.obj")};
    SequenceEntry walk = sequenceOf("walk", "walk.pc2");
    walk.range = FrameRange{FrameIndex(3), FrameIndex(9)};
    project.sequences = {walk};
    saveProject(project, folder / "p.quadrille");
    EXPECT_EQ(textOf(folder / "p.quadrille"), R"({
  "format": "quadrille-project",
  "version": 1,
  "settings": {
    "fps": 25,
    "up_axis": "y",
    "unit": "m",
    "cache_megabytes": 512
  },
  "characters": [
    {
      "name": "a",
      "mesh": "a.obj"
    }
  ],
  "sequences": [
    {
      "name": "walk",
      "source": "walk.pc2",
      "range": [3, 9]
    }
  ],
  "exports": []
}
)");
}

TEST(ProjectFile, UnknownKeysAreKeptEverywhere)
{
    const TemporaryFolder folder;
    const std::string text = document(R"(  "settings": { "fps": 30, "gamma": 2.2 },
  "characters": [ { "name": "a", "texture": { "per_frame": "t", "colour_space": "srgb" }, "height": 1.8 } ],
  "sequences": [ { "name": "s", "source": "s.pc2", "mood": { "happy": [1, "two", null] },
    "labels": [ { "label": "x", "frames": [0, 1], "colour": "red" }, { "label": "y", "frames": [2, 3] } ],
    "contacts": [ { "foot": "left", "frames": [0, 1], "sure": 0.5 } ] } ],
  "exports": [ { "name": "e", "what": "sequences/s", "path": "e.obj", "mood": "front",
    "picture": { "width": 64, "lens": "wide" } } ],
  "evaluations": [ "fig7", { "table": "fig9", "mood": "calm" } ],
  "graph": { "alpha": 3.0 }, "holograms": [])");
    const Project project = loadProject(folder.write("p.quadrille", text));
    saveProject(project, folder / "q.quadrille");
    const Json saved = Json::parse(textOf(folder / "q.quadrille"));
    EXPECT_EQ(saved["settings"]["gamma"], 2.2);
    EXPECT_EQ(saved["characters"][0]["height"], 1.8);
    EXPECT_EQ(saved["characters"][0]["texture"], Json::parse(R"({"per_frame":"t","colour_space":"srgb"})"));
    EXPECT_EQ(saved["sequences"][0]["mood"], Json::parse(R"({"happy":[1,"two",null]})"));
    EXPECT_EQ(saved["sequences"][0]["labels"][0]["colour"], "red");
    EXPECT_FALSE(saved["sequences"][0]["labels"][1].contains("colour"));
    EXPECT_EQ(saved["sequences"][0]["contacts"][0]["sure"], 0.5);
    EXPECT_EQ(saved["exports"][0]["mood"], "front");
    EXPECT_EQ(saved["exports"][0]["picture"]["lens"], "wide");
    EXPECT_EQ(saved["graph"], Json::parse(R"({"alpha":3.0})"));
    EXPECT_EQ(saved["evaluations"], Json::parse(R"(["fig7",{"table":"fig9","mood":"calm"}])"));
    EXPECT_EQ(saved["holograms"], Json::array());
    EXPECT_EQ(loadProject(folder / "q.quadrille"), project);
}

TEST(ProjectFile, UnknownKeysArePointedOutButNotesAreNot)
{
    const auto problems = readProject(document(R"(  "settings": { "fsp": 30 },
  "sequences": [ { "name": "s", "source": "s.pc2", "mood": 1, "_why": "a note",
    "labels": [ { "label": "x", "frames": [0, 1], "colour": "red" } ] } ],
  "exports": [ { "name": "e", "what": "sequences/s", "path": "e.png", "picture": { "lens": "wide" } } ],
  "holograms": [])"),
                                      "p.quadrille")
                              .problems;
    std::vector<std::string> texts;
    for (const ProjectProblem& problem : problems) {
        EXPECT_EQ(problem.severity, ProjectProblem::Severity::Warning);
        texts.push_back(problem.toString());
    }
    ASSERT_EQ(texts.size(), 5U);
    EXPECT_EQ(texts[0], "p.quadrille: The key “fsp” is not known here and has no effect. Did you mean “fps”? "
                        "(line 4, column 17)");
    EXPECT_THAT(texts[1], ::testing::HasSubstr("“mood”"));
    EXPECT_THAT(texts[1], ::testing::HasSubstr("“_mood”"));
    EXPECT_THAT(texts[2], ::testing::HasSubstr("“colour”"));
    EXPECT_THAT(texts[3], ::testing::HasSubstr("“lens”"));
    EXPECT_THAT(texts[4], ::testing::HasSubstr("“holograms”"));
}

TEST(ProjectFile, AMissingSectionIsNamedWithItsPlace)
{
    const Error error = errorOf(document(R"(  "sequnces": [ { "name": "s", "source": "s.pc2" } ],
  "animations": [ { "name": "dance", "constraints": [ { "kind": "path", "points": [ [0, 0], [1, 1] ] } ] } ],
  "exports": [ { "name": "e", "what": "animations/dance", "path": "e.glb" } ])"));
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("The section “sequences” is missing, which “animations” needs"));
    EXPECT_EQ(error.context().place.line, 5);
    EXPECT_EQ(error.context().place.column, 3);
}

TEST(ProjectFile, SyntaxErrorsNameLineAndColumn)
{
    const Error error = errorOf("{\n  \"format\": \"quadrille-project\",\n  \"version\": 1,,\n}");
    EXPECT_EQ(error.code(), ErrorCode::ProjectSyntax);
    EXPECT_EQ(error.context().place.line, 3);
    EXPECT_EQ(error.context().place.column, 16);
}

TEST(ProjectFile, SemanticErrorsNameLineAndColumn)
{
    struct Case
    {
        const char* rest;
        std::int64_t line;
        std::int64_t column;
        const char* sentence;
    };
    const Case cases[] = {
        {R"(  "settings": { "fps": "fast" })", 4, 24, "“fps” must be a number"},
        {R"(  "settings": { "fps": 0 })", 4, 24, "frame rate"},
        {R"(  "settings": { "up_axis": "w" })", 4, 28, "\"x\", \"y\" or \"z\""},
        {R"(  "settings": { "unit": "parsec" })", 4, 25, "\"cm\""},
        {R"(  "settings": [])", 4, 15, "object in braces"},
        {R"(  "sequences": {})", 4, 16, "list in brackets"},
        {R"(  "sequences": [ { "name": "s" } ])", 4, 18, "“source” is missing"},
        {R"(  "sequences": [ { "name": "s", "source": "a", "range": [1] } ])", 4, 57, "two frame numbers"},
        {R"(  "sequences": [ { "name": "s", "source": "a", "range": [9, 1] } ])", 4, 57, "ends before"},
        {R"(  "sequences": [ { "name": "s", "source": "a", "range": [-1, 1] } ])", 4, 57, "two frame"},
        {R"(  "sequences": [ { "name": "é/é", "source": "a" } ])", 4, 28, "no slashes"},
        {R"(  "sequences": [ { "name": "é", "source": "" } ])", 4, 43, "source is empty"},
        {"  \"sequences\": [ { \"name\": \"s\", \"source\": \"a\" },\n    { \"name\": \"s\", \"source\": "
         "\"b\" } ]",
         5, 15, "two entries with the name “s”"},
        {R"(  "exports": [ { "name": "e", "what": "sequences/no", "path": "e.obj" } ])", 4, 39,
         "no sequence “no”"},
        {R"(  "evaluations": [ "fig9", "fig8" ])", 4, 28, "no table “fig8”"},
        {R"(  "evaluations": [ { "table": "fig8" } ])", 4, 31, "no table “fig8”"},
        {R"(  "exports": [ { "name": "e", "what": 5, "path": "e.obj" } ])", 4, 39, "text in quotes"},
    };
    for (const Case& wrong : cases) {
        const Error error = errorOf(document(wrong.rest));
        EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid) << wrong.rest;
        EXPECT_EQ(error.context().place.line, wrong.line) << wrong.rest;
        EXPECT_EQ(error.context().place.column, wrong.column) << wrong.rest;
        EXPECT_THAT(error.what(), HasSubstr(wrong.sentence)) << wrong.rest;
    }
}

TEST(ProjectFile, DoubledKeysWrongEncodingAndDeepNestingAreRefused)
{
    const Error doubled = errorOf(document("  \"settings\": {},\n  \"settings\": {}"));
    EXPECT_EQ(doubled.code(), ErrorCode::ProjectSyntax);
    EXPECT_EQ(doubled.context().place.line, 5);
    EXPECT_EQ(doubled.context().place.column, 3);
    const Error encoding = errorOf(document("  \"x\": \"caf\xE9\""));
    EXPECT_EQ(encoding.code(), ErrorCode::FileEncoding);
    EXPECT_EQ(encoding.context().place.line, 4);
    EXPECT_EQ(errorOf(std::string(100000, '[')).code(), ErrorCode::ProjectSyntax);
    EXPECT_EQ(errorOf("[]").code(), ErrorCode::ProjectInvalid);
    EXPECT_EQ(errorOf("{\"format\": \"else\"}").code(), ErrorCode::ProjectInvalid);
}

TEST(ProjectFile, AByteOrderMarkIsNoObstacle)
{
    const TemporaryFolder folder;
    const auto file = folder.write("p.quadrille", "\xEF\xBB\xBF" + document("  \"settings\": {\"fps\": 50}"));
    EXPECT_EQ(loadProject(file).settings.fps, 50);
}

TEST(ProjectFile, ANewerVersionIsRefusedWithItsNumber)
{
    const Error error = errorOf("{\"format\": \"quadrille-project\", \"version\": 7}");
    EXPECT_EQ(error.code(), ErrorCode::ProjectNewer);
    EXPECT_THAT(error.what(), HasSubstr("version 7"));
    EXPECT_THAT(error.what(), HasSubstr("up to 1"));
    EXPECT_EQ(error.context().place.line, 1);
}

TEST(ProjectFile, AnOlderVersionGoesThroughEveryMigration)
{
    const std::array<Migration, 2> steps{
        {{1, [](Json& json) { json["way"] = "1"; }},
         {2, [](Json& json) { json["way"] = json["way"].get<std::string>() + "2"; }}}};
    auto text = parseJson(R"({"format": "quadrille-project", "version": 1})");
    migrate(text, steps, 3);
    EXPECT_EQ(text.document["way"], "12");
    EXPECT_EQ(text.document["version"], 3);
    auto impossible = parseJson(R"({"format": "quadrille-project", "version": 0})");
    EXPECT_THROW(migrate(impossible, steps, 3), Error);
}

TEST(ProjectFile, AMisspeltKeyIsAWarningThatKnowsTheRightOne)
{
    const auto reading = readProject(document(R"(  "settings": { "fsp": 30, "source-note": 1 },
  "sequenecs": [],
  "sequences": [ { "name": "s", "source": "a", "sourceFps": 30 } ])"),
                                     "p.quadrille");
    ASSERT_EQ(reading.problems.size(), 4U);
    EXPECT_FALSE(hasErrors(reading.problems));
    EXPECT_EQ(reading.problems[0].toString(),
              "p.quadrille: The key “fsp” is not known here and has no effect. Did you mean “fps”? "
              "(line 4, column 17)");
    EXPECT_THAT(reading.problems[1].toString(), HasSubstr("“_source-note”"));
    EXPECT_THAT(reading.problems[2].toString(), HasSubstr("“_sequenecs”")); // “sequences” is there
    EXPECT_THAT(reading.problems[3].toString(), HasSubstr("“source_fps”"));
}

TEST(ProjectFile, AllProblemsAreReportedInTheOrderOfTheFile)
{
    const auto reading = readProject(
        document("  \"sequences\": [ { \"name\": \"\", \"source\": 3 } ],\n  \"settings\": 4"), "p");
    ASSERT_EQ(reading.problems.size(), 3U);
    EXPECT_EQ(reading.problems[0].pointer, "/sequences/0/name");
    EXPECT_EQ(reading.problems[1].pointer, "/sequences/0/source");
    EXPECT_EQ(reading.problems[2].pointer, "/settings");
}

TEST(ProjectFile, SavingKeepsOneBackup)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    Project project;
    saveProject(project, file);
    EXPECT_FALSE(fs::exists(folder / "p.quadrille.bak"));
    project.settings.fps = 30;
    saveProject(project, file);
    project.settings.fps = 60;
    saveProject(project, file);
    saveProject(project, file);
    EXPECT_EQ(loadProject(file).settings.fps, 60);
    EXPECT_EQ(loadProject(folder / "p.quadrille.bak").settings.fps, 30);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(ProjectFile, AFailedSaveLeavesTheOldFile)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    Project project;
    project.settings.fps = 30;
    saveProject(project, file);
    const std::string before = textOf(file);
    project.characters = {characterOf("a", std::string(10000, 'm'))};

    // A full disk, as far as this process can tell: no file may grow beyond 4 kB.
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::optional<ErrorCode> code;
    try {
        saveProject(project, file);
    } catch (const Error& error) {
        code = error.code();
    }
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, oldHandler);

    EXPECT_EQ(code, ErrorCode::WriteFailed);
    EXPECT_EQ(textOf(file), before);
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().string(), ::testing::Not(HasSubstr(".tmp")));
}

TEST(ProjectFile, NothingIsSavedWhenTheBackupCannotBeMade)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    Project project;
    saveProject(project, file);
    const std::string before = textOf(file);
    fs::create_directories(folder / "p.quadrille.bak/in-the-way");
    project.settings.fps = 30;
    EXPECT_THROW(saveProject(project, file), Error);
    EXPECT_EQ(textOf(file), before);
}

TEST(ProjectFile, EmptyCutAndForeignFilesAreRefusedWithTheirName)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    const auto codeOf = [&] {
        try {
            loadProject(file);
        } catch (const Error& error) {
            EXPECT_EQ(error.context().file, file);
            return error.code();
        }
        return ErrorCode::Cancelled; // stands for no error
    };
    saveProject(fullProject(), file);
    const std::string whole = textOf(file);
    for (std::size_t length = 1; length + 2 < whole.size(); length += whole.size() / 100 + 1) {
        folder.write("p.quadrille", std::string_view(whole).substr(0, length));
        EXPECT_EQ(codeOf(), ErrorCode::ProjectSyntax) << length;
    }
    folder.write("p.quadrille", std::string(100, '\0'));
    EXPECT_EQ(codeOf(), ErrorCode::ProjectSyntax);
    folder.write("p.quadrille", "");
    EXPECT_EQ(codeOf(), ErrorCode::FileEmpty);
    fs::remove(file);
    fs::create_directories(file);
    EXPECT_EQ(codeOf(), ErrorCode::BadArgument);
}

TEST(ProjectFile, WithoutPermissionNothingIsReadOrWritten)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    saveProject(fullProject(), file);
    const std::string before = textOf(file);
    const auto codeOf = [](const auto& call) {
        try {
            call();
        } catch (const Error& error) {
            return error.code();
        }
        return ErrorCode::Cancelled; // stands for no error
    };
    fs::permissions(file, fs::perms::none);
    fs::permissions(folder.path(), fs::perms::owner_all | fs::perms::others_exec);
    {
        const WithoutRoot guard;
        if (!guard.isPlain())
            GTEST_SKIP() << "the rights of root cannot be given up here";
        EXPECT_EQ(codeOf([&] { loadProject(file); }), ErrorCode::PermissionDenied);
        const auto saved = codeOf([&] { saveProject(fullProject(), file); });
        // A user may write in his own folder.
        EXPECT_EQ(saved, guard.wasRoot() ? ErrorCode::PermissionDenied : saved);
    }
    fs::permissions(file, fs::perms::owner_all);
    EXPECT_EQ(textOf(file), before);
}

TEST(ProjectFile, AMissingFileSaysSo)
{
    try {
        loadProject("/nowhere/p.quadrille");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::FileNotFound);
    }
}
