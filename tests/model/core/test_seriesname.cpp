// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/fileplace.h"
#include "model/core/seriesname.h"
#include "tests/model/core/temporaryfolder.h"

#include <gtest/gtest.h>

using namespace quadrille;
namespace fs = std::filesystem;

TEST(SeriesName, NumbersStandWhereTheNameSaysSo)
{
    struct Case
    {
        const char* out;
        std::int64_t number;
        std::int64_t count;
        const char* name;
        const char* stem;
    };
    const Case cases[] = {
        {"dir/walk.obj", 7, 10, "walk_0007.obj", "walk"},  {"walk.obj", 7, 123456, "walk_000007.obj", "walk"},
        {"tour_####.obj", 0, 48, "tour_0000.obj", "tour"}, {"tour_##.obj", 7, 48, "tour_07.obj", "tour"},
        {"tour_#.obj", 7, 8, "tour_7.obj", "tour"},        {"tour_#.obj", 7, 11, "tour_07.obj", "tour"},
        {"tour_%03d.png", 7, 8, "tour_007.png", "tour"},   {"##_tour.ply", 3, 8, "03_tour.ply", "tour"},
        {"####.ply", 3, 8, "0003.ply", "frames"},          {"50%.ply", 3, 8, "50%_0003.ply", "50%"},
    };
    for (const Case& each : cases) {
        EXPECT_EQ(numberedName(each.out, each.number, each.count), each.name);
        EXPECT_EQ(seriesStem(each.out), each.stem) << each.out;
    }
}

TEST(FilePlace, LinksAndDotsAreResolvedAlsoWhereNothingIs)
{
    const test::TemporaryFolder own;
    const fs::path folder = fs::canonical(own.path());
    fs::create_directories(folder / "a/b");
    fs::create_directory_symlink("../elsewhere", folder / "a/dangling");
    fs::create_directory_symlink("b", folder / "a/link");
    fs::create_directory_symlink("loop", folder / "loop");
    EXPECT_EQ(resolvedFolder(folder / "a/link"), folder / "a/b");
    EXPECT_EQ(resolvedFolder(folder / "a/link/../x"), folder / "a/x");
    EXPECT_EQ(resolvedFolder(folder / "a/dangling/x"), folder / "elsewhere/x");
    EXPECT_EQ(resolvedFolder(folder / "new/../../x"), folder.parent_path() / "x");
    EXPECT_EQ(resolvedPlace(folder / "a/link"), folder / "a/link") << "a file takes the place of a link";
    EXPECT_EQ(resolvedPlace(folder / "a/link/f"), folder / "a/b/f");
    resolvedFolder(folder / "loop/x"); // comes to an end
    EXPECT_EQ(resolvedFolder(""), resolvedFolder(fs::current_path())) << "of a file without a folder";
    EXPECT_TRUE(liesIn(folder / "a/b", folder / "a"));
    EXPECT_TRUE(liesIn(folder / "a", folder / "a"));
    EXPECT_FALSE(liesIn(folder / "ab", folder / "a"));
    EXPECT_FALSE(liesIn(folder, folder / "a"));
}
