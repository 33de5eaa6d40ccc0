// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/usdwriter.h"
#include "tests/model/markedpng.h"
#include "tests/model/sequence/io/sceneiotest.h"
#include "tests/model/sequence/io/testsequence.h"

#include <charconv>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;

namespace {

/// What follows "NAME = " (or the last "NAME: ") in a USD text.
std::string_view valueOf(std::string_view text, const std::string& name)
{
    const auto at = text.find(name);
    if (at == std::string_view::npos)
        throw std::runtime_error("no " + name);
    return text.substr(at + name.size());
}

/// All numbers up to the closing bracket.
std::vector<double> numbersOf(std::string_view list)
{
    std::vector<double> numbers;
    list = list.substr(0, list.find(']'));
    const char* end = list.data() + list.size();
    for (const char* at = list.data(); at < end;) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error == std::errc())
            numbers.push_back(value);
        at = error == std::errc() ? next : at + 1;
    }
    return numbers;
}

} // namespace

TEST(Usd, PointsFacesAndUvsComeBackExactly)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(4);
    const ExportResult written = UsdExporter().write(sequence, folder / "pyramid.usda", {}, {});
    EXPECT_EQ(written.files.size(), 1U);
    const std::string text = textOf(folder / "pyramid.usda");
    EXPECT_TRUE(text.starts_with("#usda 1.0\n"));
    EXPECT_EQ(numbersOf(valueOf(text, "faceVertexCounts = ")), std::vector<double>(8, 3));
    const auto corners = numbersOf(valueOf(text, "faceVertexIndices = "));
    const auto uvs = numbersOf(valueOf(text, "primvars:st = "));
    const auto uvIndices = numbersOf(valueOf(text, "primvars:st:indices = "));
    const TopologyData& data = sequence.topology->data();
    ASSERT_EQ(corners.size(), 24U);
    ASSERT_EQ(uvIndices.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_EQ(corners[i], data.triangles[i / 3][i % 3].value);
        const Vec2f uv = data.uvs[data.triangleUvs[i / 3][i % 3]];
        const auto index = static_cast<std::size_t>(uvIndices[i]);
        EXPECT_EQ(Vec2f(static_cast<float>(uvs[index * 2]), static_cast<float>(uvs[index * 2 + 1])), uv);
    }
    const auto points = valueOf(text, "points.timeSamples = {");
    for (int f = 0; f < 4; ++f) {
        const auto values = numbersOf(valueOf(points, "\n            " + std::to_string(f) + ": "));
        ASSERT_EQ(values.size(), 21U);
        const Frame frame = sequence.frame(FrameIndex(f));
        for (std::size_t i = 0; i < 21; ++i)
            EXPECT_EQ(static_cast<float>(values[i]),
                      frame.positions()[i / 3][static_cast<Eigen::Index>(i % 3)]);
    }
    const auto extent = numbersOf(valueOf(valueOf(text, "extent.timeSamples = {"), "0: "));
    EXPECT_EQ(extent, (std::vector<double>{-1, -1, -1, 1, 1.1, 1}));
}

TEST(Usd, TheHeaderTellsTimeUnitAndAxis)
{
    const TemporaryFolder folder;
    ExportOptions options;
    options.to = {UpAxis::Z, 0.01};
    UsdExporter().write(wanderingPyramid(4), folder / "h.usda", options, {});
    const std::string text = textOf(folder / "h.usda");
    EXPECT_THAT(text, HasSubstr("metersPerUnit = 0.01\n"));
    EXPECT_THAT(text, HasSubstr("upAxis = \"Z\"\n"));
    EXPECT_THAT(text, HasSubstr("startTimeCode = 0\n"));
    EXPECT_THAT(text, HasSubstr("endTimeCode = 3\n"));
    EXPECT_THAT(text, HasSubstr("timeCodesPerSecond = 24\n"));
    EXPECT_THAT(text, HasSubstr("defaultPrim = \"pyramid\""));
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
    options.to.up = UpAxis::X;
    EXPECT_EQ(codeOf([&] { UsdExporter().write(wanderingPyramid(4), folder / "x.usda", options, {}); }),
              ErrorCode::FormatCannotStore);
}

TEST(Usd, MaterialsBecomeSubsetsWithTheirPictures)
{
    const TemporaryFolder folder;
    MeshSequence sequence = wanderingPyramid(2);
    sequence.textures = TextureSet::perMaterial({{{}, plainImage(10)}, {{}, plainImage(20)}});
    const ExportResult written = UsdExporter().write(sequence, folder / "m.usda", {}, {});
    ASSERT_EQ(written.files.size(), 3U);
    const std::string text = textOf(folder / "m.usda");
    EXPECT_THAT(text, HasSubstr("asset inputs:file = @./m_texture.png@"));
    EXPECT_THAT(text, HasSubstr("asset inputs:file = @./m_texture2.png@"));
    EXPECT_EQ(readImage(folder / "m_texture2.png"), *plainImage(20));
    const auto lower = numbersOf(valueOf(valueOf(text, "GeomSubset \"lower\""), "indices = "));
    EXPECT_THAT(lower, ::testing::ElementsAre(1, 3, 5, 7));
}

TEST(Usd, PicturesAreWrittenAsSrgb)
{
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name, const std::vector<std::byte>& png) {
        MeshSequence sequence = wanderingPyramid(2);
        const std::string text(reinterpret_cast<const char*>(png.data()), png.size());
        sequence.textures = TextureSet::single({folder.write(name + ".in.png", text)});
        UsdExporter().write(sequence, folder / (name + ".usda"), {}, {});
        return textOf(folder / (name + "_texture.png"));
    };
    const auto png = encodeImage(*plainImage(55), ".png");
    const auto usual = test::withPngGamma(png, 45'455);
    EXPECT_EQ(write("usual", usual), std::string(reinterpret_cast<const char*>(usual.data()), usual.size()));
    write("linear", test::withPngGamma(png, 100'000));
    EXPECT_EQ(readImage(folder / "linear_texture.png", ColourMarks::Ignored), *plainImage(128));
}

TEST(Usd, TexturesPerFrameAreTimeSamples)
{
    const TemporaryFolder folder;
    MeshSequence sequence = wanderingPyramid(3);
    sequence.textures = TextureSet::perFrame({{{}, plainImage(1)}, {{}, plainImage(2)}, {{}, plainImage(3)}});
    const ExportResult written =
        UsdExporter().write(sequence.cutTo({FrameIndex(1), FrameIndex(2)}), folder / "t.usda", {}, {});
    EXPECT_EQ(written.files.size(), 3U);
    const std::string text = textOf(folder / "t.usda");
    EXPECT_THAT(text, HasSubstr("asset inputs:file.timeSamples = {"));
    EXPECT_THAT(text, HasSubstr("1: @./textures/t/0001.png@,"));
    EXPECT_EQ(readImage(folder / "textures/t/0000.png"), *plainImage(2));
}

TEST(Usd, CancellingLeavesNothing)
{
    const TemporaryFolder folder;
    CancelToken token;
    token.cancel();
    MeshSequence sequence = wanderingPyramid(3);
    sequence.textures = TextureSet::single({{}, plainImage(1)});
    EXPECT_EQ(codeOf([&] { UsdExporter().write(sequence, folder / "c.usda", {}, Progress(token)); }),
              ErrorCode::Cancelled);
    // … and when it is cancelled after the picture was copied.
    CancelToken later;
    const Progress progress(later, [&](double fraction) {
        if (fraction >= 0.2)
            later.cancel();
    });
    EXPECT_EQ(codeOf([&] { UsdExporter().write(sequence, folder / "c.usda", {}, progress); }),
              ErrorCode::Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}
