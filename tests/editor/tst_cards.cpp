// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The cards of sequences: found, ordered, selected, opened and compared with real mouse and keys.
#include "editor/commands/projectedits.h"
#include "editor/docks/cardpictures.h"
#include "editor/docks/sequencecards.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/viewport/viewport.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QImage>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>
#include <functional>

namespace quadrille {

class CardsTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    void clickTreeRow(int row)
    {
        QVERIFY(test::raiseDock("projectDock"));
        auto* tree = test::find<QTreeView>("projectTree");
        const QModelIndex sequences = tree->model()->index(1, 0);
        const QRect place = tree->visualRect(tree->model()->index(row, 0, sequences));
        QVERIFY(place.isValid());
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place.center());
    }
    QPoint cardPlace(int row)
    {
        auto* cards = test::find<QListView>("cards");
        return cards->visualRect(cards->model()->index(row, 0)).center();
    }
    void whenMenuIsOpen(const std::function<void(QMenu&)>& look)
    {
        QTimer::singleShot(0, this, [look] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu != nullptr);
            look(*menu);
            menu->close();
        });
    }
    /// Triggers what the menu of a card calls so, maybe in a menu below.
    void chooseInMenu(int row, const QString& text, const QString& below = {})
    {
        auto* cards = test::find<QListView>("cards");
        const QPoint place = cardPlace(row);
        QTest::mouseClick(cards->viewport(), Qt::LeftButton, {}, place);
        QAction* chosen = nullptr;
        whenMenuIsOpen([&](QMenu& menu) {
            const auto named = [](const QMenu& in, const QString& name) {
                for (QAction* action : in.actions()) {
                    if (action->text() == name)
                        return action;
                }
                return static_cast<QAction*>(nullptr);
            };
            chosen = named(menu, text);
            if (chosen != nullptr && !below.isEmpty())
                chosen = named(*chosen->menu(), below);
            QVERIFY2(chosen != nullptr, qPrintable(text));
            chosen->trigger();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, cards->viewport()->mapToGlobal(place));
        QApplication::sendEvent(cards->viewport(), &event);
        QVERIFY(chosen != nullptr);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        for (const auto& [name, numbers] :
             {std::pair{"walk", QList<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
              std::pair{"run", QList<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}}}) {
            QDir().mkpath(m_folder.filePath(name));
            test::writeSeries(m_folder.filePath(name), numbers);
        }
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project;
        const auto path = [this](const char* name) { return m_folder.filePath(name).toStdString(); };
        project.characters = {{.name = "pyramid", .mesh = path("walk/walk_1.obj")}};
        project.sequences = {{.name = "walk", .character = "pyramid", .source = path("walk")},
                             {.name = "run", .character = "pyramid", .source = path("run")},
                             {.name = "late", .character = "pyramid", .source = path("late")}};
        context().document.reset(project);
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(test::waitForSequence(*m_window, "run"));
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void cardsShowFindAndCompare()
    {
        auto* cards = test::find<QListView>("cards");
        // Nobody has to look for them: they are in front of the tree.
        QTRY_VERIFY(!cards->visibleRegion().isEmpty());
        const auto click = [cards](int row, Qt::KeyboardModifiers modifiers) {
            QTest::mouseClick(cards->viewport(), Qt::LeftButton, modifiers,
                              cards->visualRect(cards->model()->index(row, 0)).center());
        };
        click(1, Qt::NoModifier);
        QCOMPARE(context().selection.shownSequence(), QString("run"));
        click(0, Qt::ControlModifier);
        QTRY_COMPARE(m_window->sequences().viewport().figures().size(), 2U);
        // Each ready sequence gets its moving pictures.
        const auto pictures = [cards](int row) {
            return cards->model()->index(row, 0).data(SequenceCards::PicturesRole).value<QList<QImage>>();
        };
        QTRY_COMPARE(pictures(0).size(), 12);
        QTRY_COMPARE(pictures(1).size(), 12);
        QVERIFY(pictures(2).isEmpty());
        setSequenceLabels(context().document, "run", {{"gallop", {FrameIndex(0), FrameIndex(4)}}});
        auto* search = test::find<QLineEdit>("cardSearch");
        QTest::keyClicks(search, "GALL");
        QCOMPARE(cards->model()->rowCount(), 1);
        QCOMPARE(cards->model()->index(0, 0).data().toString(), QString("run"));
        QTest::keyClick(search, Qt::Key_Escape);
        search->clear();
        // F2 and a name rename, in one step that can be undone.
        click(1, Qt::NoModifier);
        cards->setFocus();
        QTest::keyClick(cards, Qt::Key_F2);
        auto* field = cards->viewport()->findChild<QLineEdit*>();
        QVERIFY(field != nullptr);
        // One that cannot be taken keeps the field open.
        for (const char* name : {"walk", "a/b"}) {
            field->selectAll();
            QTest::keyClicks(field, name);
            QTest::keyClick(field, Qt::Key_Return);
            QCOMPARE(cards->viewport()->findChild<QLineEdit*>(), field);
            QCOMPARE(field->text(), QString(name));
        }
        field->selectAll();
        QTest::keyClicks(field, "away");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(context().document.sequence("away") != nullptr);
        QCOMPARE(pictures(1).size(), 12);
        context().document.undo();
        QVERIFY(context().document.sequence("run") != nullptr);
    }

    void cardsAndTreeSelectTheSame()
    {
        auto* cards = test::find<QListView>("cards");
        auto* tree = test::find<QTreeView>("projectTree");
        QTRY_VERIFY(!cards->visibleRegion().isEmpty());
        QTest::mouseClick(cards->viewport(), Qt::LeftButton, {}, cardPlace(0));
        QTest::keyClick(cards, Qt::Key_Down, Qt::ShiftModifier);
        QStringList inTree;
        for (const QModelIndex& index : tree->selectionModel()->selectedIndexes())
            inTree += index.data().toString();
        QCOMPARE(inTree, QStringList({"walk", "run"}));
        clickTreeRow(1);
        QCOMPARE(cards->selectionModel()->selectedIndexes().size(), 1);
        QCOMPARE(cards->currentIndex().data().toString(), QString("run"));
    }

    void cardsStandInTheOrderThatIsChosen()
    {
        auto* cards = test::find<QListView>("cards");
        const auto order = [cards] {
            QStringList names;
            for (int row = 0; row < cards->model()->rowCount(); ++row)
                names += cards->model()->index(row, 0).data().toString();
            return names;
        };
        const auto choose = [](int place) {
            test::find<QToolButton>("cardOrder")->menu()->actions()[place]->trigger();
        };
        setSequenceLabels(context().document, "walk", {{"amble", {FrameIndex(0), FrameIndex(4)}}});
        setSequenceLabels(context().document, "run", {{"gallop", {FrameIndex(0), FrameIndex(4)}}});
        QCOMPARE(order(), QStringList({"walk", "run", "late"}));
        choose(1);
        QCOMPARE(order(), QStringList({"late", "run", "walk"}));
        choose(2); // the late one is not open: it has no length
        QCOMPARE(order(), QStringList({"late", "walk", "run"}));
        choose(3);
        QCOMPARE(order(), QStringList({"walk", "run", "late"}));
        choose(1); // the next window has it, too
        MainWindow other;
        QVERIFY(other.findChild<QToolButton*>("cardOrder")->menu()->actions()[1]->isChecked());
        choose(0);
        QCOMPARE(order(), QStringList({"walk", "run", "late"}));
    }

    void theMenuOfACardOpensComparesAndRemoves()
    {
        auto* cards = test::find<QListView>("cards");
        QTRY_VERIFY(!cards->visibleRegion().isEmpty());
        m_window->workspaces().select("graph");
        chooseInMenu(1, "Open");
        QCOMPARE(m_window->workspaces().current(), QString("sequences"));
        QCOMPARE(context().selection.shownSequence(), QString("run"));
        chooseInMenu(1, "Compare with", "walk");
        QTRY_COMPARE(m_window->sequences().viewport().figures().size(), 2U);
        chooseInMenu(0, "Rename");
        auto* field = cards->viewport()->findChild<QLineEdit*>();
        QVERIFY(field != nullptr);
        QTest::keyClick(field, Qt::Key_Escape);
        chooseInMenu(1, context().actions.action("edit.remove")->text());
        QCOMPARE(context().document.project().sequences.size(), 2U);
        context().document.undo();
        // Reached by key, it is about the card that has the focus.
        QTest::mouseClick(cards->viewport(), Qt::LeftButton, {}, cardPlace(2));
        QStringList texts;
        whenMenuIsOpen([&texts](QMenu& menu) {
            for (const QAction* action : menu.actions())
                texts += action->text();
        });
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(-1, -1), QPoint(-1, -1));
        QApplication::sendEvent(cards->viewport(), &event);
        QVERIFY(texts.contains("Try again")); // the one that is not there yet
    }

    void cardPicturesKeepWithinTheirMemory()
    {
        CardPictures pictures(context());
        pictures.setActive(true, 1);
        QTRY_COMPARE(pictures.pictures("walk").size(), CardPictures::count);
        const std::size_t ofOne = pictures.bytes();
        pictures.setMostBytes(ofOne + ofOne / 2);
        QTRY_COMPARE(pictures.pictures("run").size(), CardPictures::count);
        QCOMPARE(pictures.countOf("walk"), 0);
        QCOMPARE(pictures.bytes(), ofOne);
        // What is looked at again is drawn again.
        QTRY_COMPARE(pictures.pictures("walk").size(), CardPictures::count);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::CardsTest);
#include "tst_cards.moc"
