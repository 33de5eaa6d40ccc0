// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Curves on a surface that are chosen, edited by keys and shown.
#include "surfacecurvefixture.h"
#include "tests/qt/registry.h"

using namespace quadrille::test;
using namespace quadrille::widgets;
using Mode = SurfaceCurveEditor::Mode;

class TestSurfaceCurveEdits : public SurfaceCurveFixture
{
    Q_OBJECT
private slots:
    void ctrlClickOnACurveInsertsAPoint();
    void aClickSelectsTheCurveAndDeleteAsks();
    void tabWalksOverAllPointsAndShowsThem();
    void arrowsMoveAPointToItsNeighbour();
    void aCurveCanBeDrawnByKeyboard();
    void theContextMenuIsOfWhatLiesThere();
    void aCurveWithAProblemHasASign();
    void nothingHappensWhileInactive();
    void trianglesGetColoursWithAKey();
};

void TestSurfaceCurveEdits::ctrlClickOnACurveInsertsAPoint()
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

void TestSurfaceCurveEdits::aClickSelectsTheCurveAndDeleteAsks()
{
    QSignalSpy curves(m_editor.get(), &SurfaceCurveEditor::curveRemovalRequested);
    QSignalSpy points(m_editor.get(), &SurfaceCurveEditor::pointRemovalRequested);
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

void TestSurfaceCurveEdits::tabWalksOverAllPointsAndShowsThem()
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

void TestSurfaceCurveEdits::arrowsMoveAPointToItsNeighbour()
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

void TestSurfaceCurveEdits::aCurveCanBeDrawnByKeyboard()
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

void TestSurfaceCurveEdits::theContextMenuIsOfWhatLiesThere()
{
    std::optional<SurfaceCurvePart> asked;
    connect(m_editor.get(), &SurfaceCurveEditor::contextMenuRequested, this,
            [&](const SurfaceCurvePart& part, const QPoint&) { asked = part; });
    m_editor->setCurves({ringCurve(6)});
    const QPoint at = pixel(vertexAt(6, 3));
    mouse(QEvent::MouseButtonPress, at, {}, Qt::RightButton);
    mouse(QEvent::MouseButtonRelease, at, {}, Qt::RightButton);
    QCOMPARE(asked, std::optional(SurfaceCurvePart{Kind::Curve, 0, 0}));
}

void TestSurfaceCurveEdits::aCurveWithAProblemHasASign()
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

void TestSurfaceCurveEdits::nothingHappensWhileInactive()
{
    m_editor->setCurves({ringCurve(6)});
    m_editor->setActive(false);
    click(pixel(vertexAt(6, 0)));
    QCOMPARE(m_editor->selected().kind, Kind::None);
    QImage empty(m_viewport->view()->size(), QImage::Format_ARGB32_Premultiplied);
    empty.fill(Qt::transparent);
    QCOMPARE(painted(), empty);
}

void TestSurfaceCurveEdits::trianglesGetColoursWithAKey()
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

QUADRILLE_QT_TEST(TestSurfaceCurveEdits);
#include "tst_surfacecurveedits.moc"
