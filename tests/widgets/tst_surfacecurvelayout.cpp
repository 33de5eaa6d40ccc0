// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/tools/surfacecurvedrag.h"
#include "widgets/tools/surfacecurvedrawing.h"
#include "widgets/tools/surfacecurvepaint.h"

#include <QPainter>
#include <QTest>
#include <cmath>

using namespace quadrille::widgets;

namespace {

using Grip = SurfaceCurvePart::Kind;

constexpr std::uint32_t wallColumns = 5;
constexpr std::uint32_t wallVertices = wallColumns * wallColumns;

/// Of the front wall, or of the one behind it.
constexpr std::uint32_t wallVertex(std::uint32_t column, std::uint32_t row, bool isBehind = false)
{
    return row * wallColumns + column + (isBehind ? wallVertices : 0);
}

/// Two square walls of five by five vertices, a metre apart, that are looked at from the front; the one
/// behind is hidden by the other.
FigureMesh walls()
{
    FigureMesh mesh;
    mesh.vertexCount = 2 * wallVertices;
    for (const bool isBehind : {false, true})
        for (std::uint32_t row = 0; row + 1 < wallColumns; ++row)
            for (std::uint32_t column = 0; column + 1 < wallColumns; ++column) {
                const std::uint32_t a = wallVertex(column, row, isBehind);
                mesh.triangles.push_back({a, a + 1, a + wallColumns + 1});
                mesh.triangles.push_back({a, a + wallColumns + 1, a + wallColumns});
            }
    return mesh;
}

std::vector<float> wallPositions()
{
    std::vector<float> positions;
    for (const float z : {0.0F, -1.0F})
        for (int row = -2; row <= 2; ++row)
            for (int column = -2; column <= 2; ++column)
                positions.insert(positions.end(), {static_cast<float>(column), static_cast<float>(row), z});
    return positions;
}

/// Eight vertices at y = 0 and as many at y = 1, from x = −3 on.
FigureMesh strip()
{
    FigureMesh mesh;
    mesh.vertexCount = 16;
    for (std::uint32_t i = 0; i < 7; ++i) {
        mesh.triangles.push_back({i, i + 1, i + 9});
        mesh.triangles.push_back({i, i + 9, i + 8});
    }
    return mesh;
}

std::vector<float> stripPositions()
{
    std::vector<float> positions;
    for (const float y : {0.0F, 1.0F})
        for (int x = -3; x < 5; ++x)
            positions.insert(positions.end(), {static_cast<float>(x), y, 0.0F});
    return positions;
}

/// Around the middle vertex of a wall, from the lower left corner to the right, with points there and at the
/// opposite corner.
ShownCurve squareOn(bool isBehind)
{
    ShownCurve curve;
    for (const auto& [column, row] :
         {std::pair{1U, 1U}, {2U, 1U}, {3U, 1U}, {3U, 2U}, {3U, 3U}, {2U, 3U}, {1U, 3U}, {1U, 2U}})
        curve.vertices.push_back(wallVertex(column, row, isBehind));
    curve.points = {0, 4};
    curve.color = Qt::green;
    return curve;
}

bool isNear(const std::optional<QPointF>& pixel, const QPointF& expected)
{
    return pixel && (*pixel - expected).manhattanLength() < 0.1;
}

} // namespace

/// Places, parts, drags and drawing of curves on a surface, without a viewport.
class TestSurfaceCurveLayout : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void verticesBecomePixelsAndPixelsPlaces();
    void placesAtVerticesHaveATriangle();
    void arrowsWalkAlongEdges();
    void theViewTurnsToWhatIsBehind();
    void partsAreThereOrNot();
    void keysInsertHalfTheWay();
    void partsAreFoundUnderTheirPixels();
    void whatIsHiddenIsNotSeen();
    void whatIsSeenIsKeptUntilItIsForgotten();
    void pointsStandBeforePlacesOfTheirCurve();
    void pointsAreDraggedFromWhereTheyAreGrabbed();
    void clicksDrawAndClose();
    void keysDraw();
    void curvesArePaintedFromPlainValues();

private:
    /// A hundred pixels a metre at the front wall: (x, y) is at pixel (400 + 100 x, 300 − 100 y).
    SurfaceView view() const
    {
        return {.figure = 7,
                .shape = {m_mesh, m_positions, {}},
                .camera = {.target = {0, 0, 0}, .yaw = 0, .pitch = 0, .distance = 3, .fieldOfView = 90},
                .size = {800, 600}};
    }
    SurfaceCurveLayout layout() { return {m_content, view(), m_seen}; }
    SurfaceCurvePart partAt(double x, double y) { return layout().partAt({x, y}); }

    const FigureMesh m_mesh = walls();
    const std::vector<float> m_positions = wallPositions();
    const FigureMesh m_strip = strip();
    const std::vector<float> m_stripPositions = stripPositions();
    SurfaceCurveContent m_content;
    SeenVertices m_seen;
};

void TestSurfaceCurveLayout::init()
{
    m_content = {};
    m_content.curves = {squareOn(true), squareOn(false)};
    m_seen.reset();
}

void TestSurfaceCurveLayout::verticesBecomePixelsAndPixelsPlaces()
{
    QVERIFY(isNear(view().project(wallVertex(3, 4)), {500, 100}));
    QVERIFY(isNear(view().project(wallVertex(3, 4, true)), {475, 150})); // a quarter nearer to the middle
    QVERIFY(!view().project(QVector3D(0, 0, 4)));                        // behind the camera
    const auto place = view().placeAt(QPointF(480, 290), {});
    QVERIFY(place && place->snaps && place->pick.figure == 7);
    QVERIFY((place->pick.point - QVector3D(0.8F, 0.1F, 0)).length() < 1e-3F);
    QCOMPARE(place->pick.vertex, wallVertex(3, 2));
    QVERIFY(!view().placeAt(QPointF(480, 290), Qt::AltModifier)->snaps);
    QVERIFY(!view().placeAt(QPointF(650, 300), {})); // beside the wall
    QCOMPARE(view().nearestVertex({650, 310}), std::optional(wallVertex(4, 2)));
}

void TestSurfaceCurveLayout::placesAtVerticesHaveATriangle()
{
    const std::uint32_t corner = wallVertex(4, 4);
    const auto place = view().placeAt(corner, Qt::AltModifier);
    QVERIFY(place && !place->snaps && place->pick.vertex == corner);
    QCOMPARE(place->pick.point, QVector3D(2, 2, 0));
    const auto& triangle = m_mesh.triangles[place->pick.triangle];
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(place->pick.barycentric[i], triangle[i] == corner ? 1.0F : 0.0F);
    FigureMesh loose;
    loose.vertexCount = wallVertices;
    const SurfaceView bare{.figure = 7, .shape = {loose, m_positions, {}}, .camera = {}, .size = {8, 6}};
    QVERIFY(!bare.placeAt(corner, {}));
}

void TestSurfaceCurveLayout::arrowsWalkAlongEdges()
{
    const std::uint32_t middle = wallVertex(2, 2);
    QCOMPARE(view().vertexTowards(middle, Qt::Key_Right, {}), wallVertex(3, 2));
    QCOMPARE(view().vertexTowards(middle, Qt::Key_Left, {}), wallVertex(1, 2));
    QCOMPARE(view().vertexTowards(middle, Qt::Key_Up, {}), wallVertex(2, 3));
    QCOMPARE(view().vertexTowards(middle, Qt::Key_Down, {}), wallVertex(2, 1));
    // Where nothing goes that way, it stays.
    QCOMPARE(view().vertexTowards(wallVertex(4, 4), Qt::Key_Right, {}), wallVertex(4, 4));
    QCOMPARE(view().vertexTowards(wallVertex(0, 2), Qt::Key_Right, Qt::ShiftModifier), wallVertex(4, 2));
    const SurfaceView wide{
        .figure = 7, .shape = {m_strip, m_stripPositions, {}}, .camera = view().camera, .size = {800, 600}};
    QCOMPARE(wide.vertexTowards(1, Qt::Key_Right, Qt::ShiftModifier), 6U);
    QCOMPARE(view().vertexTowards(middle, Qt::Key_A, {}), middle);
}

void TestSurfaceCurveLayout::theViewTurnsToWhatIsBehind()
{
    SurfaceView behind = view();
    behind.camera.yaw = 170;
    const Turntable turned = behind.facing(wallVertex(3, 2));
    QVERIFY(std::abs(turned.yaw) < 1e-3F && std::abs(turned.pitch) < 1e-3F);
    QCOMPARE(turned.target, QVector3D(0, 0, 0)); // the vertex is on the view as it is
    behind.camera.target = {9, 0, 0};
    QCOMPARE(behind.facing(wallVertex(3, 2)).target, QVector3D(1, 0, 0));
}

void TestSurfaceCurveLayout::partsAreThereOrNot()
{
    QVERIFY(m_content.has({Grip::Point, 1, 1}) && m_content.has({Grip::Curve, 0, 0}));
    QVERIFY(!m_content.has({}) && !m_content.has({Grip::Point, 1, 2}) &&
            !m_content.has({Grip::Point, 2, 0}) && !m_content.has({Grip::Point, -1, 0}));
    QCOMPARE(m_content.vertexOf({Grip::Point, 1, 1}), wallVertex(3, 3));
    QCOMPARE(m_content.vertexOf({Grip::Curve, 1, 0}), wallVertex(1, 1));
    QCOMPARE(m_content.points(),
             (std::vector<SurfaceCurvePart>{
                 {Grip::Point, 0, 0}, {Grip::Point, 0, 1}, {Grip::Point, 1, 0}, {Grip::Point, 1, 1}}));
    QVERIFY(m_content.drawnCurve() == nullptr);
    m_content.drawn = 1;
    QVERIFY(m_content.drawnCurve() == &m_content.curves[1]);
    m_content.drawn = 2;
    QVERIFY(m_content.drawnCurve() == nullptr);
    QVERIFY(!layout().pixelOf({Grip::Point, 1, 2}) && !layout().isSeen({Grip::Point, 1, 2}));
}

void TestSurfaceCurveLayout::keysInsertHalfTheWay()
{
    QCOMPARE(m_content.vertexAfter({Grip::Point, 1, 0}), std::optional(wallVertex(3, 1)));
    QCOMPARE(m_content.vertexAfter({Grip::Point, 1, 1}), std::optional(wallVertex(1, 3))); // to the first
    m_content.curves[1].points = {0, 1, 7};
    QVERIFY(!m_content.vertexAfter({Grip::Point, 1, 0}));
    QVERIFY(!m_content.vertexAfter({Grip::Point, 1, 2}));
}

void TestSurfaceCurveLayout::partsAreFoundUnderTheirPixels()
{
    QCOMPARE(partAt(311, 400), (SurfaceCurvePart{Grip::Point, 1, 0}));
    QCOMPARE(partAt(313, 400), (SurfaceCurvePart{Grip::Curve, 1, 0}));
    QCOMPARE(partAt(400, 407), (SurfaceCurvePart{Grip::Curve, 1, 0}));
    QCOMPARE(partAt(400, 409).kind, Grip::None);
    QCOMPARE(partAt(400, 300).kind, Grip::None);
    m_content.curves[1].isClosed = false;
    QCOMPARE(partAt(300, 350).kind, Grip::None); // from the last vertex to the first
    QCOMPARE(partAt(300, 250), (SurfaceCurvePart{Grip::Curve, 1, 0}));
    QVERIFY((layout().boxOf(1).topLeft() - QPointF(300, 200)).manhattanLength() < 0.1);
    QVERIFY((layout().boxOf(1).bottomRight() - QPointF(500, 400)).manhattanLength() < 0.1);
}

void TestSurfaceCurveLayout::whatIsHiddenIsNotSeen()
{
    const SurfaceCurvePart front{Grip::Point, 1, 0};
    const SurfaceCurvePart behind{Grip::Point, 0, 0};
    QVERIFY(layout().isSeen(front) && !layout().isSeen(behind));
    QVERIFY(isNear(layout().pixelOf(behind), {325, 375}));
    QCOMPARE(partAt(325, 375).kind, Grip::None);
    QCOMPARE(partAt(400, 375).kind, Grip::None);
    m_content.selected = behind; // what is selected can be taken hold of
    QCOMPARE(partAt(325, 375), behind);
    QCOMPARE(layout().seenOf(1), std::vector<bool>(8, true));
    QCOMPARE(layout().seenOf(0), std::vector<bool>(8, false));
}

void TestSurfaceCurveLayout::whatIsSeenIsKeptUntilItIsForgotten()
{
    SurfaceView above = view(); // over the wall's edge
    above.camera.target = {0, 4.5F, 0};
    QVERIFY(!m_seen);
    QVERIFY(layout().isSeen({Grip::Point, 1, 1}));
    QVERIFY(m_seen);
    std::swap(m_content.curves[0], m_content.curves[1]);
    QVERIFY(!layout().isSeen({Grip::Point, 0, 1})); // as it was asked for first
    m_seen.reset();
    QVERIFY(layout().isSeen({Grip::Point, 0, 1}));
    QVERIFY(!SurfaceCurveLayout(m_content, above, m_seen).isSeen({Grip::Point, 0, 1})); // below the view
}

void TestSurfaceCurveLayout::pointsStandBeforePlacesOfTheirCurve()
{
    QCOMPARE(layout().pointBefore(1, {450, 400}), 0);
    QCOMPARE(layout().pointBefore(1, {500, 250}), 0);
    QCOMPARE(layout().pointBefore(1, {450, 200}), 1);
    m_content.curves[1].points = {2, 4};
    QCOMPARE(layout().pointBefore(1, {450, 400}), 1); // before the first comes the last
}

void TestSurfaceCurveLayout::pointsAreDraggedFromWhereTheyAreGrabbed()
{
    const SurfaceCurvePart point{Grip::Point, 1, 0};
    SurfaceCurveDrag drag(layout(), point, {304, 400});
    QCOMPARE(drag.point(), point);
    QVERIFY(!drag.moveTo(view(), {305, 401}, {}) && !drag.last()); // still a click
    const auto moved = drag.moveTo(view(), {384, 300}, Qt::AltModifier);
    QVERIFY(moved && !moved->snaps);
    QVERIFY((moved->pick.point - QVector3D(-0.2F, 0, 0)).length() < 1e-3F);
    QVERIFY(!drag.moveTo(view(), {700, 300}, {})); // beside the body
    QCOMPARE(drag.last()->pick.point, moved->pick.point);
    QVERIFY(drag.moveTo(view(), {304, 400}, {})); // back again is no click any more
}

void TestSurfaceCurveLayout::clicksDrawAndClose()
{
    SurfaceCurveDrawing drawing;
    drawing.hover(layout(), {480, 290}, {});
    QVERIFY(drawing.pointer() && drawing.pointer()->pick.vertex == wallVertex(3, 2));
    QVERIFY(!drawing.hasCursor());
    QVERIFY(drawing.leave() && !drawing.pointer() && !drawing.leave());
    const auto click = [this](double x, double y) {
        return SurfaceCurveDrawing::click(layout(), {x, y}, {});
    };
    QCOMPARE(click(400, 310).point->pick.vertex, wallVertex(2, 2));
    QVERIFY(!click(650, 300).point && !click(650, 300).isDone);
    QVERIFY(!click(300, 400).isDone); // nothing is drawn yet
    m_content.drawn = 1;
    QVERIFY(click(300, 411).isDone && !click(300, 411).point);
    QVERIFY(!click(300, 413).isDone);
    QVERIFY(!click(500, 200).isDone); // another point than the first
}

void TestSurfaceCurveLayout::keysDraw()
{
    SurfaceCurveDrawing drawing;
    drawing.moveCursor(layout(), Qt::Key_Right, {}); // comes to the middle of the view first
    QVERIFY(drawing.hasCursor() && drawing.pointer()->pick.vertex == wallVertex(2, 2));
    drawing.moveCursor(layout(), Qt::Key_Right, Qt::AltModifier);
    QVERIFY(drawing.pointer()->pick.vertex == wallVertex(3, 2) && !drawing.pointer()->snaps);
    QVERIFY(drawing.placeAtCursor(layout())->snaps);
    QCOMPARE(drawing.placeAtCursor(layout())->pick.vertex, wallVertex(3, 2));
    drawing.hover(layout(), {650, 300}, {}); // the pointer takes over
    QVERIFY(!drawing.hasCursor() && !drawing.pointer());
    m_content.drawn = 1;
    QCOMPARE(drawing.placeAtCursor(layout())->pick.vertex, wallVertex(3, 3)); // the last point
    m_content.drawn = -1;
    SurfaceView aside = view();
    aside.camera.target = {5, 0, 0};
    SurfaceCurveDrawing elsewhere;
    // The view's middle shows nothing: what is nearest to it.
    QCOMPARE(elsewhere.placeAtCursor({m_content, aside, m_seen})->pick.vertex, wallVertex(4, 2, true));
}

void TestSurfaceCurveLayout::curvesArePaintedFromPlainValues()
{
    const auto painted = [this](const SurfaceCurveLook& look, const SurfaceCurveDrawing* drawing) {
        QImage picture(800, 600, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintSurfaceCurves(painter, layout(), look);
        if (drawing != nullptr)
            paintSurfaceDrawing(painter, layout(), *drawing, look);
        return picture;
    };
    const auto greens = [](const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                count += color.alpha() > 200 && color.green() > 200 && color.red() < 80 ? 1 : 0;
            }
        return count;
    };
    const QImage plain = painted({}, nullptr);
    QVERIFY(greens(plain) > 800); // 800 pixels around, less handles and round corners
    QVERIFY(greens(painted({.hovered = {Grip::Curve, 1, 0}, .refusal = {}, .occupied = {}}, nullptr)) >
            greens(plain) + 100);
    m_content.curves[1].problem = QStringLiteral("It is open.");
    QCOMPARE(greens(painted({}, nullptr)), 0); // the one behind is faint
    m_content.drawn = 1;                       // what is still drawn is not wrong
    const SurfaceCurveLook drawn{.isDrawing = true, .hovered = {}, .refusal = {}, .occupied = {}};
    QVERIFY(greens(painted(drawn, nullptr)) > 400);
    SurfaceCurveDrawing drawing;
    drawing.hover(layout(), {400, 300}, {});
    QCOMPARE(painted(drawn, nullptr).pixelColor(400, 300).alpha(), 0);
    QVERIFY(painted(drawn, &drawing).pixelColor(400, 300).alpha() > 200);
}

QUADRILLE_QT_TEST(TestSurfaceCurveLayout);
#include "tst_surfacecurvelayout.moc"
