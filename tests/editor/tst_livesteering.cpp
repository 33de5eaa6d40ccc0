// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Motion spaces that are steered live: by keys, sliders and a gamepad, and what that comes to.
#include "dropping.h"
#include "editor/workspaces/live/gamepad.h"
#include "editor/workspaces/live/livesteering.h"
#include "livefixture.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/takegraphview.h"
#include "widgets/timeline/draggedframes.h"
#include "widgets/timeline/timeline.h"

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QTimer>
#include <SDL2/SDL.h>
#include <cmath>

namespace quadrille {

class LiveSteeringTest : public LiveFixture
{
    Q_OBJECT

private slots:
    void keysSteerWhatIsPlayed()
    {
        open();
        auto* view = &workspace().viewport();
        view->setFocus();
        const double slow = session().steering().values()[0];
        QTest::keyClick(view, Qt::Key_2); // nothing is steered while it pauses
        QCOMPARE(session().wantedSpace(), 0);
        session().run();
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
        session().pause();
        QCOMPARE(workspace().view().timeline().currentFrame(), static_cast<int>(session().tickCount()));
        // What the first space was steered to is kept for when it is wanted again.
        session().want(0);
        QCOMPARE(session().steering().values()[0], reached);
    }

    void keysAreToldByWhatTheySteer()
    {
        open();
        const auto* keys = test::find<QLabel>("liveKeys");
        QVERIFY2(keys->text().contains("W S") && keys->text().contains("speed"), qPrintable(keys->text()));
        QVERIFY(!keys->text().contains("A D"));
        session().want(1);
        QVERIFY2(keys->text().contains("Nothing steers"), qPrintable(keys->text()));
    }

    void theGraphOfSpacesIsEdited()
    {
        open();
        auto* graph = test::find<widgets::TakeGraphView>("spaceGraph");
        const std::unique_ptr<QMimeData> strange = widgets::toMimeData({{.sequence = "nobody's"}});
        QDragMoveEvent over(graph->nodeRect(1).center().toPoint(), Qt::CopyAction, strange.get(),
                            Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(graph, &over);
        QVERIFY(!over.isAccepted());
        // A take that is dropped onto a space is added to it.
        test::dropCard("fast", *graph, graph->nodeRect(1).center().toPoint());
        const MotionSpaceEntry& steady = document().project().motionSpaces[1];
        QCOMPARE(steady.takes.size(), std::size_t{2});
        QCOMPARE(steady.takes.back().sequence, std::string("fast"));
        QCOMPARE(steady.parameters.size(), std::size_t{1});
        QCOMPARE(context().selection.current(), (EntryRef{Section::MotionSpaces, "steady"}));
        document().undo();
        QCOMPARE(document().project().motionSpaces[1].takes.size(), std::size_t{1});
        // Beside all it becomes another space.
        QTRY_VERIFY(session().isReady());
        const QPoint beside(graph->width() / 2, graph->height() - 2);
        QVERIFY(graph->nodeAt(beside) < 0);
        test::dropCard("fast", *graph, beside);
        QCOMPARE(document().project().motionSpaces.size(), std::size_t{3});
        QTRY_COMPARE(session().graph()->spaces.size(), std::size_t{3});
        // Who clicked there still plays and pauses by Space.
        test::find<QDockWidget>("steeringDock")->raise();
        QVERIFY(test::activate(*m_window));
        QTest::mouseClick(graph, Qt::LeftButton, {}, graph->nodeRect(0).center().toPoint());
        QTest::keyClick(graph, Qt::Key_Space);
        QVERIFY(session().isRunning());
        QTest::keyClick(graph, Qt::Key_Space);
        QVERIFY(!session().isRunning());
        // The right button offers what can be done with a space.
        QStringList offered;
        QTimer::singleShot(0, this, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu != nullptr);
            for (const QAction* each : menu->actions())
                offered += each->text().remove(QLatin1Char('&'));
            menu->close();
        });
        const QPoint node = graph->nodeRect(2).center().toPoint();
        QContextMenuEvent click(QContextMenuEvent::Mouse, node, graph->mapToGlobal(node));
        QCoreApplication::sendEvent(graph, &click);
        QVERIFY2(offered.contains("Properties") && offered.contains("Remove from the project"),
                 qPrintable(offered.join(QLatin1Char(','))));
        QCOMPARE(context().selection.current().name,
                 QString::fromStdString(document().project().motionSpaces.back().name));
        action("edit.remove")->trigger();
        QCOMPARE(document().project().motionSpaces.size(), std::size_t{2});
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

    void whatIsMeasuredIsOfAWholeCycle()
    {
        open();
        play(5);
        QVERIFY(session().measuredMotion().first > 0);
        play(300);
        // A tube that goes straight on sways as it goes.
        const auto [speed, turning] = session().measuredMotion();
        QVERIFY2(std::abs(turning) < 2, qPrintable(QString::number(turning)));
        QVERIFY(speed > 0.1);
        session().goTo(0);
        QCOMPARE(session().measuredMotion().first, 0.0);
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
        QTRY_VERIFY(gamepad.isConnected()); // it is looked for while nothing is played, too
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
        // What the next space has in common stays, and comes back after spaces without it.
        steering.setParameters({{SpaceMeasure::JumpHeight, 0.1, 0.6}, {SpaceMeasure::Speed, 0, 1}});
        QCOMPARE(steering.values(), (SpacePoint{0.1, 1}));
        QCOMPARE(steering.axisOf(1), SteeringAxis::Horizontal);
        steering.setParameters({{SpaceMeasure::JumpHeight, 0.1, 0.6}});
        steering.setParameters({{SpaceMeasure::Speed, 0, 3}});
        QCOMPARE(steering.values(), (SpacePoint{1}));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::LiveSteeringTest);
#include "tst_livesteering.moc"
