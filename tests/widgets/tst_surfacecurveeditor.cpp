// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/viewport/surfacecurveeditor.h"
#include "widgets/viewport/surfacevisibility.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <memory>

using namespace quadrille::widgets;
using Kind = SurfaceCurvePart::Kind;
using Mode = SurfaceCurveEditor::Mode;

namespace {

constexpr std::uint32_t around = 24; // vertices of a ring
constexpr std::uint32_t rings = 11;

/// An upright tube of radius 0.4 and height 2, without ends; vertex 0 of each ring is in front (+z), the
/// next ones go to the right.
FigureMesh tube()
{
    FigureMesh mesh;
    mesh.vertexCount = around * rings;
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = ring * around + i;
            const std::uint32_t b = ring * around + (i + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    return mesh;
}

std::vector<float> tubePositions()
{
    std::vector<float> positions;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2.0 * M_PI * i / around;
            positions.push_back(static_cast<float>(0.4 * std::sin(angle)));
            positions.push_back(0.2F * static_cast<float>(ring) - 1.0F);
            positions.push_back(static_cast<float>(0.4 * std::cos(angle)));
        }
    return positions;
}

constexpr std::uint32_t vertexAt(std::uint32_t ring, std::uint32_t i)
{
    return ring * around + i;
}

/// A whole ring, with points in front, behind and at both sides.
ShownCurve ringCurve(std::uint32_t ring, const QString& name = {})
{
    ShownCurve curve;
    curve.name = name;
    for (std::uint32_t i = 0; i < around; ++i)
        curve.vertices.push_back(vertexAt(ring, i));
    curve.points = {0, 6, 12, 18};
    curve.color = Theme::color(ColorRole::Text);
    return curve;
}

} // namespace

class TestSurfaceCurveEditor : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void whatTheBodyHidesIsNotSeen();
    void aClickOnTheSurfaceAddsAPointAndAnotherBesideItNone();
    void aDragWhileDrawingTurnsTheView();
    void thePointerIsToldWhileDrawing();
    void aClickOnTheFirstPointEndsDrawing();
    void returnEndsEscapeLeavesBackspaceTakesBack();
    void draggingAPointMovesItAndCommitsOnce();
    void altKeepsAPointFromSnapping();
    void aDragBesideTheBodyKeepsTheLastPlace();
    void escapeTakesADragBack();
    void pointsBehindTheBodyCannotBeGrabbed();
    void ctrlClickOnACurveInsertsAPoint();
    void aClickSelectsTheCurveAndDeleteAsks();
    void tabWalksOverAllPointsAndShowsThem();
    void arrowsMoveAPointToItsNeighbour();
    void aCurveCanBeDrawnByKeyboard();
    void theContextMenuIsOfWhatLiesThere();
    void aCurveWithAProblemHasASign();
    void nothingHappensWhileInactive();
    void trianglesGetColoursWithAKey();

private:
    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<SurfaceCurveEditor> m_editor;
    int m_figure = -1;
    std::vector<SurfacePlace> m_added;
    QPoint pixel(std::uint32_t vertex) const;
    void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton);
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
    void key(int code, Qt::KeyboardModifiers modifiers = {});
    QImage painted() const;
};

void TestSurfaceCurveEditor::init()
{
    QVERIFY(VtkView::openGlAvailable());
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(800, 600);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    m_figure = m_viewport->addFigure(tube());
    m_viewport->setPositions(m_figure, tubePositions());
    Turntable camera;
    camera.target = {0, 0, 0};
    camera.yaw = 0;
    camera.pitch = 0;
    camera.distance = 6;
    m_viewport->setCamera(camera);
    m_editor = std::make_unique<SurfaceCurveEditor>(*m_viewport);
    m_editor->setFigure(m_figure);
    m_added.clear();
    connect(m_editor.get(), &SurfaceCurveEditor::pointAdded, this,
            [this](const SurfacePlace& place) { m_added.push_back(place); });
    m_viewport->setViewTool(m_editor.get());
    m_viewport->view()->setFocus();
}

void TestSurfaceCurveEditor::cleanup()
{
    m_editor.reset();
    m_viewport.reset();
}

QPoint TestSurfaceCurveEditor::pixel(std::uint32_t vertex) const
{
    const auto shape = m_viewport->figureShape(m_figure);
    QPointF at;
    m_viewport->camera().project(shape->place(vertex), m_viewport->view()->size(), &at);
    return at.toPoint();
}

void TestSurfaceCurveEditor::mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers,
                                   Qt::MouseButton button)
{
    QWidget* view = m_viewport->view();
    const bool isRelease = type == QEvent::MouseButtonRelease;
    const Qt::MouseButtons buttons = isRelease ? Qt::NoButton : Qt::MouseButtons(button);
    QMouseEvent event(type, at, view->mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                      buttons, modifiers);
    QApplication::sendEvent(view, &event);
}

void TestSurfaceCurveEditor::click(const QPoint& at, Qt::KeyboardModifiers modifiers)
{
    QTest::mouseMove(m_viewport->view(), at);
    mouse(QEvent::MouseButtonPress, at, modifiers);
    mouse(QEvent::MouseButtonRelease, at, modifiers);
}

void TestSurfaceCurveEditor::key(int code, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_viewport->view(), static_cast<Qt::Key>(code), modifiers);
}

QImage TestSurfaceCurveEditor::painted() const
{
    QImage picture(m_viewport->view()->size(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    m_editor->paint(painter);
    return picture;
}

void TestSurfaceCurveEditor::whatTheBodyHidesIsNotSeen()
{
    const auto shape = m_viewport->figureShape(m_figure);
    const std::vector<std::uint32_t> asked{vertexAt(5, 0), vertexAt(5, 3), vertexAt(5, 12), vertexAt(5, 15)};
    const auto visible = visibleVertices(*shape, m_viewport->camera(), m_viewport->size(), asked);
    QCOMPARE(visible, (std::vector<bool>{true, true, false, false}));
    Turntable behind = m_viewport->camera();
    behind.yaw = 180;
    QCOMPARE(visibleVertices(*shape, behind, m_viewport->size(), asked),
             (std::vector<bool>{false, false, true, true}));
}

void TestSurfaceCurveEditor::aClickOnTheSurfaceAddsAPointAndAnotherBesideItNone()
{
    m_editor->setMode(Mode::Draw);
    click(pixel(vertexAt(5, 1)));
    QCOMPARE(m_added.size(), std::size_t{1});
    QCOMPARE(m_added[0].pick.vertex, vertexAt(5, 1));
    QVERIFY(m_added[0].snaps);
    click({5, 5});
    QCOMPARE(m_added.size(), std::size_t{1});
    click(pixel(vertexAt(6, 2)), Qt::AltModifier);
    QCOMPARE(m_added.size(), std::size_t{2});
    QVERIFY(!m_added[1].snaps);
}

void TestSurfaceCurveEditor::aDragWhileDrawingTurnsTheView()
{
    m_editor->setMode(Mode::Draw);
    const float yaw = m_viewport->camera().yaw;
    const QPoint from = pixel(vertexAt(5, 0));
    mouse(QEvent::MouseButtonPress, from);
    mouse(QEvent::MouseMove, from + QPoint(60, 0));
    mouse(QEvent::MouseButtonRelease, from + QPoint(60, 0));
    QVERIFY(m_viewport->camera().yaw != yaw);
    QVERIFY(m_added.empty());
}

void TestSurfaceCurveEditor::thePointerIsToldWhileDrawing()
{
    std::optional<std::uint32_t> under;
    connect(m_editor.get(), &SurfaceCurveEditor::pointerMoved, this,
            [&](const std::optional<SurfacePlace>& place) {
                under = place ? std::optional(place->pick.vertex) : std::nullopt;
            });
    m_editor->setMode(Mode::Draw);
    QTest::mouseMove(m_viewport->view(), pixel(vertexAt(5, 2)));
    QTRY_COMPARE(under, std::optional(vertexAt(5, 2)));
    QTest::mouseMove(m_viewport->view(), QPoint(3, 3));
    QTRY_COMPARE(under, std::optional<std::uint32_t>());
}

void TestSurfaceCurveEditor::aClickOnTheFirstPointEndsDrawing()
{
    QSignalSpy finished(m_editor.get(), &SurfaceCurveEditor::drawingFinished);
    m_editor->setCurves({ringCurve(5)});
    m_editor->setMode(Mode::Draw);
    m_editor->setDrawn(0);
    click(pixel(vertexAt(5, 2)));
    QCOMPARE(m_added.size(), std::size_t{1});
    click(pixel(vertexAt(5, 0)));
    QCOMPARE(m_added.size(), std::size_t{1});
    QCOMPARE(finished.count(), 1);
    QCOMPARE(m_editor->mode(), Mode::Edit);
}

void TestSurfaceCurveEditor::returnEndsEscapeLeavesBackspaceTakesBack()
{
    QSignalSpy finished(m_editor.get(), &SurfaceCurveEditor::drawingFinished);
    QSignalSpy removed(m_editor.get(), &SurfaceCurveEditor::lastPointRemovalAsked);
    m_editor->setCurves({ringCurve(5)});
    m_editor->setMode(Mode::Draw);
    m_editor->setDrawn(0);
    key(Qt::Key_Backspace);
    QCOMPARE(removed.count(), 1);
    key(Qt::Key_Escape);
    QCOMPARE(m_editor->mode(), Mode::Edit);
    QCOMPARE(finished.count(), 0);
    m_editor->setMode(Mode::Draw);
    key(Qt::Key_Return);
    QCOMPARE(m_editor->mode(), Mode::Edit);
    QCOMPARE(finished.count(), 1);
}

void TestSurfaceCurveEditor::draggingAPointMovesItAndCommitsOnce()
{
    struct Move
    {
        int curve, point;
        std::uint32_t vertex;
        bool committed;
        bool operator==(const Move&) const = default;
    };
    std::vector<Move> moves;
    connect(m_editor.get(), &SurfaceCurveEditor::pointMoved, this,
            [&](int curve, int point, const SurfacePlace& place, bool committed) {
                moves.push_back({curve, point, place.pick.vertex, committed});
            });
    m_editor->setCurves({ringCurve(3), ringCurve(6)});
    const QPoint from = pixel(vertexAt(6, 0));
    const QPoint to = pixel(vertexAt(8, 1));
    const float yaw = m_viewport->camera().yaw;
    mouse(QEvent::MouseButtonPress, from);
    QVERIFY(m_editor->isDragging());
    mouse(QEvent::MouseMove, (from + to) / 2);
    mouse(QEvent::MouseMove, to);
    QVERIFY(moves.size() >= 2);
    QVERIFY(!moves.back().committed);
    mouse(QEvent::MouseButtonRelease, to);
    QCOMPARE(moves.back(), (Move{1, 0, vertexAt(8, 1), true}));
    QCOMPARE(std::count_if(moves.begin(), moves.end(), [](const Move& move) { return move.committed; }), 1);
    QCOMPARE(m_viewport->camera().yaw, yaw);
    QCOMPARE(m_editor->selected(), (SurfaceCurvePart{Kind::Point, 1, 0}));
}

void TestSurfaceCurveEditor::altKeepsAPointFromSnapping()
{
    bool snaps = true;
    connect(m_editor.get(), &SurfaceCurveEditor::pointMoved, this,
            [&](int, int, const SurfacePlace& place, bool) { snaps = place.snaps; });
    m_editor->setCurves({ringCurve(6)});
    mouse(QEvent::MouseButtonPress, pixel(vertexAt(6, 0)));
    mouse(QEvent::MouseMove, pixel(vertexAt(7, 1)), Qt::AltModifier);
    QVERIFY(!snaps);
    mouse(QEvent::MouseMove, pixel(vertexAt(8, 1)));
    QVERIFY(snaps);
    mouse(QEvent::MouseButtonRelease, pixel(vertexAt(8, 1)));
}

void TestSurfaceCurveEditor::aDragBesideTheBodyKeepsTheLastPlace()
{
    std::uint32_t vertex = 0;
    connect(m_editor.get(), &SurfaceCurveEditor::pointMoved, this,
            [&](int, int, const SurfacePlace& place, bool) { vertex = place.pick.vertex; });
    m_editor->setCurves({ringCurve(6)});
    mouse(QEvent::MouseButtonPress, pixel(vertexAt(6, 0)));
    mouse(QEvent::MouseMove, pixel(vertexAt(8, 1)));
    mouse(QEvent::MouseMove, {4, 4});
    mouse(QEvent::MouseButtonRelease, {4, 4});
    QCOMPARE(vertex, vertexAt(8, 1));
}

void TestSurfaceCurveEditor::escapeTakesADragBack()
{
    QSignalSpy cancelled(m_editor.get(), &SurfaceCurveEditor::moveCancelled);
    int committed = 0;
    connect(m_editor.get(), &SurfaceCurveEditor::pointMoved, this,
            [&](int, int, const SurfacePlace&, bool isFinal) { committed += isFinal ? 1 : 0; });
    m_editor->setCurves({ringCurve(6)});
    mouse(QEvent::MouseButtonPress, pixel(vertexAt(6, 0)));
    mouse(QEvent::MouseMove, pixel(vertexAt(8, 1)));
    key(Qt::Key_Escape);
    QCOMPARE(cancelled.count(), 1);
    mouse(QEvent::MouseButtonRelease, pixel(vertexAt(8, 1)));
    QCOMPARE(committed, 0);
}

void TestSurfaceCurveEditor::pointsBehindTheBodyCannotBeGrabbed()
{
    Turntable camera = m_viewport->camera();
    camera.pitch = 20; // the ring's back lies higher on the view than its front
    m_viewport->setCamera(camera);
    m_editor->setCurves({ringCurve(4)});
    QCOMPARE(m_editor->partAt(pixel(vertexAt(4, 0))), (SurfaceCurvePart{Kind::Point, 0, 0}));
    QCOMPARE(m_editor->partAt(pixel(vertexAt(4, 12))).kind, Kind::None);
    m_editor->setSelected({Kind::Point, 0, 2});
    QCOMPARE(m_editor->partAt(pixel(vertexAt(4, 12))), (SurfaceCurvePart{Kind::Point, 0, 2}));
}

void TestSurfaceCurveEditor::ctrlClickOnACurveInsertsAPoint()
{
    QSignalSpy inserted(m_editor.get(), &SurfaceCurveEditor::pointInserted);
    m_editor->setCurves({ringCurve(3), ringCurve(6)});
    click(pixel(vertexAt(6, 3)), Qt::ControlModifier);
    QCOMPARE(inserted.count(), 1);
    QCOMPARE(inserted[0][0].toInt(), 1);
    QCOMPARE(inserted[0][1].toInt(), 0);
    const QPoint left = pixel(vertexAt(6, 21));
    mouse(QEvent::MouseButtonDblClick, left);
    QCOMPARE(inserted.count(), 2);
    QCOMPARE(inserted[1][1].toInt(), 3); // after the last point, before the first
}

void TestSurfaceCurveEditor::aClickSelectsTheCurveAndDeleteAsks()
{
    QSignalSpy curves(m_editor.get(), &SurfaceCurveEditor::curveRemovalAsked);
    QSignalSpy points(m_editor.get(), &SurfaceCurveEditor::pointRemovalAsked);
    m_editor->setCurves({ringCurve(3), ringCurve(6)});
    click(pixel(vertexAt(6, 3)));
    QCOMPARE(m_editor->selected(), (SurfaceCurvePart{Kind::Curve, 1, 0}));
    key(Qt::Key_Delete);
    QCOMPARE(curves.count(), 1);
    QCOMPARE(curves[0][0].toInt(), 1);
    click(pixel(vertexAt(3, 0)));
    key(Qt::Key_Delete);
    QCOMPARE(points.count(), 1);
    QCOMPARE(points[0][0].toInt(), 0);
    click({5, 5});
    QCOMPARE(m_editor->selected().kind, Kind::None);
}

void TestSurfaceCurveEditor::tabWalksOverAllPointsAndShowsThem()
{
    m_editor->setCurves({ringCurve(3), ringCurve(6)});
    for (int curve = 0; curve < 2; ++curve)
        for (int point = 0; point < 4; ++point) {
            key(Qt::Key_Tab);
            const SurfaceCurvePart part{Kind::Point, curve, point};
            QCOMPARE(m_editor->selected(), part);
            QVERIFY(m_editor->isSeen(part));
        }
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(m_editor->selected(), (SurfaceCurvePart{Kind::Point, 1, 2}));
}

void TestSurfaceCurveEditor::arrowsMoveAPointToItsNeighbour()
{
    std::vector<std::uint32_t> moves;
    connect(m_editor.get(), &SurfaceCurveEditor::pointMoved, this,
            [&](int, int, const SurfacePlace& place, bool committed) {
                QVERIFY(committed);
                moves.push_back(place.pick.vertex);
            });
    m_editor->setCurves({ringCurve(6)});
    m_editor->setSelected({Kind::Point, 0, 0});
    key(Qt::Key_Right);
    key(Qt::Key_Up);
    key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(moves, (std::vector{vertexAt(6, 1), vertexAt(7, 0), vertexAt(10, 0)}));
}

void TestSurfaceCurveEditor::aCurveCanBeDrawnByKeyboard()
{
    m_editor->setMode(Mode::Draw);
    key(Qt::Key_Insert);
    QCOMPARE(m_added.size(), std::size_t{1});
    const std::uint32_t first = m_added[0].pick.vertex;
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    key(Qt::Key_Insert);
    QCOMPARE(m_added.size(), std::size_t{2});
    QCOMPARE(m_added[1].pick.vertex, first + 2);
}

void TestSurfaceCurveEditor::theContextMenuIsOfWhatLiesThere()
{
    std::optional<SurfaceCurvePart> asked;
    connect(m_editor.get(), &SurfaceCurveEditor::contextMenuAsked, this,
            [&](const SurfaceCurvePart& part, const QPoint&) { asked = part; });
    m_editor->setCurves({ringCurve(6)});
    const QPoint at = pixel(vertexAt(6, 3));
    mouse(QEvent::MouseButtonPress, at, {}, Qt::RightButton);
    mouse(QEvent::MouseButtonRelease, at, {}, Qt::RightButton);
    QCOMPARE(asked, std::optional(SurfaceCurvePart{Kind::Curve, 0, 0}));
}

void TestSurfaceCurveEditor::aCurveWithAProblemHasASign()
{
    const auto reds = [](const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                count += color.alpha() > 200 && color.red() > 180 && color.green() < 110 ? 1 : 0;
            }
        return count;
    };
    ShownCurve curve = ringCurve(6, QStringLiteral("waist"));
    m_editor->setCurves({curve});
    QCOMPARE(reds(painted()), 0);
    const QImage before = painted();
    curve.problem = QStringLiteral("It is open.");
    m_editor->setCurves({curve});
    QVERIFY(reds(painted()) > 100);
    QVERIFY(painted() != before);
}

void TestSurfaceCurveEditor::nothingHappensWhileInactive()
{
    m_editor->setCurves({ringCurve(6)});
    m_editor->setActive(false);
    click(pixel(vertexAt(6, 0)));
    QCOMPARE(m_editor->selected().kind, Kind::None);
    QImage empty(m_viewport->view()->size(), QImage::Format_ARGB32_Premultiplied);
    empty.fill(Qt::transparent);
    QCOMPARE(painted(), empty);
}

void TestSurfaceCurveEditor::trianglesGetColoursWithAKey()
{
    const std::size_t count = tube().triangles.size();
    std::vector<QRgb> colors(count, qRgb(0, 0, 255));
    const ColorKey key{.title = QStringLiteral("Parts"), .items = {{QStringLiteral("tube"), Qt::blue}}};
    m_viewport->setShading(Shading::Scalar);
    m_viewport->setTriangleColors(m_figure, colors, key);
    const auto blues = [&](bool annotations) {
        const QImage picture = m_viewport->snapshot({.size = {}, .annotations = annotations});
        int found = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                found += color.blue() > 60 && color.red() < 30 && color.green() < 30 ? 1 : 0;
            }
        return found;
    };
    const int bare = blues(false);
    QVERIFY(bare > 5000);
    QVERIFY(blues(true) > bare);
    m_viewport->setTriangleColors(m_figure, {}, {});
    QCOMPARE(blues(true), 0);
}

QTEST_MAIN(TestSurfaceCurveEditor)
#include "tst_surfacecurveeditor.moc"
