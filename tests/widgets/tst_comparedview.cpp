// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/controls/comparedview.h"

#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <memory>

using namespace quadrille::widgets;

namespace {

QImage plainPicture(const QColor& colour)
{
    QImage image(200, 100, QImage::Format_RGBA8888);
    image.fill(colour);
    return image;
}

} // namespace

class TestComparedView : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void showsTheOtherRightOfTheLine();
    void draggingMovesTheLine();
    void keysWithShiftMoveTheLine();
    void withoutAnotherThereIsNoLine();
    void theTintLiesOverBoth();
    void draggingPaintsAStroke();
    void quickDabsAreStrokes();
    void theMiddleButtonMovesTheTextureUnderABrush();
    void keysPaintWithoutAMouse();
    void escapeGivesAStrokeUp();
    void withoutABrushNothingIsPainted();

private:
    std::unique_ptr<ComparedView> m_view;

    QPoint placeOf(double u, double v) const { return m_view->positionOf({u, v}).toPoint(); }
    QColor colourAt(double u, double v)
    {
        const QImage picture = m_view->grab().toImage();
        return picture.pixelColor((m_view->positionOf({u, v}) * picture.devicePixelRatio()).toPoint());
    }
    void compare() { m_view->setOther({plainPicture(Qt::blue), {}}); }
    bool isTaken(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
        event.ignore();
        QApplication::sendEvent(m_view.get(), &event);
        return event.isAccepted();
    }
};

void TestComparedView::init()
{
    m_view = std::make_unique<ComparedView>();
    m_view->resize(416, 316);
    m_view->setPicture({plainPicture(Qt::red), {}});
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
}

void TestComparedView::showsTheOtherRightOfTheLine()
{
    QCOMPARE(colourAt(0.9, 0.2), QColor(Qt::red));
    compare();
    QCOMPARE(colourAt(0.4, 0.2), QColor(Qt::red));
    QCOMPARE(colourAt(0.6, 0.2), QColor(Qt::blue));
    QSignalSpy moved(m_view.get(), &ComparedView::splitMoved);
    m_view->setSplit(0.8);
    QCOMPARE(colourAt(0.6, 0.2), QColor(Qt::red));
    QCOMPARE(colourAt(0.9, 0.2), QColor(Qt::blue));
    m_view->setSplit(7);
    QCOMPARE(m_view->split(), 1.0);
    QCOMPARE(moved.size(), 0);
}

void TestComparedView::draggingMovesTheLine()
{
    compare();
    QSignalSpy moved(m_view.get(), &ComparedView::splitMoved);
    QTest::mouseMove(m_view.get(), placeOf(0.5, 0.5));
    QTRY_COMPARE(m_view->cursor().shape(), Qt::SplitHCursor);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    QTest::mouseMove(m_view.get(), placeOf(0.25, 0.1));
    QCOMPARE(m_view->split(), 0.25);
    QTest::mouseMove(m_view.get(), QPoint(0, 10));
    QCOMPARE(m_view->split(), 0.0);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.1, 0.1));
    QCOMPARE(moved.size(), 2);
    QCOMPARE(moved.last().first().toDouble(), 0.0);
    QTest::mouseMove(m_view.get(), placeOf(0.7, 0.5));
    QTRY_VERIFY(m_view->cursor().shape() != Qt::SplitHCursor);
    QCOMPARE(m_view->split(), 0.0);
}

void TestComparedView::keysWithShiftMoveTheLine()
{
    compare();
    QVERIFY(isTaken(Qt::Key_Left, Qt::ShiftModifier));
    QTest::keyClick(m_view.get(), Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(m_view->split(), 0.55);
    QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::ShiftModifier);
    QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(m_view->split(), 0.45);
    QTest::keyClick(m_view.get(), Qt::Key_End, Qt::ShiftModifier);
    QCOMPARE(m_view->split(), 1.0);
    QTest::keyClick(m_view.get(), Qt::Key_Home, Qt::ShiftModifier);
    QCOMPARE(m_view->split(), 0.0);
    QVERIFY(!isTaken(Qt::Key_Home));
}

void TestComparedView::withoutAnotherThereIsNoLine()
{
    QVERIFY(!isTaken(Qt::Key_Left, Qt::ShiftModifier));
    QTest::keyClick(m_view.get(), Qt::Key_End, Qt::ShiftModifier);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    QTest::mouseMove(m_view.get(), placeOf(0.25, 0.5));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    QCOMPARE(m_view->split(), 0.5);
    // The line goes while it is dragged.
    compare();
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    m_view->setOther({});
    QTest::mouseMove(m_view.get(), placeOf(0.25, 0.5));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    QCOMPARE(m_view->split(), 0.5);
}

void TestComparedView::theTintLiesOverBoth()
{
    compare();
    QImage tint(2, 1, QImage::Format_RGBA8888);
    tint.fill(QColor(0, 255, 0, 255));
    m_view->setTint(tint);
    QCOMPARE(colourAt(0.2, 0.2), QColor(Qt::green));
    QCOMPARE(colourAt(0.8, 0.2), QColor(Qt::green));
    m_view->setTint({});
    QCOMPARE(colourAt(0.2, 0.2), QColor(Qt::red));
}

void TestComparedView::draggingPaintsAStroke()
{
    m_view->setBrush(TextureBrush{.radius = 0.05});
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    QTest::mouseMove(m_view.get(), placeOf(0.5, 0.75));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.75));
    QCOMPARE(painted.size(), 3);
    QVERIFY(!painted[1][1].toBool());
    QVERIFY(painted[2][1].toBool());
    QCOMPARE(painted[2][0].value<QList<QPointF>>(), (QList<QPointF>{{0.25, 0.5}, {0.5, 0.75}}));
    QCOMPARE(m_view->brushPlace(), QPointF(0.5, 0.75));
}

void TestComparedView::quickDabsAreStrokes()
{
    m_view->setBrush(TextureBrush{});
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.5, 0.5));
    const auto strokes = std::ranges::count_if(painted, [](const auto& each) { return each[1].toBool(); });
    QCOMPARE(strokes, 2);
    QVERIFY(m_view->isFitted());
}

void TestComparedView::theMiddleButtonMovesTheTextureUnderABrush()
{
    m_view->setBrush(TextureBrush{});
    m_view->zoomAbout({200, 150}, 4);
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    const QPointF before = m_view->positionOf({0.5, 0.5});
    QTest::mousePress(m_view.get(), Qt::MiddleButton, {}, {200, 150});
    QTest::mouseMove(m_view.get(), {230, 160});
    QTest::mouseRelease(m_view.get(), Qt::MiddleButton, {}, {230, 160});
    QVERIFY(m_view->positionOf({0.5, 0.5}) != before);
    QCOMPARE(painted.size(), 0);
}

void TestComparedView::keysPaintWithoutAMouse()
{
    m_view->setBrush(TextureBrush{.radius = 0.1});
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    QVERIFY(isTaken(Qt::Key_Space));
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QTest::keyClick(m_view.get(), Qt::Key_Up);
    QTest::keyClick(m_view.get(), Qt::Key_Up);
    QCOMPARE(m_view->brushPlace(), QPointF(0.55, 0.6));
    QTest::keyClick(m_view.get(), Qt::Key_Space);
    QCOMPARE(painted.size(), 1);
    QCOMPARE(painted[0][0].value<QList<QPointF>>(), (QList<QPointF>{{0.55, 0.6}}));
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(m_view.get(), Qt::Key_Left);
    QCOMPARE(m_view->brushPlace().x(), 0.0);
}

void TestComparedView::escapeGivesAStrokeUp()
{
    m_view->setBrush(TextureBrush{});
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    QSignalSpy cancelled(m_view.get(), &ComparedView::strokeCancelled);
    QVERIFY(!isTaken(Qt::Key_Escape));
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    QVERIFY(isTaken(Qt::Key_Escape));
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.3, 0.5));
    QCOMPARE(cancelled.size(), 1);
    QCOMPARE(painted.size(), 1);
    QVERIFY(!painted[0][1].toBool());
}

void TestComparedView::withoutABrushNothingIsPainted()
{
    QSignalSpy painted(m_view.get(), &ComparedView::strokePainted);
    QVERIFY(!isTaken(Qt::Key_Space));
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    m_view->setBrush(TextureBrush{});
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, placeOf(0.25, 0.5));
    m_view->setBrush(std::nullopt);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, placeOf(0.3, 0.5));
    QCOMPARE(painted.size(), 1);
    QVERIFY(!painted[0][1].toBool());
}

QUADRILLE_QT_TEST(TestComparedView);
#include "tst_comparedview.moc"
