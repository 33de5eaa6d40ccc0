// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"
#include "tests/model/cli/clifixture.h"

#include <fstream>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(Cli, SaysItsVersionAndHelps)
{
    const Outcome built = runQuadrille({"--version"}, folder.path());
    EXPECT_EQ(built.status, 0);
    EXPECT_THAT(built.out, StartsWith("quadrille "));
    EXPECT_EQ(run({"--version"}).out, built.out);
    for (const char* command : {"info", "convert", "sample", "import", "check", "rebuild", "data"}) {
        const Outcome help = run({command, "--help"});
        EXPECT_EQ(help.status, 0) << command;
        EXPECT_THAT(help.out, HasSubstr("Example")) << command;
        EXPECT_THAT(help.out, HasSubstr(std::string("quadrille ") + command)) << command;
    }
}

TEST_F(Cli, WrongUseEndsWithTwo)
{
    writeObjSeries(folder);
    const std::vector<std::vector<std::string>> wrong{
        {"unknown"},
        {"info"},
        {"convert", "frames"},
        {"convert", "frames", "out.pc2", "--range", "4:2"},
        {"convert", "frames", "out.pc2", "--range", "all"},
        {"convert", "frames", "out.pc2", "--fps", "-3"},
        {"convert", "frames", "out.pc2", "--unit", "parsec"},
        {"rebuild", "p.quadrille", "--jobs", "0"},
        {"rebuild", "--sideways", "p.quadrille"},
    };
    for (const auto& arguments : wrong) {
        const Outcome result = run(arguments);
        EXPECT_EQ(result.status, 2) << ::testing::PrintToString(arguments);
        EXPECT_THAT(result.err, StartsWith("error: ")) << ::testing::PrintToString(arguments);
    }
}

TEST_F(Cli, FailuresEndWithOneAndNameTheFile)
{
    const Outcome missing = run({"info", "nowhere.obj"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_EQ(runQuadrille({"info", "nowhere.obj"}, folder.path()).status, 1);
    EXPECT_THAT(missing.err, HasSubstr("error: nowhere.obj: "));
    folder.write("bad.quadrille", "{\n  \"format\": \"quadrille-project\",\n  \"version\": 1,\n  oops\n}");
    const Outcome bad = run({"check", "bad.quadrille"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.err, HasSubstr("error: bad.quadrille: "));
    EXPECT_THAT(bad.err, HasSubstr("(line 4, column 3)"));
    EXPECT_EQ(run({"rebuild", "nowhere.quadrille"}).status, 1);
    EXPECT_EQ(run({"convert", "nowhere.obj", "x.pc2"}).status, 1);
}

TEST_F(Cli, SaysWhatThereIsWhenNothingIsAsked)
{
    const Outcome result = run({});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("Usage: quadrille "));
    EXPECT_THAT(result.err, HasSubstr("rebuild"));
}

TEST_F(Cli, InfoReadsAsSentences)
{
    writeObjSeries(folder);
    const std::string text = run({"info", "frames"}).out;
    EXPECT_THAT(text, HasSubstr("4 vertices, 2 triangles, 1 component, 4 boundary edges in 1 loop"));
    EXPECT_THAT(text, HasSubstr("6 frames, rate unknown"));
    EXPECT_THAT(text, HasSubstr("UVs, no texture"));
    EXPECT_THAT(text, HasSubstr("x 0.000 … 1.000, y 0.000 … 0.500, z 0.000 … 1.000 m, y up"));
}

TEST_F(Cli, InfoNamesTheFirstBadFrame)
{
    writeObjSeries(folder);
    const std::string bad = "v nan 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n"
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 3/3 2/2\nf 1/1 4/4 3/3\n";
    for (const char* file : {"frames/up_12.obj", "frames/up_11.obj", "frames/up_10.obj"})
        folder.write(file, bad);
    const Outcome outcome = run({"info", "frames"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("up_10.obj"));
}

TEST_F(Cli, InfoHasItsDocumentedKeys)
{
    writeObjSeries(folder);
    const Json list = info({"frames"});
    ASSERT_EQ(list.size(), 1U);
    const Json& rise = list[0];
    EXPECT_EQ(rise["vertices"], 4);
    EXPECT_EQ(rise["triangles"], 2);
    EXPECT_EQ(rise["frames"], 6);
    EXPECT_EQ(rise["fps"], nullptr); // nothing says it
    EXPECT_EQ(rise["fps_source"], nullptr);
    EXPECT_EQ(rise["duration"], nullptr);
    EXPECT_EQ(rise["components"], 1);
    EXPECT_EQ(rise["boundary_edges"], 4);
    EXPECT_EQ(rise["boundary_loops"], 1);
    EXPECT_EQ(rise["uvs"], true);
    EXPECT_EQ(rise["bounds"], Json::parse("{\"min\": [0.0, 0.0, 0.0], \"max\": [1.0, 0.5, 1.0]}"));
    EXPECT_EQ(rise["textures"]["kind"], "none");
    EXPECT_EQ(rise["problems"], Json::array());
    const std::string help = run({"info", "--help"}).out;
    for (const auto& [key, value] : rise.items())
        EXPECT_THAT(help, HasSubstr(key));
}

TEST_F(Cli, ConvertCutsResamplesAndChangesAxes)
{
    writeObjSeries(folder);
    ASSERT_EQ(run({"convert", "frames", "cut.pc2", "--range", "1:3"}).status, 0);
    const std::string mesh = "frames/up_8.obj";
    const auto bounds = [&](const std::string& file) {
        const Outcome result = run({"info", file, "--mesh", mesh, "--json"});
        return Json::parse(result.out)[0];
    };
    EXPECT_EQ(bounds("cut.pc2")["frames"], 3);
    EXPECT_NEAR(bounds("cut.pc2")["bounds"]["min"][1].get<double>(), 0.1, 1e-6);
    ASSERT_EQ(run({"convert", "frames", "slow.pc2", "--source-fps", "10", "--fps", "20"}).status, 0);
    EXPECT_EQ(bounds("slow.pc2")["frames"], 11);
    ASSERT_EQ(run({"convert", "frames", "z.pc2", "--up-axis", "z", "--unit", "cm"}).status, 0);
    EXPECT_NEAR(bounds("z.pc2")["bounds"]["max"][2].get<double>(), 50, 1e-4);
    const Outcome outside = run({"convert", "frames", "no.pc2", "--range", "3:9"});
    EXPECT_EQ(outside.status, 1);
    EXPECT_FALSE(fs::exists(folder / "no.pc2"));
}

TEST_F(Cli, ImportCheckRebuildAndRebuildAgain)
{
    importSeries();
    addExport("cache", "out/rise.pc2");
    EXPECT_EQ(loadProject(folder / "p.quadrille").settings.fps, 10);
    const Outcome check = run({"check", "p.quadrille"});
    EXPECT_EQ(check.status, 0) << check.err;
    EXPECT_FALSE(fs::exists(folder / "p.quadrille.cache")) << "check computes nothing";

    const Outcome dry = run({"rebuild", "p.quadrille", "--dry-run"});
    EXPECT_EQ(dry.status, 0);
    EXPECT_THAT(dry.out, HasSubstr("would compute  exports/cache"));
    EXPECT_FALSE(fs::exists(folder / "out/rise.pc2"));

    const Outcome first = run({"rebuild", "p.quadrille", "--json", "report.json"});
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_TRUE(fs::exists(folder / "out/rise.pc2"));
    EXPECT_THAT(first.out, HasSubstr("out/rise.pc2"));
    const Json report = Json::parse(textOf(folder / "report.json"));
    EXPECT_EQ(report["failed"], 0);
    EXPECT_EQ(report["fresh"], 0);

    const Outcome second = run({"rebuild", "p.quadrille", "--json", "report.json"});
    EXPECT_EQ(Json::parse(textOf(folder / "report.json"))["computed"], 0) << second.out;

    ASSERT_EQ(run({"rebuild", "p.quadrille", "exports/cache", "--force", "--json", "report.json"}).status, 0);
    EXPECT_EQ(Json::parse(textOf(folder / "report.json"))["computed"], 1);
    const Outcome unknown = run({"rebuild", "p.quadrille", "exports/none"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.err, HasSubstr("exports/cache"));
}

TEST_F(Cli, ADamagedResultIsMendedWithAWarning)
{
    importSeries();
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    const std::string result = "p.quadrille.cache/sequences/rise/statistics.h5";
    const std::string before = textOf(folder / result);
    folder.write(result, before.substr(0, 600));
    EXPECT_THAT(run({"check", "p.quadrille"}).err, HasSubstr("statistics.h5: A stored result is damaged"));
    const Outcome mended = run({"rebuild", "p.quadrille"});
    EXPECT_EQ(mended.status, 0);
    EXPECT_THAT(mended.err, HasSubstr("warning: "));
    EXPECT_EQ(textOf(folder / result), before);
}

TEST_F(Cli, DataListsAndWrites)
{
    importSeries();
    EXPECT_THAT(run({"data", "p.quadrille"}).err, HasSubstr("nothing is computed yet"));
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    const Outcome list = run({"data", "p.quadrille"});
    EXPECT_THAT(list.out, HasSubstr("frames\t6 × 3"));
    EXPECT_THAT(list.out, HasSubstr("sequences/rise/bounds\t6 × 6\tm\t"));
    EXPECT_THAT(run({"data", "p.quadrille", "frames"}).out,
                StartsWith("index,sequence,frame (frame)\n0,rise,0\n1,rise,1\n"));
    ASSERT_EQ(run({"data", "p.quadrille", "frames", "-o", "frames.csv"}).status, 0);
    EXPECT_THAT(textOf(folder / "frames.csv"),
                StartsWith("index,sequence,frame (frame)\n0,rise,0\n1,rise,1\n"));
    ASSERT_EQ(run({"data", "p.quadrille", "sequences/rise/centroid", "-o", "c.npy"}).status, 0);
    EXPECT_TRUE(fs::exists(folder / "c.npy"));
    const Outcome unknown = run({"data", "p.quadrille", "framse", "-o", "x.csv"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.err, HasSubstr("It has: "));
    EXPECT_EQ(run({"data", "p.quadrille", "frames", "-o", "x.doc"}).status, 1);
}

TEST_F(Cli, QuietSaysNothingAndVerboseMore)
{
    importSeries();
    const Outcome quiet = run({"rebuild", "p.quadrille", "--quiet"});
    EXPECT_EQ(quiet.out + quiet.err, "");
    const Outcome normal = run({"rebuild", "p.quadrille"});
    const Outcome verbose = run({"--verbose", "rebuild", "p.quadrille"});
    EXPECT_THAT(verbose.out, HasSubstr("up to date  sequences/rise/statistics"));
    EXPECT_LT(normal.out.size(), verbose.out.size());
    EXPECT_THAT(normal.out + normal.err, ::testing::Not(HasSubstr("\r"))) << "no bar without a terminal";
}

TEST_F(Cli, AnInterruptedRebuildLeavesNothingHalfWritten)
{
    importSeries();
    Project project = loadProject(folder / "p.quadrille");
    project.sequences[0].sourceFps = 0.01; // resampled to thousands of frames
    saveProject(project, folder / "p.quadrille");
    addExport("pictures", "pictures/rise.png");
    const Outcome result = interruptQuadrille({"rebuild", "p.quadrille", "exports"}, folder.path(), [this] {
        std::error_code error;
        return fs::exists(folder / "pictures", error);
    });
    EXPECT_EQ(result.status, 1) << result.out;
    EXPECT_THAT(result.err, HasSubstr("error: Cancelled."));
    EXPECT_FALSE(fs::exists(folder / "p.quadrille.cache/exports/pictures.h5"));
    std::error_code error;
    EXPECT_TRUE(!fs::exists(folder / "pictures", error) || fs::is_empty(folder / "pictures"));
}

TEST_F(Cli, TheSampleReplacesOnlyASample)
{
    const fs::path project = folder / "demo/sample.quadrille";
    fs::create_directories(project.parent_path());
    std::ofstream(project) << "mine";
    const Outcome refused = run({"sample", "demo"});
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("sample.quadrille"), HasSubstr("--overwrite")));
    EXPECT_EQ(textOf(project), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(project.parent_path()), {}), 1);
    EXPECT_EQ(run({"sample", "--overwrite", "demo"}).status, 0);
    EXPECT_EQ(run({"sample", "demo"}).status, 0) << "the same again";
}
