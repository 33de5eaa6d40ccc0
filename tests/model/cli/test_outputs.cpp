// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the program writes for its user, and what it never writes over.
#include "model/core/image.h"
#include "model/project/file/projectfile.h"
#include "tests/model/cli/clifixture.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

namespace {

class Outputs : public Cli
{
protected:
    /// p.quadrille with the take “jog 1”, a point cache of six frames beside its mesh.
    void makeProject() const
    {
        writeObjSeries(folder);
        fs::create_directories(folder / "takes");
        fs::copy_file(folder / "frames/up_8.obj", folder / "man.obj");
        ASSERT_EQ(run({"convert", "frames", "takes/jog_1.pc2"}).status, 0);
        const Outcome imported =
            run({"import", "p.quadrille", "takes/jog_1.pc2", "--mesh", "man.obj", "--name", "jog 1"});
        ASSERT_EQ(imported.status, 0) << imported.err;
    }
    /// The project with one export, or with more.
    void setExports(const std::vector<std::string>& paths) const
    {
        Project project = loadProject(folder / "p.quadrille");
        project.exports.clear();
        for (const std::string& path : paths) {
            ExportEntry entry;
            entry.name = "e" + std::to_string(project.exports.size() + 1);
            entry.what = "sequences/" + project.sequences.front().name;
            entry.path = path;
            entry.range = FrameRange{FrameIndex(0), FrameIndex(3)};
            project.exports.push_back(entry);
        }
        saveProject(project, folder / "p.quadrille");
    }
    /// Runs `rebuild` and `check`, which both must refuse, and looks whether a file stays as it is.
    void expectRefused(const std::string& path, const std::string& file, const std::string& why) const
    {
        setExports({path});
        const std::string before = textOf(folder / file);
        const Outcome rebuilt = run({"rebuild", "p.quadrille", "--overwrite", "--allow-outside"});
        EXPECT_EQ(rebuilt.status, 1) << path;
        EXPECT_THAT(rebuilt.err, HasSubstr(why)) << path;
        EXPECT_EQ(textOf(folder / file), before) << path;
        const Outcome checked = run({"check", "p.quadrille", "--allow-outside"});
        EXPECT_EQ(checked.status, 1) << path;
        EXPECT_THAT(checked.err, HasSubstr(why)) << path;
        EXPECT_THAT(checked.err, ::testing::ContainsRegex("line [0-9]+, column [0-9]+")) << path;
    }
};

} // namespace

TEST_F(Outputs, NoExportIsWrittenOverAnInputByAnyPath)
{
    makeProject();
    fs::create_hard_link(folder / "takes/jog_1.pc2", folder / "hard.pc2");
    fs::create_symlink("takes/jog_1.pc2", folder / "soft.pc2");
    fs::create_directory_symlink("takes", folder / "linked");
    const std::string take = "takes/jog_1.pc2";
    for (const std::string path : {take.c_str(), "./takes/../takes/./jog_1.pc2", "hard.pc2", "soft.pc2",
                                   "linked/jog_1.pc2", "nowhere/../takes/jog_1.pc2"})
        expectRefused(path, take, "is an input (sequences/jog 1)");
    expectRefused((folder / take).string(), take, "is an input (sequences/jog 1)");
}

TEST_F(Outputs, NoExportIsWrittenIntoTheResultsOrTheProject)
{
    makeProject();
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    expectRefused("p.quadrille.cache/sequences/x.pc2", "p.quadrille", "the results of the project");
    Project project = loadProject(folder / "p.quadrille");
    project.exports.front().path = "p.quadrille";
    project.exports.front().format = "pc2";
    saveProject(project, folder / "p.quadrille");
    const std::string before = textOf(folder / "p.quadrille");
    EXPECT_EQ(run({"rebuild", "p.quadrille", "--overwrite"}).status, 1);
    EXPECT_EQ(textOf(folder / "p.quadrille"), before);
}

TEST_F(Outputs, FramesOfASeriesAreInputsAlsoThoseThatAreNotThereYet)
{
    writeObjSeries(folder);
    ASSERT_EQ(run({"import", "p.quadrille", "frames/up_#.obj", "--name", "rise"}).status, 0);
    expectRefused("frames/up_#.obj", "frames/up_8.obj", "is an input (sequences/rise)");
    expectRefused("frames/up.obj", "frames/up_8.obj", "is an input (sequences/rise)");
    EXPECT_FALSE(fs::exists(folder / "frames/up_0000.obj"));
    setExports({"frames/upward.obj"});
    EXPECT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    EXPECT_EQ(run({"check", "p.quadrille"}).status, 0);
}

TEST_F(Outputs, CompanionsOfAnExportDoNotHitInputs)
{
    writeObjSeries(folder);
    for (int f = 8; f < 14; ++f) {
        const std::string file = "frames/up_" + std::to_string(f) + ".obj";
        folder.write(file, "mtllib walk.mtl\nusemtl skin\n" + textOf(folder / file));
    }
    folder.write("frames/walk.mtl", "newmtl skin\nmap_Kd walk_texture.png\n");
    writeImage(Image(2, 2), folder / "frames/walk_texture.png");
    ASSERT_EQ(run({"import", "p.quadrille", "frames/up_#.obj", "--name", "rise"}).status, 0);
    expectRefused("frames/walk.obj", "frames/walk.mtl", "is an input (sequences/rise)");
    expectRefused("frames/walk.usda", "frames/walk_texture.png", "is an input (sequences/rise)");
}

TEST_F(Outputs, ConvertDoesNotCutItsOwnInput)
{
    makeProject();
    const std::string before = textOf(folder / "takes/jog_1.pc2");
    fs::create_hard_link(folder / "takes/jog_1.pc2", folder / "hard.pc2");
    fs::create_symlink("takes/jog_1.pc2", folder / "soft.pc2");
    for (const char* out : {"takes/jog_1.pc2", "./takes/jog_1.pc2", "hard.pc2", "soft.pc2"}) {
        const Outcome result =
            run({"convert", "takes/jog_1.pc2", out, "--mesh", "man.obj", "--range", "0:3", "--overwrite"});
        EXPECT_EQ(result.status, 1) << out;
        EXPECT_THAT(result.err, HasSubstr("never written over")) << out;
        EXPECT_EQ(textOf(folder / "takes/jog_1.pc2"), before) << out;
    }
    EXPECT_EQ(run({"convert", "frames", "frames/up_#.obj", "--overwrite"}).status, 1);
    EXPECT_EQ(run({"convert", "takes/jog_1.pc2", "man.obj", "--mesh", "man.obj"}).status, 0)
        << "man_0000.obj, … are other files";
}

TEST_F(Outputs, FilesOfSomebodyElseAreReplacedOnlyWhenAsked)
{
    makeProject();
    folder.write("out/jog.pc2", "of somebody else");
    const Outcome converted = run({"convert", "frames", "out/jog.pc2"});
    EXPECT_EQ(converted.status, 1);
    EXPECT_THAT(converted.err, HasSubstr("--overwrite"));
    setExports({"out/jog.pc2"});
    const Outcome rebuilt = run({"rebuild", "p.quadrille"});
    EXPECT_EQ(rebuilt.status, 1);
    EXPECT_THAT(rebuilt.err, HasSubstr("--overwrite"));
    EXPECT_EQ(textOf(folder / "out/jog.pc2"), "of somebody else");
    EXPECT_EQ(run({"rebuild", "p.quadrille", "--overwrite"}).status, 0);
    EXPECT_EQ(run({"rebuild", "p.quadrille", "--force"}).status, 0) << "now it is its own";
}

TEST_F(Outputs, TheProgramKnowsWhatItWrote)
{
    makeProject();
    setExports({"out/jog.pc2"});
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    const std::string four = textOf(folder / "out/jog.pc2");
    const auto setRange = [this](std::int64_t last) {
        Project project = loadProject(folder / "p.quadrille");
        project.exports.front().range = FrameRange{FrameIndex(0), FrameIndex(last)};
        saveProject(project, folder / "p.quadrille");
    };
    setRange(2);
    EXPECT_EQ(run({"rebuild", "p.quadrille"}).status, 0) << "what it wrote itself is replaced";

    // The whole folder on another machine.
    fs::create_directories(folder / "elsewhere");
    for (const char* name : {"p.quadrille", "p.quadrille.cache", "takes", "man.obj", "out"})
        fs::copy(folder / name, folder / "elsewhere" / name, fs::copy_options::recursive);
    fs::last_write_time(folder / "elsewhere/out/jog.pc2", fs::file_time_type::clock::now());
    Project moved = loadProject(folder / "elsewhere/p.quadrille");
    moved.exports.front().range = FrameRange{FrameIndex(1), FrameIndex(2)};
    saveProject(moved, folder / "elsewhere/p.quadrille");
    EXPECT_EQ(run({"rebuild", "elsewhere/p.quadrille"}).status, 0);

    // Without the results the same content is known again; another one is not.
    fs::remove_all(folder / "p.quadrille.cache");
    EXPECT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    fs::remove_all(folder / "p.quadrille.cache");
    setRange(3);
    EXPECT_EQ(run({"rebuild", "p.quadrille"}).status, 1);
    EXPECT_EQ(run({"rebuild", "p.quadrille", "--overwrite"}).status, 0);
    EXPECT_EQ(textOf(folder / "out/jog.pc2"), four);

    // What somebody worked on is not the program's any more.
    folder.write("out/jog.pc2", "worked on");
    EXPECT_EQ(run({"rebuild", "p.quadrille"}).status, 1);
    EXPECT_EQ(textOf(folder / "out/jog.pc2"), "worked on");
}

TEST_F(Outputs, TwoExportsDoNotWriteToOnePath)
{
    makeProject();
    const std::vector<std::vector<std::string>> pairs{
        {"out/a.pc2", "out/./a.pc2"}, {"out/a.obj", "out/a_####.obj"}, {"out/a.png", "out/a_###.png"}};
    for (const auto& paths : pairs) {
        setExports(paths);
        const Outcome checked = run({"check", "p.quadrille"});
        EXPECT_EQ(checked.status, 1) << paths.back();
        EXPECT_THAT(checked.err, HasSubstr("is written by exports/e2, too")) << paths.back();
        EXPECT_THAT(checked.err, HasSubstr("is written by exports/e1, too")) << paths.back();
        const Outcome rebuilt = run({"rebuild", "p.quadrille", "--overwrite"});
        EXPECT_EQ(rebuilt.status, 1) << paths.back();
        EXPECT_FALSE(fs::exists(folder / "out")) << paths.back();
    }
    setExports({"out/a.obj", "out/a.usda", "out/b.obj"});
    EXPECT_EQ(run({"check", "p.quadrille"}).status, 0) << "pictures beside one clip are the same pictures";
}

TEST_F(Outputs, AProjectWritesNowhereElseUnasked)
{
    makeProject();
    fs::create_directories(folder / "in");
    for (const char* name : {"p.quadrille", "takes", "man.obj"})
        fs::rename(folder / name, folder / "in" / name);
    fs::create_directories(folder / "victim");
    fs::create_directory_symlink(folder / "victim", folder / "in/exports");
    fs::create_directory_symlink("../missing", folder / "in/dangling");
    fs::create_symlink(folder / "victim/target.pc2", folder / "in/file.pc2");
    const auto setPath = [this](const std::string& path) {
        Project project = loadProject(folder / "in/p.quadrille");
        ExportEntry entry;
        entry.name = "e";
        entry.what = "sequences/jog 1";
        entry.path = path;
        project.exports = {entry};
        saveProject(project, folder / "in/p.quadrille");
    };
    for (const std::string& path :
         {std::string("../../x.glb"), std::string("../x.pc2"), (folder / "victim/x.pc2").string(),
          std::string("takes/../../x.pc2"), std::string("exports/x.pc2"), std::string("dangling/x.pc2")}) {
        setPath(path);
        const Outcome rebuilt = run({"rebuild", "in/p.quadrille", "--overwrite"});
        EXPECT_EQ(rebuilt.status, 1) << path;
        EXPECT_THAT(rebuilt.err, HasSubstr("--allow-outside")) << path;
        EXPECT_EQ(run({"check", "in/p.quadrille"}).status, 1) << path;
        EXPECT_TRUE(fs::is_empty(folder / "victim")) << path;
        EXPECT_FALSE(fs::exists(folder / "missing")) << path;
        EXPECT_FALSE(fs::exists(folder / "x.pc2")) << path;
    }
    setPath("file.pc2");
    EXPECT_EQ(run({"rebuild", "in/p.quadrille"}).status, 1) << "a link is nobody's own file";
    EXPECT_EQ(run({"rebuild", "in/p.quadrille", "--overwrite"}).status, 0);
    EXPECT_TRUE(fs::is_empty(folder / "victim")) << "the link is replaced, not followed";
    setPath("exports/x.pc2");
    EXPECT_EQ(run({"rebuild", "in/p.quadrille", "--allow-outside"}).status, 0);
    EXPECT_TRUE(fs::exists(folder / "victim/x.pc2"));
    EXPECT_EQ(run({"check", "in/p.quadrille", "--allow-outside"}).status, 0);
}

TEST_F(Outputs, ResultsDoNotFollowALinkOut)
{
    makeProject();
    fs::create_directories(folder / "in");
    for (const char* name : {"p.quadrille", "takes", "man.obj"})
        fs::rename(folder / name, folder / "in" / name);
    fs::create_directories(folder / "victim");
    fs::create_directory_symlink(folder / "victim", folder / "in/p.quadrille.cache");
    const Outcome rebuilt = run({"rebuild", "in/p.quadrille"});
    EXPECT_EQ(rebuilt.status, 1);
    EXPECT_THAT(rebuilt.err, HasSubstr("--allow-outside"));
    EXPECT_TRUE(fs::is_empty(folder / "victim"));
    EXPECT_EQ(run({"rebuild", "in/p.quadrille", "--allow-outside"}).status, 0);
}

TEST_F(Outputs, DataAndReportsDoNotHitInputs)
{
    makeProject();
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    fs::copy_file(folder / "man.obj", folder / "data.csv");
    Project project = loadProject(folder / "p.quadrille");
    project.sequences.front().jointAngles = "data.csv";
    saveProject(project, folder / "p.quadrille");
    EXPECT_EQ(run({"data", "p.quadrille", "frames", "-o", "data.csv", "--overwrite"}).status, 1);
    EXPECT_EQ(textOf(folder / "data.csv"), textOf(folder / "man.obj"));
    folder.write("notes.csv", "mine");
    EXPECT_EQ(run({"data", "p.quadrille", "frames", "-o", "notes.csv"}).status, 1);
    EXPECT_EQ(run({"data", "p.quadrille", "frames", "-o", "notes.csv", "--overwrite"}).status, 0);
    EXPECT_EQ(run({"data", "p.quadrille", "frames", "-o", "notes.csv"}).status, 0);
    const std::string mesh = textOf(folder / "man.obj");
    EXPECT_EQ(run({"rebuild", "p.quadrille", "--json", "man.obj", "--overwrite"}).status, 1);
    EXPECT_EQ(textOf(folder / "man.obj"), mesh);
}

TEST_F(Outputs, HashesInAnExportsNameAreTheNumberOfTheFrame)
{
    makeProject();
    setExports({"out/tour_####.obj"});
    ASSERT_EQ(run({"rebuild", "p.quadrille"}).status, 0);
    EXPECT_TRUE(fs::exists(folder / "out/tour_0000.obj"));
    EXPECT_TRUE(fs::exists(folder / "out/tour_0003.obj"));
    EXPECT_EQ(run({"convert", "frames", "short/a##b.ply", "--range", "0:2"}).status, 0);
    EXPECT_TRUE(fs::exists(folder / "short/a02b.ply"));
    EXPECT_EQ(info({"out/tour_####.obj"})[0]["frames"], 4) << "it is read by the name that it was written by";
    const Outcome one = run({"convert", "frames", "tour_####.glb"});
    EXPECT_EQ(one.status, 1);
    EXPECT_THAT(one.err, HasSubstr("Leave the # out"));
}
