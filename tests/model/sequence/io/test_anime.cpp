// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/anime.h"
#include "model/sequence/io/files/appendbytes.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <limits>

using namespace quadrille;

namespace {

ImportResult openAnime(const std::filesystem::path& path)
{
    return AnimeImporter().open(fileSource(path), {}, {});
}

template <typename T>
void appendAll(std::string& bytes, std::initializer_list<T> values)
{
    for (const T value : values)
        appendBytes(bytes, value);
}

/// Two frames of one triangle; the second is raised by 2 along z.
std::string triangleFile()
{
    std::string file;
    appendAll<std::int32_t>(file, {2, 3, 1});
    appendAll<float>(file, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    appendAll<std::int32_t>(file, {0, 1, 2});
    appendAll<float>(file, {0, 0, 2, 0, 0, 2, 0, 0, 2});
    return file;
}

} // namespace

TEST(Anime, OffsetsAreAddedToTheFirstFrame)
{
    const TemporaryFolder folder;
    const ImportResult result = openAnime(folder.write("jump.anime", triangleFile()));
    const MeshSequence& sequence = result.sequences.at(0);
    EXPECT_EQ(sequence.name, "jump");
    ASSERT_EQ(sequence.frameCount(), 2);
    EXPECT_EQ(sequence.fps, ImportOptions().fps);
    EXPECT_EQ(sequence.frame(FrameIndex(0)).positions()[1], Vec3f(1, 0, 0));
    EXPECT_EQ(sequence.frame(FrameIndex(1)).positions()[1], Vec3f(1, 0, 2));
}

TEST(Anime, TheFoxEqualsItsPointCache)
{
    const auto file = dataDirectory() / "raw/fox_walk.anime";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no data";
    const ImportResult result = openAnime(file);
    const auto expected = readPointCache(dataDirectory() / "characters/fox/walk.pc2");
    const MeshSequence& sequence = result.sequences.at(0);
    ASSERT_EQ(sequence.frameCount(), static_cast<std::int64_t>(expected.frames));
    EXPECT_EQ(sequence.topology->triangles().size(), 1654U);
    const auto frames = loadFrames(sequence);
    float largest = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
        largest = std::max(largest, (frames[i] - expected.positions[i]).norm());
    EXPECT_LT(largest, 1e-6F * sizeOf(frames)); // one rounding of the sum
}

TEST(Anime, BadFilesAreRefused)
{
    const TemporaryFolder folder;
    const auto codeOfFile = [&](const std::string& content) {
        return codeOf([&] { openAnime(folder.write("bad.anime", content)); });
    };
    const std::string good = triangleFile();
    EXPECT_EQ(codeOf([&] { openAnime(folder / "none.anime"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOfFile(""), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOfFile(good.substr(0, 8)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOfFile(good.substr(0, good.size() - 1)), ErrorCode::FileTruncated);
    const auto header = [&](std::int32_t frames, std::int32_t vertices, std::int32_t triangles) {
        std::string file;
        appendAll<std::int32_t>(file, {frames, vertices, triangles});
        return file + good.substr(12);
    };
    EXPECT_EQ(codeOfFile(header(2, 2000000000, 1)), ErrorCode::CountTooLarge);
    EXPECT_EQ(codeOfFile(header(2, 3, 2000000000)), ErrorCode::CountTooLarge);
    EXPECT_EQ(codeOfFile(header(2000000000, 3, 1)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOfFile(header(-1, 3, 1)), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfFile(header(2, -3, 1)), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfFile(header(2, 0, 1)), ErrorCode::NoVertices);
    EXPECT_EQ(codeOfFile(header(2, 3, 0)), ErrorCode::NoFaces);
    std::string outside = good;
    outside[12 + 36] = 7;
    EXPECT_EQ(codeOfFile(outside), ErrorCode::IndexOutOfRange);
}

TEST(Anime, AFrameThatIsNotFiniteIsNamed)
{
    const TemporaryFolder folder;
    std::string content = triangleFile();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(content.data() + content.size() - 4, &nan, 4);
    const ImportResult result = openAnime(folder.write("nan.anime", content));
    EXPECT_NO_THROW(result.sequences.at(0).frame(FrameIndex(0)));
    EXPECT_EQ(codeOf([&] { result.sequences.at(0).frame(FrameIndex(1)); }), ErrorCode::NonFiniteCoordinate);
}

TEST(Anime, AFileThatShrinksMeanwhileIsAnError)
{
    const TemporaryFolder folder;
    const auto path = folder.write("shrinks.anime", triangleFile());
    const ImportResult result = openAnime(path);
    std::filesystem::resize_file(path, 70);
    EXPECT_EQ(codeOf([&] { result.sequences.at(0).frame(FrameIndex(1)); }), ErrorCode::FileTruncated);
}
