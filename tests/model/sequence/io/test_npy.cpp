// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "model/core/npy.h"

#include <algorithm>
#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

class Npy : public FolderTest
{
protected:
    Npy() { write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }
    std::filesystem::path array(const std::string& header, const std::string& values)
    {
        return write("take.npy", header + values);
    }
};

template <typename Value>
std::string values(std::size_t count, bool isBigEndian = false)
{
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = static_cast<Value>(static_cast<float>(i));
        std::string one(reinterpret_cast<const char*>(&value), sizeof value);
        if (isBigEndian)
            std::reverse(one.begin(), one.end());
        bytes += one;
    }
    return bytes;
}

std::string header(const std::string& type, std::vector<std::int64_t> shape)
{
    return npyHeader("'" + type + "'", shape);
}

} // namespace

TEST_F(Npy, HeadersReadBack)
{
    const std::vector<std::int64_t> shape{2, 3, 3};
    const std::string text = npyHeader("'<f4'", shape);
    EXPECT_EQ(text.size() % 64, 0U);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_THAT(text, HasSubstr("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 3, ), }"));
    const NpyHeader read = parseNpyHeader(text, "a.npy");
    EXPECT_EQ(read.type, "<f4");
    EXPECT_EQ(read.shape, shape);
    EXPECT_EQ(read.size, text.size());
    EXPECT_FALSE(read.isFortranOrder);
}

TEST_F(Npy, ReadsEveryTypeAndByteOrderOfNumbers)
{
    const std::vector<std::pair<std::string, std::string>> files{
        {"<f4", values<float>(18)},       {">f4", values<float>(18, true)},
        {"<f8", values<double>(18)},      {">f8", values<double>(18, true)},
        {"<f2", values<Eigen::half>(18)}, {">f2", values<Eigen::half>(18, true)},
    };
    for (const auto& [type, bytes] : files) {
        const auto sequence = openSequences(array(header(type, {2, 3, 3}), bytes)).sequences.at(0);
        ASSERT_EQ(sequence.frameCount(), 2) << type;
        EXPECT_EQ(positionsOf(sequence, 1)[2], Vec3f(15, 16, 17)) << type;
    }
}

TEST_F(Npy, TakesOneFrameWithoutTheFirstExtent)
{
    const auto sequence = openSequences(array(header("<f4", {3, 3}), values<float>(9))).sequences.at(0);
    EXPECT_EQ(sequence.frameCount(), 1);
    EXPECT_EQ(positionsOf(sequence)[1], Vec3f(3, 4, 5));
}

TEST_F(Npy, ReadsLaterVersionsOfTheFormat)
{
    std::string text = header("<f4", {1, 3, 3});
    text[6] = '\2';
    text.insert(10, 2, '\0');
    EXPECT_EQ(openSequences(array(text, values<float>(9))).sequences.at(0).frameCount(), 1);
}

TEST_F(Npy, HalvesKeepTheirValue)
{
    // 1.5, -2, the smallest number above 0, the largest one, and zeros.
    const std::string halves("\x00\x3e\x00\xc0\x01\x00\xff\x7b\x00\x00\x00\x80\x00\x00\x00\x00\x00\x00", 18);
    const auto sequence = openSequences(array(header("<f2", {1, 3, 3}), halves)).sequences.at(0);
    EXPECT_EQ(positionsOf(sequence)[0], Vec3f(1.5F, -2.0F, 0x1p-24F));
    EXPECT_EQ(positionsOf(sequence)[1], Vec3f(65504.0F, 0, 0));
    const std::string infinite = std::string("\x00\x7c", 2) + std::string(16, '\0');
    EXPECT_EQ(errorOf([&] {
                  openSequences(array(header("<f2", {1, 3, 3}), infinite));
              }).code(),
              ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(errorOf([&] {
                  openSequences(array(header("<f2", {1, 3, 3}), halves.substr(1)));
              }).code(),
              ErrorCode::CountTooLarge);
}

TEST_F(Npy, ADoubleBeyondFloatIsNoCoordinate)
{
    std::string bytes = values<double>(9);
    const double large = 1e300;
    bytes.replace(8 * 4, 8, reinterpret_cast<const char*>(&large), 8);
    const auto error = errorOf([&] { openSequences(array(header("<f8", {1, 3, 3}), bytes)); });
    EXPECT_EQ(error.code(), ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(valueOf(error, "vertex"), "1");
}

TEST_F(Npy, RefusesWhatIsNoArrayOfPositions)
{
    const auto errorFor = [&](const std::string& head, const std::string& bytes) {
        return errorOf([&] { openSequences(array(head, bytes)); });
    };
    EXPECT_EQ(errorFor(header("<f3", {1, 3, 3}), values<float>(9)).code(), ErrorCode::FormatRefused);
    EXPECT_EQ(errorFor(header("<i4", {1, 3, 3}), values<float>(9)).code(), ErrorCode::FormatRefused);
    EXPECT_EQ(errorFor(header("|O", {1, 3, 3}), values<float>(9)).code(), ErrorCode::FormatRefused);
    EXPECT_EQ(errorFor(npyHeader("[('x', '<f4')]", std::vector<std::int64_t>{9}), values<float>(9)).code(),
              ErrorCode::FormatRefused);
    const auto shape = errorFor(header("<f4", {3, 4}), values<float>(12));
    EXPECT_EQ(shape.code(), ErrorCode::FormatRefused);
    EXPECT_THAT(shape.what(), HasSubstr("3 × 4"));
    std::string fortran = header("<f4", {2, 3, 3});
    fortran.replace(fortran.find("False"), 5, "True ");
    EXPECT_THAT(errorFor(fortran, values<float>(18)).what(), HasSubstr("Fortran order"));
    EXPECT_EQ(errorFor("\x93NUMPX", "").code(), ErrorCode::FileSyntax);
    EXPECT_EQ(errorFor(header("<f4", {1, 3, 3}).substr(0, 30), "").code(), ErrorCode::FileTruncated);
    EXPECT_EQ(errorFor(header("<f4", {2, 3, 3}), values<float>(17)).code(), ErrorCode::FileTruncated);
    EXPECT_EQ(errorFor(header("<f4", {1, 4000000000000000000, 3}), values<float>(9)).code(),
              ErrorCode::CountTooLarge);
    const auto vertices = errorFor(header("<f4", {2, 4, 3}), values<float>(24));
    EXPECT_EQ(vertices.code(), ErrorCode::VertexCountMismatch);
    EXPECT_EQ(valueOf(vertices, "found"), "3");
    EXPECT_EQ(valueOf(vertices, "expected"), "4 (take.npy)");
}
