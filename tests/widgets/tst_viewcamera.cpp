// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How the mouse, the axes and framing move the camera of a view.
#include "tests/qt/viewapplication.h"
#include "viewportfixture.h"
#include "widgets/viewport/axesgizmo.h"

#include <QContextMenuEvent>
#include <QSignalSpy>

using namespace quadrille::test;
using namespace quadrille::widgets;

class TestViewCamera : public ViewportFixture
{
    Q_OBJECT
private slots:
    void draggingTurnsTheCameraAndTheWheelComesNearer();
    void framesWhatIsThere();
    void dragsDoWhatThePresetSays_data();
    void dragsDoWhatThePresetSays();
    void theRightButtonOpensAMenuUnlessItDrags();
    void aClickOnAnAxisLooksFromThere();
    void framesAFigureWithThePathAboutIt();
};

void TestViewCamera::draggingTurnsTheCameraAndTheWheelComesNearer()
{
    addSquare(Qt::red);
    QTest::qWait(50);
    const Turntable before = m_viewport->camera();
    QWidget* view = m_viewport->view();
    const QPoint from = view->rect().center();
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step)
        QTest::mouseMove(view, from + QPoint(12 * step, 4 * step));
    QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(60, 20));
    QTRY_VERIFY(std::abs(m_viewport->camera().yaw - before.yaw) > 5);
    QWheelEvent wheel(from, view->mapToGlobal(from), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &wheel);
    QTRY_VERIFY(m_viewport->camera().distance < before.distance);
}

void TestViewCamera::framesWhatIsThere()
{
    const int figure = addSquare(Qt::red);
    m_viewport->setFigureOffset(figure, {10, 0, 0});
    m_viewport->frameAll();
    QTRY_VERIFY(std::abs(m_viewport->camera().target.x() - 10) < 0.5F);
}

void TestViewCamera::dragsDoWhatThePresetSays_data()
{
    QTest::addColumn<MousePreset>("preset");
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("keys");
    QTest::addColumn<QString>("effect");
    const Qt::KeyboardModifiers none;
    using enum MousePreset;
    QTest::newRow("own left") << Quadrille << Qt::LeftButton << none << "orbit";
    QTest::newRow("own right") << Quadrille << Qt::RightButton << none << "pan";
    QTest::newRow("own shift") << Quadrille << Qt::MiddleButton << Qt::KeyboardModifiers(Qt::ShiftModifier)
                               << "pan";
    QTest::newRow("blender left") << Blender << Qt::LeftButton << none << "nothing";
    QTest::newRow("blender middle") << Blender << Qt::MiddleButton << none << "orbit";
    QTest::newRow("blender ctrl") << Blender << Qt::MiddleButton << Qt::KeyboardModifiers(Qt::ControlModifier)
                                  << "dolly";
    QTest::newRow("maya left") << Maya << Qt::LeftButton << none << "nothing";
    QTest::newRow("maya alt left") << Maya << Qt::LeftButton << Qt::KeyboardModifiers(Qt::AltModifier)
                                   << "orbit";
    QTest::newRow("maya alt right") << Maya << Qt::RightButton << Qt::KeyboardModifiers(Qt::AltModifier)
                                    << "dolly";
    QTest::newRow("paraview middle") << ParaView << Qt::MiddleButton << none << "pan";
    QTest::newRow("paraview right") << ParaView << Qt::RightButton << none << "dolly";
}

void TestViewCamera::dragsDoWhatThePresetSays()
{
    QFETCH(MousePreset, preset);
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, keys);
    QFETCH(QString, effect);
    m_viewport->setMousePreset(preset);
    const Turntable before = m_viewport->camera();
    QWidget* view = m_viewport->view();
    const QPoint from = view->rect().center();
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButtons down) {
        QMouseEvent event(type, at, view->mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                          down, keys);
        QApplication::sendEvent(view, &event);
    };
    send(QEvent::MouseButtonPress, from, button);
    for (int step = 1; step <= 5; ++step)
        send(QEvent::MouseMove, from + QPoint(10 * step, 8 * step), button);
    send(QEvent::MouseButtonRelease, from + QPoint(50, 40), Qt::NoButton);
    const Turntable after = m_viewport->camera();
    QCOMPARE(after.yaw != before.yaw, effect == "orbit");
    QCOMPARE(after.target != before.target, effect == "pan");
    QCOMPARE(after.distance != before.distance, effect == "dolly");
}

void TestViewCamera::theRightButtonOpensAMenuUnlessItDrags()
{
    QSignalSpy asked(m_viewport.get(), &Viewport::contextMenuRequested);
    QWidget* view = m_viewport->view();
    const QPoint from = view->rect().center();
    QTest::mousePress(view, Qt::RightButton, {}, from);
    QTest::mouseMove(view, from + QPoint(30, 0));
    QTest::mouseMove(view, from + QPoint(60, 0));
    QTest::mouseRelease(view, Qt::RightButton, {}, from + QPoint(60, 0));
    QCOMPARE(asked.size(), 0);
    QTest::mouseClick(view, Qt::RightButton, {}, from);
    QCOMPARE(asked.size(), 1);
    QContextMenuEvent key(QContextMenuEvent::Keyboard, from, view->mapToGlobal(from));
    QApplication::sendEvent(view, &key);
    QCOMPARE(asked.size(), 2);
}

void TestViewCamera::aClickOnAnAxisLooksFromThere()
{
    Turntable camera = m_viewport->camera();
    camera.yaw = 30;
    camera.pitch = 20;
    m_viewport->setCamera(camera);
    auto* axes = m_viewport->findChild<AxesGizmo*>();
    QVERIFY(axes != nullptr && axes->isVisible());
    QVERIFY(m_viewport->rect().contains(axes->geometry()));
    const auto top = axes->endOf(StandardView::Top);
    QVERIFY(top && top->y() < axes->height() / 2.0);
    QTest::mouseClick(axes, Qt::LeftButton, {}, top->toPoint());
    QTRY_COMPARE(m_viewport->camera().pitch, 90.0F);
    // The axis that points at the eye hides the one behind it.
    QVERIFY(axes->endOf(StandardView::Top));
    QTRY_VERIFY(!axes->endOf(StandardView::Bottom));
}

void TestViewCamera::framesAFigureWithThePathAboutIt()
{
    const int figure = addSquare(Qt::red);
    SceneMarks path;
    path.curves = {{.points = {{0, 0, 0}, {9, 0, 0}}, .color = Qt::green, .colors = {}}};
    m_viewport->setMarks("path", path);
    m_viewport->frameFigure(figure);
    const auto isSeen = [this](const QVector3D& place) {
        QPointF pixel;
        return m_viewport->camera().project(place, m_viewport->size(), &pixel) &&
               QRectF(m_viewport->rect()).contains(pixel);
    };
    QTRY_VERIFY(isSeen({9, 0, 0}) && isSeen({-1, 2, 0}));
    // It fills the view: a third nearer, something would be cut off.
    Turntable nearer = m_viewport->camera();
    nearer.distance *= 0.66F;
    m_viewport->setCamera(nearer);
    QVERIFY(!isSeen({9, 0, 0}) || !isSeen({-1, 2, 0}));
}

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, TestViewCamera);
#include "tst_viewcamera.moc"
