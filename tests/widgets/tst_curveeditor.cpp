// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/charts/curveeditor.h"
#include "widgets/theme/theme.h"

#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

namespace {

constexpr double fps = 25;

} // namespace

class TestCurveEditor : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void draggingMovesAPointByFramesAndTellsOnce();
    void pointsStayBetweenTheirNeighbours();
    void escapeGivesADragUp();
    void doubleClickAddsAPoint();
    void keysChooseMoveAddAndRemove();
    void theFirstStaysAtTheBeginning();
    void keysThatAreNotOursAreLeftToTheWindow();
    void aPointThatIsDraggedIsNotExchanged();
    void drawsTheCurveThatItIsGiven();

private:
    std::unique_ptr<CurveEditor> m_editor;
    std::unique_ptr<QSignalSpy> m_edited;
    QPoint at(double time, double moment) { return m_editor->positionOf({time, moment}).toPoint(); }
    void drag(const QPoint& from, const QPoint& to)
    {
        QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, from);
        QTest::mouseMove(m_editor.get(), (from + to) / 2);
        QTest::mouseMove(m_editor.get(), to);
        QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, to);
    }
    bool wasCommitted() const { return m_edited->last().at(1).toBool(); }
};

void TestCurveEditor::init()
{
    m_editor = std::make_unique<CurveEditor>();
    m_editor->resize(600, 500);
    m_editor->setFps(fps);
    m_editor->setLength(4);
    m_editor->setPoints({{0, 0}, {2, 1}, {4, 4}});
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    m_edited = std::make_unique<QSignalSpy>(m_editor.get(), &CurveEditor::edited);
}

void TestCurveEditor::draggingMovesAPointByFramesAndTellsOnce()
{
    drag(at(2, 1), at(1.03, 2.52));
    QVERIFY(m_edited->size() >= 2);
    QVERIFY(!m_edited->first().at(1).toBool());
    QVERIFY(wasCommitted());
    const QPointF moved = m_editor->points()[1];
    QVERIFY(qAbs(moved.x() - 1.03) < 0.05 && qAbs(moved.y() - 2.52) < 0.05);
    // On a frame, both ways.
    QVERIFY(qAbs(moved.x() * fps - qRound(moved.x() * fps)) < 1e-9);
    QVERIFY(qAbs(moved.y() * fps - qRound(moved.y() * fps)) < 1e-9);
    // A click is no edit.
    m_edited->clear();
    QTest::mouseClick(m_editor.get(), Qt::LeftButton, {}, at(moved.x(), moved.y()));
    QCOMPARE(m_edited->size(), 0);
    QCOMPARE(m_editor->selected(), 1);
}

void TestCurveEditor::pointsStayBetweenTheirNeighbours()
{
    drag(at(2, 1), at(4.6, 2));
    QCOMPARE(m_editor->points()[1].x(), 4 - 1 / fps);
    drag(at(4 - 1 / fps, m_editor->points()[1].y()), at(2, 3.9));
    drag(at(0, 0), at(0, 3.99));
    const auto& points = m_editor->points();
    QVERIFY(points[0].y() <= points[1].y() && points[1].y() <= points[2].y());
    QCOMPARE(points[0].x(), 0.0);
    // Nothing beyond the end of the clip; later is allowed.
    drag(at(4, 4), QPoint(m_editor->width() - 30, 2));
    QVERIFY(m_editor->points()[2].x() > 4.2);
    QCOMPARE(m_editor->points()[2].y(), 4.0);
}

void TestCurveEditor::escapeGivesADragUp()
{
    const QList<QPointF> before = m_editor->points();
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, at(2, 1));
    QTest::mouseMove(m_editor.get(), at(3, 2));
    QVERIFY(m_editor->points() != before);
    QTest::keyClick(m_editor.get(), Qt::Key_Escape);
    QCOMPARE(m_editor->points(), before);
    QVERIFY(wasCommitted());
    QTest::mouseMove(m_editor.get(), at(1, 1));
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, at(1, 1));
    QCOMPARE(m_editor->points(), before);
}

void TestCurveEditor::doubleClickAddsAPoint()
{
    QTest::mouseDClick(m_editor.get(), Qt::LeftButton, {}, at(3, 2));
    QCOMPARE(m_editor->points().size(), 4);
    QCOMPARE(m_editor->selected(), 2);
    QVERIFY(wasCommitted());
    QVERIFY(qAbs(m_editor->points()[2].x() - 3) < 0.05);
    // Where its moment would go back it is held.
    QTest::mouseDClick(m_editor.get(), Qt::LeftButton, {}, at(1, 3));
    QCOMPARE(m_editor->points()[1].y(), 1.0);
    // On a point, nothing is added.
    const auto count = m_editor->points().size();
    QTest::mouseDClick(m_editor.get(), Qt::LeftButton, {}, at(4, 4));
    QCOMPARE(m_editor->points().size(), count);
}

void TestCurveEditor::keysChooseMoveAddAndRemove()
{
    m_editor->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_editor.get()));
    m_editor->setFocus(Qt::TabFocusReason);
    QCOMPARE(m_editor->selected(), 0);
    QTest::keyClick(m_editor.get(), Qt::Key_PageDown);
    QCOMPARE(m_editor->selected(), 1);
    QTest::keyClick(m_editor.get(), Qt::Key_Right);
    QTest::keyClick(m_editor.get(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(qAbs(m_editor->points()[1].x() - (2 + 1 / fps)) < 1e-9);
    QVERIFY(qAbs(m_editor->points()[1].y() - (1 + 10 / fps)) < 1e-9);
    QTest::keyClick(m_editor.get(), Qt::Key_Left);
    QTest::keyClick(m_editor.get(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(qAbs(m_editor->points()[1].x() - 2) < 1e-9 && qAbs(m_editor->points()[1].y() - 1) < 1e-9);
    QTest::keyClick(m_editor.get(), Qt::Key_Insert);
    QCOMPARE(m_editor->points().size(), 4);
    QCOMPARE(m_editor->selected(), 2);
    QCOMPARE(m_editor->points()[2], QPointF(3, 2.5));
    QTest::keyClick(m_editor.get(), Qt::Key_Delete);
    QCOMPARE(m_editor->points().size(), 3);
    QVERIFY(wasCommitted());
    // The last one stays.
    QTest::keyClick(m_editor.get(), Qt::Key_PageDown);
    QCOMPARE(m_editor->selected(), 2);
    QTest::keyClick(m_editor.get(), Qt::Key_Delete);
    QCOMPARE(m_editor->points().size(), 3);
}

void TestCurveEditor::theFirstStaysAtTheBeginning()
{
    drag(at(0, 0), at(1, 0.5));
    QCOMPARE(m_editor->points()[0].x(), 0.0);
    QVERIFY(qAbs(m_editor->points()[0].y() - 0.5) < 0.05);
    const auto count = m_edited->size();
    QTest::keyClick(m_editor.get(), Qt::Key_Left);
    QCOMPARE(m_edited->size(), count);
}

void TestCurveEditor::keysThatAreNotOursAreLeftToTheWindow()
{
    const auto isTaken = [this](Qt::Key key) {
        QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
        event.ignore();
        QApplication::sendEvent(m_editor.get(), &event);
        return event.isAccepted();
    };
    QVERIFY(!isTaken(Qt::Key_Right) && !isTaken(Qt::Key_Escape) && !isTaken(Qt::Key_Space));
    m_editor->select(1);
    QVERIFY(isTaken(Qt::Key_Right) && isTaken(Qt::Key_Delete));
    QVERIFY(!isTaken(Qt::Key_Space));
}

void TestCurveEditor::aPointThatIsDraggedIsNotExchanged()
{
    // What a document tells back while a point is dragged is that drag.
    connect(m_editor.get(), &CurveEditor::edited, m_editor.get(), [this](const QList<QPointF>&, bool) {
        m_editor->setPoints({{0, 0}, {4, 4}});
    });
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, at(2, 1));
    QTest::mouseMove(m_editor.get(), at(3, 2));
    QCOMPARE(m_editor->points().size(), 3);
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, at(3, 2));
    QCOMPARE(m_editor->points().size(), 2);
}

void TestCurveEditor::drawsTheCurveThatItIsGiven()
{
    const auto isCurve = [this](double time, double moment) {
        const QImage picture = m_editor->grab().toImage();
        const QColor color =
            picture.pixelColor((m_editor->positionOf({time, moment}) * picture.devicePixelRatio()).toPoint());
        return Theme::contrast(color, Theme::color(ColorRole::Base)) > 2;
    };
    QVERIFY(isCurve(1.03, 0.515));
    QVERIFY(!isCurve(1.03, 0.88));
    m_editor->setInterpolation([](const QList<QPointF>&) -> CurveEditor::Curve {
        return [](double time) { return time < 0.5 ? 0 : time < 3 ? 0.88 : 4; };
    });
    QVERIFY(isCurve(1.03, 0.88));
    QVERIFY(!isCurve(1.03, 0.515));
}

QUADRILLE_QT_TEST(TestCurveEditor);
#include "tst_curveeditor.moc"
