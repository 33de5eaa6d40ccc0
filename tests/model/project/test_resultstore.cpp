// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/resultstore.h"
#include "tests/model/project/testproject.h"

#include <cmath>
#include <fstream>

using namespace quadrille;
using namespace quadrille::test;

namespace {

Result fullResult()
{
    DataArray matrix;
    matrix.name = "pose-distance";
    matrix.description = "Distances – metres.";
    matrix.unit = "m";
    matrix.shape = {2, 3};
    matrix.values = std::vector<float>{0, 1, INFINITY, 3, 4.5F, -0.0F};
    matrix.columns = {"a", "b", "c"};
    DataArray empty = columnOf("nothing", "", std::vector<double>{});
    DataArray picture;
    picture.name = "picture";
    picture.shape = {1, 2, 4};
    picture.values = std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 255};
    Result result;
    result.arrays = {matrix, empty, picture};
    result.tables = {{"frames",
                      "All frames.",
                      {columnOf("index", "", std::vector<std::int64_t>{0, 1}),
                       columnOf("sequence", "", std::vector<std::string>{"größe", ""})}}};
    result.files = {{"out/a.ply", "00ff"}, {"out/b.ply", "11"}};
    return result;
}

ErrorCode codeOfReading(const std::filesystem::path& file)
{
    try {
        readResultFile(file);
    } catch (const Error& error) {
        return error.code();
    }
    return ErrorCode::Cancelled;
}

} // namespace

TEST(ResultFile, GivesBackWhatWasWritten)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "r.h5", {"stage", "key"}, fullResult());
    EXPECT_EQ(readResultFile(folder / "r.h5"), fullResult());
    const ResultHeader header = readResultHeader(folder / "r.h5");
    EXPECT_EQ(header.stage, "stage");
    EXPECT_EQ(header.key, "key");
}

TEST(ResultFile, HasTheSameBytesWheneverItIsWritten)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "a.h5", {"stage", "key"}, fullResult());
    ::usleep(1100000); // HDF5 keeps whole seconds where it keeps times
    writeResultFile(folder / "b.h5", {"stage", "key"}, fullResult());
    EXPECT_EQ(textOf(folder / "a.h5"), textOf(folder / "b.h5"));
}

TEST(ResultFile, AnyChangedByteOfTheContentIsFound)
{
    const TemporaryFolder folder;
    DataArray array = columnOf("values", "", std::vector<double>(64, 1.25));
    Result result;
    result.arrays = {array};
    writeResultFile(folder / "r.h5", {"stage", "key"}, result);
    std::string bytes = textOf(folder / "r.h5");
    const std::string one("\0\0\0\0\0\0\xF4\x3F", 8); // 1.25, little-endian
    const auto at = bytes.find(one + one);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 9] = '\x01';
    folder.write("r.h5", bytes);
    EXPECT_EQ(codeOfReading(folder / "r.h5"), ErrorCode::ResultDamaged);
}

TEST(ResultFile, TruncatedAndForeignFilesAreDamaged)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "r.h5", {"stage", "key"}, fullResult());
    const std::string bytes = textOf(folder / "r.h5");
    for (std::size_t size = 1; size < bytes.size(); size += 97) {
        folder.write("cut.h5", bytes.substr(0, size));
        EXPECT_EQ(codeOfReading(folder / "cut.h5"), ErrorCode::ResultDamaged) << size << " bytes";
    }
    folder.write("text.h5", "this is no HDF5 file");
    EXPECT_EQ(codeOfReading(folder / "text.h5"), ErrorCode::ResultDamaged);
}

TEST(ResultStore, TellsFreshFromOtherFromDamagedFromMissing)
{
    const TemporaryFolder folder;
    const ResultStore store(folder.path());
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Missing);
    store.save("sequences/a/statistics", "k", fullResult());
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Fresh);
    EXPECT_EQ(store.load("sequences/a/statistics", "k").result, fullResult());
    EXPECT_EQ(store.load("sequences/a/statistics", "l").state, ResultStore::State::OtherKey);
    std::ofstream(store.fileOf("sequences/a/statistics"), std::ios::binary).close();
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Damaged);
}
