// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/mainwindow.h"
#include "tests/qt/patience.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QDockWidget>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

namespace quadrille::test {

/// Settings, sessions and samples of a test stay in folders of its own, and views are drawn quickly rather
/// than well. Call before anything else.
inline void isolate()
{
    widgets::VtkView::setBestLevel(widgets::RenderGovernor::levels - 1);
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Quadrille"));
    QCoreApplication::setApplicationName(QStringLiteral("quadrille-test-") +
                                         QString::number(QCoreApplication::applicationPid()));
}

/// A numbered OBJ series of a pyramid, 1.7 units high, whose tip wanders.
inline void writeSeries(const QString& folder, const QList<int>& numbers)
{
    for (const int number : numbers) {
        std::ofstream file(QStringLiteral("%1/walk_%2.obj").arg(folder).arg(number).toStdString());
        file << "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.5 1.7 " << 0.1 * number
             << "\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 5/3\nf 2/1 3/2 5/3\nf 3/1 4/2 5/3\nf 4/1 1/2 5/3\n"
                "f 4/1 3/2 2/3 1/1\n";
    }
}

/// A widget of the program by its object name, where there are several the one that is seen; fails the test
/// when there is none.
template <typename Widget>
Widget* find(const QString& name)
{
    Widget* hidden = nullptr;
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* found = qobject_cast<Widget*>(widget);
        if (found == nullptr || found->objectName() != name)
            continue;
        if (found->isVisible())
            return found;
        hidden = found;
    }
    if (hidden != nullptr)
        return hidden;
    QTest::qFail(qPrintable(QStringLiteral("no widget called ") + name), __FILE__, __LINE__);
    return nullptr;
}

/// Gives a window the keyboard, as a click on it does.
inline bool activate(QWidget& window)
{
    window.activateWindow();
    return QTest::qWaitForWindowActive(&window);
}

/// Brings a dock to the front of those that share its place, as a click on its tab does.
inline bool raiseDock(const QString& name)
{
    auto* dock = find<QDockWidget>(name);
    dock->show();
    dock->raise();
    return QTest::qWaitFor([dock] { return !dock->widget()->visibleRegion().isEmpty(); });
}

/// Waits until a sequence of the window's project can be shown.
inline bool waitForSequence(MainWindow& window, const QString& name)
{
    return QTest::qWaitFor([&] { return window.context().media.untrimmed(name) != nullptr; }, test::patience);
}

} // namespace quadrille::test
