// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/patheditor.h"
#include "widgets/viewport/pathgeometry.h"
#include "widgets/viewport/scenemarks.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace quadrille::widgets;
using Part = PathPart::Kind;

class TestPathEditor : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void threeClicksDrawAPath();
    void theCurveIsPreviewedToThePointer();
    void aStrokeBecomesFewPoints();
    void aDoubleClickEndsDrawing();
    void aClickOnTheFirstPointClosesThePath();
    void draggingAPointMovesItAndCommitsOnce();
    void escapeTakesADragBack();
    void shiftKeepsToAnAxisAndCtrlSnapsToTheGrid();
    void draggingNothingTurnsTheCamera();
    void handlesMirrorUnlessAltIsHeld();
    void pullingDrawsBezierHandles();
    void aDoubleClickOnTheCurveInsertsAPoint();
    void deleteRemovesAPointAndAtLastThePath();
    void everythingCanBeDoneByKeyboard();
    void pointsInSpaceAreLiftedByTheirArrow();
    void endsOfStretchesAreDraggedAlongTheCurve();
    void discsAreDrawnMovedResizedAndDeleted();
    void polygonsAreDrawnCornerByCorner();
    void measuringHasPrecedence();
    void dividingABezierKeepsItsForm();
    void polygonsAreTriangulatedAndHatchedInside();

private:
    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<PathEditor> m_editor;
    int m_edits = 0;    ///< committed
    int m_previews = 0; ///< not committed
    void show(PathShape shape);
    void showLine(PathKind kind = PathKind::Polyline, bool inSpace = false);
    QPoint pixel(const QVector3D& place) const;
    QPoint pixel(const PathPart& part) const;
    void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton);
    void click(const QVector3D& place);
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void key(int code, Qt::KeyboardModifiers modifiers = {});
};

namespace {

constexpr float nearby = 0.03F; // metres; a pixel is some 0.013 here, and clicks fall on whole ones

std::vector<QVector3D> sample(PathKind kind, const std::vector<QVector3D>& points)
{
    constexpr int steps = 20;
    std::vector<QVector3D> samples{points.front()};
    const std::size_t stride = kind == PathKind::Bezier ? 3 : 1;
    for (std::size_t i = 0; i + stride < points.size(); i += stride) {
        for (int step = 1; step <= steps; ++step) {
            const float t = static_cast<float>(step) / steps;
            const float s = 1.0F - t;
            samples.push_back(kind == PathKind::Bezier
                                  ? s * s * s * points[i] + 3 * s * s * t * points[i + 1] +
                                        3 * s * t * t * points[i + 2] + t * t * t * points[i + 3]
                                  : s * points[i] + t * points[i + 1]);
        }
        samples.back() = points[i + stride];
    }
    return samples;
}

bool isNear(const QVector3D& a, const QVector3D& b)
{
    return (a - b).length() < nearby;
}

} // namespace

#define VERIFY_NEAR(actual, ...)                                                                             \
    do {                                                                                                     \
        const QVector3D is = (actual);                                                                       \
        QVERIFY2(isNear(is, __VA_ARGS__),                                                                    \
                 qPrintable(QStringLiteral("%1 %2 %3").arg(is.x()).arg(is.y()).arg(is.z())));                \
    } while (false)

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
    connect(m_editor.get(), &PathEditor::obstacleDeletionAsked, this, [change](int index) {
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
    m_viewport->grab();
    QVERIFY(!sampled.empty());
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

void TestPathEditor::handlesMirrorUnlessAltIsHeld()
{
    showLine(PathKind::Bezier);
    QCOMPARE(m_editor->shape().points.size(), 7U);
    const QVector3D middle = m_editor->shape().points[3];
    const float reach = (m_editor->shape().points[2] - middle).length();
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(1, 0, -1)));
    VERIFY_NEAR(m_editor->shape().points[4], {1, 0, -1});
    VERIFY_NEAR(m_editor->shape().points[2], {-reach, 0, -1});
    const QVector3D kept = m_editor->shape().points[2];
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(0.6F, 0, 0.2F)), Qt::AltModifier);
    VERIFY_NEAR(m_editor->shape().points[4], {0.6F, 0, 0.2F});
    QCOMPARE(m_editor->shape().points[2], kept);
    // Once broken they stay so, until a double click on their point.
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(0.8F, 0, 0.2F)));
    QCOMPARE(m_editor->shape().points[2], kept);
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 3, 0}));
    QVERIFY(isSmooth(m_editor->shape().points, 1));
}

void TestPathEditor::pullingDrawsBezierHandles()
{
    PathShape shape;
    shape.kind = PathKind::Bezier;
    show(shape);
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, 0});
    drag(pixel(QVector3D(1, 0, 0)), pixel(QVector3D(1, 0, 1)));
    const auto& points = m_editor->shape().points;
    QCOMPARE(points.size(), 4U);
    VERIFY_NEAR(points[3], {1, 0, 0});
    VERIFY_NEAR(points[2], {1, 0, -1});
    click({3, 0, 0});
    QCOMPARE(m_editor->shape().points.size(), 7U);
    QVERIFY(isSmooth(m_editor->shape().points, 1));
}

void TestPathEditor::aDoubleClickOnTheCurveInsertsAPoint()
{
    showLine();
    const QPoint at = pixel(QVector3D(-0.7F, 0, -1));
    QCOMPARE(m_editor->partAt(at).kind, Part::Curve);
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, at);
    QCOMPARE(m_editor->shape().points.size(), 4U);
    VERIFY_NEAR(m_editor->shape().points[1], {-0.7F, 0, -1});
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 1, 0}));
    showLine(PathKind::Bezier);
    const auto before = m_editor->curve();
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, pixel(before.at(3.0)));
    QCOMPARE(m_editor->shape().points.size(), 10U);
    VERIFY_NEAR(m_editor->shape().points[6], before.at(3.0));
    QVERIFY(std::abs(m_editor->curve().length() - before.length()) < 0.01);
}

void TestPathEditor::deleteRemovesAPointAndAtLastThePath()
{
    showLine();
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 1, 0}));
    key(Qt::Key_Delete);
    QCOMPARE(m_editor->shape().points, (std::vector<QVector3D>{{-2, 0, -1}, {0, 0, 1}}));
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().points.empty());
}

void TestPathEditor::everythingCanBeDoneByKeyboard()
{
    m_editor->setMode(PathEditor::Mode::Draw);
    key(Qt::Key_Insert);
    key(Qt::Key_Insert);
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().points.size(), 3U);
    VERIFY_NEAR(m_editor->shape().points[0], {0, 0, 0});
    key(Qt::Key_Return);
    key(Qt::Key_Escape);
    key(Qt::Key_Tab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 0, 0}));
    key(Qt::Key_Tab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 1, 0}));
    const QVector3D before = m_editor->shape().points[1];
    key(Qt::Key_Right);
    key(Qt::Key_Right, Qt::ShiftModifier);
    VERIFY_NEAR(m_editor->shape().points[1], before + QVector3D(1.1F, 0, 0));
    key(Qt::Key_Up);
    VERIFY_NEAR(m_editor->shape().points[1], before + QVector3D(1.1F, 0, -0.1F));
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().points.size(), 4U);
    key(Qt::Key_Delete);
    QCOMPARE(m_editor->shape().points.size(), 3U);
    key(Qt::Key_Escape);
    QCOMPARE(m_editor->selected(), PathPart{});
    m_editor->setMode(PathEditor::Mode::Disc);
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    key(Qt::Key_Backtab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Obstacle, 0, 0}));
    const float radius = m_editor->shape().obstacles[0].radius;
    key(Qt::Key_Plus);
    QVERIFY(m_editor->shape().obstacles[0].radius > radius);
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().obstacles.empty());
}

void TestPathEditor::pointsInSpaceAreLiftedByTheirArrow()
{
    showLine(PathKind::Polyline, true);
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 1, 0}));
    const PathPart arrow{Part::Lift, 1, 0};
    QVERIFY(m_editor->pixelOf(arrow));
    const QPoint from = pixel(arrow);
    QCOMPARE(m_editor->partAt(from), arrow);
    drag(from, from - QPoint(0, 40));
    const QVector3D lifted = m_editor->shape().points[1];
    QVERIFY2(lifted.y() > 1.3F, qPrintable(QString::number(lifted.y())));
    QCOMPARE(lifted.x(), 0.0F);
    QCOMPARE(lifted.z(), -1.0F);
    drag(pixel({Part::Point, 1, 0}), pixel({Part::Point, 1, 0}) + QPoint(50, 0));
    QCOMPARE(m_editor->shape().points[1].y(), lifted.y());
    QVERIFY(m_editor->shape().points[1].x() > 0.3F);
    key(Qt::Key_PageDown);
    QVERIFY(std::abs(m_editor->shape().points[1].y() - lifted.y() + 0.1F) < 1e-4F);
}

void TestPathEditor::endsOfStretchesAreDraggedAlongTheCurve()
{
    showLine();
    PathShape shape = m_editor->shape();
    shape.stretches = {{0.5, 1.5, "jog"}};
    show(shape);
    drag(pixel({Part::StretchEnd, 0, 0}), pixel(QVector3D(0, 0, 0.2F)));
    const PathStretch& stretch = m_editor->shape().stretches[0];
    QVERIFY2(std::abs(stretch.to - 3.2) < 0.03, qPrintable(QString::number(stretch.to)));
    QCOMPARE(stretch.from, 0.5);
    QCOMPARE(m_edits, 1);
    // The ends never pass each other.
    drag(pixel({Part::StretchStart, 0, 0}), pixel(QVector3D(0, 0, 1)));
    QVERIFY(m_editor->shape().stretches[0].from < m_editor->shape().stretches[0].to);
    key(Qt::Key_Left);
    QVERIFY(std::abs(m_editor->shape().stretches[0].from - 3.05) < 0.05);
    QSignalSpy deletion(m_editor.get(), &PathEditor::stretchDeletionAsked);
    key(Qt::Key_Delete);
    QCOMPARE(deletion.size(), 1);
}

void TestPathEditor::discsAreDrawnMovedResizedAndDeleted()
{
    showLine();
    m_editor->setMode(PathEditor::Mode::Disc);
    drag(pixel(QVector3D(2, 0, 0)), pixel(QVector3D(2.5F, 0, 0)));
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {2, 0, 0});
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.5F) < nearby);
    drag(pixel({Part::Obstacle, 0, 0}), pixel(QVector3D(1.5F, 0, 1)));
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {1.5F, 0, 1});
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.5F) < nearby);
    drag(pixel(QVector3D(2, 0, 1)), pixel(QVector3D(2.3F, 0, 1)));
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.8F) < 2 * nearby);
    QCOMPARE(m_edits, 3);
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().obstacles.empty());
}

void TestPathEditor::polygonsAreDrawnCornerByCorner()
{
    showLine();
    m_editor->setMode(PathEditor::Mode::Polygon);
    click({1, 0, 0});
    click({2, 0, 0});
    click({2, 0, 1});
    click({1, 0, 0});
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    QCOMPARE(m_editor->shape().obstacles[0].corners.size(), 3U);
    drag(pixel({Part::ObstacleCorner, 0, 2}), pixel(QVector3D(2.5F, 0, 1.5F)));
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[2], {2.5F, 0, 1.5F});
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {1, 0, 0});
}

void TestPathEditor::measuringHasPrecedence()
{
    showLine();
    m_viewport->setTool(Viewport::Tool::Measure);
    const QPoint at = pixel({Part::Point, 1, 0});
    drag(at, at + QPoint(40, 0));
    QCOMPARE(m_edits + m_previews, 0);
}

void TestPathEditor::dividingABezierKeepsItsForm()
{
    const std::vector<QVector3D> points{{0, 0, 0}, {1, 0, 2}, {3, 0, 2}, {4, 0, 0}};
    const SampledCurve whole(sample(PathKind::Bezier, points));
    const QVector3D place = whole.at(1.3);
    const float t = nearestParameter(points, 0, place);
    const auto divided = insertedPoint(PathKind::Bezier, points, 0, t, place);
    QCOMPARE(divided.size(), 7U);
    VERIFY_NEAR(divided[3], place);
    const SampledCurve again(sample(PathKind::Bezier, divided));
    QVERIFY(std::abs(again.length() - whole.length()) < 0.01);
    QCOMPARE(removedAnchor(PathKind::Bezier, divided, 1).size(), 4U);
    QVERIFY(removedAnchor(PathKind::Bezier, points, 1).empty());
}

void TestPathEditor::polygonsAreTriangulatedAndHatchedInside()
{
    // An L of three square metres, clockwise and the other way.
    std::vector<QVector3D> outline{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}};
    for (int turn = 0; turn < 2; ++turn) {
        const auto triangles = triangulate(outline, {0, 1, 0});
        QCOMPARE(triangles.size(), 12U);
        float area = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return outline[static_cast<std::size_t>(triangles[i + k])];
            };
            area += QVector3D::crossProduct(corner(1) - corner(0), corner(2) - corner(0)).length() / 2;
        }
        QVERIFY(std::abs(area - 3.0F) < 1e-5F);
        const auto hatch = hatchLines(outline, {0, 1, 0}, 0.25F);
        QVERIFY(hatch.size() > 10);
        for (std::size_t i = 0; i + 1 < hatch.size(); i += 2) {
            const QVector3D middle = (hatch[i] + hatch[i + 1]) / 2;
            QVERIFY(middle.x() < 1.001F || middle.z() < 1.001F);
        }
        std::reverse(outline.begin(), outline.end());
    }
}

int main(int argc, char** argv)
{
    VtkView::setDefaultFormat();
    QApplication application(argc, argv);
    TestPathEditor test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_patheditor.moc"
