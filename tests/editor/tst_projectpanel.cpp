// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/projecttreemodel.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/fieldnote.h"

#include <QLineEdit>
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
        QVERIFY(test::raiseDock("projectDock"));
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

    void renamesInPlaceAndKeepsTheFieldWhileANameCannotBeTaken()
    {
        QTest::keyClick(&tree(), Qt::Key_D, Qt::ControlModifier);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, place("walk"));
        QTest::keyClick(&tree(), Qt::Key_F2);
        const auto type = [this](const QString& name) {
            auto* field = tree().findChild<QLineEdit*>();
            QVERIFY(field != nullptr);
            field->selectAll();
            // A result that arrives now takes neither the selection nor what is typed.
            const auto arrive = [this, edited = tree().currentIndex()] {
                emit tree().model()->dataChanged(edited, edited);
            };
            arrive();
            QTest::keyClicks(field, name);
            arrive();
            QTest::keyClick(field, Qt::Key_Return);
        };
        const auto note = [this] {
            auto* shown = m_window->findChild<widgets::FieldNote*>();
            return shown == nullptr ? QString() : shown->text();
        };
        type("walk 2");
        QVERIFY2(note().contains("walk 2"), qPrintable(note()));
        type("take 1/2");
        QTRY_VERIFY2(note().contains("slashes"), qPrintable(note()));
        QCOMPARE(tree().findChild<QLineEdit*>()->text(), QString("take 1/2"));
        type("..");
        QTRY_VERIFY2(note().contains("cannot be a name"), qPrintable(note()));
        type(QString(256, 'a'));
        QTRY_VERIFY2(note().contains("256 bytes"), qPrintable(note()));
        QVERIFY(document().sequence("walk") != nullptr);
        type("stroll");
        QTRY_VERIFY(document().sequence("stroll") != nullptr);
        QTRY_VERIFY(tree().findChild<QLineEdit*>() == nullptr);
        QTRY_COMPARE(note(), QString());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ProjectPanelTest);
#include "tst_projectpanel.moc"
