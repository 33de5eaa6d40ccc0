// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/exporting/exportdialog.h"
#include "editortest.h"
#include "widgets/controls/messagestrip.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
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
    static ExportDialog* dialog()
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* found = qobject_cast<ExportDialog*>(widget); found != nullptr && found->isVisible())
                return found;
        }
        return nullptr;
    }
    /// Chooses a format with the keyboard.
    static void choose(const QString& format)
    {
        auto* box = test::find<QComboBox>("exportFormat");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        while (box->currentData().toString() != format && box->currentIndex() + 1 < box->count())
            QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(box->currentData().toString(), format);
    }
    static void type(const QString& path)
    {
        auto* field = test::find<QLineEdit>("exportPlace");
        field->selectAll();
        QTest::keyClicks(field, path);
    }
    static void accept() { QTest::mouseClick(test::find<QPushButton>("exportAccept"), Qt::LeftButton); }
    static bool isDone() { return test::find<QPushButton>("exportAccept")->text() == "Close"; }
    /// Exports, waits until all is written, and closes the dialog.
    static void acceptAndClose()
    {
        accept();
        QTRY_VERIFY(isDone());
        accept();
        QTRY_VERIFY(dialog() == nullptr);
    }
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
