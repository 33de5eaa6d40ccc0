// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTest>

namespace quadrille::test {

/// Runs a test function in each language of the editor: rows of a column `language`.
inline void addLanguages()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("French") << "fr";
}

} // namespace quadrille::test
