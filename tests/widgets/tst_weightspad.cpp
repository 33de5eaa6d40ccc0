// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/controls/weightspad.h"
#include "widgets/theme/theme.h"

#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

class TestWeightsPad : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void draggingTellsBothWeightsAndEndsOnce();
    void thePointStaysInTheSquare();
    void thePointClingsToLearnedNodes();
    void arrowsMoveByHundredthsAndTenths();
    void keysGoToTheEnds();
    void keysStayWithThePadWhileItHasTheFocus();
    void escapeGivesADragUp();
    void weightsFromElsewhereDoNotDisturbADrag();
    void drawsThePointWhereItLies();
    void namesItsCorners();

private:
    std::unique_ptr<WeightsPad> m_pad;
    std::unique_ptr<QSignalSpy> m_edited;
    QPoint at(double x, double y) { return m_pad->positionOf({x, y}).toPoint(); }
    QPointF told() const { return m_edited->last().at(0).toPointF(); }
    bool wasFinal() const { return m_edited->last().at(1).toBool(); }
    bool isNear(const QPointF& a, const QPointF& b) { return (a - b).manhattanLength() < 0.02; }
};

void TestWeightsPad::init()
{
    m_pad = std::make_unique<WeightsPad>();
    m_pad->resize(240, 260);
    m_pad->setCorners({QStringLiteral("short low"), QStringLiteral("long low"), QStringLiteral("short high"),
                       QStringLiteral("long high")});
    m_pad->setWeights({0.5, 0.5});
    m_pad->show();
    m_pad->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_pad.get()));
    m_pad->setFocus();
    m_edited = std::make_unique<QSignalSpy>(m_pad.get(), &WeightsPad::edited);
}

void TestWeightsPad::draggingTellsBothWeightsAndEndsOnce()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, at(0.2, 0.8));
    QVERIFY(isNear(told(), {0.2, 0.8}));
    QVERIFY(!wasFinal());
    QTest::mouseMove(m_pad.get(), at(0.3, 0.1));
    QVERIFY(isNear(told(), {0.3, 0.1}));
    QVERIFY(!wasFinal());
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, at(0.7, 0.1));
    QVERIFY(isNear(told(), {0.7, 0.1}));
    QVERIFY(wasFinal());
    QCOMPARE(m_pad->weights(), told());
    const auto count = m_edited->count();
    QTest::mouseMove(m_pad.get(), at(0.1, 0.1));
    QTest::mousePress(m_pad.get(), Qt::RightButton, {}, at(0.1, 0.1));
    QCOMPARE(m_edited->count(), count);
}

void TestWeightsPad::thePointStaysInTheSquare()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, at(0.5, 0.5));
    QTest::mouseMove(m_pad.get(), at(1.2, -0.1));
    QCOMPARE(told(), QPointF(1, 0));
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, at(-0.2, 1.1));
    QCOMPARE(told(), QPointF(0, 1));
    m_pad->setWeights({7, -7});
    QCOMPARE(m_pad->weights(), QPointF(1, 0));
}

void TestWeightsPad::thePointClingsToLearnedNodes()
{
    m_pad->setNodes({{0.333, 0.25}});
    QTest::mouseClick(m_pad.get(), Qt::LeftButton, {}, at(0.333, 0.25) + QPoint(3, -3));
    QCOMPARE(told(), QPointF(0.333, 0.25));
    QTest::mouseClick(m_pad.get(), Qt::LeftButton, {}, at(0.333, 0.25) + QPoint(20, 0));
    QVERIFY(told().x() > 0.36);
}

void TestWeightsPad::arrowsMoveByHundredthsAndTenths()
{
    QTest::keyClick(m_pad.get(), Qt::Key_Right);
    QCOMPARE(told(), QPointF(0.51, 0.5));
    QVERIFY(wasFinal());
    QTest::keyClick(m_pad.get(), Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(told(), QPointF(0.51, 0.6));
    QTest::keyClick(m_pad.get(), Qt::Key_Down);
    QTest::keyClick(m_pad.get(), Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(told(), QPointF(0.41, 0.59));
    m_pad->setWeights({0, 0.5});
    const auto count = m_edited->count();
    QTest::keyClick(m_pad.get(), Qt::Key_Left);
    QCOMPARE(m_edited->count(), count);
}

void TestWeightsPad::keysGoToTheEnds()
{
    QTest::keyClick(m_pad.get(), Qt::Key_Home);
    QCOMPARE(told(), QPointF(0, 0.5));
    QTest::keyClick(m_pad.get(), Qt::Key_PageUp);
    QCOMPARE(told(), QPointF(0, 1));
    QTest::keyClick(m_pad.get(), Qt::Key_End);
    QCOMPARE(told(), QPointF(1, 1));
    QTest::keyClick(m_pad.get(), Qt::Key_PageDown);
    QCOMPARE(told(), QPointF(1, 0));
}

void TestWeightsPad::keysStayWithThePadWhileItHasTheFocus()
{
    QKeyEvent right(QEvent::ShortcutOverride, Qt::Key_Right, Qt::NoModifier);
    right.ignore();
    QApplication::sendEvent(m_pad.get(), &right);
    QVERIFY(right.isAccepted());
    for (const auto& [key, modifiers] :
         {std::pair(Qt::Key_Space, Qt::NoModifier), std::pair(Qt::Key_Right, Qt::ControlModifier)}) {
        QKeyEvent other(QEvent::ShortcutOverride, key, modifiers);
        other.ignore();
        QApplication::sendEvent(m_pad.get(), &other);
        QVERIFY(!other.isAccepted());
    }
}

void TestWeightsPad::escapeGivesADragUp()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, at(0.1, 0.1));
    QTest::keyClick(m_pad.get(), Qt::Key_Escape);
    QCOMPARE(told(), QPointF(0.5, 0.5));
    QVERIFY(wasFinal());
    const auto count = m_edited->count();
    QTest::mouseMove(m_pad.get(), at(0.9, 0.9));
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, at(0.9, 0.9));
    QCOMPARE(m_edited->count(), count);
}

void TestWeightsPad::weightsFromElsewhereDoNotDisturbADrag()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, at(0.2, 0.2));
    const QPointF dragged = m_pad->weights();
    m_pad->setWeights({0.9, 0.9});
    QCOMPARE(m_pad->weights(), dragged);
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, at(0.2, 0.2));
    m_pad->setWeights({0.9, 0.9});
    QCOMPARE(m_pad->weights(), QPointF(0.9, 0.9));
}

void TestWeightsPad::drawsThePointWhereItLies()
{
    const QColor accent = Theme::color(ColorRole::Accent);
    m_pad->setWeights({0.25, 0.75});
    const QImage image = m_pad->grab().toImage();
    const double ratio = image.devicePixelRatio();
    QCOMPARE(image.pixelColor((m_pad->positionOf({0.25, 0.75}) * ratio).toPoint()), accent);
    QVERIFY(image.pixelColor((m_pad->positionOf({0.75, 0.25}) * ratio).toPoint()) != accent);
    // To the right and upwards.
    QVERIFY(at(1, 0).x() > at(0, 0).x() && at(0, 1).y() < at(0, 0).y());
}

void TestWeightsPad::namesItsCorners()
{
    const QImage before = m_pad->grab().toImage();
    m_pad->setCorners({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C"), QStringLiteral("D")});
    QVERIFY(m_pad->grab().toImage() != before);
    m_pad->setWeights({0.3, 0.8});
    QVERIFY(m_pad->accessibleDescription().contains(QStringLiteral("30")));
    QVERIFY(m_pad->accessibleDescription().contains(QStringLiteral("80")));
}

QUADRILLE_QT_TEST(TestWeightsPad);
#include "tst_weightspad.moc"
