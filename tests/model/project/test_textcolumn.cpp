// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/result.h"
#include "model/project/store/textcolumn.h"

#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TextColumn, IsAListOfTexts)
{
    TextColumn column{"walk", "walk", "run", "walk", ""};
    column.push_back("run");
    EXPECT_THAT(column, ElementsAre("walk", "walk", "run", "walk", "", "run"));
    EXPECT_EQ(column.size(), 6U);
    EXPECT_EQ(column[3], "walk");
    EXPECT_EQ(column.at(4), "");
    EXPECT_THROW(column.at(6), std::out_of_range);
    EXPECT_EQ(column.front(), "walk");
    EXPECT_EQ(column.back(), "run");
    EXPECT_THAT(column.list(), ElementsAre("walk", "walk", "run", "walk", "", "run"));
    EXPECT_THAT(TextColumn(), IsEmpty());
}

TEST(TextColumn, KeepsEachWordOnce)
{
    TextColumn column;
    for (int i = 0; i < 1000; ++i)
        column.push_back(i % 2 == 0 ? "original" : "transition");
    EXPECT_THAT(column.words(), ElementsAre("original", "transition"));
    EXPECT_LT(column.bytes(), 5000U);
    Result result;
    result.tables = {{"edges", "", {columnOf("kind", "", column.list())}}};
    EXPECT_LT(bytesOf(result), 5000U + sizeof(Result));
}

TEST(TextColumn, IsEqualToOneOfTheSameTexts)
{
    const std::vector<std::string> texts{"b", "a", "b"};
    EXPECT_EQ(TextColumn(texts), (TextColumn{"b", "a", "b"}));
    EXPECT_NE(TextColumn(texts), (TextColumn{"b", "a", "a"}));
    EXPECT_NE(TextColumn(texts), (TextColumn{"a", "b", "a"}));
    EXPECT_NE(TextColumn(texts), (TextColumn{"b", "a"}));
}
