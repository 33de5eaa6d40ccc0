// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectpaths.h"
#include "editor/relinking/lostmediatable.h"
#include "editor/relinking/relinkdialog.h"
#include "editortest.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/resultplaces.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QTreeView>

namespace quadrille {

/// A project with two numbered takes whose folder was moved away since it was saved.
class RelinkTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    QString place(const QString& name) const { return m_folder->filePath(name); }
    void newWindow()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(test::activate(*m_window));
    }
    /// Imports and saves two takes, and waits until their contents are noted.
    void makeProject()
    {
        QDir().mkpath(place("old/takes"));
        test::writeSeries(place("old/takes"), {1, 2, 3});
        for (const QString number : {"1", "2"})
            QFile::copy(place("old/takes/walk_" + number + ".obj"),
                        place("old/takes/run_" + number + ".obj"));
        newWindow();
        m_window->open({place("old/takes/walk_1.obj"), place("old/takes/run_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(test::waitForSequence(*m_window, "run"));
        QCOMPARE(context().document.project().sequences.size(), 2U);
        context().document.saveAs(place("p.quadrille").toStdString());
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(QFile::exists(place("p.quadrille.cache/media.json")));
        m_window.reset();
    }
    void openProject()
    {
        newWindow();
        m_window->open({place("p.quadrille")});
    }
    static RelinkDialog* dialog()
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* found = qobject_cast<RelinkDialog*>(widget); found != nullptr && found->isVisible())
                return found;
        }
        return nullptr;
    }
    widgets::MessageStrip* strip() { return m_window->findChild<widgets::MessageStrip*>("missingStrip"); }
    /// Opens the dialog from the strip, with the mouse.
    void ask()
    {
        QTRY_VERIFY(strip()->isVisible());
        QTest::mouseClick(strip()->findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(dialog() != nullptr);
        QTRY_VERIFY(!dialog()->plan().media.empty());
        QVERIFY(test::activate(*dialog()));
    }
    /// Searches a folder, with the keyboard alone.
    static void search(const QString& folder)
    {
        auto* field = test::find<QLineEdit>("relinkFolder");
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, folder);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(field->isEnabled());
    }
    static QString state(int row)
    {
        return test::find<LostMediaTable>("relinkTable")
            ->topLevelItem(row)
            ->text(LostMediaTable::StateColumn);
    }
    static int rowOf(const QString& file)
    {
        auto* table = test::find<LostMediaTable>("relinkTable");
        for (int row = 0; row < table->topLevelItemCount(); ++row) {
            if (table->topLevelItem(row)->text(LostMediaTable::FileColumn) == file)
                return row;
        }
        return -1;
    }
    QString sourceOf(const QString& sequence)
    {
        return QString::fromStdString(context().document.sequence(sequence)->source);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        makeProject();
    }
    void cleanup()
    {
        if (m_window)
            context().document.reset({});
        m_window.reset();
        m_folder.reset();
    }

    void takesThatMovedLoadAgainAndUndoForgetsIt()
    {
        QDir().mkpath(place("new/deep"));
        QVERIFY(QDir().rename(place("old/takes"), place("new/deep/footage")));
        openProject();
        ask();
        const int walk = rowOf("walk_####.obj");
        const int run = rowOf("run_####.obj");
        QVERIFY(walk >= 0 && run >= 0);
        QCOMPARE(state(walk), QString("missing"));
        auto* accept = test::find<QPushButton>("relinkAccept");
        QVERIFY(!accept->isEnabled());

        search(place("nowhere"));
        QTRY_VERIFY(dialog()->findChild<widgets::MessageStrip*>()->isVisible());
        search(place("old"));
        QTRY_VERIFY(dialog()->findChild<widgets::MessageStrip*>()->text().contains("None of"));
        search(place("new"));
        QTRY_COMPARE(state(walk), QString("found by name and content"));
        QCOMPARE(state(run), QString("found by name and content"));
        // Nothing has changed yet.
        QCOMPARE(sourceOf("walk"), place("old/takes/walk_####.obj"));
        QVERIFY(!context().document.isModified());
        QTest::keyClick(test::find<QLineEdit>("relinkFolder"), Qt::Key_Return);

        QTRY_VERIFY(dialog() == nullptr);
        QCOMPARE(sourceOf("walk"), place("new/deep/footage/walk_####.obj"));
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(test::waitForSequence(*m_window, "run"));
        QTRY_VERIFY(!strip()->isVisible());
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(sourceOf("walk"), place("old/takes/walk_####.obj"));
        QCOMPARE(sourceOf("run"), place("old/takes/run_####.obj"));
        QVERIFY(!context().document.canUndo());
        QTRY_VERIFY(strip()->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!strip()->isVisible());
    }

    void cancelLeavesEverything()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        openProject();
        const Project before = context().document.project();
        ask();
        search(place("old"));
        QTRY_VERIFY(test::find<QPushButton>("relinkAccept")->isEnabled());
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(dialog() == nullptr);
        QVERIFY(context().document.project() == before);
        QVERIFY(!context().document.canUndo());
        QVERIFY(strip()->isVisible());
    }

    void aSearchCanBeStopped()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        openProject();
        ask();
        auto* field = test::find<QLineEdit>("relinkFolder");
        auto* button = test::find<QPushButton>("relinkSearch");
        QTRY_VERIFY(field->hasFocus());
        field->setText("/");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!field->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(field->hasFocus());
        QCOMPARE(dialog()->plan().foundCount(), 0U);
        QVERIFY(!dialog()->findChild<widgets::MessageStrip*>()->isVisible());
        search(place("old"));
        QTRY_COMPARE(dialog()->plan().foundCount(), dialog()->plan().media.size());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void aNamesakeWithOtherContentIsNotTakenUnasked()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        std::ofstream(place("old/moved/run_2.obj").toStdString(), std::ios::app) << "# edited since\n";
        openProject();
        ask();
        search(place("old"));
        const int run = rowOf("run_####.obj");
        QTRY_COMPARE(state(run), QString("found, but different content"));
        QCOMPARE(state(rowOf("walk_####.obj")), QString("found by name and content"));
        auto* table = test::find<LostMediaTable>("relinkTable");
        QVERIFY(!table->isWanted(run));
        const auto wanted = dialog()->plan().newPaths().size();
        // Whoever wants it ticks it.
        table->setFocus();
        table->selectMedium(run);
        QVERIFY(test::find<QLabel>("relinkNote")->text().contains("not the one"));
        QTest::keyClick(table, Qt::Key_Space);
        QVERIFY(table->isWanted(run));
        QCOMPARE(dialog()->plan().newPaths().size(), wanted + 1);
        QTest::keyClick(table, Qt::Key_Space);
        QTest::mouseClick(test::find<QPushButton>("relinkAccept"), Qt::LeftButton);
        QCOMPARE(sourceOf("run"), place("old/takes/run_####.obj"));
        QCOMPARE(sourceOf("walk"), place("old/moved/walk_####.obj"));
        QTRY_VERIFY(strip()->isVisible());
    }

    void oneFileByHandBringsTheOthers()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        openProject();
        ask();
        auto* table = test::find<LostMediaTable>("relinkTable");
        table->selectMedium(rowOf("walk_####.obj"));
        QTimer::singleShot(0, this, [this] {
            QFileDialog* chooser = nullptr;
            QTRY_VERIFY((chooser = dialog()->findChild<QFileDialog*>()) != nullptr && chooser->isVisible());
            auto* field = chooser->findChild<QLineEdit*>("fileNameEdit");
            field->setText(place("old/moved/walk_2.obj"));
            QTest::keyClick(field, Qt::Key_Return);
        });
        QTest::mouseClick(test::find<QPushButton>("relinkByHand"), Qt::LeftButton);
        QTRY_COMPARE(state(rowOf("walk_####.obj")), QString("found by name and content"));
        QTRY_COMPARE(state(rowOf("run_####.obj")), QString("found by name and content"));
        QTest::mouseClick(test::find<QPushButton>("relinkAccept"), Qt::LeftButton);
        QCOMPARE(sourceOf("walk"), place("old/moved/walk_####.obj"));
        QVERIFY(test::waitForSequence(*m_window, "run"));
    }

    void whatIsPutBackLoadsWithoutAsking()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        openProject();
        QTRY_VERIFY(strip()->isVisible());
        QVERIFY(QDir().rename(place("old/moved"), place("old/takes")));
        // Another window had the keyboard meanwhile.
        emit qGuiApp->applicationStateChanged(Qt::ApplicationActive);
        QTRY_VERIFY(!strip()->isVisible());
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(test::waitForSequence(*m_window, "run"));
    }

    void theDialogSaysWhenNothingIsMissing()
    {
        openProject();
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(!strip()->isVisible());
        context().actions.action("file.findMissing")->trigger();
        QTRY_VERIFY(test::find<QLabel>("relinkEmpty")->text().contains("Nothing is missing"));
        QVERIFY(!test::find<QPushButton>("relinkSearch")->isEnabled());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void theTreeOffersItForWhatFailed()
    {
        QVERIFY(QDir().rename(place("old/takes"), place("old/moved")));
        openProject();
        QTRY_VERIFY(strip()->isVisible());
        QVERIFY(test::raiseDock("projectDock"));
        auto* tree = test::find<QTreeView>("projectTree");
        const QModelIndex run = tree->model()->index(1, 0, tree->model()->index(1, 0));
        QTRY_VERIFY(context().media.resultState("run")->phase == ResultPhase::Failed);
        tree->expandAll();
        tree->setCurrentIndex(run);
        QTimer::singleShot(0, this, [this] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu != nullptr);
            QAction* action = context().actions.action("file.findMissing");
            QVERIFY(menu->actions().contains(action));
            menu->setActiveAction(action);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, tree->visualRect(run).center(),
                                tree->viewport()->mapToGlobal(tree->visualRect(run).center()));
        QApplication::sendEvent(tree->viewport(), &event);
        QTRY_VERIFY(dialog() != nullptr);
        QTRY_VERIFY(!dialog()->plan().media.empty());
        QTRY_COMPARE(test::find<LostMediaTable>("relinkTable")->currentMedium(), rowOf("run_####.obj"));
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    /// A file stands where the folder of results should be.
    void resultsThatCannotBeBesideTheProjectGoElsewhereAndTheWindowSaysSo()
    {
        makeProject();
        QVERIFY(QDir(place("p.quadrille.cache")).removeRecursively());
        std::ofstream(place("p.quadrille.cache").toStdString()) << "in the way";
        setResultRoot(place("cache").toStdString());
        openProject();
        auto* strip = m_window->findChild<widgets::MessageStrip*>("resultsStrip");
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(strip->text().contains(QDir::toNativeSeparators(place("cache"))));
        const auto file = context().document.file();
        const RebuildReport report = rebuild(context().document.snapshot(), file, {.targets = {"sequences"}});
        QVERIFY(!report.hasFailures());
        QVERIFY(resultPlaces(file).isElsewhere);
        // The word goes with its cause.
        QVERIFY(QFile::remove(place("p.quadrille.cache")));
        QTRY_VERIFY(!strip->isVisible());
        setResultRoot({});
    }

    void savingUnderAnotherNameTakesTheResultsAlong()
    {
        makeProject();
        openProject();
        QTRY_COMPARE(context().document.project().sequences.size(), 2U);
        const RebuildReport before =
            rebuild(context().document.snapshot(), context().document.file(), {.targets = {"sequences"}});
        QVERIFY(before.count(StepState::Computed) > 0);
        QDir().mkpath(place("elsewhere"));
        const QString copy = place("elsewhere/q.quadrille");
        QTimer::singleShot(0, this, [&] {
            QFileDialog* chooser = nullptr;
            QTRY_VERIFY((chooser = m_window->findChild<QFileDialog*>()) != nullptr && chooser->isVisible());
            auto* field = chooser->findChild<QLineEdit*>("fileNameEdit");
            field->setText(copy);
            QTest::keyClick(field, Qt::Key_Return);
        });
        context().actions.action("file.saveAs")->trigger();
        QTRY_COMPARE(toQString(context().document.file()), copy);
        const RebuildReport after =
            rebuild(context().document.snapshot(), context().document.file(), {.targets = {"sequences"}});
        QCOMPARE(after.count(StepState::Computed), 0U);
        QCOMPARE(after.count(StepState::Fresh), before.steps.size());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::RelinkTest);
#include "tst_relink.moc"
