// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Paths that are drawn, dragged and seen; the rest is in tst_patheditorparts.cpp.
#include "tst_patheditor.h"

#include "tests/qt/viewapplication.h"

#include <QApplication>

void TestPathEditor::init()
{
    QVERIFY(VtkView::openGlAvailable());
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(800, 600);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    Turntable camera;
    camera.target = {0, 0, 0};
    camera.yaw = 0;
    camera.pitch = 55;
    camera.distance = 12;
    m_viewport->setCamera(camera);
    m_editor = std::make_unique<PathEditor>(*m_viewport);
    m_editor->setSampler(sample);
    m_edits = m_previews = 0;
    const auto change = [this](bool committed, const auto& edit) {
        ++(committed ? m_edits : m_previews);
        PathShape shape = m_editor->shape();
        edit(shape);
        m_editor->setShape(shape);
    };
    connect(m_editor.get(), &PathEditor::pointsEdited, this,
            [change](const std::vector<QVector3D>& points, PathEdit, bool committed) {
                change(committed, [&](PathShape& shape) { shape.points = points; });
            });
    connect(m_editor.get(), &PathEditor::stretchEdited, this,
            [change](int stretch, double from, double to, bool committed) {
                change(committed, [&](PathShape& shape) {
                    shape.stretches[static_cast<std::size_t>(stretch)].from = from;
                    shape.stretches[static_cast<std::size_t>(stretch)].to = to;
                });
            });
    connect(m_editor.get(), &PathEditor::obstacleAdded, this, [change](const PathObstacle& obstacle) {
        change(true, [&](PathShape& shape) { shape.obstacles.push_back(obstacle); });
    });
    connect(m_editor.get(), &PathEditor::obstacleEdited, this,
            [change](int index, const PathObstacle& obstacle, bool committed) {
                change(committed, [&](PathShape& shape) {
                    shape.obstacles[static_cast<std::size_t>(index)] = obstacle;
                });
            });
    connect(m_editor.get(), &PathEditor::obstacleDeletionRequested, this, [change](int index) {
        change(true, [&](PathShape& shape) { shape.obstacles.erase(shape.obstacles.begin() + index); });
    });
    m_viewport->setViewTool(m_editor.get());
    m_viewport->view()->setFocus();
}

void TestPathEditor::cleanup()
{
    m_editor.reset();
    m_viewport.reset();
}

void TestPathEditor::show(PathShape shape)
{
    m_editor->setShape(shape);
    m_viewport->grab();
}

/// Two metres along x, then two along z.
void TestPathEditor::showLine(PathKind kind, bool inSpace)
{
    PathShape shape;
    shape.kind = kind;
    shape.inSpace = inSpace;
    const float height = inSpace ? 1.0F : 0.0F;
    shape.points = {{-2, height, -1}, {0, height, -1}, {0, height, 1}};
    if (kind == PathKind::Bezier)
        shape.points = convertedPoints(shape.points, PathKind::Polyline, kind);
    show(shape);
}

QPoint TestPathEditor::pixel(const QVector3D& place) const
{
    QPointF at;
    m_viewport->camera().project(place, m_viewport->view()->size(), &at);
    return at.toPoint();
}

QPoint TestPathEditor::pixel(const PathPart& part) const
{
    return m_editor->pixelOf(part).value_or(QPointF()).toPoint();
}

void TestPathEditor::mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers,
                           Qt::MouseButton button)
{
    QWidget* view = m_viewport->view();
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, at, view->mapToGlobal(at), isMove ? Qt::NoButton : button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : button, modifiers);
    QApplication::sendEvent(view, &event);
}

void TestPathEditor::click(const QVector3D& place)
{
    QTest::mouseMove(m_viewport->view(), pixel(place));
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel(place));
}

void TestPathEditor::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers)
{
    mouse(QEvent::MouseButtonPress, from, modifiers);
    for (int step = 1; step <= 4; ++step)
        mouse(QEvent::MouseMove, from + (to - from) * step / 4, modifiers);
    mouse(QEvent::MouseButtonRelease, to, modifiers);
}

void TestPathEditor::key(int code, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_viewport->view(), static_cast<Qt::Key>(code), modifiers);
}

void TestPathEditor::threeClicksDrawAPath()
{
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, -1});
    QCOMPARE(m_edits, 0); // one point is no path yet
    click({0, 0, 1});
    click({2, 0, 0});
    QCOMPARE(m_edits, 2);
    const auto& points = m_editor->shape().points;
    QCOMPARE(points.size(), 3U);
    VERIFY_NEAR(points[0], {-2, 0, -1});
    VERIFY_NEAR(points[1], {0, 0, 1});
    VERIFY_NEAR(points[2], {2, 0, 0});
    key(Qt::Key_Return);
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    click({1, 0, -2});
    QCOMPARE(m_editor->shape().points.size(), 3U);
}

void TestPathEditor::theCurveIsPreviewedToThePointer()
{
    std::vector<std::vector<QVector3D>> sampled;
    m_editor->setSampler([&](PathKind kind, const std::vector<QVector3D>& points) {
        sampled.push_back(points);
        return sample(kind, points);
    });
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, -1});
    QTest::mouseMove(m_viewport->view(), pixel(QVector3D(1, 0, 1)));
    QTRY_VERIFY((m_viewport->grab(), !sampled.empty()));
    QCOMPARE(sampled.back().size(), 2U);
    VERIFY_NEAR(sampled.back()[1], {1, 0, 1});
    QVERIFY(m_editor->shape().points.empty());
}

void TestPathEditor::aStrokeBecomesFewPoints()
{
    m_editor->setMode(PathEditor::Mode::Draw);
    mouse(QEvent::MouseButtonPress, pixel(QVector3D(-2, 0, 0)));
    for (int i = 1; i <= 60; ++i) {
        const float x = -2.0F + 4.0F * static_cast<float>(i) / 60;
        mouse(QEvent::MouseMove, pixel(QVector3D(x, 0, std::sin(1.5F * x + 3.0F))));
    }
    mouse(QEvent::MouseButtonRelease, pixel(QVector3D(2, 0, std::sin(6.0F))));
    QCOMPARE(m_edits, 1);
    const auto& points = m_editor->shape().points;
    QVERIFY2(points.size() >= 4 && points.size() <= 15, qPrintable(QString::number(points.size())));
    VERIFY_NEAR(points.front(), {-2, 0, 0});
    VERIFY_NEAR(points.back(), {2, 0, std::sin(6.0F)});
}

void TestPathEditor::aDoubleClickEndsDrawing()
{
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, -1});
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel(QVector3D(1, 0, 1)));
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, pixel(QVector3D(1, 0, 1)));
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().points.size(), 2U);
}

void TestPathEditor::aClickOnTheFirstPointClosesThePath()
{
    showLine();
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, -1});
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().points.size(), 4U);
    QCOMPARE(m_editor->shape().points.back(), m_editor->shape().points.front());
}

void TestPathEditor::draggingAPointMovesItAndCommitsOnce()
{
    showLine();
    drag(pixel({Part::Point, 1, 0}), pixel(QVector3D(1, 0, -1.5F)));
    VERIFY_NEAR(m_editor->shape().points[1], {1, 0, -1.5F});
    VERIFY_NEAR(m_editor->shape().points[0], {-2, 0, -1});
    QCOMPARE(m_edits, 1);
    QVERIFY(m_previews >= 3);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 1, 0}));
}

void TestPathEditor::escapeTakesADragBack()
{
    showLine();
    const auto before = m_editor->shape();
    const QPoint from = pixel({Part::Point, 1, 0});
    mouse(QEvent::MouseButtonPress, from);
    mouse(QEvent::MouseMove, from + QPoint(60, 20));
    QVERIFY(!(m_editor->shape() == before));
    key(Qt::Key_Escape);
    QCOMPARE(m_editor->shape().points, before.points);
    QCOMPARE(m_edits, 1); // which says that the drag is over
    mouse(QEvent::MouseMove, from + QPoint(90, 20));
    QCOMPARE(m_editor->shape().points, before.points);
}

void TestPathEditor::shiftKeepsToAnAxisAndCtrlSnapsToTheGrid()
{
    showLine();
    drag(pixel({Part::Point, 1, 0}), pixel(QVector3D(1.03F, 0, -1.2F)), Qt::ShiftModifier);
    QCOMPARE(m_editor->shape().points[1].z(), -1.0F);
    QVERIFY(std::abs(m_editor->shape().points[1].x() - 1.03F) < nearby);
    drag(pixel({Part::Point, 1, 0}), pixel(QVector3D(1.6F, 0, 0.3F)), Qt::ControlModifier);
    for (const int axis : {0, 2}) {
        const float metres = m_editor->shape().points[1][axis];
        QVERIFY2(std::abs(metres - std::round(metres)) < 1e-4F, qPrintable(QString::number(metres)));
    }
}

void TestPathEditor::draggingNothingTurnsTheCamera()
{
    showLine();
    const float before = m_viewport->camera().yaw;
    const QPoint from = pixel(QVector3D(2, 0, 2));
    drag(from, from + QPoint(50, 0));
    QVERIFY(std::abs(m_viewport->camera().yaw - before) > 5.0F);
    QCOMPARE(m_edits + m_previews, 0);
}

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, TestPathEditor);

#include "moc_tst_patheditor.cpp"
