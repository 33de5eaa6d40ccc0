// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/media/media.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/project/testproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::ElementsAre;

namespace {

/// A project with a mesh, a take, a numbered take and a folder of pictures, all of them noted.
class FindMedia : public ::testing::Test
{
protected:
    FindMedia()
    {
        folder.write("old/mesh.obj", "the mesh");
        folder.write("old/walk.pc2", "the walk");
        folder.write("old/run/run_1.obj", "run, frame 1");
        folder.write("old/run/run_2.obj", "run, frame 2");
        folder.write("old/pictures/a.png", "picture a");
        folder.write("old/pictures/b.png", "picture b");
        project.characters = {characterOf("ada", "old/mesh.obj")};
        project.sequences = {sequenceOf("walk", "old/walk.pc2"), sequenceOf("run", "old/run/run_#.obj")};
        project.sequences[0].texture = textureOf(TextureReference::Kind::PerFrame, {"old/pictures"});
        FileHashes hashes;
        known = contentsOfMedia(project, folder.path(), hashes);
    }
    std::vector<FoundMedium> find(std::vector<std::string> paths, const std::string& where = "new") const
    {
        return findMedia({std::move(paths), known, folder / where, {}});
    }

    TemporaryFolder folder;
    Project project;
    KnownMedia known;
};

} // namespace

TEST_F(FindMedia, AllThatMovedIsRelinked)
{
    ASSERT_EQ(known.size(), 4U);
    fs::create_directories(folder / "new/deep");
    fs::rename(folder / "old", folder / "new/deep/data");
    const RelinkReport report = relinkMedia(project, folder.path(), folder / "new", known);
    EXPECT_EQ(report.moved.size(), 4U);
    EXPECT_TRUE(report.missing.empty());
    EXPECT_EQ(project.characters[0].mesh, "new/deep/data/mesh.obj");
    EXPECT_EQ(project.sequences[0].source, "new/deep/data/walk.pc2");
    EXPECT_EQ(project.sequences[1].source, "new/deep/data/run/run_#.obj");
    EXPECT_THAT(project.sequences[0].texture.paths, ElementsAre("new/deep/data/pictures"));
}

TEST_F(FindMedia, SaysHowSureItIs)
{
    folder.write("new/a/walk.pc2", "THE WALK"); // of the same size
    folder.write("new/b/walk.pc2", "the walk");
    folder.write("new/c/another.obj", "the mesh");
    folder.write("new/run_1.obj", "run, frame 1");
    folder.write("new/run_2.obj", "something else");
    folder.write("new/photos/1.png", "picture a");
    folder.write("new/photos/2.png", "picture b");
    const auto found =
        find({"old/walk.pc2", "old/mesh.obj", "old/run/run_#.obj", "old/pictures", "old/gone"});
    ASSERT_EQ(found.size(), 5U);
    EXPECT_EQ(found[0].file, folder / "new/b/walk.pc2");
    EXPECT_EQ(found[0].match, MediaMatch::NameAndContent);
    EXPECT_EQ(found[1].file, folder / "new/c/another.obj");
    EXPECT_EQ(found[1].match, MediaMatch::Content);
    EXPECT_EQ(found[2].file, folder / "new/run_#.obj");
    EXPECT_EQ(found[2].match, MediaMatch::OtherContent);
    EXPECT_EQ(found[3].file, folder / "new/photos");
    EXPECT_EQ(found[3].match, MediaMatch::Content);
    EXPECT_EQ(found[4].match, MediaMatch::Missing);
    EXPECT_TRUE(found[4].file.empty());
}

TEST_F(FindMedia, ANamesakeWithOtherContentIsNotRelinked)
{
    folder.write("new/walk.pc2", "another walk");
    fs::remove(folder / "old/walk.pc2");
    const RelinkReport report = relinkMedia(project, folder.path(), folder / "new", known);
    EXPECT_TRUE(report.moved.empty());
    ASSERT_EQ(report.different.size(), 1U);
    EXPECT_EQ(report.different[0].file, folder / "new/walk.pc2");
    EXPECT_EQ(project.sequences[0].source, "old/walk.pc2");
}

TEST_F(FindMedia, OfUnknownNamesakesTheNearestIsTaken)
{
    known.clear();
    folder.write("new/a/walk.pc2", "one");
    folder.write("new/old/walk.pc2", "two");
    folder.write("new/z/walk.pc2", "three");
    const auto found = find({"old/walk.pc2"});
    EXPECT_EQ(found[0].file, folder / "new/old/walk.pc2");
    EXPECT_EQ(found[0].match, MediaMatch::Name);
    EXPECT_TRUE(found[0].isAmbiguous);
}

TEST_F(FindMedia, WhatWentTheSameWayIsFoundBesideTheFolder)
{
    folder.write("new/takes/walk.pc2", "the walk");
    folder.write("new/mesh.obj", "the mesh");
    MediaSearch search{{(folder / "old/mesh.obj").string()}, {}, folder / "new/takes", {}};
    EXPECT_EQ(findMedia(search)[0].match, MediaMatch::Missing);
    search.example = {folder / "old/takes/walk.pc2", folder / "new/takes/walk.pc2"};
    EXPECT_EQ(findMedia(search)[0].file, folder / "new/mesh.obj");
}

TEST_F(FindMedia, ComparesWhatSomebodyChose)
{
    const auto match = [&](const std::string& path, const std::string& file) {
        return examineMedium(path, folder / file, known).match;
    };
    folder.write("x.pc2", "the walk");
    EXPECT_EQ(match("old/walk.pc2", "x.pc2"), MediaMatch::Content);
    EXPECT_EQ(match("old/walk.pc2", "old/mesh.obj"), MediaMatch::OtherContent);
    EXPECT_EQ(match("old/walk.pc2", "nowhere"), MediaMatch::Missing);
    EXPECT_EQ(match("never/noted.pc2", "x.pc2"), MediaMatch::Name);
}

TEST_F(FindMedia, StopsAndRefusesAMissingFolder)
{
    CancelToken token;
    token.cancel();
    EXPECT_THROW(findMedia({{"old/walk.pc2"}, known, folder.path(), {}}, Progress(token)), Error);
    EXPECT_THROW(find({"old/walk.pc2"}, "nowhere"), Error);
}

TEST_F(FindMedia, LinksAreNotFollowedInCircles)
{
    known.clear();
    folder.write("new/a/walk.pc2", "the walk");
    fs::create_directory_symlink(folder / "new", folder / "new/a/again");
    fs::create_symlink("nowhere", folder / "new/dangling");
    const auto found = find({"old/walk.pc2"});
    EXPECT_EQ(found[0].file, folder / "new/a/walk.pc2");
    EXPECT_FALSE(found[0].isAmbiguous);
}

TEST_F(FindMedia, NotesOfWhatIsGoneAreKept)
{
    const fs::path file = folder / "p.quadrille";
    noteMedia(project, file);
    EXPECT_EQ(readKnownMedia(cacheFolder(file)), known);
    fs::remove(folder / "old/walk.pc2");
    folder.write("old/mesh.obj", "another mesh");
    noteMedia(project, file);
    const KnownMedia after = readKnownMedia(cacheFolder(file));
    EXPECT_EQ(after.at("old/walk.pc2"), known.at("old/walk.pc2"));
    EXPECT_EQ(after.at("old/mesh.obj").bytes, 12U);
    folder.write("p.quadrille.cache/media.json", "[1");
    EXPECT_TRUE(readKnownMedia(cacheFolder(file)).empty());
}
