// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/importsurvey.h"
#include "model/sequence/io/registry.h"
#include "testproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view triangle = "v 0 0 0\nv 1 0 0\nv 0 170 0\nf 1 2 3\n";

class ImportSurvey : public ::testing::Test
{
protected:
    fs::path write(const std::string& name, std::string_view text = triangle) const
    {
        return folder.write(name, text);
    }
    void writeCache(const std::string& name) const
    {
        const auto mesh = write("elsewhere/mesh.obj");
        exportSequence(openSequences(mesh).sequences.front(), folder / name);
    }
    std::vector<std::string> found(const std::vector<fs::path>& paths) const
    {
        std::vector<std::string> names;
        for (const fs::path& source : findSources(paths).sources)
            names.push_back(fs::relative(source, folder.path()).generic_string());
        return names;
    }

    test::TemporaryFolder folder;
};

} // namespace

TEST_F(ImportSurvey, ANumberedFileStandsForItsSeries)
{
    const auto first = write("s/f_8.obj");
    const auto second = write("s/f_10.obj");
    EXPECT_THAT(found({first}), ElementsAre("s/f_####.obj"));
    EXPECT_THAT(found({first, second}), ElementsAre("s/f_####.obj"));
    EXPECT_THAT(found({write("s/single.obj")}), ElementsAre("s/single.obj"));
}

TEST_F(ImportSurvey, AFolderStandsForTheTakesInItAndBelow)
{
    for (const char* name :
         {"a/walk_1.obj", "a/walk_2.obj", "a/run_1.ply", "b/x_1.obj", "b/x_2.obj", ".hidden/y_1.obj"})
        write(name);
    write("readme.txt", "no mesh");
    EXPECT_THAT(found({folder.path()}), ElementsAre("a/walk_####.obj", "b/x_####.obj", "a/run_1.ply"));
}

TEST_F(ImportSurvey, AMeshBesidePointCachesIsTheirs)
{
    writeCache("c/take_10.pc2");
    writeCache("c/take_9.pc2");
    const auto mesh = write("c/mesh.obj");
    const auto sources = findSources(std::vector{folder / "c"});
    EXPECT_THAT(sources.sources, ElementsAre(folder / "c/take_9.pc2", folder / "c/take_10.pc2"));
    EXPECT_EQ(sources.mesh, mesh);
    EXPECT_EQ(findSources(std::vector{folder / "c/take_9.pc2", mesh}).mesh, mesh);
}

TEST_F(ImportSurvey, SaysWhenThereIsNothing)
{
    write("readme.txt", "no mesh");
    EXPECT_THROW(found({folder.path()}), Error);
}

TEST_F(ImportSurvey, DescribesTakesAndWhyOneCannotBeOpened)
{
    write("s/f_1.obj");
    write("s/f_3.obj");
    write("s/f_2.bvh", "HIERARCHY");
    const auto broken = write("broken.obj", "v 0 0 0\nf 1 2 3\n");
    writeCache("c/take.pc2");
    write("c/mesh.ply", "nothing");
    const auto mesh = write("c/other.obj");
    write("c/take.bvh", "HIERARCHY");
    SurveyOptions options;
    options.mesh = mesh;
    options.fps = 30;
    const auto takes = surveySources({folder / "s/f_####.obj", broken, folder / "c/take.pc2"}, options);
    ASSERT_EQ(takes.size(), 3U);
    EXPECT_EQ(takes[0].format, "Wavefront OBJ");
    ASSERT_TRUE(takes[0].sequence);
    EXPECT_EQ(takes[0].sequence->frameCount(), 2);
    EXPECT_EQ(takes[0].size, Vec3f(1, 170, 0));
    EXPECT_FALSE(takes[0].hasOwnFps);
    EXPECT_TRUE(std::ranges::any_of(
        takes[0].issues, [](const Issue& issue) { return issue.code == Issue::Code::NumberingGap; }));
    EXPECT_FALSE(takes[1].sequence);
    ASSERT_TRUE(takes[1].error);
    EXPECT_EQ(takes[1].error->code(), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(takes[2].mesh, mesh);
    EXPECT_EQ(takes[2].jointAngles, folder / "c/take.bvh");
    EXPECT_EQ(takes[2].sequence->fps, 30);
}

TEST_F(ImportSurvey, NamesTheMeshThatItFoundBeside)
{
    writeCache("c/take.pc2");
    const auto mesh = write("c/mesh.obj");
    EXPECT_EQ(surveySources({folder / "c/take.pc2"}, {}).at(0).mesh, mesh);
}

TEST_F(ImportSurvey, TakesTheMeshOfACharacterThatFits)
{
    writeCache("c/take.pc2");
    const fs::path known = folder / "elsewhere/mesh.obj";
    const fs::path other = write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");
    SurveyOptions options;
    EXPECT_TRUE(surveySources({folder / "c/take.pc2"}, options).at(0).error);
    options.knownMeshes = {other, folder / "gone.obj", known};
    const SurveyedTake take = surveySources({folder / "c/take.pc2"}, options).at(0);
    EXPECT_FALSE(take.error);
    EXPECT_EQ(take.mesh, known);
    options.knownMeshes = {other};
    const auto without = surveySources({folder / "c/take.pc2"}, options);
    ASSERT_TRUE(without.at(0).error);
    EXPECT_EQ(without.at(0).error->code(), ErrorCode::FormatNeedsMesh);
}

TEST_F(ImportSurvey, CanBeCancelled)
{
    CancelToken cancel;
    cancel.cancel();
    EXPECT_THROW(surveySources({write("a.obj"), write("b.obj")}, {}, Progress(cancel)), Error);
}

TEST_F(ImportSurvey, ProposesTheUnitThatMakesAPerson)
{
    EXPECT_EQ(likelyMetresPerUnit(1.75), 1);
    EXPECT_EQ(likelyMetresPerUnit(175), 0.01);
    EXPECT_EQ(likelyMetresPerUnit(1750), 0.001);
    EXPECT_EQ(likelyMetresPerUnit(0.01), 1);
}
