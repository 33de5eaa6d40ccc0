// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "squaretriangles.h"

#include <cstring>

using namespace quadrille;

namespace {

using Stl = FolderTest;
using Facet = std::array<Vec3f, 3>;

const std::array<Facet, 2> squareFacets{Facet{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0)},
                                        Facet{Vec3f(-0.0F, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)}};

std::string solidText(const std::array<Facet, 2>& facets)
{
    std::string text = "solid square\n";
    for (const Facet& facet : facets) {
        text += "  facet normal 0 0 1\n    outer loop\n";
        for (const Vec3f& p : facet) {
            text += "      vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                    std::to_string(p.z()) + "\n";
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid square\n";
}

std::string binaryOf(const std::array<Facet, 2>& facets, std::uint32_t count = 2)
{
    std::string bytes = "solid though it is binary";
    bytes.resize(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    for (const Facet& facet : facets) {
        bytes.append(12, '\0');
        for (const Vec3f& p : facet)
            bytes.append(reinterpret_cast<const char*>(p.data()), sizeof(Vec3f));
        bytes.append(2, '\0');
    }
    return bytes;
}

} // namespace

TEST_F(Stl, JoinsCornersAtTheSamePlaceAndSaysSo)
{
    for (const auto& content : {solidText(squareFacets), binaryOf(squareFacets)}) {
        const auto result = openSequences(write("a.stl", content));
        const auto& sequence = result.sequences.at(0);
        EXPECT_EQ(sequence.topology->triangles(), squareTriangles);
        EXPECT_EQ(positionsOf(sequence)[3], Vec3f(0, 1, 0));
        EXPECT_TRUE(hasIssue(result.issues, Issue::Code::VerticesWelded));
    }
}

TEST_F(Stl, ReadsASeries)
{
    auto moved = squareFacets;
    moved[1][2].y() = 2;
    write("s/f_1.stl", binaryOf(squareFacets));
    write("s/f_2.stl", binaryOf(moved));
    const auto sequence = openSequences(folder() / "s").sequences.at(0);
    EXPECT_EQ(positionsOf(sequence, 1)[3], Vec3f(0, 2, 0));
}

TEST_F(Stl, SaysWhenAFrameJoinsOtherwise)
{
    auto apart = squareFacets;
    apart[1][0].x() = 0.5F;
    write("s/f_1.stl", solidText(squareFacets));
    write("s/f_2.stl", solidText(apart));
    const auto error = errorOf([&] { openSequences(folder() / "s"); });
    EXPECT_EQ(error.code(), ErrorCode::VertexCountMismatch);
    EXPECT_EQ(error.context().place.frame, FrameIndex(1));
}

TEST_F(Stl, RefusesWhatIsDamaged)
{
    const auto codeOf = [&](const std::string& content) {
        return errorOf([&] { openSequences(write("bad.stl", content)); }).code();
    };
    EXPECT_EQ(codeOf("solid nothing\nendsolid\n"), ErrorCode::NoFaces);
    EXPECT_EQ(codeOf("solid a\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n"),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("solid a\nfacet normal 0 0 1\nvertex 0 0 x\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("solid a\nfacet normal 0 0 1\nvertex 0 0 0\n"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf("short"), ErrorCode::FileTruncated);
    const std::string text = solidText(squareFacets);
    EXPECT_EQ(codeOf(text.substr(0, text.find("endsolid"))), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(binaryOf(squareFacets, 3)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf(binaryOf(squareFacets, 4000000000U)), ErrorCode::CountTooLarge);
    auto infinite = squareFacets;
    infinite[0][1].x() = std::numeric_limits<float>::infinity();
    EXPECT_EQ(codeOf(binaryOf(infinite)), ErrorCode::NonFiniteCoordinate);
}

TEST_F(Stl, RefusesAPolygonSoup)
{
    auto apart = squareFacets;
    for (Vec3f& corner : apart[1])
        corner.z() += 1;
    EXPECT_EQ(errorOf([&] { openSequences(write("bad.stl", solidText(apart))); }).code(),
              ErrorCode::PolygonSoup);
}
