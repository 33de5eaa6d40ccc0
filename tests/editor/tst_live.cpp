// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Motion spaces that are steered live: by keys, sliders and a gamepad; rewound, recorded, played again.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/live/gamepad.h"
#include "editor/workspaces/live/livesession.h"
#include "editor/workspaces/live/livesteering.h"
#include "editor/workspaces/live/liveworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/model/variation/tubewalk.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTreeWidget>
#include <SDL2/SDL.h>
#include <fstream>
#include <memory>

namespace quadrille {

class LiveTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    LiveWorkspace& workspace() { return m_window->live(); }
    LiveSession& session() { return workspace().session(); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }

    void writeTake(const QString& name, const test::TubeWalk& walk)
    {
        QDir(m_folder->path()).mkdir(name);
        const std::vector<std::string> files = test::walkFiles(walk);
        for (std::size_t f = 0; f < files.size(); ++f)
            std::ofstream(m_folder->filePath(name + "/f_" + QString::number(100 + f) + ".obj").toStdString())
                << files[f];
    }
    static MotionSpaceEntry spaceOf(const std::string& name, const std::vector<std::string>& takes)
    {
        MotionSpaceEntry entry;
        entry.name = name;
        for (const std::string& take : takes)
            entry.takes.emplace_back().sequence = take;
        if (takes.size() > 1)
            entry.parameters.emplace_back().name = "speed";
        entry.tolerance = 0.02;
        return entry;
    }
    void play(int ticks)
    {
        for (int t = 0; t < ticks; ++t)
            session().step();
    }
    void open()
    {
        m_window->open({m_folder->filePath("p.quadrille")});
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        m_window->workspaces().select("live");
        QTRY_VERIFY(session().isReady());
        QTRY_VERIFY(workspace().scene().figureOf(LiveWorkspace::figureName()) >= 0);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        m_folder = std::make_unique<QTemporaryDir>();
        writeTake("slow", {});
        writeTake("fast", {.period = 16, .step = 0.05, .size = 1.6});
        const QString file = m_folder->filePath("p.quadrille");
        m_window = std::make_unique<MainWindow>();
        Project project;
        for (const char* name : {"slow", "fast"}) {
            SequenceEntry& sequence = project.sequences.emplace_back();
            sequence.name = name;
            sequence.source = m_folder->filePath(name).toStdString();
        }
        project.motionSpaces = {spaceOf("walk", {"slow", "fast"}), spaceOf("steady", {"slow"})};
        document().reset(project);
        document().saveAs(file.toStdString());
        m_window.reset();
    }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup()
    {
        if (m_window)
            document().undoStack()->setClean();
        m_window.reset();
    }

    void keysSteerWhatIsPlayed()
    {
        open();
        auto* view = &workspace().viewport();
        view->setFocus();
        const double slow = session().steering().values()[0];
        QTest::keyPress(view, Qt::Key_W);
        play(30);
        QTest::keyRelease(view, Qt::Key_W);
        QVERIFY(session().steering().values()[0] > slow);
        const double reached = session().steering().values()[0];
        play(10);
        QCOMPARE(session().steering().values()[0], reached);
        QVERIFY(session().state().track.root.shift.norm() > 0);
        // A digit wants another space, and it is entered.
        QTest::keyClick(view, Qt::Key_2);
        QCOMPARE(session().wantedSpace(), 1);
        play(120);
        QCOMPARE(session().state().track.space, std::size_t{1});
        QCOMPARE(session().decisions().size(), std::size_t{1});
        QTest::keyClick(view, Qt::Key_R);
        QVERIFY(session().isResponsive());
        // The figure is where the player has it.
        QCOMPARE(workspace().view().timeline().currentFrame(), 160);
    }

    void slidersHoldAValue()
    {
        open();
        auto* slider = test::find<QSlider>("liveParameter1");
        QVERIFY(slider->isVisible());
        QVERIFY(!test::find<QSlider>("liveParameter2")->isVisible());
        slider->setValue(slider->maximum());
        play(20);
        const SteeredParameter steered = session().steering().parameters()[0];
        QCOMPARE(session().steering().values()[0], steered.greatest);
    }

    void spacePlaysAndPauses()
    {
        open();
        action("play.toggle")->trigger();
        QVERIFY(session().isRunning());
        QTRY_VERIFY(session().tickCount() > 20);
        action("play.toggle")->trigger();
        QVERIFY(!session().isRunning());
        m_window->workspaces().select("sequences");
        m_window->workspaces().select("live");
        action("live.run")->trigger();
        QVERIFY(session().isRunning());
        m_window->workspaces().select("sequences");
        QVERIFY(!session().isRunning());
    }

    void everyTickCanBeGoneBackTo()
    {
        open();
        play(40);
        session().want(1);
        play(80);
        const auto pose = [this] {
            const auto values = session().pose();
            return std::vector<float>(values.begin(), values.end());
        };
        const std::vector<float> last = pose();
        auto* tree = test::find<QTreeWidget>("rewindTree");
        QTRY_COMPARE(tree->topLevelItemCount(), 1);
        QVERIFY(tree->topLevelItem(0)->childCount() >= 2);
        tree->setCurrentItem(tree->topLevelItem(0));
        QCOMPARE(session().state().tick, std::int64_t{41});
        QVERIFY(session().isReplaying());
        // It plays again as it was.
        play(79);
        QCOMPARE(session().tickCount(), std::int64_t{120});
        QCOMPARE(pose(), last);
        // Who steers takes over.
        session().goTo(60);
        session().want(0);
        QCOMPARE(session().tickCount(), std::int64_t{60});
        play(100);
        QCOMPARE(session().state().track.space, std::size_t{0});
    }

    void recordingsArePerformancesOfTheProject()
    {
        open();
        play(10);
        action("live.record")->trigger();
        QVERIFY(session().isRecording());
        session().pause();
        play(60);
        session().want(1);
        play(60);
        const auto shown = session().pose();
        const std::vector<float> last(shown.begin(), shown.end());
        action("live.record")->trigger();
        QVERIFY(!session().isRecording());
        QCOMPARE(document().project().lives.size(), std::size_t{1});
        const LiveEntry entry = document().project().lives.front();
        QCOMPARE(entry.from, std::int64_t{10});
        QVERIFY(entry.ticks >= 130);
        // It is selected, and plays again from its first frame.
        QCOMPARE(context().selection.current().name, QString::fromStdString(entry.name));
        QCOMPARE(session().state().tick, std::int64_t{10});
        session().goTo(130);
        const auto again = session().pose();
        QVERIFY(std::ranges::equal(again, last));
        QVERIFY(action("live.export")->isEnabled());
        action("live.addSequence")->trigger();
        QCOMPARE(document().project().sequences.back().source, "clip:live/" + entry.name);
        document().undo();
        document().undo();
        QVERIFY(document().project().lives.empty());
        document().undoStack()->redo();
        QCOMPARE(document().project().lives.front(), entry);
        document().undo();
    }

    void projectsWithoutSpacesAreExplained()
    {
        Project project;
        SequenceEntry& sequence = project.sequences.emplace_back();
        sequence.name = "slow";
        sequence.source = m_folder->filePath("slow").toStdString();
        document().reset(project);
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        m_window->workspaces().select("live");
        QVERIFY(workspace().view().message().isVisible());
        QVERIFY(!action("live.run")->isEnabled());
    }

    void gamepadsComeAndGo()
    {
        open();
        Gamepad& gamepad = workspace().gamepad();
        gamepad.poll();
        if (gamepad.isConnected())
            QSKIP("There is a gamepad at this computer.");
        const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 1);
        QVERIFY(device >= 0);
        for (int poll = 0; poll < 100 && !gamepad.isConnected(); ++poll)
            gamepad.poll();
        QVERIFY(gamepad.isConnected());
        QVERIFY(!test::find<QLabel>("liveGamepad")->text().isEmpty());
        SDL_Joystick* stick = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device));
        QVERIFY(stick != nullptr);
        SDL_JoystickSetVirtualAxis(stick, 1, -32768); // forward
        play(5);
        QCOMPARE(session().steering().values()[0], session().steering().parameters()[0].greatest);
        SDL_JoystickSetVirtualAxis(stick, 1, 2000); // it never rests quite in the middle
        play(2);
        QCOMPARE(session().steering().values()[0], session().steering().parameters()[0].least);
        SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 1);
        play(1);
        QCOMPARE(session().wantedSpace(), 1);
        session().run();
        SDL_JoystickDetachVirtual(device);
        QTRY_VERIFY(!gamepad.isConnected());
        QVERIFY(!session().isRunning());
        QVERIFY(workspace().view().message().isVisible());
    }

    static void steeringHasItsAxes()
    {
        LiveSteering steering;
        steering.setParameters({{SpaceMeasure::Speed, 1, 3}, {SpaceMeasure::Turning, -40, 60}});
        QCOMPARE(steering.axisOf(0), SteeringAxis::Vertical);
        QCOMPARE(steering.axisOf(1), SteeringAxis::Horizontal);
        QCOMPARE(steering.values(), (SpacePoint{1, 0}));
        steering.advance({.axes = {1, 1, 0}}, 0.75); // to the right, and faster
        QCOMPARE(steering.values(), (SpacePoint{2, -40}));
        steering.advance({}, 0.3);
        QCOMPARE(steering.values(), (SpacePoint{2, -20}));
        steering.advance({}, 10);
        QCOMPARE(steering.values(), (SpacePoint{2, 0}));
        steering.setValue(1, 100);
        steering.advance({}, 10);
        QCOMPARE(steering.values(), (SpacePoint{2, 60}));
        steering.advance({.axes = {-0.5, 0.25, 0}, .isAnalog = true}, 0.01);
        QCOMPARE(steering.values(), (SpacePoint{1.5, 30}));
        // What the next space has in common stays.
        steering.setParameters({{SpaceMeasure::JumpHeight, 0.1, 0.6}, {SpaceMeasure::Speed, 0, 1}});
        QCOMPARE(steering.values(), (SpacePoint{0.1, 1}));
        QCOMPARE(steering.axisOf(1), SteeringAxis::Third);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::LiveTest);
#include "tst_live.moc"
