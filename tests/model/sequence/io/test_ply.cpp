// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "squaretriangles.h"

#include <bit>
#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::HasSubstr;

namespace {

using Ply = FolderTest;

const std::string squareHeader = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                                 "element face 2\nproperty list uchar int vertex_indices\nend_header\n";

std::string asciiSquare(const std::string& height)
{
    return "ply\nformat ascii 1.0\n" + squareHeader + "0 0 0\n1 " + height +
           " 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
}

template <typename Value>
std::string bytesOf(Value value, bool isBigEndian)
{
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (isBigEndian)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string binarySquare(float height, bool isBigEndian = false)
{
    std::string text = std::string("ply\nformat ") +
                       (isBigEndian ? "binary_big_endian" : "binary_little_endian") + " 1.0\n" + squareHeader;
    for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, height, 0.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F})
        text += bytesOf(value, isBigEndian);
    for (const auto& face : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        text += '\3';
        for (const std::int32_t corner : face)
            text += bytesOf(corner, isBigEndian);
    }
    return text;
}

} // namespace

TEST_F(Ply, ReadsEveryEncoding)
{
    for (const auto& content : {asciiSquare("0.25"), binarySquare(0.25F), binarySquare(0.25F, true)}) {
        const auto result = openSequences(write("a.ply", content));
        EXPECT_EQ(result.sequences.at(0).topology->triangles(), squareTriangles);
        EXPECT_EQ(positionsOf(result.sequences[0])[1], Vec3f(1, 0.25F, 0));
        EXPECT_FALSE(result.sequences[0].topology->hasUvs());
    }
}

TEST_F(Ply, FindsItsWayAmongOtherElementsAndProperties)
{
    const auto result = openSequences(
        write("a.ply", "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info nothing\r\n"
                       "element camera 1\r\nproperty list uchar float matrix\r\nproperty int id\r\n"
                       "element nothing 7\r\n"
                       "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\nproperty float64 y\r\n"
                       "property short x\r\nproperty list uchar int neighbours\r\n"
                       "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\n"
                       "element face 1\r\nproperty uchar flags\r\nproperty list uchar uint vertex_index\r\n"
                       "end_header\r\n"
                       "2 0.5 0.5 9\r\n"
                       "255 0 0 0 1 3\r\n255 0 0 1 0\r\n255 0 1 1 0\r\n255 2.5 1 0 2 1 1\r\n"
                       "0 1\r\n"
                       "1 4 0 1 2 3\r\n"));
    EXPECT_EQ(result.sequences.at(0).topology->triangles(), squareTriangles);
    EXPECT_EQ(positionsOf(result.sequences[0])[3], Vec3f(0, 1, 2.5F));
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::PolygonsTriangulated));
}

TEST_F(Ply, KeepsUvsOfCornersAndOfVertices)
{
    const std::string start = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\n";
    const auto corners =
        openSequences(write("corners.ply", start + "element face 2\nproperty list uchar int vertex_indices\n"
                                                   "property list uchar float texcoord\nend_header\n"
                                                   "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                                   "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.5 0.5 1 1 0 1\n"));
    const auto& data = corners.sequences.at(0).topology->data();
    EXPECT_EQ(data.vertexCount, 4U);
    ASSERT_EQ(data.uvs.size(), 5U); // (1, 1) is shared, the seam at vertex 0 is not
    EXPECT_EQ(data.uvs[data.triangleUvs[1][0]], Vec2f(0.5F, 0.5F));
    EXPECT_EQ(data.triangleUvs[0][2], data.triangleUvs[1][1]);

    const auto vertices = openSequences(
        write("vertices.ply", start + "property float s\nproperty float t\nelement face 2\n"
                                      "property list uchar int vertex_indices\nend_header\n"
                                      "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n3 0 1 2\n3 0 2 3\n"));
    const auto& other = vertices.sequences.at(0).topology->data();
    EXPECT_EQ(other.uvs.size(), 4U);
    EXPECT_EQ(other.uvs[other.triangleUvs[1][2]], Vec2f(0, 1));
}

TEST_F(Ply, ReadsASeriesAndComparesWhatIsBehindTheVertices)
{
    write("b/f_1.ply", binarySquare(0.0F));
    write("b/f_2.ply", binarySquare(0.5F));
    write("b/f_10.ply", asciiSquare("0.75")); // another encoding is read whole
    const auto sequence = openSequences(folder() / "b").sequences.at(0);
    ASSERT_EQ(sequence.frameCount(), 3);
    EXPECT_EQ(positionsOf(sequence, 1)[1], Vec3f(1, 0.5F, 0));
    EXPECT_EQ(positionsOf(sequence, 2)[1], Vec3f(1, 0.75F, 0));
}

TEST_F(Ply, SaysWhichFrameHasAnotherTopologyAndWhatDiffers)
{
    for (const bool isBinary : {false, true}) {
        const std::string good = isBinary ? binarySquare(0) : asciiSquare("0");
        std::string other = good;
        if (isBinary) {
            const std::size_t corner = other.size() - 4;
            other[corner] = 1;
        } else {
            other.replace(other.size() - 2, 1, "1");
        }
        const std::string name = isBinary ? "binary" : "text";
        write(name + "/f_0001.ply", good);
        write(name + "/f_0002.ply", other);
        write(name + "/f_0003.ply", good);
        const auto error = errorOf([&] {
            const auto sequence = openSequences(folder() / name).sequences.at(0);
            positionsOf(sequence, 1);
        });
        EXPECT_EQ(error.code(), ErrorCode::TopologyMismatch);
        EXPECT_EQ(error.context().place.frame, FrameIndex(1));
        EXPECT_EQ(valueOf(error, "what"), "triangle 1 joins vertices 0, 2, 1 instead of 0, 2, 3");
    }
}

TEST_F(Ply, RefusesWhatIsDamaged)
{
    const auto codeOf = [&](const std::string& content) {
        return errorOf([&] { openSequences(write("bad.ply", content)); }).code();
    };
    const std::string good = binarySquare(0);
    EXPECT_EQ(codeOf("ply\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nelement vertex four\nend_header\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("ply\nformat xml 1.0\n" + squareHeader), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nproperty float x\nend_header\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n0\n"),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf(good.substr(0, good.size() - 3)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(asciiSquare("0").substr(0, asciiSquare("0").size() - 3)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(asciiSquare("abc")), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf(asciiSquare("nan")), ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                     "property float z\nend_header\n"),
              ErrorCode::NoVertices);
    EXPECT_EQ(codeOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                     "property float z\nend_header\n0 0 0\n"),
              ErrorCode::NoFaces);
    EXPECT_EQ(codeOf(asciiSquare("0") + std::string("\0 more", 6)), ErrorCode::FileEncoding);
}

TEST_F(Ply, SaysTheLineOfAValueThatIsNone)
{
    const auto error = errorOf([&] { openSequences(write("bad.ply", asciiSquare("abc"))); });
    EXPECT_EQ(error.context().place.line, 11);
}

TEST_F(Ply, SaysWhichVertexAFaceNames)
{
    std::string text = asciiSquare("0");
    text.replace(text.size() - 2, 1, "7");
    const auto error = errorOf([&] { openSequences(write("bad.ply", text)); });
    EXPECT_EQ(error.code(), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(valueOf(error, "index"), "7");
    EXPECT_EQ(valueOf(error, "count"), "4");
}

TEST_F(Ply, DoesNotBelieveAbsurdCounts)
{
    for (const std::string encoding : {"ascii", "binary_little_endian"}) {
        for (const std::string count : {"4000000000", "9000000000000000000"}) {
            const auto error = errorOf([&] {
                openSequences(write("bad.ply", "ply\nformat " + encoding + " 1.0\nelement vertex " + count +
                                                   "\nproperty float x\nproperty float y\nproperty float z\n"
                                                   "end_header\n0 0 0\n"));
            });
            EXPECT_EQ(error.code(), ErrorCode::CountTooLarge);
            EXPECT_EQ(valueOf(error, "count"), count);
        }
    }
    // A list that promises more than there is.
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\nproperty list uint double more\nend_header\n";
    text += std::string(12, '\0') + "\xff\xff\xff\xff";
    EXPECT_EQ(errorOf([&] { openSequences(write("bad.ply", text)); }).code(), ErrorCode::FileTruncated);
}
