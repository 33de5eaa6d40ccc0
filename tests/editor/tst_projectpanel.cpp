// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/projecttreemodel.h"
#include "editortest.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTreeView>

namespace quadrille {

class ProjectPanelTest : public QObject
{
    Q_OBJECT

private:
    ProjectDocument& document() { return m_window->context().document; }
    Selection& selection() { return m_window->context().selection; }
    QTreeView& tree() { return *m_tree; }
    QPoint place(const QString& sequence)
    {
        auto* model = qobject_cast<ProjectTreeModel*>(m_tree->model());
        return m_tree->visualRect(model->indexOf({Section::Sequences, sequence})).center();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    QTreeView* m_tree = nullptr;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(m_folder->path(), {1, 2, 3});
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(test::activate(*m_window));
        m_tree = test::find<QTreeView>("projectTree");
        m_tree->expandAll();
        QTest::mouseClick(m_tree->viewport(), Qt::LeftButton, {}, place("walk"));
        m_tree->setFocus();
    }
    void cleanup()
    {
        document().saveAs(m_folder->filePath("project.quadrille").toStdString());
        m_window.reset();
        m_folder.reset();
    }

    void duplicatesAndRemovesByKeys()
    {
        QTest::keyClick(&tree(), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(document().project().sequences.size(), 2U);
        const QString copy = selection().shownSequence();
        QVERIFY(copy != "walk");
        // What is selected elsewhere is selected here.
        QCOMPARE(tree().currentIndex().data().toString(), copy);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, Qt::ControlModifier, place("walk"));
        QCOMPARE(selection().sequences().size(), 2);
        QTest::keyClick(&tree(), Qt::Key_Delete);
        QVERIFY(document().project().sequences.empty());
        document().undo();
        QCOMPARE(document().project().sequences.size(), 2U);
    }

    void renamesInPlaceAndSaysWhenANameIsTaken()
    {
        QTest::keyClick(&tree(), Qt::Key_D, Qt::ControlModifier);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, place("walk"));
        const auto rename = [this](const QString& name) {
            QTest::keyClick(&tree(), Qt::Key_F2);
            auto* field = tree().findChild<QLineEdit*>();
            QVERIFY(field != nullptr);
            field->selectAll();
            QTest::keyClicks(field, name);
            QTest::keyClick(field, Qt::Key_Return);
            QTRY_VERIFY(tree().findChild<QLineEdit*>() == nullptr);
        };
        rename("stroll");
        QTRY_VERIFY(document().sequence("stroll") != nullptr);
        const QSignalSpy refused(tree().model(), SIGNAL(nameRefused(quadrille::EntryRef, QString)));
        rename("walk 2");
        QVERIFY(document().sequence("stroll") != nullptr);
        QCOMPARE(refused.count(), 1);
    }
};

} // namespace quadrille

QTEST_MAIN(quadrille::ProjectPanelTest)
#include "tst_projectpanel.moc"
