// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/progress.h"

#include <gtest/gtest.h>
#include <vector>

using namespace quadrille;

TEST(Progress, PartsNest)
{
    std::vector<double> seen;
    const Progress progress(CancelToken(), [&seen](double fraction) { seen.push_back(fraction); });
    const Progress second = progress.part(0.5, 1.0);
    second.report(0.5);
    second.part(0.5, 1.0).report(1, 2);
    EXPECT_EQ(seen, (std::vector<double>{0.75, 0.875}));
}

TEST(Progress, NeverGoesBack)
{
    std::vector<double> seen;
    const Progress progress(CancelToken(), [&seen](double fraction) { seen.push_back(fraction); });
    progress.report(0.5);
    progress.report(0.25);
    EXPECT_EQ(seen, std::vector<double>{0.5});
}

TEST(Progress, ThrowsOnceCancelled)
{
    CancelToken token;
    const Progress progress(token);
    EXPECT_NO_THROW(progress.report(0.1));
    token.cancel();
    try {
        progress.part(0.2, 0.3).report(0.5);
        FAIL() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
}

TEST(Progress, DefaultReportsNothing)
{
    EXPECT_NO_THROW(Progress().report(0.5));
    EXPECT_FALSE(Progress().isCancelled());
}
