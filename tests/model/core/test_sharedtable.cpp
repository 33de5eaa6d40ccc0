// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/core/sharedtable.h"
#include "tests/model/core/temporaryfolder.h"

#include <gtest/gtest.h>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::size_t before = 4100; // more than a page, and no whole number of them
const std::string_view text = "what is kept";

std::filesystem::path writeText(const TemporaryFolder& folder)
{
    const std::filesystem::path file = folder / "kept.bin";
    writeAtomically(file, std::string(before, '-') + std::string(text) + "…");
    return file;
}

std::string_view textOf(const MappedBytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.bytes().data()), bytes.bytes().size()};
}

Table<float> counted(Eigen::Index rows, Eigen::Index columns)
{
    Table<float> table(rows, columns);
    std::iota(table.data(), table.data() + table.size(), 0.0F);
    return table;
}

SharedTable<float> inFile(const TemporaryFolder& folder, const Table<float>& table)
{
    const std::filesystem::path file = folder / "table.bin";
    const auto size = static_cast<std::size_t>(table.size()) * sizeof(float);
    writeAtomically(file, std::string_view(reinterpret_cast<const char*>(table.data()), size));
    return {MappedBytes::tryToMap(file, 0, size), table.rows(), table.cols()};
}

} // namespace

TEST(MappedBytes, AreThoseOfTheFileFromAnyByteOn)
{
    const TemporaryFolder folder;
    const auto file = writeText(folder);
    const auto bytes = MappedBytes::tryToMap(file, before, text.size());
    ASSERT_NE(bytes, nullptr);
    EXPECT_EQ(textOf(*bytes), text);
    bytes->unload();
    EXPECT_EQ(textOf(*bytes), text);
}

TEST(MappedBytes, StayWhenTheFileIsReplacedOrRemoved)
{
    const TemporaryFolder folder;
    const auto file = writeText(folder);
    const auto bytes = MappedBytes::tryToMap(file, before, text.size());
    ASSERT_NE(bytes, nullptr);
    writeAtomically(file, "short");
    bytes->unload();
    EXPECT_EQ(textOf(*bytes), text);
    std::filesystem::remove(file);
    bytes->unload();
    EXPECT_EQ(textOf(*bytes), text);
}

TEST(MappedBytes, AreNoneWhereTheFileHasThemNot)
{
    const TemporaryFolder folder;
    const auto file = writeText(folder);
    const std::uint64_t size = std::filesystem::file_size(file);
    EXPECT_NE(MappedBytes::tryToMap(file, 0, size), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(file, 0, size + 1), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(file, size, 1), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(file, size + 5000, 1), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(file, 1, ~std::size_t{0}), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(file, 0, 0), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(folder / "nothing.bin", 0, 1), nullptr);
    EXPECT_EQ(MappedBytes::tryToMap(folder.path(), 0, 1), nullptr);
}

TEST(TableView, LooksAtATableAndThenAtAnother)
{
    const Table<float> small = counted(2, 3);
    const Table<float> large = counted(4, 5);
    TableView<float> view = small;
    EXPECT_EQ(view.data(), small.data());
    EXPECT_EQ(view(1, 2), 5);
    EXPECT_EQ(view.row(1).sum(), 12);
    view = large;
    EXPECT_EQ(view.data(), large.data());
    EXPECT_EQ(view.rows(), 4);
    EXPECT_EQ(view.cols(), 5);
    EXPECT_EQ(small(1, 2), 5);
    EXPECT_EQ(TableView<float>().size(), 0);
}

TEST(SharedTable, IsTakenWithoutACopyWhereNobodyElseHasIt)
{
    SharedTable<float> table(counted(3, 4));
    const float* const data = table.data();
    const SharedTable<float> other = table;
    const Table<float> copy = std::move(table).take();
    EXPECT_NE(copy.data(), data);
    EXPECT_EQ(other.data(), data);
    EXPECT_TRUE((copy == *other).all());
    const Table<float> same = SharedTable<float>(other).take();
    EXPECT_NE(same.data(), data);
    SharedTable<float> last(counted(3, 4));
    const float* const own = last.data();
    const Table<float> taken = std::move(last).take();
    EXPECT_EQ(taken.data(), own);
}

TEST(SharedTable, IsTheSameInAFile)
{
    const TemporaryFolder folder;
    const Table<float> numbers = counted(60, 70);
    SharedTable<float> table = inFile(folder, numbers);
    EXPECT_EQ(table(59, 69), 4199);
    EXPECT_EQ(table[70], 70);
    EXPECT_EQ(std::accumulate(table.begin(), table.end(), 0.0), 4199.0 * 4200 / 2);
    EXPECT_EQ(table, SharedTable<float>(numbers));
    EXPECT_FALSE(table == SharedTable<float>(counted(70, 60)));
    EXPECT_FALSE(table == SharedTable<float>(numbers + 1.0F));
    const SharedTable<float> other = table;
    Table<float> copy = std::move(table).take();
    copy(0, 0) = 7;
    EXPECT_EQ(other(0, 0), 0);
    EXPECT_EQ(other(59, 69), 4199);
    EXPECT_TRUE(SharedTable<float>().empty());
}
