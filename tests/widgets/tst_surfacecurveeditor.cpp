// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Curves that are drawn on a surface, and points that are dragged.
#include "surfacecurvefixture.h"
#include "tests/qt/registry.h"
#include "widgets/tools/smoothline.h"

#include <cmath>

using namespace quadrille::test;
using namespace quadrille::widgets;
using Mode = SurfaceCurveEditor::Mode;

class TestSurfaceCurveEditor : public SurfaceCurveFixture
{
    Q_OBJECT
private slots:
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
    void aLineIsDrawnWithoutTheZigzagOfItsEdges();
};

void TestSurfaceCurveEditor::aLineIsDrawnWithoutTheZigzagOfItsEdges()
{
    std::vector<QVector3D> zigzag;
    for (int i = 0; i < 12; ++i)
        zigzag.emplace_back(static_cast<float>(i), i % 2 == 0 ? 0.1F : -0.1F, 0.0F);
    const auto smooth = withoutZigzag(zigzag, {6}, false);
    QCOMPARE(smooth.size(), zigzag.size());
    for (const std::size_t end : {std::size_t{0}, std::size_t{6}, std::size_t{11}})
        QCOMPARE(smooth[end], zigzag[end]);
    for (const std::size_t inside : {std::size_t{3}, std::size_t{9}})
        QVERIFY(std::abs(smooth[inside].y()) < 0.02F);
    // Places go through a line's own, and a straight line stays straight.
    const std::vector<QVector3D> straight{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
    QCOMPARE(smoothPlace(straight, 1, 0.0F, false), straight[1]);
    QCOMPARE(smoothPlace(straight, 1, 1.0F, false), straight[2]);
    QVERIFY((smoothPlace(straight, 1, 0.5F, false) - QVector3D(1.5F, 1.5F, 0)).length() < 1e-6F);
    // A regular ring stays one; only its radius shrinks, without corners.
    std::vector<QVector3D> ring;
    for (int i = 0; i < 24; ++i)
        ring.emplace_back(std::cos(static_cast<float>(i) * 0.2617994F),
                          std::sin(static_cast<float>(i) * 0.2617994F), 0.0F);
    const auto round = withoutZigzag(ring, {}, true);
    for (const QVector3D& place : round)
        QVERIFY(std::abs(place.length() - round[0].length()) < 1e-5F);
    QVERIFY(std::abs(smoothPlace(round, 23, 0.5F, true).length() - round[0].length()) < 1e-3F);
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
    QSignalSpy removed(m_editor.get(), &SurfaceCurveEditor::lastPointRemovalRequested);
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

QUADRILLE_QT_TEST(TestSurfaceCurveEditor);
#include "tst_surfacecurveeditor.moc"
