// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Camera keys of an animation: added from the view, moved, replaced, removed, and looked through.
#include "animatedproject.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/animationcamera.h"
#include "tests/qt/registry.h"
#include "widgets/timeline/momentlane.h"

#include <QAction>

namespace quadrille {

class CameraKeysTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    widgets::MomentLane& lane() { return m_window->animate().camera().lane(); }
    widgets::Viewport& viewport() { return m_window->animate().viewport(); }
    widgets::Timeline& timeline() { return m_window->animate().view().timeline(); }
    const std::vector<CameraKeyEntry>& keys() { return context().document.animation("dance")->camera; }
    void trigger(const char* id) { context().actions.action(QLatin1String(id))->trigger(); }
    void lookFrom(float yaw, float distance)
    {
        widgets::Turntable camera = viewport().camera();
        camera.target = {0.5F, 1, 0.25F};
        camera.yaw = yaw;
        camera.pitch = 10;
        camera.distance = distance;
        viewport().setCamera(camera);
    }
    void goTo(int frame)
    {
        m_window->animate().player().goTo(frame);
        timeline().setCurrentFrame(frame);
    }
    void addTwo()
    {
        goTo(0);
        lookFrom(30, 4);
        trigger("animate.camera.add");
        goTo(20);
        lookFrom(90, 8);
        trigger("animate.camera.add");
        QCOMPARE(keys().size(), 2U);
    }

    std::unique_ptr<QTemporaryDir> m_takes;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        m_takes = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_takes->path());
    }
    void init()
    {
        m_window = test::openAnimated(m_takes->path());
        QVERIFY(m_window);
        QVERIFY(test::waitForResult(context(), "dance"));
        QTRY_VERIFY(m_window->animate().scene().frameCount() > 20);
    }
    void cleanup()
    {
        context().document.undoStack()->setClean();
        m_window.reset();
    }

    void aKeyKeepsWhatIsSeen()
    {
        QVERIFY(!context().actions.action("animate.camera.look")->isEnabled());
        QVERIFY(test::activate(*m_window));
        goTo(10);
        lookFrom(30, 4);
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::AltModifier);
        QCOMPARE(keys().size(), 1U);
        const CameraKey& key = keys()[0].key;
        QCOMPARE(key.time, 10 / context().document.project().settings.fps);
        QCOMPARE(key.azimuth, 30.0);
        QCOMPARE(key.elevation, 10.0);
        QCOMPARE(key.distance, 4.0);
        // The film sees it from where the view does.
        const QVector3D seen = viewport().camera().position();
        const Camera filmed = toCamera(key, context().media.upAxis());
        QVERIFY((filmed.eye - Vec3d(seen.x(), seen.y(), seen.z())).norm() < 1e-3);
        QVERIFY(context().actions.action("animate.camera.look")->isEnabled());
        // At the same frame it takes the key's place.
        lookFrom(60, 4);
        trigger("animate.camera.add");
        QCOMPARE(keys().size(), 1U);
        QCOMPARE(keys()[0].key.azimuth, 60.0);
        context().document.undo();
        QCOMPARE(keys()[0].key.azimuth, 30.0);
        context().document.undo();
        QVERIFY(keys().empty());
    }

    void keysAreDraggedInOneStepAndKeepTheirOrder()
    {
        addTwo();
        const double fps = context().document.project().settings.fps;
        const int steps = context().document.undoStack()->count();
        const QPoint from = lane().centreOf(0).toPoint();
        const QPoint to(static_cast<int>(lane().xOf(8.5 / fps)), from.y());
        QTest::mousePress(&lane(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&lane(), (from + to) / 2);
        QTest::mouseMove(&lane(), to);
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, to);
        QCOMPARE(keys()[0].key.time, 8 / fps);
        QCOMPARE(context().document.undoStack()->count(), steps + 1);
        QTest::mousePress(&lane(), Qt::LeftButton, {}, lane().centreOf(0).toPoint());
        const QPoint far(static_cast<int>(lane().xOf(40 / fps)), from.y());
        QTest::mouseMove(&lane(), far);
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, far);
        QCOMPARE(keys()[0].key.time, 19 / fps); // a frame before the next
        context().document.undo();
        context().document.undo();
        QCOMPARE(keys()[0].key.time, 0.0);
    }

    void everythingIsDoneByKeyboard()
    {
        addTwo();
        const double fps = context().document.project().settings.fps;
        lane().setFocus();
        QTest::keyClick(&lane(), Qt::Key_Left);
        QTest::keyClick(&lane(), Qt::Key_Left);
        QCOMPARE(lane().selected(), 0);
        QTest::keyClick(&lane(), Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(keys()[0].key.time, 1 / fps);
        QTest::keyClick(&lane(), Qt::Key_Return);
        QCOMPARE(timeline().currentFrame(), 1);
        QCOMPARE(viewport().camera().yaw, 30.0F);
        lookFrom(45, 5);
        trigger("animate.camera.replace");
        QCOMPARE(keys()[0].key.azimuth, 45.0);
        QCOMPARE(keys()[0].key.time, 1 / fps);
        QTest::keyClick(&lane(), Qt::Key_Delete);
        QCOMPARE(keys().size(), 1U);
        QCOMPARE(keys()[0].key.azimuth, 90.0);
        QVERIFY(!context().actions.action("animate.camera.remove")->isEnabled());
        for (int i = 0; i < 3; ++i)
            context().document.undo();
        QCOMPARE(keys().size(), 2U);
        QCOMPARE(keys()[0].key.time, 0.0);
    }

    void aDoubleClickAddsAKeyWhereItIs()
    {
        lookFrom(10, 3);
        const double fps = context().document.project().settings.fps;
        const QPoint place(static_cast<int>(lane().xOf(12.5 / fps)), lane().height() / 2);
        QTest::mouseDClick(&lane(), Qt::LeftButton, {}, place);
        QCOMPARE(keys().size(), 1U);
        QCOMPARE(keys()[0].key.time, 12 / fps);
    }

    void lookingThroughTheCameraFollowsTheKeys()
    {
        addTwo();
        trigger("animate.camera.look");
        goTo(0);
        QTRY_COMPARE(viewport().camera().yaw, 30.0F);
        goTo(20);
        QTRY_COMPARE(viewport().camera().yaw, 90.0F);
        goTo(10);
        QTRY_VERIFY(viewport().camera().yaw > 35 && viewport().camera().yaw < 85);
        QVERIFY(viewport().camera().distance > 4.1F && viewport().camera().distance < 7.9F);
        // Playback takes it along.
        goTo(0);
        m_window->animate().player().play();
        QTRY_VERIFY(viewport().camera().yaw > 40);
        m_window->animate().player().pause();
        trigger("animate.camera.look");
        lookFrom(5, 4);
        goTo(15);
        QCOMPARE(viewport().camera().yaw, 5.0F);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::CameraKeysTest);
#include "tst_camerakeys.moc"
