// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What all formats of positions alone have in common when they are written.
#include "fixture.h"
#include "testsequence.h"

#include <bit>
#include <gmock/gmock.h>

using namespace quadrille;

namespace {

class CacheWriter : public FolderTest, public ::testing::WithParamInterface<std::string>
{
public:
    std::filesystem::path out(const std::string& name) const { return folder() / (name + GetParam()); }
};

std::string plain(const std::string& extension)
{
    return extension.substr(1);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Formats, CacheWriter, ::testing::Values(".pc2", ".mdd", ".npy"),
                         [](const auto& format) { return plain(format.param); });

TEST_P(CacheWriter, ReadsBackBitByBit)
{
    const MeshSequence sequence = wanderingPyramid(5);
    exportSequence(sequence, folder() / "mesh.obj", {.range = FrameRange{FrameIndex(0), FrameIndex(0)}});
    exportSequence(sequence, out("take"));
    ImportOptions options;
    options.mesh = folder() / "mesh_0000.obj";
    const auto back = openSequences(out("take"), options).sequences.at(0);
    ASSERT_EQ(back.frameCount(), 5);
    for (std::int64_t f = 0; f < 5; ++f)
        EXPECT_EQ(positionsOf(back, f), positionsOf(sequence, f));
    EXPECT_EQ(back.topology->triangles(), sequence.topology->triangles());
}

TEST_P(CacheWriter, GoesRoundThroughOtherFormatsUnchanged)
{
    const MeshSequence sequence = wanderingPyramid(4);
    exportSequence(sequence, folder() / "a/p.obj");
    const auto fromObj = openSequences(folder() / "a").sequences.at(0);
    exportSequence(fromObj, out("take"));
    ImportOptions options;
    options.mesh = folder() / "a/p_0000.obj";
    const auto fromCache = openSequences(out("take"), options).sequences.at(0);
    exportSequence(fromCache, folder() / "b/p.ply");
    const auto fromPly = openSequences(folder() / "b").sequences.at(0);
    exportSequence(fromPly, folder() / "c/p.obj");
    const auto last = openSequences(folder() / "c").sequences.at(0);
    EXPECT_EQ(last.topology->triangles(), sequence.topology->triangles());
    for (std::int64_t f = 0; f < 4; ++f)
        EXPECT_EQ(positionsOf(last, f), positionsOf(sequence, f));
}

TEST_P(CacheWriter, LeavesNothingHalfWritten)
{
    CancelToken cancel;
    cancel.cancel();
    EXPECT_EQ(errorOf([&] { exportSequence(wanderingPyramid(5), out("take"), {}, Progress(cancel)); }).code(),
              ErrorCode::Cancelled);
    EXPECT_TRUE(names(folder()).empty());
    const auto blocked = write("file", "not a folder");
    EXPECT_EQ(errorOf([&] { exportSequence(wanderingPyramid(2), blocked / ("p" + GetParam())); }).code(),
              ErrorCode::WriteFailed);
}

/// The file read without this project's code: the last value of the last frame, and how many bytes stand
/// before the values.
TEST_P(CacheWriter, HoldsWhatItsFormatSays)
{
    const MeshSequence sequence = wanderingPyramid(3);
    exportSequence(sequence, out("take"));
    const std::string bytes = read(out("take"));
    const bool isBigEndian = GetParam() == ".mdd";
    const std::size_t header = bytes.size() - std::size_t{3} * 7 * 3 * 4;
    if (GetParam() == ".npy") {
        ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\1\0", 8));
        EXPECT_EQ(header,
                  10U + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]));
        EXPECT_NE(bytes.find("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 7, 3, ), }"),
                  std::string::npos);
    } else {
        EXPECT_EQ(header, isBigEndian ? 8U + 3 * 4 : 32U);
    }
    const auto all = loadFrames(sequence);
    for (std::size_t i = 0; i < all.size() * 3; ++i) {
        std::uint32_t bits = 0;
        for (std::size_t b = 0; b < 4; ++b) {
            const auto byte = static_cast<unsigned char>(bytes[header + 4 * i + b]);
            bits |= static_cast<std::uint32_t>(byte) << (isBigEndian ? 24 - 8 * b : 8 * b);
        }
        ASSERT_EQ(bits, std::bit_cast<std::uint32_t>(all[i / 3][static_cast<Eigen::Index>(i % 3)])) << i;
    }
}

TEST_P(CacheWriter, IsNotReadAnywayWhenItIsEmptyOrClosed)
{
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto file = write("take" + GetParam(), "");
    EXPECT_EQ(errorOf([&] { openSequences(file); }).code(), ErrorCode::FileEmpty);
    write("take" + GetParam(), "closed");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    if (::access(file.c_str(), R_OK) == 0)
        GTEST_SKIP() << "this user may read everything";
    const auto error = errorOf([&] { openSequences(file); });
    EXPECT_EQ(error.code(), ErrorCode::PermissionDenied);
    EXPECT_EQ(error.context().file, file);
}

TEST_P(CacheWriter, NamesBothNumbersWhenTheMeshDiffers)
{
    exportSequence(wanderingPyramid(2), out("take"));
    const auto mesh = write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto error = errorOf([&] { openSequences(out("take"), {.mesh = mesh}); });
    EXPECT_EQ(error.code(), ErrorCode::VertexCountMismatch);
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("3 vertices where 7 (" + out("take").filename().string() + ") are"));
}

using Mdd = FolderTest;

TEST_F(Mdd, CarriesItsRate)
{
    const MeshSequence sequence = wanderingPyramid(25); // 24 fps
    exportSequence(sequence, folder() / "take.mdd");
    exportSequence(sequence, folder() / "mesh.ply", {.range = FrameRange{FrameIndex(0), FrameIndex(0)}});
    const auto result = openSequences(folder() / "take.mdd", {.mesh = folder() / "mesh_0000.ply"});
    EXPECT_TRUE(result.hasOwnFps);
    EXPECT_DOUBLE_EQ(result.sequences.at(0).fps, 24);
}

TEST_F(Mdd, IsBigEndian)
{
    exportSequence(wanderingPyramid(2), folder() / "take.mdd");
    const std::string bytes = read(folder() / "take.mdd");
    EXPECT_EQ(bytes.substr(0, 8), std::string("\0\0\0\2\0\0\0\7", 8));
    EXPECT_EQ(bytes.size(), 8 + 2 * 4 + 2 * 7 * 12);
    EXPECT_EQ(bytes.substr(16 + 4, 4), "\x3f\x8c\xcc\xcd"); // 1.1, the height of the tip
}

TEST_F(Mdd, RefusesWhatIsDamaged)
{
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto codeOf = [&](const std::string& bytes) {
        return errorOf([&] { openSequences(write("bad.mdd", bytes)); }).code();
    };
    const auto counts = [](std::uint32_t frames, std::uint32_t points) {
        std::string bytes;
        for (const std::uint32_t value : {frames, points}) {
            for (const unsigned shift : {24U, 16U, 8U, 0U})
                bytes += static_cast<char>(value >> shift);
        }
        return bytes;
    };
    EXPECT_EQ(codeOf("1234"), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(counts(2, 3) + std::string(8 + 50, '\0')), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(counts(2, 0) + std::string(8, '\0')), ErrorCode::NoVertices);
    EXPECT_EQ(codeOf(counts(0, 3) + std::string(100, '\0')), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf(counts(0x7FFFFFFF, 3) + std::string(100, '\0')), ErrorCode::CountTooLarge);
    EXPECT_EQ(codeOf(counts(1, 0x7FFFFFFF) + std::string(100, '\0')), ErrorCode::CountTooLarge);
    std::string notANumber = counts(1, 3) + std::string(4 + 36, '\0');
    notANumber.replace(8 + 4, 4, "\x7f\xc0\x00\x00", 4);
    EXPECT_EQ(codeOf(notANumber), ErrorCode::NonFiniteCoordinate);
}
