// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"

#include <gtest/gtest.h>

using namespace quadrille;

TEST(Error, NamesFileSentenceRemedyAndPlace)
{
    const Error error(ErrorCode::FileTruncated,
                      {"walk.pc2", {.byte = 4096}, {{"expected", "50 frames"}, {"found", "3"}}});
    EXPECT_STREQ(error.what(), "walk.pc2: The file ends too early: 50 frames expected, 3 found. "
                               "Export or copy it again. (byte 4096)");
}

TEST(Error, ListsAllKnownPlaces)
{
    const ErrorPlace place{.line = 3, .column = 7, .frame = FrameIndex(12)};
    EXPECT_EQ(place.toString(), "frame 12, line 3, column 7");
    EXPECT_EQ(ErrorPlace{}.toString(), "");
}

TEST(Error, ValuesThatHoldPlaceholdersAreNotExpandedAgain)
{
    const ErrorContext context{{}, {}, {{"reason", "{reason}"}}};
    EXPECT_EQ(fillMessage("Because {reason}.", context), "Because {reason}.");
}

TEST(Error, EveryCodeHasASentence)
{
    for (int code = 0; code <= static_cast<int>(ErrorCode::NoTransition); ++code)
        EXPECT_NE(std::string(errorMessage(static_cast<ErrorCode>(code)).sentence), "") << "code " << code;
    for (int code = 0; code <= static_cast<int>(Issue::Code::Other); ++code)
        EXPECT_NE(std::string(issueMessage(static_cast<Issue::Code>(code)).sentence), "") << "code " << code;
}
