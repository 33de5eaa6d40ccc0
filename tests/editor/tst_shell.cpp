// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What stands around the workspaces: palette, preferences, sessions, recovery, recent projects.
#include "editor/application/recoveries.h"
#include "editor/application/session.h"
#include "editor/commands/projectedits.h"
#include "editor/exporting/pictureflow.h"
#include "editor/jobs/joblistmodel.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/welcome/recentprojects.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "model/project/file/projectfile.h"
#include "tests/qt/registry.h"
#include "widgets/controls/actionpalette.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/viewport/viewport.h"

#include <QComboBox>
#include <QFile>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <thread>

namespace quadrille {

class ShellTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    QString project() const { return m_folder->filePath("take.quadrille"); }
    void openSaved()
    {
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        context().document.saveAs(project().toStdString());
    }
    void newWindow()
    {
        m_window.reset();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(test::activate(*m_window));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(m_folder->path(), {1, 2, 3, 4, 5, 6});
        newWindow();
    }
    void cleanup()
    {
        if (m_window)
            context().document.saveAs(project().toStdString());
        m_window.reset();
        m_folder.reset();
    }

    void everyActionIsNamedAndNoShortcutIsTakenTwice()
    {
        QMap<QString, QString> owners;
        for (const QAction* action : context().actions.actions()) {
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->objectName()));
            for (const QKeySequence& keys : action->shortcuts()) {
                const QString text = keys.toString();
                QVERIFY2(!owners.contains(text),
                         qPrintable(text + ": " + owners[text] + ", " + action->objectName()));
                owners[text] = action->objectName();
            }
        }
    }

    void theHelpNamesEveryShortcut()
    {
        QFile page(":/help/en/keyboard.md");
        QVERIFY(page.open(QIODevice::ReadOnly));
        QString text = QString::fromUtf8(page.readAll());
        for (const auto& [sign, key] : {std::pair{"←", "Left"}, {"→", "Right"}})
            text.replace(sign, key);
        QStringList missing;
        for (const QAction* action : context().actions.actions()) {
            for (const QKeySequence& keys : action->shortcuts()) {
                const QRegularExpression word("(^|[ |,])" + QRegularExpression::escape(keys.toString()) +
                                              "($|[ |,])");
                if (!text.contains(word))
                    missing += keys.toString() + ": " + action->objectName();
            }
        }
        QCOMPARE(missing.join('\n'), QString());
    }

    void thePaletteFindsAndRunsActions()
    {
        QVERIFY(widgets::ActionPalette::score("tr st", "Trim start to here") > 0);
        QCOMPARE(widgets::ActionPalette::score("xyz", "Trim start to here"), 0);
        QVERIFY(widgets::ActionPalette::score("frame", "Frame all") >
                widgets::ActionPalette::score("frame", "Wireframe"));
        openSaved();
        m_window->sequences().player().pause();
        m_window->sequences().player().goTo(2);
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        auto* field = test::find<QLineEdit>("actionPaletteField");
        QTRY_VERIFY(field->isVisible());
        QTest::keyClicks(field, "trim start");
        QCOMPARE(test::find<QListWidget>("actionPaletteList")->count(), 1);
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!field->isVisible());
        QVERIFY(context().document.sequence("walk")->range == (FrameRange{FrameIndex(2), FrameIndex(5)}));
    }

    void theButtonBesideAJobCancelsThatOne()
    {
        const auto untilCancelled = [](const Progress& progress) {
            while (true) {
                progress.report(0.5);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        };
        JobRunner& jobs = context().jobs;
        QTRY_VERIFY(jobs.jobs().empty());
        const QPointer<Job> hidden =
            jobs.start({.name = "Hidden", .background = true}, untilCancelled, [] {});
        const QPointer<Job> first = jobs.start({.name = "First"}, untilCancelled, [] {});
        const QPointer<Job> second = jobs.start({.name = "Second"}, untilCancelled, [] {});
        auto* cancel = test::find<QToolButton>("cancelJob");
        QTRY_VERIFY(cancel->isVisible());
        QCOMPARE(cancel->toolTip(), QString("Cancel “First”"));
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_VERIFY(first.isNull());
        QVERIFY(!second.isNull() && second->state() != Job::State::Cancelling);
        QVERIFY(!hidden.isNull() && hidden->state() != Job::State::Cancelling);
        jobs.cancelAll();
        QTRY_VERIFY(jobs.jobs().empty());
    }

    void runningJobsAreListedAndCancelledOneByOne()
    {
        const auto untilCancelled = [](const Progress& progress) {
            while (true) {
                progress.report(0.5);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        };
        JobRunner& jobs = context().jobs;
        QTRY_VERIFY(jobs.jobs().empty());
        // Words have their room at once, not with the next layout.
        auto* shown = test::find<QToolButton>("jobName");
        int whole = 0;
        connect(m_window->findChild<JobListModel*>(), &QAbstractItemModel::rowsInserted, shown,
                [&] { whole += shown->width() >= shown->sizeHint().width() ? 1 : 0; });
        const QPointer<Job> first = jobs.start({.name = "First"}, untilCancelled, [] {});
        const QPointer<Job> second = jobs.start({.name = "Second"}, untilCancelled, [] {});
        QTRY_VERIFY(shown->text().contains("more"));
        QCOMPARE(whole, 2);
        QVERIFY(shown->isVisible());
        QVERIFY(shown->text().startsWith("First"));
        QTest::mouseClick(shown, Qt::LeftButton);
        auto* popup = test::find<QFrame>("jobsPopup");
        QTRY_VERIFY(popup->isVisible());
        QVERIFY(m_window->screen()->geometry().contains(popup->geometry()));
        const auto cancels = popup->findChildren<QToolButton*>("jobRowCancel");
        QCOMPARE(cancels.size(), 2);
        QTest::mouseClick(cancels[1], Qt::LeftButton);
        QTRY_VERIFY(second.isNull());
        QVERIFY(!first.isNull());
        QVERIFY(popup->isVisible());
        QTest::keyClick(cancels[0], Qt::Key_Space);
        QTRY_VERIFY(first.isNull());
        QTRY_VERIFY(!popup->isVisible());
        QVERIFY(!shown->isVisible());
    }

    void thePictureIsSaved()
    {
        openSaved();
        const QString file = m_folder->filePath("view.png");
        const auto& viewport = m_window->sequences().viewport();
        const QSize size = viewport.size() * viewport.devicePixelRatioF();
        m_window->pictures().save(file);
        auto* message = test::find<QLabel>("message");
        QTRY_COMPARE(message->text(), QString("Saved to %1").arg(file));
        const QImage picture(file);
        QCOMPARE(picture.size(), size);
        QVERIFY(picture.pixelColor(picture.rect().center()) != picture.pixelColor(0, 0));
        // What was told passes; what went wrong stays.
        auto* passes = m_window->findChild<QTimer*>("messagePasses");
        QVERIFY(passes->isActive());
        passes->start(0);
        QTRY_VERIFY(message->text().isEmpty());

        m_window->pictures().save(m_folder->filePath("walk_1.obj/view.png"));
        QTRY_COMPARE(context().issues.count(IssueLog::Severity::Error), 1);
        QVERIFY(!message->text().isEmpty() && !passes->isActive());
    }

    void preferencesApplyAtOnce()
    {
        QTest::keyClick(m_window.get(), Qt::Key_Comma, Qt::ControlModifier);
        auto* theme = test::find<QComboBox>("preferencesTheme");
        theme->setFocus();
        QTest::keyClick(theme, Qt::Key_End);
        QVERIFY(widgets::Theme::instance().isDark());
        QTest::keyClick(theme, Qt::Key_Up);
        QVERIFY(!widgets::Theme::instance().isDark());
        auto* mouse = test::find<QComboBox>("preferencesMouse");
        mouse->setFocus();
        QTest::keyClick(mouse, Qt::Key_Down);
        QVERIFY(Settings().mousePreset() == widgets::MousePreset::Blender);
        QVERIFY(m_window->sequences().viewport().mousePreset() == widgets::MousePreset::Blender);
        QTest::keyClick(mouse, Qt::Key_Up);
        QVERIFY(m_window->sequences().viewport().mousePreset() == widgets::MousePreset::Quadrille);
    }

    void shortcutsCanBeChangedButNotTakenTwice()
    {
        QTest::keyClick(m_window.get(), Qt::Key_Comma, Qt::ControlModifier);
        QDialog* dialog = m_window->findChild<QDialog*>("preferencesDialog");
        dialog->findChild<QTabWidget*>()->setCurrentIndex(1);
        auto* list = test::find<QTreeWidget>("shortcutList");
        QTest::keyClicks(test::find<QLineEdit>("shortcutSearch"), "clear foot");
        QTreeWidgetItem* found = nullptr;
        for (QTreeWidgetItemIterator it(list, QTreeWidgetItemIterator::NotHidden); *it != nullptr; ++it) {
            if (!(*it)->data(0, Qt::UserRole).isNull())
                found = *it;
        }
        QVERIFY(found != nullptr);
        list->setCurrentItem(found);
        auto* keys = test::find<QKeySequenceEdit>("shortcutKeys");
        QAction* action = context().actions.action("edit.clearContacts");
        keys->setFocus();
        QTest::keyClick(keys, Qt::Key_S, Qt::ControlModifier);
        auto* strip = dialog->findChild<widgets::MessageStrip*>();
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(strip->text().contains("Save"));
        QVERIFY(action->shortcut().isEmpty());
        keys->setFocus();
        QTest::keyClick(keys, Qt::Key_F13);
        QTRY_COMPARE(action->shortcut(), QKeySequence(Qt::Key_F13));
        QTest::mouseClick(test::find<QPushButton>("shortcutReset"), Qt::LeftButton);
        QVERIFY(action->shortcut().isEmpty());
    }

    void aProjectIsSeenAgainAsItWasLeft()
    {
        openSaved();
        SequencesWorkspace& before = m_window->sequences();
        QTRY_COMPARE(before.scene().frame(), before.player().frame());
        before.player().pause();
        before.player().goTo(3);
        auto camera = before.viewport().camera();
        camera.yaw += 40;
        before.viewport().setCamera(camera);
        context().actions.action("view.clay")->setChecked(true);
        m_window->close();
        QVERIFY(QFile::exists(thumbnailFile(project())));

        newWindow();
        m_window->open({project()});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        SequencesWorkspace& after = m_window->sequences();
        QTRY_COMPARE(after.viewport().camera().yaw, camera.yaw);
        QVERIFY(after.viewport().shading() == widgets::Shading::Clay);
    }

    void editsThatACrashLeftAreOfferedAgain()
    {
        openSaved();
        duplicateSequence(context().document, "walk");
        // What a crash leaves: a copy that no program holds.
        const Project edited = context().document.project();
        context().document.save();
        const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                          "/recovery");
        QDir().mkpath(folder.path());
        saveProject(edited, folder.filePath("left.quadrille").toStdString());
        QFile info(folder.filePath("left.json"));
        QVERIFY(info.open(QIODevice::WriteOnly));
        info.write("{\"project\": \"" + project().toUtf8() + "\"}");
        info.close();

        newWindow();
        m_window->offerRecovery();
        QTRY_VERIFY(test::find<QPushButton>("recoveryAccept")->isVisible());
        QTest::mouseClick(test::find<QPushButton>("recoveryAccept"), Qt::LeftButton);
        QTRY_COMPARE(context().document.project().sequences.size(), 2U);
        QVERIFY(context().document.isModified());
        QCOMPARE(QString::fromStdString(context().document.file().string()), project());
        QTRY_VERIFY(!QFile::exists(folder.filePath("left.json"))); // taken over by a copy of this program
        context().document.save();
        QTRY_VERIFY(findRecoveries().works.empty());
    }

    void recentProjectsAreInMenuAndWelcome()
    {
        context().settings.addRecentProject("/nowhere/old.quadrille");
        auto* menu = test::find<QMenu>("recentMenu");
        QCOMPARE(menu->actions().front()->text(), QString("old"));
        QVERIFY(!menu->actions().front()->isEnabled());
        auto* list = test::find<QListWidget>("recentProjects");
        QVERIFY(list->isVisible());
        list->setCurrentRow(0);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Delete);
        QVERIFY(!context().settings.recentProjects().contains("/nowhere/old.quadrille"));
    }

    void aProjectThatIsGoneSaysSoAndCanBeTakenOut()
    {
        context().settings.addRecentProject("/nowhere/gone.quadrille");
        auto* list = test::find<QListWidget>("recentProjects");
        const QModelIndex first = list->model()->index(0, 0);
        QVERIFY(first.data(RecentProjects::MissingRole).toBool());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(first).center());
        auto* strip = test::find<QWidget>("welcomePage")->findChild<widgets::MessageStrip*>();
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(strip->text().contains("/nowhere/gone.quadrille"));
        QCOMPARE(context().issues.count(IssueLog::Severity::Error), 0);
        QTest::mouseClick(strip->findChild<QPushButton*>("messageStripAction"), Qt::LeftButton);
        QVERIFY(!context().settings.recentProjects().contains("/nowhere/gone.quadrille"));
        QVERIFY(!strip->isVisible());
    }

    void docksWaitUntilThereIsAProject()
    {
        const auto shown = [this] {
            QStringList names;
            for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
                if (dock->isVisible())
                    names += dock->objectName();
            }
            return names;
        };
        QCOMPARE(shown(), QStringList());
        openSaved();
        QTRY_VERIFY(shown().contains("cardsDock"));
        QVERIFY(shown().contains("propertiesDock"));
        test::find<QDockWidget>("propertiesDock")->hide();
        m_window->workspaces().select("graph");
        const QStringList inGraph = shown();
        context().actions.action("file.new")->trigger();
        QCOMPARE(shown(), QStringList());
        m_window->workspaces().select("sequences");
        QCOMPARE(shown(), QStringList());
        // They come back as they were, also where the window was closed without a project.
        m_window->close();
        newWindow();
        QCOMPARE(shown(), QStringList());
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QTRY_VERIFY(shown().contains("cardsDock"));
        QVERIFY(!shown().contains("propertiesDock"));
        m_window->workspaces().select("graph");
        QCOMPARE(shown(), inGraph);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ShellTest);
#include "tst_shell.moc"
