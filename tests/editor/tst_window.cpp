// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the window gives to all workspaces: keys, focus, colours of labels, a start that can fail, room on
// small screens.
#include "cutwords.h"
#include "editor/application/defaultsettings.h"
#include "editor/application/startguard.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "tests/qt/languages.h"
#include "tests/qt/registry.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"
#include "windowfixture.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>
#include <thread>

namespace quadrille {

class WindowTest : public test::WindowFixture
{
    Q_OBJECT

private slots:
    void theViewHasTheFocusOnceAProjectIsOpen()
    {
        test::find<QWidget>("welcome.file.open")->setFocus();
        openTake();
        QTRY_COMPARE(QApplication::focusWidget(), m_window->sequences().viewport().focusWidget());
        m_window->workspaces().select("animate");
        QVERIFY(m_window->workspaces().currentWorkspace()->isAncestorOf(QApplication::focusWidget()));
    }

    void playingKeysPlayWhereverNoTextIsEdited()
    {
        openTake();
        auto* button = test::find<QToolButton>("tool.view.grid");
        const bool hadGrid = button->isChecked();
        for (QWidget* holder : std::initializer_list<QWidget*>{button, test::find<QTreeView>("projectTree"),
                                                               &m_window->sequences().viewport()}) {
            holder->setFocus();
            QTRY_VERIFY(holder->hasFocus() || holder->isAncestorOf(QApplication::focusWidget()));
            QWidget* focus = QApplication::focusWidget();
            QTest::keyClick(focus, Qt::Key_Space);
            QVERIFY2(player().isPlaying(), qPrintable(holder->objectName()));
            QTest::keyClick(focus, Qt::Key_Space);
            QVERIFY2(!player().isPlaying(), qPrintable(holder->objectName()));
            QTest::keyClick(focus, Qt::Key_Home);
            QCOMPARE(player().frame(), FrameIndex(0));
            QTest::keyClick(focus, Qt::Key_Right);
            QCOMPARE(player().frame(), FrameIndex(1));
            QTest::keyClick(focus, Qt::Key_L);
            QVERIFY2(player().isPlaying(), qPrintable(holder->objectName()));
            QTest::keyClick(focus, Qt::Key_K);
            QVERIFY2(!player().isPlaying(), qPrintable(holder->objectName()));
            QTest::keyClick(focus, Qt::Key_End);
            QCOMPARE(player().frame(), FrameIndex(5));
            QTest::keyClick(focus, Qt::Key_7);
            QTRY_VERIFY2(m_window->sequences().viewport().camera().pitch > 80,
                         qPrintable(holder->objectName()));
            QTest::keyClick(focus, Qt::Key_1);
            QTRY_VERIFY2(m_window->sequences().viewport().camera().pitch < 10,
                         qPrintable(holder->objectName()));
        }
        QCOMPARE(button->isChecked(), hadGrid);
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Return);
        QCOMPARE(button->isChecked(), !hadGrid);
    }

    void boxesAndChoicesAreUsedByReturn()
    {
        openTake();
        m_window->workspaces().select("animate");
        action("animate.new")->trigger();
        dock("finishDock")->show();
        dock("finishDock")->raise();
        auto* loop = test::find<QCheckBox>("postLoop");
        QTRY_VERIFY(loop->isVisible());
        loop->setFocus();
        QTest::keyClick(loop, Qt::Key_Space);
        QVERIFY(!loop->isChecked());
        QTest::keyClick(loop, Qt::Key_Return);
        QVERIFY(loop->isChecked());
        auto* names = test::find<QComboBox>("animationNames");
        names->setFocus();
        QTest::keyClick(names, Qt::Key_Return);
        QTRY_VERIFY(names->view()->isVisible());
        names->hidePopup();
        action("animate.new")->trigger();
        names->setFocus();
        QTest::keyClick(names, Qt::Key_Home);
        QCOMPARE(names->currentIndex(), 0);
        QTest::keyClick(names, Qt::Key_End);
        QCOMPARE(names->currentIndex(), 1);
    }

    void aTextKeepsItsKeys()
    {
        openTake();
        dock("cardsDock")->raise();
        auto* search = test::find<QLineEdit>("cardSearch");
        QTRY_VERIFY(search->isVisible());
        search->setFocus();
        QTest::keyClicks(search, "a jl 7");
        QCOMPARE(search->text(), QString("a jl 7"));
        QVERIFY(!player().isPlaying());
        QTest::keyClick(search, Qt::Key_Home);
        QCOMPARE(search->cursorPosition(), 0);
    }

    void usualKeysAreThereOnEveryDesktop()
    {
        const QList<std::pair<const char*, const char*>> expected{
            {"file.new", "Ctrl+N"},
            {"file.open", "Ctrl+O"},
            {"file.close", "Ctrl+W"},
            {"file.save", "Ctrl+S"},
            {"file.saveAs", "Ctrl+Shift+S"},
            {"file.quit", "Ctrl+Q"},
            {"edit.undo", "Ctrl+Z"},
            {"edit.redo", "Ctrl+Y"},
            {"edit.redo", "Ctrl+Shift+Z"},
            {"edit.preferences", "Ctrl+,"},
            {"help.here", "F1"},
            {"view.fullScreen", "F11"},
            {"view.zoomIn", "Ctrl++"},
            {"view.zoomOut", "Ctrl+-"},
        };
        for (const auto& [id, keys] : expected)
            QVERIFY2(action(id)->shortcuts().contains(QKeySequence(QString::fromLatin1(keys))), id);
    }

    void everyKeyOfTheManualDoesSomething()
    {
        QFile page(":/help/en/keyboard.md");
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(page.readAll());
        QSet<QString> known;
        for (const QAction* each : context().actions.actions()) {
            for (const QKeySequence& keys : each->shortcuts())
                known += keys.toString();
        }
        static const QRegularExpression row("^\\| ([^|]+) \\| ", QRegularExpression::MultilineOption);
        QStringList missing;
        for (const char* section : {"## Everywhere", "## Playing"}) {
            const QString part = text.section(section, 1).section("\n## ", 0, 0);
            for (const auto& match : row.globalMatch(part)) {
                if (match.captured(1) == "Key" || match.captured(1).startsWith('-'))
                    continue;
                for (const QString& keys : match.captured(1).split(", ")) {
                    if (keys.front().isLower())
                        continue; // where they count
                    if (!known.contains(QKeySequence(keys).toString()))
                        missing += keys;
                }
            }
        }
        QCOMPARE(missing.join(" "), QString());
    }

    void zoomingComesCloser()
    {
        openTake();
        widgets::Viewport& view = m_window->sequences().viewport();
        const float distance = view.camera().distance;
        action("view.zoomIn")->trigger();
        QVERIFY(view.camera().distance < distance);
        action("view.zoomOut")->trigger();
        QCOMPARE(view.camera().distance, distance);
    }

    void everyWorkspaceFitsASmallScreen_data() { test::addLanguages(); }
    void everyWorkspaceFitsASmallScreen()
    {
        QFETCH(QString, language);
        constexpr int width = 1280;
        constexpr int height = 720 - 32; // the title bar
        context().languages.setLanguage(language);
        openTake();
        for (const QString& workspace : test::workspaceNames) {
            m_window->workspaces().select(workspace);
            // With every panel that this workspace has.
            for (auto* each : m_window->findChildren<QDockWidget*>()) {
                if (each->toggleViewAction()->isVisible())
                    each->show();
            }
            m_window->resize(width, height);
            QCoreApplication::processEvents();
            m_window->resize(width, height);
            QTRY_VERIFY2(
                m_window->width() <= width && m_window->height() <= height,
                qPrintable(
                    QString("%1: %2 × %3").arg(workspace).arg(m_window->width()).arg(m_window->height())));
        }
        context().languages.setLanguage("en");
    }

    void noWordIsCutOnASmallScreen_data() { test::addLanguages(); }
    void noWordIsCutOnASmallScreen()
    {
        QFETCH(QString, language);
        context().languages.setLanguage(language);
        m_window->resize(1280, 720 - 32); // the title bar
        openTake();
        QStringList cut;
        for (const QString& workspace : test::workspaceNames) {
            m_window->workspaces().select(workspace);
            QCoreApplication::processEvents();
            for (auto* each : m_window->findChildren<QDockWidget*>()) {
                if (each->isHidden())
                    continue;
                each->raise();
                // What a job has just said is laid out a moment later.
                const auto wordsFit = [this] { return test::wordsCutIn(*m_window).isEmpty(); };
                if (QTest::qWaitFor(wordsFit, 1000))
                    continue;
                for (const QString& words : test::wordsCutIn(*m_window))
                    cut += workspace + ": " + words;
            }
        }
        cut.removeDuplicates();
        QCOMPARE(cut.join('\n'), QString());
        context().languages.setLanguage("en");
    }

    void aStoryboardWithCardsShowsInALowWindow()
    {
        m_window->resize(1280, 720 - 32); // the title bar
        openTake();
        m_window->workspaces().select("animate");
        QTRY_VERIFY(dock("storyboardDock")->isHidden());
        addAnimation(context().document, {.name = "nothing yet"});
        AnimationEntry steps{.name = "steps"};
        steps.constraints = {ActionEntry{.frames = {.label = {}, .sequence = "walk", .range = {}}}};
        addAnimation(context().document, steps);
        context().selection.selectAnimations({"nothing yet"});
        QTest::qWait(20);
        QVERIFY2(dock("storyboardDock")->isHidden(), "there is nothing on it");
        context().selection.selectAnimations({"steps"});
        QTRY_VERIFY(dock("storyboardDock")->isVisible());
        // Who closes it wants the room.
        dock("storyboardDock")->hide();
        context().selection.selectAnimations({"nothing yet"});
        context().selection.selectAnimations({"steps"});
        QTest::qWait(20);
        QVERIFY(dock("storyboardDock")->isHidden());
    }

    void nothingMovesWhenJobsAndTipsCome()
    {
        openTake();
        const QWidget& view = m_window->sequences().viewport();
        QTRY_VERIFY(context().jobs.jobs().empty());
        const QSize size = view.size();
        const QPointer<Job> job = context().jobs.start(
            {.name = "A job with a name that is rather long"},
            [](const Progress& progress) {
                while (true) {
                    progress.report(0.5);
                    std::this_thread::sleep_for(std::chrono::milliseconds(5));
                }
            },
            [] {});
        QTRY_VERIFY(test::find<QToolButton>("jobName")->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(view.size(), size);
        action("view.ghosts")->hover();
        QCoreApplication::processEvents();
        QCOMPARE(view.size(), size);
        m_window->statusBar()->showMessage("A message");
        QCoreApplication::processEvents();
        QCOMPARE(view.size(), size);
        context().jobs.cancelAll();
        QTRY_VERIFY(job.isNull());
        QCOMPARE(view.size(), size);
    }

    void coloursOfLabelsStayWhenOthersAreAdded()
    {
        openTake();
        const auto& timeline = m_window->sequences().view().timeline();
        const auto colors = [&timeline] {
            QMap<QString, QColor> shown;
            for (const widgets::TimelineTrack& track : timeline.tracks()) {
                for (const widgets::TimelineSpan& span : track.spans)
                    shown[track.kind == widgets::TimelineTrack::Kind::Contacts ? track.id : span.text] =
                        span.color;
            }
            return shown;
        };
        const auto label = [](const char* name) { return LabelSpan{name, {FrameIndex(0), FrameIndex(2)}}; };
        setSequenceLabels(context().document, "walk", {label("walk"), label("run")});
        setSequenceContacts(
            context().document, "walk",
            {{"left", {FrameIndex(0), FrameIndex(1)}}, {"right", {FrameIndex(2), FrameIndex(3)}}});
        const auto before = colors();
        QCOMPARE(before.size(), 4);
        setSequenceLabels(context().document, "walk",
                          {label("crawl"), label("jump"), label("walk"), label("run"), label("a")});
        const auto after = colors();
        QCOMPARE(after.size(), 7);
        for (auto it = before.begin(); it != before.end(); ++it)
            QCOMPARE(after[it.key()], it.value());
        QSet<QRgb> different;
        for (const QColor& color : after)
            different += color.rgb();
        QCOMPARE(different.size(), after.size());
    }

    void defaultSettingsAreTakenAndTheOthersKept()
    {
        context().settings.setTheme(widgets::Theme::Mode::Dark);
        context().settings.addRecentProject("/somewhere/old.quadrille");
        for (const auto& [button, isTaken] : {std::pair{"startAsBefore", false}, {"startDefaults", true}}) {
            QTimer::singleShot(0, this, [name = QString(button)] { test::find<QPushButton>(name)->click(); });
            QCOMPARE(askForDefaultSettings(3), isTaken);
        }
        const QString aside = takeDefaultSettings();
        QFile kept(aside);
        QVERIFY(kept.open(QIODevice::ReadOnly));
        QVERIFY(kept.readAll().contains("theme=dark"));
        QVERIFY(Settings().theme() == widgets::Theme::Mode::System);
        QCOMPARE(Settings().recentProjects(), QStringList{"/somewhere/old.quadrille"});
        QFile::remove(aside);
    }

    void failedStartsAreCountedUntilOneSucceeds()
    {
        const QTemporaryDir folder;
        const auto markers = [&folder] { return QDir(folder.path()).entryList({"starting-*"}, QDir::Files); };
        // Left by programs that do not run any more, the last one by one that was killed as it removed a
        // lock.
        for (const char* name : {"starting-a", "starting-b", "starting-b.lock.rmlock"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        {
            StartGuard guard(folder.path());
            QCOMPARE(guard.failedStarts(), 2);
            // Another one that is just starting did not fail.
            const StartGuard second(folder.path());
            QCOMPARE(second.failedStarts(), 2);
            guard.watch(*m_window);
            QTRY_VERIFY(!markers().contains("starting-a"));
            QCOMPARE(guard.failedStarts(), 0);
        }
        QVERIFY(!markers().contains("starting-b"));
        QCOMPARE(StartGuard(folder.path()).failedStarts(), 0);
    }

    void toolsThatDoNotFitAreInAMenu()
    {
        openTake();
        auto* tools = test::find<QToolBar>("viewTools");
        m_window->resize(m_window->minimumSizeHint().width(), 800);
        dock("projectDock")->show();
        dock("propertiesDock")->show();
        tools->setFixedWidth(200);
        auto* more = tools->findChild<QToolButton*>("qt_toolbar_ext_button");
        QTRY_VERIFY(more->isVisible());
        QVERIFY(tools->rect().contains(more->geometry()));
        QVERIFY(!more->icon().isNull());
        // The button waits until its menu is closed.
        bool isOpen = false;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&isOpen, tools] {
            QWidget* popup = QApplication::activePopupWidget();
            isOpen = isOpen || tools->height() > 60 || (popup != nullptr && !popup->actions().isEmpty());
            if (popup != nullptr)
                popup->close();
        });
        look.start(50);
        QTest::mouseClick(more, Qt::LeftButton);
        QTRY_VERIFY(isOpen);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::WindowTest);
#include "tst_window.moc"
