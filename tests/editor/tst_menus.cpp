// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Menus, the palette of actions, panels and their layouts.
#include "editor/commands/projectedits.h"
#include "tests/qt/registry.h"
#include "widgets/controls/actionpalette.h"
#include "windowfixture.h"

#include <QContextMenuEvent>
#include <QInputDialog>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>

namespace quadrille {

namespace {

QString plain(const QString& text)
{
    return QString(text).remove('&');
}

/// A menu and those that open from it.
void addMenus(const QMenu& menu, QList<const QMenu*>& all)
{
    all += &menu;
    for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr)
            addMenus(*action->menu(), all);
    }
}

} // namespace

class MenusTest : public test::WindowFixture
{
    Q_OBJECT

private:
    QList<const QMenu*> menus() const
    {
        QList<const QMenu*> all;
        for (const QAction* entry : m_window->menuBar()->actions())
            addMenus(*entry->menu(), all);
        return all;
    }
    static bool isInFront(const QDockWidget* dock)
    {
        return dock->isVisible() && dock->geometry().right() > 0;
    }
    QMap<QString, bool> shownPanels() const
    {
        QMap<QString, bool> shown;
        for (const auto* dock : m_window->findChildren<QDockWidget*>())
            shown[dock->objectName()] = dock->isVisible();
        return shown;
    }

private slots:
    void panelsLeaveTheMenusTheirLetters()
    {
        openTake();
        for (const char* language : {"fr", "en"}) {
            m_window->context().languages.setLanguage(QLatin1String(language));
            QSet<QKeySequence> letters;
            for (const QAction* entry : m_window->menuBar()->actions())
                letters += QKeySequence::mnemonic(entry->text());
            QVERIFY(letters.size() > 6);
            QStringList taken;
            for (const auto* button : m_window->findChildren<QAbstractButton*>()) {
                const QKeySequence letter = QKeySequence::mnemonic(button->text());
                if (!letter.isEmpty() && button->window() == m_window.get() && letters.contains(letter))
                    taken += button->objectName() + QLatin1String(": ") + button->text();
            }
            QVERIFY2(taken.isEmpty(), qPrintable(taken.join(QLatin1String("; "))));
        }
    }

    void menusHaveOneCaseAndAreShort()
    {
        openTake();
        const QSet<QString> names{"Quadrille", "Essential"};
        constexpr int longest = 17;
        for (const QMenu* menu : menus()) {
            QVERIFY2(menu->objectName() == "recentMenu" || !plain(menu->title()).isEmpty(),
                     "a menu without a title");
            int entries = 0;
            for (const QAction* entry : menu->actions()) {
                if (entry->isSeparator())
                    continue;
                entries += entry->isVisible() ? 1 : 0;
                if (menu->objectName() == "languageMenu" || menu->objectName() == "recentMenu")
                    continue; // names
                const QStringList words = plain(entry->text()).split(' ');
                QVERIFY2(words.front().front().isUpper() || !words.front().front().isLetter(),
                         qPrintable(entry->text()));
                for (const QString& word : words.mid(1))
                    QVERIFY2(!word.front().isUpper() || names.contains(word), qPrintable(entry->text()));
            }
            QVERIFY2(entries <= longest, qPrintable(menu->title()));
        }
    }

    void undoSaysWhatWhileItsMenuIsOpen()
    {
        openTake();
        renameEntry(context().document, {Section::Sequences, "walk"}, "run & jump");
        QMenu* edit = m_window->findChild<QMenu*>("editMenu");
        const QString before = action("edit.undo")->text();
        emit edit->aboutToShow();
        QVERIFY2(action("edit.undo")->text().contains("run && jump"),
                 qPrintable(action("edit.undo")->text()));
        emit edit->aboutToHide();
        QCOMPARE(action("edit.undo")->text(), before);
    }

    void everyActionOfTheMenusIsThereOnce()
    {
        QMap<const QAction*, QString> places;
        for (const QMenu* menu : menus()) {
            for (const QAction* entry : menu->actions()) {
                if (entry->isSeparator())
                    continue;
                QVERIFY2(!places.contains(entry), qPrintable(entry->text()));
                places[entry] = menu->title();
            }
        }
        for (const QAction* each : context().actions.actions())
            QVERIFY2(places.contains(each), qPrintable(each->objectName() + " is in no menu"));
    }

    void thePaletteListsNothingTwice()
    {
        openTake();
        for (const QString& workspace : test::workspaceNames) {
            m_window->workspaces().select(workspace);
            action("help.palette")->trigger();
            auto* list = test::find<QListWidget>("actionPaletteList");
            QTRY_VERIFY(list->isVisible());
            QSet<QString> seen;
            for (int row = 0; row < list->count(); ++row) {
                const QString entry =
                    list->item(row)->text() + " – " + list->item(row)->data(Qt::UserRole + 1).toString();
                QVERIFY2(!seen.contains(entry), qPrintable(workspace + ": " + entry));
                seen += entry;
            }
            test::find<QWidget>("actionPalette")->close();
        }
    }

    void aPanelComesToTheFrontAndGoes()
    {
        openTake();
        auto* history = m_window->findChild<QAction*>("panel.historyDock");
        QVERIFY(!history->isChecked());
        history->trigger();
        QTRY_VERIFY(isInFront(dock("historyDock")));
        QVERIFY(history->isChecked());
        dock("propertiesDock")->raise();
        QTRY_VERIFY(!isInFront(dock("historyDock")));
        history->trigger(); // it was shown, but nobody could see it
        QTRY_VERIFY(isInFront(dock("historyDock")));
        QVERIFY(history->isChecked());
        history->trigger();
        QTRY_VERIFY(!dock("historyDock")->isVisible());
        QVERIFY(!history->isChecked());
    }

    void theTitleOfAPanelHasAMenu()
    {
        openTake();
        QDockWidget* properties = dock("propertiesDock");
        bool wasShown = false;
        QTimer::singleShot(0, this, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            wasShown = menu != nullptr && menu->actions().size() >= 5;
            if (menu != nullptr)
                menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, {20, 8}, properties->mapToGlobal(QPoint(20, 8)));
        QApplication::sendEvent(properties, &event);
        QVERIFY(wasShown);
    }

    void layoutsAreNamedAppliedDeletedAndReset()
    {
        openTake();
        const auto first = shownPanels();
        auto* menu = test::find<QMenu>("layoutsMenu");
        const auto entry = [menu](const QString& name) -> QAction* {
            emit menu->aboutToShow();
            for (QAction* each : menu->actions()) {
                if (each->text() == name)
                    return each;
            }
            return nullptr;
        };
        dock("textureDock")->show();
        dock("projectDock")->hide();
        const auto own = shownPanels();
        action("layout.save")->trigger();
        auto* dialog = m_window->findChild<QInputDialog*>("layoutName");
        dialog->setTextValue("Textures & all");
        dialog->accept();
        action("layout.reset")->trigger();
        QCOMPARE(shownPanels(), first);
        QVERIFY(entry("Textures && all") != nullptr);
        entry("Textures && all")->trigger();
        QCOMPARE(shownPanels(), own);
        // A layout belongs to its workspace, and outlasts the window.
        m_window->workspaces().select("graph");
        QVERIFY(entry("Textures && all") == nullptr);
        m_window->workspaces().select("sequences");
        QVERIFY(entry("Textures && all") != nullptr);
        auto* removal = menu->findChild<QMenu*>("layoutRemoval");
        QCOMPARE(removal->actions().size(), 1);
        removal->actions().front()->trigger();
        QVERIFY(entry("Textures && all") == nullptr);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::MenusTest);
#include "tst_menus.moc"
