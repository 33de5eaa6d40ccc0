// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTest>

namespace quadrille::test {

/// How long tests wait for what is to come, milliseconds. Where all is well nobody waits so long; a machine
/// that has other work is not wrong for being slow, and much less a program that checks each of its accesses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int patience = 1'200'000;
#else
inline constexpr int patience = 240'000;
#endif

} // namespace quadrille::test

// Qt's own wait for five seconds.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, quadrille::test::patience)
#define QTRY_VERIFY2(condition, message)                                                                     \
    QTRY_VERIFY2_WITH_TIMEOUT(condition, message, quadrille::test::patience)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, quadrille::test::patience)
