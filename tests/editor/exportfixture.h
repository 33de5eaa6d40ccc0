// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "exporting.h"
#include "widgets/controls/messagestrip.h"

#include <memory>

namespace quadrille {

/// The window with a saved project of one take, and its dialog for exports.
class ExportFixture : public QObject
{
    Q_OBJECT

protected:
    ProjectDocument& document() { return m_window->context().document; }
    QString place(const QString& name) const { return m_folder->filePath(name); }

    void openDialog()
    {
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(dialog() != nullptr);
    }
    static ExportDialog* dialog() { return test::exportDialog(); }
    static void choose(const QString& format) { test::chooseExportFormat(format); }
    static void type(const QString& path) { test::typeExportPlace(path); }
    static void accept() { test::acceptExport(); }
    static bool isDone() { return test::isExportDone(); }
    static void acceptAndClose() { test::acceptAndCloseExport(); }
    static widgets::MessageStrip* strip() { return dialog()->findChild<widgets::MessageStrip*>(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

protected slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(m_folder->path(), {1, 2, 3, 4, 5});
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({place("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        document().saveAs(place("project.quadrille").toStdString());
    }
    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }
};

} // namespace quadrille
