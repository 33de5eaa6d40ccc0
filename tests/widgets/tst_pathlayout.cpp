// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/tools/pathdrag.h"
#include "widgets/tools/pathdrawing.h"
#include "widgets/tools/pathedits.h"

#include <QCoreApplication>
#include <QTest>

using namespace quadrille::widgets;

namespace {

using Part = PathPart::Kind;

/// Seen from straight above, a hundred pixels a metre: (x, z) is at pixel (400 + 100 x, 300 + 100 z).
GroundView fromAbove()
{
    GroundView view;
    view.camera = {.target = {0, 0, 0}, .yaw = 0, .pitch = 90, .distance = 3, .fieldOfView = 90};
    view.size = {800, 600};
    return view;
}

QPointF at(double x, double z)
{
    return {400 + 100 * x, 300 + 100 * z};
}

/// Whether two places are less than a millimetre apart; pixels are computed in single precision.
bool isSamePlace(const QVector3D& a, const QVector3D& b)
{
    return (a - b).length() < 1e-3F;
}

bool areSamePlaces(const std::vector<QVector3D>& a, const std::vector<QVector3D>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSamePlace);
}

} // namespace

/// Places, parts, drags and drawing of a path, without a viewport.
class TestPathLayout : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void pixelsMeanPlacesOnTheGround();
    void heightsAreReadFromTheSide();
    void movesKeepToAxesAndGrid();
    void partsAreFoundUnderTheirPixels();
    void partsStandInOrder();
    void pointsAreDraggedFromWhereTheyWereGrabbed();
    void endsOfStretchesKeepApart();
    void obstaclesAreMovedAndSized();
    void keysMoveAlongTheViewsAxes();
    void lengthsLieBetweenAnchors();
    void clicksDrawPoints();
    void strokesBecomeFewPoints();
    void pullsMakeHandles();
    void discsAndPolygonsAreDrawn();
    void whatWasBegunIsForgottenWithItsMode();

private:
    PathContent m_content;
    PathLayout layout() const { return {m_content, fromAbove()}; }
    void setPoints(std::vector<QVector3D> points)
    {
        m_content.shape.points = points;
        m_content.curve = SampledCurve(std::move(points));
    }
};

void TestPathLayout::init()
{
    m_content = {};
    m_content.shape.kind = PathKind::Polyline;
    setPoints({{-2, 0, 0}, {0, 0, 0}, {0, 0, 2}});
}

void TestPathLayout::pixelsMeanPlacesOnTheGround()
{
    const GroundView view = fromAbove();
    QVERIFY(isSamePlace(view.placeAt(at(1.5, -2), 0).value(), {1.5F, 0, -2}));
    // At half of the camera's height a pixel is half as much.
    QVERIFY(isSamePlace(view.placeAt(at(1.5, -2), 1.5F).value(), {0.75F, 1.5F, -1}));
    QVERIFY(!view.placeAt(at(0, 0), 4)); // behind the camera
    QVERIFY(std::abs(view.unitsPerPixel({1, 0, 1}) - 0.01F) < 1e-5F);
    const auto pixel = view.project(QVector3D(1.5F, 0, -2));
    QVERIFY(pixel && (*pixel - at(1.5, -2)).manhattanLength() < 0.1);
    QCOMPARE(view.project(std::vector<QVector3D>{{0, 0, 0}, {0, 5, 0}}).size(), 1);
    GroundView low = view;
    low.ground = -1;
    QCOMPARE(low.onGround({1, 2, 3}), QVector3D(1, -1, 3));
}

void TestPathLayout::heightsAreReadFromTheSide()
{
    GroundView view = fromAbove();
    view.camera.pitch = 0;
    // Three metres away, the middle of the view is as high as the target, and up is up.
    QVERIFY(std::abs(view.heightAt({400, 300}, {0, 0, 0})) < 1e-3F);
    QVERIFY(std::abs(view.heightAt({400, 200}, {0, 0, 0}) - 1.0F) < 1e-3F);
    QVERIFY(!view.placeAt({400, 200}, 0)); // above the horizon
}

void TestPathLayout::movesKeepToAxesAndGrid()
{
    const GroundView view = fromAbove();
    const QVector3D from(0.33F, 0, 0.33F);
    QCOMPARE(view.constrained(from, {1, 0, 0.5F}, Qt::ShiftModifier), QVector3D(1, 0, 0.33F));
    QCOMPARE(view.constrained(from, {0.5F, 0, 1}, Qt::ShiftModifier), QVector3D(0.33F, 0, 1));
    // Ten pixels are 6.7 cm near by and 20 cm from afar, so that lines are ten centimetres or a metre apart.
    GroundView near = view;
    near.camera.distance = 2;
    QVERIFY(isSamePlace(near.constrained(from, {1.04F, 0, 0.48F}, Qt::ControlModifier), {1, 0, 0.5F}));
    GroundView far = view;
    far.camera.distance = 6;
    QVERIFY(isSamePlace(far.constrained(from, {1.04F, 0, 0.58F}, Qt::ControlModifier), {1, 0, 1}));
    QVERIFY(isSamePlace(near.constrained(from, {1.04F, 0, 0.48F}, Qt::ControlModifier | Qt::ShiftModifier),
                        {1, 0, 0.33F}));
}

void TestPathLayout::partsAreFoundUnderTheirPixels()
{
    m_content.shape.stretches = {{.from = 1, .to = 2.05, .text = {}}};
    m_content.shape.obstacles = {{.corners = {{2, 0, 1}}, .radius = 0.5F, .problem = {}}};
    const auto partAt = [this](double x, double z) { return layout().partAt(at(x, z)); };
    QCOMPARE(partAt(-2.1, 0), (PathPart{Part::Point, 0, 0}));
    QCOMPARE(partAt(-2.13, 0).kind, Part::None); // 13 pixels
    QCOMPARE(partAt(-1.0, 0), (PathPart{Part::StretchStart, 0, 0}));
    QCOMPARE(partAt(0, 0.03), (PathPart{Part::Point, 1, 0})); // lies on top of the stretch's end
    m_content.selected = {Part::StretchEnd, 0, 0};
    QCOMPARE(partAt(0, 0.03), (PathPart{Part::StretchEnd, 0, 0}));
    QCOMPARE(partAt(-1.5, 0.07).kind, Part::Curve);
    QCOMPARE(partAt(-1.5, 0.09).kind, Part::None);
    QCOMPARE(partAt(2, 1), (PathPart{Part::Obstacle, 0, 0}));
    QCOMPARE(partAt(2, 1.56), (PathPart{Part::ObstacleRadius, 0, 0}));
    double distance = 0;
    QVERIFY(std::abs(layout().lengthAt(at(0.3, 1), &distance).value() - 3) < 1e-3);
    QVERIFY(std::abs(distance - 30) < 0.1);
    QVERIFY(!layout().placeOf({Part::Point, 3, 0}) && !layout().placeOf({Part::ObstacleCorner, 0, 1}));
}

void TestPathLayout::partsStandInOrder()
{
    m_content.shape.inSpace = true;
    m_content.shape.stretches = {{}};
    m_content.shape.obstacles = {{.corners = {{}, {}, {}}, .problem = {}}};
    m_content.selected = {Part::Point, 1, 0};
    std::vector<PathPart::Kind> kinds;
    for (const PathPart& part : layout().parts())
        kinds.push_back(part.kind);
    using enum PathPart::Kind;
    QCOMPARE(kinds, (std::vector{Point, Point, Point, Lift, StretchStart, StretchEnd, Obstacle,
                                 ObstacleCorner, ObstacleCorner, ObstacleCorner}));
    QCOMPARE((PathPart{Lift, 1, 0}).owner(), m_content.selected);
    QCOMPARE((PathPart{ObstacleRadius, 2, 0}).owner(), (PathPart{Obstacle, 2, 0}));
}

void TestPathLayout::pointsAreDraggedFromWhereTheyWereGrabbed()
{
    PathDrag drag(layout(), {Part::Point, 1, 0}, at(0.05, 0), {});
    QVERIFY(!drag.moveTo(layout(), at(0.06, 0.01), {}));
    QVERIFY(!drag.hasMoved());
    const auto moved = drag.moveTo(layout(), at(1.05, 1), {});
    QVERIFY(moved && areSamePlaces(moved->points, {{-2, 0, 0}, {1, 0, 1}, {0, 0, 2}}));
    QVERIFY(drag.hasMoved());
    QCOMPARE(drag.before(), m_content.shape);
    QVERIFY(isSamePlace(drag.moveTo(layout(), at(1.05, 0.4), Qt::ShiftModifier)->points[1], {1, 0, 0}));
    // In space Alt lifts; from above a pixel up is as much as it is aside.
    m_content.shape.inSpace = true;
    PathDrag lift(layout(), {Part::Point, 1, 0}, at(0, 0), Qt::AltModifier);
    QVERIFY(isSamePlace(lift.moveTo(layout(), at(0.3, -0.5), Qt::AltModifier)->points[1], {0, 0.5F, 0}));
    QVERIFY(
        isSamePlace(lift.moveTo(layout(), at(0, 0.5), Qt::AltModifier)->points[1], {0, 0, 0})); // the ground
}

void TestPathLayout::endsOfStretchesKeepApart()
{
    m_content.shape.stretches = {{.from = 1, .to = 3, .text = {}}};
    PathDrag end(layout(), {Part::StretchEnd, 0, 0}, at(0, 1), {});
    QVERIFY(std::abs(end.moveTo(layout(), at(0.2, 1.5), {})->stretches[0].to - 3.5) < 1e-3);
    QVERIFY(std::abs(end.moveTo(layout(), at(-2, 0), {})->stretches[0].to - 1.05) < 1e-3);
    PathDrag start(layout(), {Part::StretchStart, 0, 0}, at(-1, 0), {});
    QVERIFY(std::abs(start.moveTo(layout(), at(0, 2), {})->stretches[0].from - 2.95) < 1e-3);
    m_content.selected = {Part::StretchStart, 0, 0};
    const auto nudged = nudgedSelection(layout(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(nudged && nudged->stretches[0].from == 0.0 && nudged->stretches[0].to == 3.0);
}

void TestPathLayout::obstaclesAreMovedAndSized()
{
    m_content.shape.obstacles = {{.corners = {{2, 0, 1}}, .radius = 0.5F, .problem = {}},
                                 {.corners = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, .problem = {}}};
    PathDrag edge(layout(), {Part::ObstacleRadius, 0, 0}, at(2.5, 1), {});
    QVERIFY(std::abs(edge.moveTo(layout(), at(2.8, 1), {})->obstacles[0].radius - 0.8F) < 1e-3F);
    QVERIFY(std::abs(edge.moveTo(layout(), at(2, 1), {})->obstacles[0].radius - 0.05F) < 1e-6F);
    PathDrag whole(layout(), {Part::Obstacle, 1, 0}, at(0.5, 0.5), {});
    QVERIFY(areSamePlaces(whole.moveTo(layout(), at(1.5, 0.5), {})->obstacles[1].corners,
                          {{1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}}));
    PathDrag corner(layout(), {Part::ObstacleCorner, 1, 2}, at(1, 1), {});
    QVERIFY(isSamePlace(corner.moveTo(layout(), at(1.5, 1.5), {})->obstacles[1].corners[2], {1.5F, 0, 1.5F}));
    m_content.selected = {Part::Obstacle, 0, 0};
    QVERIFY(std::abs(resizedSelection(layout(), -0.1F)->obstacles[0].radius - 0.4F) < 1e-6F);
    m_content.selected = {Part::Obstacle, 1, 0};
    QVERIFY(!resizedSelection(layout(), 0.1F));
}

void TestPathLayout::keysMoveAlongTheViewsAxes()
{
    m_content.selected = {Part::Point, 1, 0};
    const auto nudged = [this](int key, Qt::KeyboardModifiers modifiers, float yaw) {
        GroundView view = fromAbove();
        view.camera.yaw = yaw;
        const auto shape = nudgedSelection({m_content, view}, key, modifiers);
        return shape ? shape->points[1] : QVector3D(9, 9, 9);
    };
    QVERIFY(isSamePlace(nudged(Qt::Key_Right, {}, 20), {0.1F, 0, 0}));
    QVERIFY(isSamePlace(nudged(Qt::Key_Up, Qt::ShiftModifier, 20), {0, 0, -1}));
    QVERIFY(isSamePlace(nudged(Qt::Key_Right, Qt::ControlModifier, 90), {0, 0, -0.01F}));
    QVERIFY(isSamePlace(nudged(Qt::Key_PageUp, {}, 0), {9, 9, 9})); // all lies on the ground
    m_content.shape.inSpace = true;
    QVERIFY(isSamePlace(nudged(Qt::Key_PageUp, {}, 0), {0, 0.1F, 0}));
}

void TestPathLayout::lengthsLieBetweenAnchors()
{
    QCOMPARE(anchorBefore(layout(), 0.5), 0U);
    QCOMPARE(anchorBefore(layout(), 2.5), 1U);
    QCOMPARE(anchorBefore(layout(), 9), 1U);
    QCOMPARE(lengthAfter(layout(), 0), 1.0);
    QCOMPARE(lengthAfter(layout(), 1), 3.0);
    QCOMPARE(lengthAfter(layout(), 2), 3.0);
    QVERIFY(isSamePlace(nextPlace(m_content.shape.points, fromAbove()), {0, 0, 3}));
    GroundView aslant = fromAbove();
    aslant.camera.pitch = 45;
    QVERIFY(isSamePlace(nextPlace({{1, 0, 0}}, aslant), {1, 0, -1})); // away from the viewer
}

void TestPathLayout::clicksDrawPoints()
{
    setPoints({});
    PathDrawing drawing;
    drawing.setMode(PathMode::Draw);
    const auto click = [&](double x, double z) {
        drawing.press(layout(), at(x, z), {});
        return drawing.release(layout(), true);
    };
    QVERIFY(click(-1, 0).points.empty()); // one point is no path
    QVERIFY(isSamePlace(drawing.firstPoint().value(), {-1, 0, 0}));
    drawing.hover(layout(), at(1, 0.5), Qt::ShiftModifier);
    QVERIFY(areSamePlaces(drawing.preview(m_content.shape), {{-1, 0, 0}, {1, 0, 0}}));
    QVERIFY(click(-1, 0).points.empty()); // there again
    const auto second = click(1, 0);
    QVERIFY(areSamePlaces(second.points, {{-1, 0, 0}, {1, 0, 0}}));
    QVERIFY(second.edit == PathEdit::Add && !second.isDone);
    init();
    const auto closing = click(-2.03, 0);
    QVERIFY(closing.isDone && closing.points.size() == 4 && closing.points.back() == QVector3D(-2, 0, 0));
    drawing.press(layout(), at(3, 0), {});
    QVERIFY(drawing.release(layout(), false).points.empty());
}

void TestPathLayout::strokesBecomeFewPoints()
{
    setPoints({});
    PathDrawing drawing;
    drawing.setMode(PathMode::Draw);
    drawing.press(layout(), at(-2, 0), {});
    for (int i = 1; i <= 20; ++i)
        drawing.move(layout(), at(i <= 10 ? -2 + 0.2 * i : 0, i <= 10 ? 0.01 * (i % 2) : 0.2 * (i - 10)));
    QVERIFY(drawing.hasMoved() && drawing.stroke().size() == 21);
    const auto outcome = drawing.release(layout(), true);
    QCOMPARE(outcome.edit, PathEdit::Draw);
    QVERIFY(areSamePlaces(outcome.points, {{-2, 0, 0}, {0, 0, 0}, {0, 0, 2}}));
    QCOMPARE(drawing.gesture(), PathDrawing::Gesture::None);
}

void TestPathLayout::pullsMakeHandles()
{
    m_content.shape.kind = PathKind::Bezier;
    setPoints({});
    PathDrawing drawing;
    drawing.setMode(PathMode::Draw);
    drawing.press(layout(), at(-2, 0), {});
    drawing.release(layout(), true);
    drawing.press(layout(), at(1, 0), {});
    QCOMPARE(drawing.gesture(), PathDrawing::Gesture::Pull);
    drawing.move(layout(), at(1, 1));
    const auto outcome = drawing.release(layout(), true);
    QCOMPARE(outcome.points.size(), 4U);
    QVERIFY(isSamePlace(outcome.points[3], {1, 0, 0}));
    QVERIFY(isSamePlace(outcome.points[2], {1, 0, -1})); // across the point from the pointer
}

void TestPathLayout::discsAndPolygonsAreDrawn()
{
    PathDrawing drawing;
    drawing.setMode(PathMode::Disc);
    drawing.press(layout(), at(1, 1), {});
    drawing.move(layout(), at(1.6, 1));
    const auto disc = drawing.release(layout(), true);
    QVERIFY(disc.isDone && disc.obstacle && isSamePlace(disc.obstacle->corners[0], {1, 0, 1}));
    QVERIFY(std::abs(disc.obstacle->radius - 0.6F) < 1e-3F);
    drawing.press(layout(), at(1, 1), {});
    QCOMPARE(drawing.release(layout(), true).obstacle->radius, 0.4F); // a click
    drawing.setMode(PathMode::Polygon);
    for (const QPointF& corner : {at(0, 0), at(1, 0)})
        QVERIFY(!drawing.press(layout(), corner, {}));
    QVERIFY(!drawing.polygon());
    drawing.press(layout(), at(1, 1), {});
    QVERIFY(drawing.press(layout(), at(0.05, 0.05), {})); // the first corner again
    QVERIFY(areSamePlaces(drawing.polygon()->corners, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}));
    QCOMPARE(usualObstacle(PathMode::Polygon, {}, fromAbove()).corners.size(), 4U);
}

void TestPathLayout::whatWasBegunIsForgottenWithItsMode()
{
    PathDrawing drawing;
    drawing.setMode(PathMode::Disc);
    drawing.press(layout(), at(1, 1), {});
    drawing.setMode(PathMode::Edit); // by another hand, while the button is down
    QVERIFY(!drawing.release(layout(), true).obstacle);
    drawing.setMode(PathMode::Polygon);
    drawing.press(layout(), at(0, 0), {});
    drawing.setMode(PathMode::Draw);
    QVERIFY(drawing.corners().empty() && !drawing.pointer());
}

QUADRILLE_QT_TEST_IN(QCoreApplication, TestPathLayout);
#include "tst_pathlayout.moc"
