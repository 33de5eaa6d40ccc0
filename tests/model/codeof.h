// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <gtest/gtest.h>

namespace quadrille::test {

/// Code of the Error that a call throws; fails the test when it throws none.
template <typename Call>
ErrorCode codeOf(Call&& call)
{
    try {
        call();
    } catch (const Error& error) {
        EXPECT_STRNE(error.what(), "");
        return error.code();
    }
    ADD_FAILURE() << "no error was thrown";
    return ErrorCode::Unexpected;
}

} // namespace quadrille::test
