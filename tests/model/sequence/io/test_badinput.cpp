// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What must hold for every format, whatever is wrong with a file: a clear Error that names the file, or a
// sequence; never anything else. What is particular to a format is in its own test.
#include "fixture.h"
#include "meshbytes.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/withoutroot.h"
#include "testsequence.h"

#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <optional>

using namespace quadrille;
using ::testing::AnyOf;
using ::testing::ContainsRegex;
using ::testing::Not;

namespace {

/// A whole file of some format.
struct GoodFile
{
    std::string name;
    std::string extension;
    std::string bytes;
    bool isText = false;
};

// Names are all that need be shown of a case.
std::ostream& operator<<(std::ostream& out, const GoodFile& file)
{
    return out << file.name;
}

std::string exported(const std::string& extension)
{
    const test::TemporaryFolder folder;
    const auto path = folder / ("take" + extension);
    exportSequence(wanderingPyramid(3), path);
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<GoodFile> goodFiles()
{
    std::vector<GoodFile> files;
    for (const RawFormat& format : rawFormats())
        files.push_back({format.name, format.extension, format.bytes(rawPyramid()), format.isText});
    for (const std::string extension : {".pc2", ".mdd", ".npy"})
        files.push_back({"Cache" + extension.substr(1), extension, exported(extension)});
    files.push_back({"GlbMorphs", ".glb", exported(".glb")});
    return files;
}

class AnyFile : public FolderTest, public ::testing::WithParamInterface<GoodFile>
{
protected:
    AnyFile()
    {
        exportSequence(wanderingPyramid(1), folder() / "base" / "mesh.ply");
        m_mesh = folder() / "base" / names(folder() / "base").front();
    }

    std::filesystem::path file() const { return folder() / ("take" + GetParam().extension); }
    std::filesystem::path writeBytes(std::string_view bytes) const { return write(file().filename(), bytes); }
    ImportResult open() const { return openSequences(file(), {.mesh = m_mesh}); }

    /// Opens the file and reads every frame.
    /// \return the error, which must name the file; nothing where all went well.
    std::optional<Error> tryAll() const
    {
        try {
            for (const MeshSequence& sequence : open().sequences)
                loadFrames(sequence);
        } catch (const Error& error) {
            EXPECT_THAT(error.context().file, AnyOf(file(), m_mesh)) << error.what();
            EXPECT_THAT(error.what(), Not(ContainsRegex("[{][a-z]+[}]"))) << "a value is missing";
            return error;
        }
        return std::nullopt;
    }

private:
    std::filesystem::path m_mesh;
};

} // namespace

TEST_P(AnyFile, OpensWhenItIsWhole)
{
    writeBytes(GetParam().bytes);
    const auto error = tryAll();
    EXPECT_FALSE(error) << error->what();
}

TEST_P(AnyFile, SaysThatItIsMissing)
{
    EXPECT_EQ(errorOf([&] { open(); }).code(), ErrorCode::FileNotFound);
}

TEST_P(AnyFile, SaysThatItIsEmpty)
{
    writeBytes("");
    const auto error = errorOf([&] { open(); });
    EXPECT_EQ(error.code(), ErrorCode::FileEmpty);
    EXPECT_EQ(error.context().file, file());
}

TEST_P(AnyFile, AFolderInItsPlaceHoldsNoSeries)
{
    std::filesystem::create_directories(file());
    const auto error = errorOf([&] { open(); });
    EXPECT_EQ(error.code(), ErrorCode::SeriesEmpty);
    EXPECT_EQ(error.context().file, file());
    SourceFiles source{.path = file(), .files = {file()}, .stem = "take"};
    EXPECT_EQ(errorOf([&] { importerFor(source); }).code(), ErrorCode::BadArgument);
}

TEST_P(AnyFile, SaysThatItMayNotBeRead)
{
    writeBytes(GetParam().bytes);
    std::filesystem::permissions(file(), std::filesystem::perms::none);
    const WithoutRoot guard;
    if (!guard.isPlain())
        GTEST_SKIP() << "the rights of root cannot be given up here";
    const auto error = errorOf([&] { open(); });
    EXPECT_EQ(error.code(), ErrorCode::PermissionDenied);
    EXPECT_EQ(error.context().file, file());
}

TEST_P(AnyFile, IsRefusedWhereItIsCut)
{
    const std::string& bytes = GetParam().bytes;
    const std::size_t step = bytes.size() / 300 + 1;
    for (std::size_t length = 1; length < bytes.size(); length += step) {
        writeBytes(std::string_view(bytes).substr(0, length));
        const auto error = tryAll();
        const bool holdsAll = length + 13 >= bytes.size(); // the empty node at the end of an FBX file
        EXPECT_TRUE(error || GetParam().isText || holdsAll)
            << "opened with " << length << " of " << bytes.size();
    }
}

TEST_P(AnyFile, NeverFailsOtherwiseWhereAByteIsWrong)
{
    const std::string& bytes = GetParam().bytes;
    const std::size_t step = bytes.size() / 300 + 1;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
        for (const unsigned change : {0xFFU, 0x01U}) {
            std::string wrong = bytes;
            wrong[at] = static_cast<char>(static_cast<unsigned char>(wrong[at]) ^ change);
            writeBytes(wrong);
            EXPECT_NO_THROW(tryAll()) << "byte " << at;
        }
    }
}

TEST_P(AnyFile, OfOtherContentIsRefused)
{
    const std::vector<std::string> contents{
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1", 20),
        std::string("\xFF\xFEv\0 \0001\0 \0002\0 \0003\0\n\0", 18), // UTF-16
        std::string(1000, '\0'),
        std::string(1000, '\xFF'),
        "<html><body>404 Not Found</body></html>\n",
        "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
    };
    for (const std::string& content : contents) {
        writeBytes(content);
        EXPECT_TRUE(tryAll()) << content.substr(0, 30);
    }
}

TEST_P(AnyFile, ThatShrinksWhileItIsOpenIsAnErrorAtMost)
{
    writeBytes(GetParam().bytes);
    const auto result = open();
    std::filesystem::resize_file(file(), GetParam().bytes.size() / 2);
    for (const MeshSequence& sequence : result.sequences) {
        try {
            loadFrames(sequence);
        } catch (const Error& error) {
            EXPECT_EQ(error.context().file, file());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, AnyFile, ::testing::ValuesIn(goodFiles()),
                         [](const auto& format) { return format.param.name; });

namespace {

class AnyMesh : public FolderTest, public ::testing::WithParamInterface<RawFormat>
{
protected:
    std::filesystem::path file() const { return folder() / (std::string("mesh") + GetParam().extension); }
    ImportResult open(const RawMesh& mesh) const
    {
        return openSequences(write(file().filename(), GetParam().bytes(mesh)));
    }
    /// The error of a mesh, which must name its file.
    Error errorFor(const RawMesh& mesh) const
    {
        auto error = errorOf([&] { open(mesh); });
        EXPECT_EQ(error.context().file, file());
        EXPECT_THAT(error.what(), Not(ContainsRegex("[{][a-z]+[}]"))) << "a value is missing";
        return error;
    }
};

} // namespace

TEST_P(AnyMesh, KeepsItsVertices)
{
    const auto result = open(rawPyramid());
    ASSERT_EQ(result.sequences.size(), 1U);
    EXPECT_EQ(result.sequences[0].topology->vertexCount(), 6U);
    EXPECT_EQ(result.sequences[0].topology->triangles().size(), 8U);
    EXPECT_TRUE(result.sequences[0].topology->isClosed());
}

TEST_P(AnyMesh, RefusesWhatIsNotFinite)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        RawMesh mesh = rawPyramid();
        mesh.points[3].y() = bad;
        const auto error = errorFor(mesh);
        EXPECT_TRUE(error.code() == ErrorCode::NonFiniteCoordinate ||
                    (GetParam().isText && error.code() == ErrorCode::FileSyntax))
            << error.what();
    }
}

TEST_P(AnyMesh, RefusesDecimalCommas)
{
    if (!GetParam().isText || std::string_view(GetParam().name).starts_with("Fbx"))
        GTEST_SKIP() << "no text, or commas stand between numbers";
    RawMesh mesh = rawPyramid();
    mesh.points[2].x() = 1.25F;
    std::string bytes = GetParam().bytes(mesh);
    bytes.replace(bytes.find("1.25"), 4, "1,25");
    const auto error = errorOf([&] { openSequences(write(file().filename(), bytes)); });
    EXPECT_EQ(error.code(), ErrorCode::FileSyntax);
    EXPECT_TRUE(error.context().place.line);
}

TEST_P(AnyMesh, RefusesIndicesThatAreNotThere)
{
    if (!GetParam().hasIndices || !GetParam().keepsIndices)
        GTEST_SKIP() << "faces hold their points";
    for (const int bad : {6, 0x7FFFFFF0}) {
        RawMesh mesh = rawPyramid();
        mesh.faces[5][1] = bad;
        EXPECT_EQ(errorFor(mesh).code(), ErrorCode::IndexOutOfRange) << bad;
    }
}

TEST_P(AnyMesh, RefusesAMeshWithoutFaces)
{
    RawMesh mesh = rawPyramid();
    mesh.faces.clear();
    const auto code = errorFor(mesh).code();
    EXPECT_TRUE(code == ErrorCode::NoFaces || code == ErrorCode::SceneWithoutMesh) << static_cast<int>(code);
}

TEST_P(AnyMesh, RefusesAMeshWithoutVertices)
{
    const auto code = errorFor({}).code();
    EXPECT_TRUE(code == ErrorCode::NoVertices || code == ErrorCode::NoFaces ||
                code == ErrorCode::SceneWithoutMesh || code == ErrorCode::FileEmpty)
        << static_cast<int>(code);
}

TEST_P(AnyMesh, RefusesAPolygonSoup)
{
    RawMesh soup;
    for (int i = 0; i < 4; ++i) {
        const auto x = static_cast<float>(3 * i);
        soup.points.insert(soup.points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    EXPECT_EQ(errorFor(soup).code(), ErrorCode::PolygonSoup);
}

TEST_P(AnyMesh, ReportsNonManifoldEdges)
{
    if (!GetParam().keepsIndices)
        GTEST_SKIP() << "vertices are joined where surfaces go on";
    RawMesh fins;
    fins.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
    fins.faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    const auto result = open(fins);
    EXPECT_EQ(result.sequences.at(0).topology->triangles().size(), 3U);
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::NonManifoldEdges));
}

TEST_P(AnyMesh, CutsPolygonsAndSaysSo)
{
    if (!GetParam().hasPolygons)
        GTEST_SKIP() << "triangles only";
    RawMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 5}, {1, 2, 3, 4, 5}};
    const auto result = open(mesh);
    EXPECT_EQ(result.sequences.at(0).topology->vertexCount(), 6U);
    EXPECT_EQ(result.sequences.at(0).topology->triangles().size(), 4U);
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::PolygonsTriangulated));
}

TEST_P(AnyMesh, LeavesOutTrianglesThatNameAVertexTwice)
{
    if (!GetParam().keepsIndices)
        GTEST_SKIP() << "vertices are joined where surfaces go on";
    RawMesh mesh = rawPyramid();
    mesh.faces.push_back({0, 1, 1});
    const auto result = open(mesh);
    EXPECT_EQ(result.sequences.at(0).topology->triangles().size(), 8U);
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::DuplicateFaces));
}

TEST_P(AnyMesh, NamesTheFrameOfASeriesThatDiffers)
{
    const std::string extension = GetParam().extension;
    if (extension != ".obj" && extension != ".ply" && extension != ".off" && extension != ".stl")
        GTEST_SKIP() << "one file holds all frames";
    RawMesh turned = rawPyramid();
    std::swap(turned.faces[3][0], turned.faces[3][1]);
    RawMesh open = rawPyramid();
    open.faces.pop_back();
    RawMesh larger = rawPyramid();
    larger.points.emplace_back(3, 3, 3);
    larger.faces[0][0] = 6;
    RawMesh infinite = rawPyramid();
    infinite.points[2].x() = std::numeric_limits<float>::infinity();
    const std::vector<std::pair<RawMesh, ErrorCode>> cases{{turned, ErrorCode::TopologyMismatch},
                                                           {open, ErrorCode::TopologyMismatch},
                                                           {larger, ErrorCode::VertexCountMismatch},
                                                           {infinite, ErrorCode::NonFiniteCoordinate}};
    const auto path = [&](int i) { return "s/f_" + std::to_string(i) + extension; };
    write(path(1), GetParam().bytes(rawPyramid()));
    write(path(3), GetParam().bytes(rawPyramid()));
    const auto check = [&](ErrorCode code) {
        const auto sequence = openSequences(folder() / "s").sequences.at(0);
        EXPECT_NO_THROW(sequence.frame(FrameIndex(2)));
        const auto error = errorOf([&] { sequence.frame(FrameIndex(1)); });
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_EQ(error.context().place.frame, FrameIndex(1));
        EXPECT_EQ(error.context().file, folder() / path(2));
    };
    for (const auto& [mesh, code] : cases) {
        write(path(2), GetParam().bytes(mesh));
        check(code);
    }
    write(path(2), "");
    check(ErrorCode::FileEmpty);
    write(path(2), GetParam().bytes(rawPyramid()));
    const auto sequence = openSequences(folder() / "s").sequences.at(0);
    std::filesystem::remove(folder() / path(2));
    const auto gone = errorOf([&] { sequence.frame(FrameIndex(1)); });
    EXPECT_EQ(gone.code(), ErrorCode::FileNotFound);
    EXPECT_EQ(gone.context().place.frame, FrameIndex(1));
}

INSTANTIATE_TEST_SUITE_P(Formats, AnyMesh, ::testing::ValuesIn(rawFormats()),
                         [](const auto& format) { return format.param.name; });
