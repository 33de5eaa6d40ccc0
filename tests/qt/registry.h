// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/qt/handovers.h"
#include "tests/qt/patience.h"

#include <QApplication>

namespace quadrille::test {

/// Runs a test class with the program's arguments; gives the exit code.
using RunTest = int (*)(int argc, char** argv);

/// Lets the program run a test class under the name of its source, without folder and extension.
struct Registration
{
    Registration(const char* source, RunTest run);
};

/// Runs a test class in an application of its own.
template <typename Test, typename Application>
int runIn(int argc, char** argv)
{
    const Observed<Application> application(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace quadrille::test

#define QUADRILLE_JOIN_NOW(a, b) a##b
#define QUADRILLE_JOIN(a, b) QUADRILLE_JOIN_NOW(a, b)

/// Makes a test class known to the program, to be run in an application of the class given.
#define QUADRILLE_QT_TEST_IN(Application, Test)                                                              \
    static const quadrille::test::Registration QUADRILLE_JOIN(registration, __COUNTER__)(                    \
        __FILE__, quadrille::test::runIn<Test, Application>)

/// The same in a plain application with widgets.
#define QUADRILLE_QT_TEST(Test) QUADRILLE_QT_TEST_IN(QApplication, Test)
