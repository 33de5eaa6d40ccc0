// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "model/sequence/io/mesh/off.h"
#include "squaretriangles.h"

using namespace quadrille;

namespace {

using Off = FolderTest;

} // namespace

TEST_F(Off, ReadsTheManyWaysToWriteTheSame)
{
    for (const std::string text : {
             "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
             "# a comment\nOFF # another\n\n4 2 0\n0 0 0\n1 0 0\n# between\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3",
             "OFF 4 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3 255 0 0\r\n",
             "4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
             "COFF\n4 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n4 0 1 2 3 0.5 0.5 "
             "0.5\n",
             "NOFF\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n",
         }) {
        const auto sequence = openSequences(write("a.off", text)).sequences.at(0);
        EXPECT_EQ(sequence.topology->triangles(), squareTriangles) << text;
        EXPECT_EQ(positionsOf(sequence)[3], Vec3f(0, 1, 0)) << text;
    }
}

TEST_F(Off, KeepsTextureCoordinates)
{
    const auto sequence =
        openSequences(write("a.off", "STOFF\n3 1 0\n0 0 0 0.1 0.2\n1 0 0 0.3 0.4\n0 1 0 0.5 0.6\n3 0 1 2\n"))
            .sequences.at(0);
    const auto& data = sequence.topology->data();
    ASSERT_TRUE(sequence.topology->hasUvs());
    EXPECT_EQ(data.uvs[data.triangleUvs[0][2]], Vec2f(0.5F, 0.6F));
}

TEST_F(Off, ReadsASeries)
{
    write("s/f_9.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("s/f_10.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n");
    const auto sequence = openSequences(folder() / "s").sequences.at(0);
    ASSERT_EQ(sequence.frameCount(), 2);
    EXPECT_EQ(positionsOf(sequence, 1)[2], Vec3f(0, 2, 0));
}

TEST_F(Off, RefusesWhatIsDamaged)
{
    const auto errorFor = [&](const std::string& text) {
        return errorOf([&] { openSequences(write("bad.off", text)); });
    };
    EXPECT_EQ(errorFor("OFF\nmany 1 0\n").code(), ErrorCode::FileSyntax);
    EXPECT_EQ(errorFor("OFF\n0 0 0\n").code(), ErrorCode::NoVertices);
    EXPECT_EQ(errorFor("OFF\n1 0 0\n0 0 0\n").code(), ErrorCode::NoFaces);
    EXPECT_EQ(errorFor("OFF\n-3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").code(), ErrorCode::FileSyntax);
    EXPECT_EQ(errorFor("\n").code(), ErrorCode::FileSyntax);
    EXPECT_EQ(errorOf([] { parseOff({}, "empty.off"); }).context().place.line, 1);
    EXPECT_EQ(errorFor("OFF BINARY\n").code(), ErrorCode::FormatRefused);
    EXPECT_EQ(errorFor("4OFF\n3 1 0\n").code(), ErrorCode::FormatRefused);
    EXPECT_EQ(errorFor("OFF\n4000000000 1 0\n0 0 0\n").code(), ErrorCode::CountTooLarge);
    EXPECT_EQ(errorFor("OFF\n3 999999 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").code(), ErrorCode::CountTooLarge);
    EXPECT_EQ(errorFor("OFF\n3 2 0\n0 0 0.000\n1 0 0.000\n0 1 0.000\n3 0 1 2\n").code(),
              ErrorCode::FileTruncated);
    EXPECT_EQ(errorFor("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n").code(),
              ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(errorFor("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1 2\n").context().place.line, 6);
    const auto range = errorFor("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
    EXPECT_EQ(range.code(), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(range.context().place.line, 6);
}
