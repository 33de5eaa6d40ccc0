// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What people do with the program from beginning to end, through all its workspaces.
#include "animatedproject.h"
#include "dropping.h"
#include "editor/documents/projectpaths.h"
#include "editor/jobs/jobrunner.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/workspacetabs.h"
#include "exporting.h"
#include "model/core/file.h"
#include "tests/qt/registry.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTreeView>
#include <filesystem>
#include <memory>

namespace quadrille {

class StoriesTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    QString place(const QString& name) const { return m_folder->filePath(name); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(m_window.get(), key, modifiers);
    }
    static void press(const QString& button)
    {
        QTest::mouseClick(test::find<QAbstractButton>(button), Qt::LeftButton);
    }
    QString animation() { return context().selection.shownAnimation(); }
    bool waitForClip() { return test::waitForResult(context(), animation()); }
    void undoAll()
    {
        while (document().canUndo())
            document().undo();
    }
    void redoAll()
    {
        while (document().undoStack()->canRedo())
            document().redo();
    }

    void dropKey(const QString& take, int frame)
    {
        widgets::Timeline& timeline = m_window->animate().view().timeline();
        test::dropCard(take, timeline,
                       {timeline.xOfFrame(frame), timeline.trackRect(QStringLiteral("keys")).top() + 8});
    }
    /// Exports what is selected as a point cache.
    void exportTo(const QString& file)
    {
        // A take that was looked at meanwhile is not what the workspace is about.
        m_window->context().selection.selectSequences(
            {QString::fromStdString(m_window->context().document.project().sequences.front().name)});
        key(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(test::exportDialog() != nullptr);
        QCOMPARE(test::find<QComboBox>("exportClip")->currentData().toString(), "animations/" + animation());
        test::chooseExportFormat("pc2");
        test::typeExportPlace(file);
        test::acceptAndCloseExport();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_folder->path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1400, 1000);
        m_window->show();
        QVERIFY(test::activate(*m_window));
    }

    void cleanup()
    {
        if (m_window != nullptr)
            document().undoStack()->setClean();
        m_window.reset();
        m_folder.reset();
    }

    void twoTakesBecomeAPerformanceThatTheProgramRepeats()
    {
        m_window->open({place("first"), place("second")});
        QTRY_COMPARE(document().project().sequences.size(), 2U);
        const QString first = QString::fromStdString(document().project().sequences[0].name);
        const QString second = QString::fromStdString(document().project().sequences[1].name);
        QVERIFY(test::waitForSequence(*m_window, first));
        QVERIFY(test::waitForSequence(*m_window, second));

        // Their graph, and what moving α changes.
        key(Qt::Key_F6);
        const QString character = context().graphs.firstCharacter();
        QTRY_VERIFY(context().graphs.resultState(character) != nullptr);
        QTRY_VERIFY(context().graphs.resultState(character)->phase == ResultPhase::Idle);
        press("graphStateButton");
        QTRY_VERIFY(context().graphs.resultState(character)->phase == ResultPhase::Ready);
        auto* density = test::find<QLabel>("essentialDensity");
        QTRY_VERIFY(density->text().contains("%"));
        const QString before = density->text();
        auto* alpha = m_window->findChild<QWidget*>("graphAlpha")->findChild<QSlider*>();
        QVERIFY(alpha != nullptr);
        alpha->setFocus();
        QTest::keyClick(alpha, Qt::Key_PageUp);
        QTRY_VERIFY(density->text() != before);

        // Four poses at four times.
        key(Qt::Key_F7);
        key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(document().project().animations.size(), 1U);
        dropKey(first, 10);
        dropKey(second, 50);
        dropKey(first, 90);
        dropKey(second, 130);
        QVERIFY(waitForClip());
        auto* table = test::find<QTableView>("keysTable");
        QCOMPARE(table->model()->rowCount(), 4);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < table->model()->columnCount(); ++column)
                QVERIFY(!table->model()->index(row, column).data().toString().isEmpty());
        }

        // Into a file, which the program writes again from the saved project, elsewhere.
        exportTo(place("out/poses.pc2"));
        document().saveAs(toPath(place("poses.quadrille")));
        const FileContent written = readFile(toPath(place("out/poses.pc2")));
        namespace fs = std::filesystem;
        fs::create_directory(toPath(place("elsewhere")));
        for (const char* name : {"first", "second", "poses.quadrille"})
            fs::copy(toPath(place(name)), toPath(place(QStringLiteral("elsewhere/") + name)),
                     fs::copy_options::recursive);
        QProcess program;
        program.start(QStringLiteral(QUADRILLE_PROGRAM), {"rebuild", place("elsewhere/poses.quadrille")});
        QVERIFY(program.waitForFinished(120000));
        QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
        QVERIFY(readFile(toPath(place("elsewhere/out/poses.pc2"))).text() == written.text());

        // Back to the beginning and forth again.
        const Project after = document().project();
        undoAll();
        QVERIFY(document().project().animations.empty() && document().project().sequences.empty());
        redoAll();
        QCOMPARE(document().project(), after);
    }

    void aStoryboardOfThreeActionsIsLooped()
    {
        document().reset(test::swayingProject(m_folder->path()));
        for (const char* take : {"first", "second", "third"})
            QVERIFY(test::waitForSequence(*m_window, take));
        const Project before = document().project();
        key(Qt::Key_F7);
        key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        auto* board = test::find<QAbstractScrollArea>("storyboard");
        QTRY_VERIFY(board->isVisible());
        int cards = 0;
        for (const char* take : {"first", "second", "third"})
            test::dropCard(take, *board->viewport(), {cards++ * 128 + 6, 40});
        QVERIFY(waitForClip());
        const auto told = context().animations.result(animation());
        QCOMPARE(told->walk.solution.actions.size(), 3U);
        QVERIFY(!told->travel.has_value());

        test::find<QDockWidget>("finishDock")->raise();
        auto* loop = test::find<QCheckBox>("postLoop");
        QTRY_VERIFY(loop->isVisible());
        loop->setFocus();
        QTest::keyClick(loop, Qt::Key_Return);
        QVERIFY(document().animation(animation())->post.steps.loop.has_value());
        QVERIFY(waitForClip());
        const auto looped = context().animations.result(animation());
        QVERIFY(looped->travel.has_value());
        QVERIFY(looped->walk.solution == told->walk.solution);

        undoAll();
        QCOMPARE(document().project(), before);
    }

    void aWindowClosesWhileItComputes()
    {
        document().reset(test::swayingProject(m_folder->path()));
        key(Qt::Key_F6);
        QTRY_VERIFY(context().graphs.resultState("spire") != nullptr);
        context().graphs.ask("spire");
        QVERIFY(!context().jobs.jobs().empty());
        // Whatever shows the media is gone before they are.
        const QPointer<QTreeView> tree = test::find<QTreeView>("projectTree");
        bool wasGone = false;
        connect(&context().media, &QObject::destroyed, [&] { wasGone = tree.isNull(); });
        m_window.reset();
        QVERIFY(wasGone);
    }

    void whatIsCancelledMidwayLeavesTheProjectAsItWas()
    {
        Project project = test::swayingProject(m_folder->path());
        project.animations[0].search.budget = 100'000'000;
        project.animations[0].constraints.push_back(
            PathEntry{.points = {{0, 0, 0}, {0.3, 0, 1}, {0, 0, 2}, {0.4, 0, 3}}});
        document().reset(project);
        for (const char* take : {"first", "second", "third"})
            QVERIFY(test::waitForSequence(*m_window, take));
        const Project before = document().project();

        // The graph, before it is there.
        key(Qt::Key_F6);
        QTRY_VERIFY(context().graphs.resultState("spire")->phase == ResultPhase::Idle);
        press("graphStateButton");
        press("graphStateButton");
        QTRY_VERIFY(context().graphs.resultState("spire")->phase == ResultPhase::Idle);

        // The search, once it has found something: that stays.
        key(Qt::Key_F7);
        QTRY_VERIFY(context().animations.result("dance") != nullptr);
        QVERIFY(context().animations.resultState("dance")->phase == ResultPhase::Computing);
        key(Qt::Key_Period, Qt::ControlModifier);
        QVERIFY(context().animations.resultState("dance")->phase == ResultPhase::Idle);
        QTRY_VERIFY(context().jobs.jobs().empty());
        QVERIFY(context().animations.result("dance") != nullptr);
        QVERIFY(m_window->animate().scene().frameCount() > 0);
        QCOMPARE(document().project(), before);
        QVERIFY(!document().isModified());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::StoriesTest);
#include "tst_stories.moc"
