// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

constexpr std::string_view loneTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::vector<std::string> fileNames(const SourceFiles& source)
{
    std::vector<std::string> names;
    for (const auto& file : source.files)
        names.push_back(file.filename().string());
    return names;
}

using Registry = FolderTest;

} // namespace

TEST_F(Registry, FindsASeriesInNaturalOrderAndKeepsItsGaps)
{
    for (const char* name : {"walk10.obj", "walk2.obj", "walk1.obj", "walk9.obj", "notes.txt"})
        write(name, loneTriangle);
    const auto source = findSource(folder());
    EXPECT_THAT(fileNames(source), ElementsAre("walk1.obj", "walk2.obj", "walk9.obj", "walk10.obj"));
    EXPECT_THAT(source.numbers, ElementsAre(1, 2, 9, 10));
    EXPECT_THAT(source.missing, ElementsAre(3, 4, 5, 6, 7, 8));
    EXPECT_EQ(source.stem, "walk");
    EXPECT_TRUE(source.isSeries());
}

TEST_F(Registry, TakesAnyPrefixAndTheNumberThatRuns)
{
    for (const char* name : {"take2_f001_v3.obj", "take2_f002_v3.obj", "take2_f003_v3.obj"})
        write(name, loneTriangle);
    const auto source = findSource(folder());
    EXPECT_THAT(source.numbers, ElementsAre(1, 2, 3));
    for (const char* name : {"0.obj", "1.obj"})
        write(std::string("plain/") + name, loneTriangle);
    EXPECT_THAT(findSource(folder() / "plain").numbers, ElementsAre(0, 1));
}

TEST_F(Registry, LeavesOtherMeshesBesideASeriesOut)
{
    for (const char* name : {"a_1.obj", "a_2.obj", "template.obj"})
        write(name, loneTriangle);
    EXPECT_THAT(fileNames(findSource(folder())), ElementsAre("a_1.obj", "a_2.obj"));
}

TEST_F(Registry, SaysWhatAFolderHoldsWhenItIsNotOneSeries)
{
    EXPECT_EQ(errorOf([&] { findSource(folder()); }).code(), ErrorCode::SeriesEmpty);
    write("one.obj", loneTriangle);
    EXPECT_THAT(fileNames(findSource(folder())), ElementsAre("one.obj"));
    write("other.obj", loneTriangle);
    const auto singles = errorOf([&] { findSource(folder()); });
    EXPECT_EQ(singles.code(), ErrorCode::SeriesAmbiguous);
    EXPECT_THAT(singles.what(), HasSubstr("the file one.obj"));
    for (const char* name : {"a_1.obj", "a_2.obj", "b_1.obj", "b_2.obj", "b_3.obj"})
        write(name, loneTriangle);
    const auto two = errorOf([&] { findSource(folder()); });
    EXPECT_EQ(two.code(), ErrorCode::SeriesAmbiguous);
    EXPECT_THAT(two.what(), HasSubstr("a series of 2 files from a_1.obj to a_2.obj"));
    EXPECT_THAT(two.what(), HasSubstr("a series of 3 files from b_1.obj to b_3.obj"));
}

TEST_F(Registry, RefusesTwoFilesWithOneNumber)
{
    for (const char* name : {"a_1.obj", "a_01.obj", "a_2.obj"})
        write(name, loneTriangle);
    EXPECT_EQ(errorOf([&] { findSource(folder()); }).code(), ErrorCode::SeriesAmbiguous);
}

TEST_F(Registry, FindsPatterns)
{
    for (const char* name : {"a_0008.obj", "a_0009.obj", "a_10.obj", "b_0001.obj", "a_x.obj"})
        write(name, loneTriangle);
    for (const char* pattern : {"a_####.obj", "a_%04d.obj", "a_%d.obj", "a_[0-9]*.obj"}) {
        const auto source = findSource(folder() / pattern);
        EXPECT_THAT(fileNames(source), ElementsAre("a_0008.obj", "a_0009.obj", "a_10.obj")) << pattern;
    }
    EXPECT_THAT(fileNames(findSource(folder() / "a_000?.obj")), ElementsAre("a_0008.obj", "a_0009.obj"));
    EXPECT_EQ(errorOf([&] { findSource(folder() / "*.obj"); }).code(), ErrorCode::SeriesAmbiguous);
    EXPECT_EQ(errorOf([&] { findSource(folder() / "c_###.obj"); }).code(), ErrorCode::SeriesEmpty);
}

TEST_F(Registry, ANumberedFileMeansThatFileButItsSeriesIsFound)
{
    for (const char* name : {"a_1.obj", "a_2.obj", "a_4.obj", "b_1.ply"})
        write(name, loneTriangle);
    const auto alone = findSource(folder() / "a_2.obj");
    EXPECT_FALSE(alone.isSeries());
    EXPECT_THAT(fileNames(alone), ElementsAre("a_2.obj"));
    const auto series = seriesAround(folder() / "a_2.obj");
    EXPECT_THAT(series.numbers, ElementsAre(1, 2, 4));
    EXPECT_FALSE(seriesAround(folder() / "b_1.ply").isSeries());
}

TEST_F(Registry, SurvivesTimeStampsAsNumbers)
{
    write("f1700000000000.obj", loneTriangle);
    write("f1700000033333.obj", loneTriangle);
    write("f99999999999999999999999.obj", loneTriangle);
    EXPECT_EQ(findSource(folder() / "f17*.obj").files.size(), 2U);
}

TEST_F(Registry, ReportsMissingPaths)
{
    EXPECT_EQ(errorOf([&] { openSequences(folder() / "no.obj"); }).code(), ErrorCode::FileNotFound);
    EXPECT_EQ(errorOf([&] { openSequences(folder() / "no" / "a_*.obj"); }).code(), ErrorCode::FileNotFound);
    EXPECT_EQ(errorOf([&] { openSequences(write("empty.obj", "")); }).code(), ErrorCode::FileEmpty);
}

TEST_F(Registry, ChoosesByExtensionThenBySignature)
{
    EXPECT_EQ(importerFor(findSource(write("a.OBJ", loneTriangle))).format().id, "obj");
    EXPECT_EQ(importerFor(findSource(write("mesh.dat", loneTriangle))).format().id, "obj");
    EXPECT_EQ(importerFor(findSource(write("cache", std::string_view("POINTCACHE2\0....", 16)))).format().id,
              "pc2");
    EXPECT_EQ(errorOf([&] { openSequences(write("a.txt", "hello")); }).code(), ErrorCode::FormatUnknown);
}

TEST_F(Registry, RefusesForeignFormatsWithARemedy)
{
    for (const char* name : {"a.abc", "a.bvh", "a.asf", "a.amc", "a.drc", "a.ktx2", "a.usdz", "a.usda",
                             "a.blend", "a.max", "a.ma", "a.mb", "a.c4d", "a.zip"}) {
        const auto error = errorOf([&] { openSequences(write(name, "whatever")); });
        EXPECT_EQ(error.code(), ErrorCode::FormatRefused) << name;
        EXPECT_GT(valueOf(error, "remedy").size(), 15U) << name;
    }
    for (const std::string_view head : {"Ogawa\xff", "DRACO\x02\x02", "\xABKTX 20\xBB\r\n\x1A\n",
                                        "BLENDER-v300", "PXR-USDC", "HIERARCHY\nROOT hips"}) {
        EXPECT_EQ(errorOf([&] { openSequences(write("renamed.bin", head)); }).code(),
                  ErrorCode::FormatRefused)
            << head;
    }
    for (const char* name : {"d/0001.drc", "d/0002.drc"})
        write(name, "DRACO");
    EXPECT_EQ(errorOf([&] { openSequences(folder() / "d"); }).code(), ErrorCode::FormatRefused);
}

TEST_F(Registry, ReportsGapsAndTheAssumedRate)
{
    for (const char* name : {"a_1.obj", "a_2.obj", "a_4.obj"})
        write(name, loneTriangle);
    const auto result = openSequences(folder(), {.fps = 30});
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::NumberingGap));
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::FpsAssumed));
    EXPECT_EQ(result.sequences.at(0).frameCount(), 3);
    EXPECT_EQ(result.sequences.at(0).fps, 30);
    const auto single = openSequences(folder() / "a_1.obj");
    EXPECT_FALSE(hasIssue(single.issues, Issue::Code::FpsAssumed));
}

TEST_F(Registry, ConvertsAxesAndUnit)
{
    const auto file = write("z.obj", "v 100 200 300\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto result = openSequences(file, {.from = CoordinateSystem{UpAxis::Z, 0.01}});
    EXPECT_TRUE(positionsOf(result.sequences.at(0))[0].isApprox(Vec3f(1, 3, -2)));
}

TEST_F(Registry, OrdersNamesNaturally)
{
    EXPECT_TRUE(naturalLess("f2", "f10"));
    EXPECT_FALSE(naturalLess("f10", "f2"));
    EXPECT_TRUE(naturalLess("f009", "f10"));
    EXPECT_TRUE(naturalLess("a", "b"));
    EXPECT_FALSE(naturalLess("a1", "a1"));
    EXPECT_TRUE(naturalLess("a", "a1"));
    EXPECT_NE(naturalLess("a01", "a1"), naturalLess("a1", "a01"));
}

TEST_F(Registry, DescribesNumbers)
{
    EXPECT_EQ(describeNumbers(std::vector<std::int64_t>{3, 7, 8, 9, 12, 13}), "3, 7–9, 12, 13");
}
