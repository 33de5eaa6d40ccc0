// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "squaretriangles.h"

#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::HasSubstr;

namespace {

using Obj = FolderTest;

/// Two triangles with UVs whose second vertex moves up by `height`.
std::string square(float height, std::string_view faces = "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
{
    return "# a square\nv 0 0 0\nv 1 " + std::to_string(height) +
           " 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + std::string(faces);
}

} // namespace

TEST_F(Obj, KeepsVerticesAndTheirOrderThoughUvsHaveSeams)
{
    const auto file = write("a.obj", "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                     "vt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n"
                                     "f 1/1 3/2 4/3\nf 3/4 5/1 4/2\n");
    const auto result = openSequences(file);
    const auto& topology = result.sequences.at(0).topology->data();
    EXPECT_EQ(topology.vertexCount, 5U);
    EXPECT_EQ(topology.triangles, (std::vector{triangleOf(0, 2, 3), triangleOf(2, 4, 3)}));
    EXPECT_EQ(topology.uvs.size(), 4U);
    EXPECT_EQ(topology.triangleUvs[1], (std::array<std::uint32_t, 3>{3, 0, 1}));
    EXPECT_EQ(positionsOf(result.sequences[0])[1], Vec3f(9, 9, 9));
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::UnusedVertices));
}

TEST_F(Obj, TriangulatesPolygonsFromTheirFirstCorner)
{
    const auto result =
        openSequences(write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 2 3 4 1\nf 4 3 5\n"));
    EXPECT_EQ(result.sequences[0].topology->triangles(),
              (std::vector{triangleOf(1, 2, 3), triangleOf(1, 3, 0), triangleOf(3, 2, 4)}));
    ASSERT_TRUE(hasIssue(result.issues, Issue::Code::PolygonsTriangulated));
    EXPECT_EQ(result.issues[0].context.values[0].second, "1");
}

TEST_F(Obj, ReadsTheManyWaysToWriteTheSame)
{
    const auto expected = std::vector{triangleOf(0, 1, 2), triangleOf(0, 2, 3)};
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    const std::vector<std::string> variants{
        vertices + "f 1 2 3\nf 1 3 4",
        vertices + "f -4 -3 -2\nf -4 -2 -1\n",
        vertices + "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n",
        vertices + "f 1/1/1 2/1/1 3/1/1\nf 1/1 3/1 4/1\n",
        vertices + "f 1 2 \\\n 3\nf 1 3 4 # with a comment\n",
        vertices + "s off\ng part\nf\t1  2\t3 \no other\nf 1 3 4\n",
        "f 1 2 3\nf 1 3 4\n" + vertices,
        "\xEF\xBB\xBF# byte order mark\n" + vertices + "f 1 2 3\nf 1 3 4\n",
        "# caf\xE9 in latin-1\n" + vertices + "f 1 2 3\nf 1 3 4\n",
        "v 0 0 0 1\nv +1 0e0 0. 0.5 0.5 0.5\nv 1 1 0\n  v 0 1 0\nl 1 2\np 1\nf 1 2 3\nf 1 3 4\n",
    };
    for (const auto& text : variants) {
        for (const bool windows : {false, true}) {
            std::string content;
            for (const char c : text)
                content += windows && c == '\n' ? "\r\n" : std::string(1, c);
            const auto result = openSequences(write("a.obj", content));
            EXPECT_EQ(result.sequences[0].topology->triangles(), expected) << content;
            EXPECT_EQ(positionsOf(result.sequences[0])[3], Vec3f(0, 1, 0)) << content;
        }
    }
}

TEST_F(Obj, GivesCornersWithoutUvTheOrigin)
{
    const auto result = openSequences(
        write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt .5 .5\nf 1/1 2/1 3/1\nf 1 3 4\n"));
    const auto& topology = result.sequences[0].topology->data();
    EXPECT_EQ(topology.uvs.at(topology.triangleUvs.at(1)[2]), Vec2f(0, 0));
    EXPECT_EQ(topology.uvs.at(topology.triangleUvs.at(0)[2]), Vec2f(0.5F, 0.5F));
}

TEST_F(Obj, LeavesOutFacesThatNameAVertexTwice)
{
    const auto result =
        openSequences(write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2\nf 1 2 3\nf 1 2 3 3\n"));
    EXPECT_EQ(result.sequences[0].topology->triangles().size(), 2U);
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::DuplicateFaces));
}

TEST_F(Obj, NumbersTooSmallOrTooLargeForFloat)
{
    const auto tiny = openSequences(write("a.obj", "v 1e-60 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_EQ(positionsOf(tiny.sequences[0])[0].x(), 0);
    const auto error =
        errorOf([&] { openSequences(write("b.obj", "v 0 0 0\nv 1e60 0 0\nv 0 1 0\nf 1 2 3\n")); });
    EXPECT_EQ(error.code(), ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(valueOf(error, "vertex"), "1");
    EXPECT_EQ(error.context().file, folder() / "b.obj");
}

TEST_F(Obj, RefusesBadFilesWithTheirLine)
{
    struct Case
    {
        std::string content;
        ErrorCode code;
        std::optional<std::int64_t> line;
    };
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::vector<Case> cases{
        {vertices + "f 1 2 4\n", ErrorCode::IndexOutOfRange, 4},
        {vertices + "f 0 1 2\n", ErrorCode::IndexOutOfRange, 4},
        {vertices + "f -4 1 2\n", ErrorCode::IndexOutOfRange, 4},
        {vertices + "f 1/1 2/1 3/1\n", ErrorCode::IndexOutOfRange, 4},
        {vertices + "f 1 2 99999999999999\n", ErrorCode::IndexOutOfRange, 4},
        {vertices + "f 1 2\n", ErrorCode::FileSyntax, 4},
        {vertices + "f 1 2 x\n", ErrorCode::FileSyntax, 4},
        {vertices + "f 1 2 3x\n", ErrorCode::FileSyntax, 4},
        {"v 0 0\n" + vertices + "f 1 2 3\n", ErrorCode::FileSyntax, 1},
        {"\nv 0 0 zero\n", ErrorCode::FileSyntax, 2},
        {"\nv 0 0 1,5\n" + vertices + "f 1 2 3\n", ErrorCode::FileSyntax, 2},
        {vertices, ErrorCode::NoFaces, {}},
        {vertices + "f 1 1 2\n", ErrorCode::NoFaces, {}},
        {"f 1 2 3\n", ErrorCode::NoVertices, {}},
        {"nothing at all\n", ErrorCode::NoVertices, {}},
        {std::string("\xFF\xFEv\0 \0", 6), ErrorCode::FileEncoding, {}},
        {std::string("v\0 \0001\0", 6), ErrorCode::FileEncoding, {}},
        {vertices + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n", ErrorCode::PolygonSoup, {}},
        {"v nan 0 0\n" + vertices + "f 1 2 3\n", ErrorCode::NonFiniteCoordinate, {}},
    };
    for (const auto& bad : cases) {
        const auto file = write("bad.obj", bad.content);
        const auto error = errorOf([&] { openSequences(file); });
        EXPECT_EQ(error.code(), bad.code) << bad.content << error.what();
        EXPECT_EQ(error.context().place.line, bad.line) << bad.content;
        EXPECT_EQ(error.context().file, file) << bad.content;
    }
}

TEST_F(Obj, AcceptsAndReportsNonManifoldEdges)
{
    const auto result = openSequences(
        write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"));
    EXPECT_TRUE(hasIssue(result.issues, Issue::Code::NonManifoldEdges));
}

TEST_F(Obj, ReadsASeries)
{
    for (int f = 0; f < 3; ++f)
        write("s_" + std::to_string(f) + ".obj", square(static_cast<float>(f) / 4));
    const auto sequence = openSequences(folder()).sequences.at(0);
    ASSERT_EQ(sequence.frameCount(), 3);
    for (int f = 0; f < 3; ++f)
        EXPECT_EQ(positionsOf(sequence, f)[1].y(), static_cast<float>(f) / 4);
    EXPECT_EQ(sequence.name, "s");
}

TEST_F(Obj, ReadsASeriesWrittenDifferentlyFromFrameToFrame)
{
    const std::vector<std::string> variants{
        square(0),
        square(0, "f -4/-4 -3/-3 -2/-2\nf -4/-4 -2/-2 -1/-1\n"),
        square(0, "usemtl skin\nf 1/1 2/2 3/3\nusemtl cloth\nf 1/1 3/3 4/4"),
        square(0, "f 1/1/1 2/2/1 3/3/1\n f 1/1 3/3 4/4\n"),
        square(0, "f 1/1 2/2 3/3 4/4\n"),
        "v 0 0 0 \r\nv 1 0 0\r\n" + square(0).substr(square(0).find("v 1 1")),
    };
    for (std::size_t f = 0; f < variants.size(); ++f)
        write("s_" + std::to_string(f) + ".obj", variants[f]);
    const auto sequence = openSequences(folder()).sequences.at(0);
    for (std::size_t f = 0; f < variants.size(); ++f) {
        EXPECT_EQ(positionsOf(sequence, static_cast<std::int64_t>(f)), positionsOf(sequence, 0)) << f;
    }
}

TEST_F(Obj, NamesTheFrameThatDiffersAndWhatDiffers)
{
    struct Case
    {
        std::string content;
        ErrorCode code;
        std::string what;
    };
    const std::vector<Case> cases{
        {square(0, "f 1/1 2/2 3/3\nf 1/1 4/3 3/4\n"), ErrorCode::TopologyMismatch,
         "triangle 1 joins vertices 0, 3, 2 instead of 0, 2, 3"},
        {square(0, "f 1/1 2/2 3/3\n"), ErrorCode::TopologyMismatch, "1 triangles instead of 2"},
        {square(0) + "f 2/2 3/3 4/4\n", ErrorCode::TopologyMismatch, "3 triangles instead of 2"},
        {square(0) + " f 2/2 3/3 4/4\n", ErrorCode::TopologyMismatch, "3 triangles instead of 2"},
        {square(0, "f 1/1 2/2 3/3\nf 1/1 3/3 4/1\n"), ErrorCode::TopologyMismatch,
         "triangle 1 has other texture coordinates"},
        {square(0, "f 1 2 3\nf 1 3 4\n"), ErrorCode::TopologyMismatch, "it has no texture coordinates"},
        {square(0) + "v 3 3 3\n", ErrorCode::VertexCountMismatch, "5 vertices where 4 are expected"},
        {"v 3 3 3\n" + square(0), ErrorCode::VertexCountMismatch, "5 vertices where 4 are expected"},
        {"v 1 2 3\nv 2 2 2\nv 1 1 1\nf 1 2 3\n", ErrorCode::VertexCountMismatch,
         "3 vertices where 4 are expected"},
        {square(0, "f 1/1 2/2 3/3\nf 1/1 3/3 9/4\n"), ErrorCode::IndexOutOfRange, "line 11"},
        {square(0) + "v nan 0 0\n", ErrorCode::VertexCountMismatch, "frame 1"},
        {"v 0 nan" + square(0).substr(square(0).find(" 0\nv 1")), ErrorCode::NonFiniteCoordinate, "Vertex 0"},
        {square(0).substr(0, square(0).find("vt")), ErrorCode::NoFaces, "frame 1"},
        {square(0).substr(0, 40), ErrorCode::FileSyntax, "frame 1, line 4"},
    };
    write("s_0.obj", square(1));
    write("s_2.obj", square(2));
    for (const auto& bad : cases) {
        const auto file = write("s_1.obj", bad.content);
        const auto sequence = openSequences(folder()).sequences.at(0);
        EXPECT_NO_THROW(sequence.frame(FrameIndex(2)));
        const auto error = errorOf([&] { sequence.frame(FrameIndex(1)); });
        EXPECT_EQ(error.code(), bad.code) << bad.content << error.what();
        EXPECT_THAT(error.what(), HasSubstr(bad.what));
        EXPECT_EQ(error.context().place.frame, FrameIndex(1)) << bad.content;
        EXPECT_EQ(error.context().file, file);
    }
}

TEST_F(Obj, NegativeIndicesCountFromWhereTheyStand)
{
    // The same text of the faces, but vertices stand elsewhere before them.
    const std::string face = "f -3 -2 -1\n";
    const std::string a = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + face + "v 1 1 0\n" + face;
    const std::string b = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n# \n" + face + "\n" + face;
    write("s_0.obj", a);
    write("s_1.obj", b);
    write("s_2.obj", a);
    const auto sequence = openSequences(folder()).sequences.at(0);
    EXPECT_EQ(errorOf([&] { sequence.frame(FrameIndex(1)); }).code(), ErrorCode::TopologyMismatch);
}

TEST_F(Obj, FindsASingleTextureThroughTheMaterialLibrary)
{
    write("tex/Skin.PNG", "picture");
    write("a.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd -s 1 1 1 -blendu on -o 0 0 -bm 0.5 tex\\Skin.PNG\r\n");
    const auto result =
        openSequences(write("a.obj", "mtllib a.mtl\nusemtl skin\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    const auto& textures = result.sequences[0].textures;
    ASSERT_EQ(textures.kind(), TextureSet::Kind::Single);
    EXPECT_EQ(textures.textures()[0].file.filename(), "Skin.PNG");
    EXPECT_FALSE(hasIssue(result.issues, Issue::Code::TextureMissing));
    EXPECT_EQ(result.sequences[0].topology->data().materials, std::vector<std::string>{"skin"});
}

TEST_F(Obj, FindsATexturePerMaterial)
{
    write("a.png", "picture");
    write("b with blank.jpg", "picture");
    write("a.mtl", "newmtl b\nmap_Kd b with blank.jpg\nnewmtl a\nmap_Kd /home/other/a.png\nnewmtl c\n");
    const auto result = openSequences(write(
        "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nusemtl a\nf 1 2 3\nusemtl c\nf 2 3 4\n"
                 "usemtl b\nf 1 3 4\nusemtl a\nf 1 2 4\n"));
    const auto& sequence = result.sequences[0];
    EXPECT_EQ(sequence.topology->data().materials, (std::vector<std::string>{"a", "c", "b"}));
    EXPECT_EQ(sequence.topology->data().triangleMaterials, (std::vector<std::uint16_t>{0, 1, 2, 0}));
    ASSERT_EQ(sequence.textures.kind(), TextureSet::Kind::PerMaterial);
    ASSERT_EQ(sequence.textures.textures().size(), 3U);
    EXPECT_EQ(sequence.textures.textures()[0].file.filename(), "a.png");
    EXPECT_TRUE(sequence.textures.textures()[1].isEmpty());
    EXPECT_EQ(sequence.textures.textures()[2].file.filename(), "b with blank.jpg");
}

TEST_F(Obj, ReportsMissingTexturesAndLibraries)
{
    write("a.mtl", "newmtl m\nmap_Kd gone.png\n");
    const std::string mesh = "usemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto texture = openSequences(write("a.obj", "mtllib a.mtl\n" + mesh));
    EXPECT_TRUE(hasIssue(texture.issues, Issue::Code::TextureMissing));
    EXPECT_EQ(texture.sequences[0].textures.kind(), TextureSet::Kind::None);
    const auto library = openSequences(write("b.obj", "mtllib gone.mtl\n" + mesh));
    EXPECT_TRUE(hasIssue(library.issues, Issue::Code::TextureMissing));
}
