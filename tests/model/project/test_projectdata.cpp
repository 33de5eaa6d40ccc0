// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/jsonline.h"
#include "model/project/json/jsontext.h"
#include "model/project/store/dataitem.h"
#include "tests/model/project/testproject.h"

#include <cmath>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;

namespace {

DataItem matrix()
{
    DataArray array;
    array.name = "bounds";
    array.description = "Boxes.";
    array.unit = "m";
    array.shape = {2, 2};
    array.values = std::vector<double>{0.1, INFINITY, -2, 1e-9};
    array.columns = {"low", "high, really"};
    return {"sequences/walk/bounds", "", true, array};
}

DataItem table()
{
    return {"frames", "", true,
            DataTable{"frames",
                      "Frames.",
                      {columnOf("sequence", "", std::vector<std::string>{"é \"x\"", "b"}),
                       columnOf("frame", "frame", std::vector<std::int64_t>{0, 7})}}};
}

} // namespace

TEST(WriteData, CsvHasAHeaderWithUnits)
{
    const TemporaryFolder folder;
    writeData(matrix(), folder / "a.csv");
    EXPECT_EQ(textOf(folder / "a.csv"), "low (m),\"high, really (m)\"\n0.1,inf\n-2,1e-09\n");
    writeData(table(), folder / "t.csv");
    EXPECT_EQ(textOf(folder / "t.csv"), "sequence,frame (frame)\n\"é \"\"x\"\"\",0\nb,7\n");
}

TEST(WriteData, CsvLeavesCellsOfTablesEmptyWhereThereIsNoValue)
{
    const TemporaryFolder folder;
    const DataTable report{"report",
                           "Report.",
                           {columnOf("wanted", "", std::vector<double>{NAN, 2.5}),
                            columnOf("obtained", "", std::vector<double>{1, 2})}};
    writeData({"report", "", true, report}, folder / "r.csv");
    EXPECT_EQ(textOf(folder / "r.csv"), "wanted,obtained\n,1\n2.5,2\n");
}

TEST(WriteData, NpyIsAlignedAndRowMajor)
{
    const TemporaryFolder folder;
    writeData(matrix(), folder / "a.npy");
    const std::string bytes = textOf(folder / "a.npy");
    ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header =
        10 + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
    EXPECT_EQ(header % 64, 0U);
    EXPECT_EQ(bytes[header - 1], '\n');
    EXPECT_EQ(bytes.size() - header, 4 * sizeof(double));
    EXPECT_NE(bytes.find("'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, )"), std::string::npos);
}

TEST(WriteData, TablesBecomeStructuredArrays)
{
    const TemporaryFolder folder;
    writeData(table(), folder / "t.npy");
    const std::string bytes = textOf(folder / "t.npy");
    EXPECT_NE(bytes.find("[('sequence', '<U5'), ('frame', '<i8'), ]"), std::string::npos);
    const std::size_t rowBytes = 5 * 4 + 8;
    EXPECT_EQ((bytes.size() - 2 * rowBytes) % 64, 0U);
}

TEST(JsonLine, IsWhatTheLibraryOfJsonWrites)
{
    const std::vector<std::string> texts{"a \"b\" \\", "é"};
    const std::vector<double> numbers{0, -0.0, 0.1, 1e300, 25};
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    const std::string text = jsonLine({texts, numbers, "x", true, 3, -4.0, most, std::vector<int>()});
    EXPECT_EQ(text, Json({texts, numbers, "x", true, 3, -4.0, most, std::vector<int>()}).dump());
    EXPECT_EQ(jsonLine({0.5}), "[0.5]");
    EXPECT_EQ(jsonLine({JsonLine(texts)}), R"([["a \"b\" \\","é"]])");
}

TEST(WriteData, JsonHasNullWhereThereIsNoNumber)
{
    const TemporaryFolder folder;
    writeData(matrix(), folder / "a.json");
    const Json json = Json::parse(textOf(folder / "a.json"));
    EXPECT_EQ(json["name"], "sequences/walk/bounds");
    EXPECT_EQ(json["unit"], "m");
    EXPECT_EQ(json["values"], Json::parse("[[0.1, null], [-2.0, 1e-9]]"));
    writeData(table(), folder / "t.json");
    EXPECT_EQ(Json::parse(textOf(folder / "t.json"))["columns"]["frame"], Json::parse("[0, 7]"));
}

TEST(WriteData, OtherEndingsAreRefused)
{
    const TemporaryFolder folder;
    EXPECT_THROW(writeData(matrix(), folder / "a.xlsx"), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.xlsx"));
}
