// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/graph/barchart.h"

#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

class TestBarChart : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void barsBeginAtZeroAndAreAsLongAsTheirValues();
    void whatWasNotMeasuredHasNoBar();
    void hoveringReadsACategory();
    void keysReadFromCategoryToCategory();
    void valuesAreCopiedAsCsv();
    void itIsAsHighAsItsBarsNeed();
    void namesLeaveRoomForBars();

private:
    QColor colorAt(const QPointF& place) const;

    std::unique_ptr<BarChart> m_chart;
};

void TestBarChart::init()
{
    m_chart = std::make_unique<BarChart>();
    m_chart->setBars({"Slide", "m/s", false}, {"walk", "run \"fast\"", "jump"},
                     {{"take", Qt::blue, {4.0, 2.0, -2.0}}, {"clip", Qt::red, {1.0, std::nullopt, 0.0}}});
    m_chart->resize(480, 300);
    m_chart->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_chart.get()));
    QTest::mouseMove(m_chart.get(), {2, 2});
}

QColor TestBarChart::colorAt(const QPointF& place) const
{
    const QImage picture = m_chart->grab().toImage();
    return picture.pixelColor((place * picture.devicePixelRatio()).toPoint());
}

void TestBarChart::barsBeginAtZeroAndAreAsLongAsTheirValues()
{
    const QRectF four = m_chart->barOf(0, 0);
    const QRectF two = m_chart->barOf(1, 0);
    const QRectF less = m_chart->barOf(2, 0);
    const QRectF nothing = m_chart->barOf(2, 1);
    QVERIFY(std::abs(four.width() - 2 * two.width()) < 1e-6);
    QVERIFY(std::abs(less.width() - two.width()) < 1e-6);
    QVERIFY(std::abs(four.left() - two.left()) < 1e-6);
    QVERIFY(std::abs(less.right() - four.left()) < 1e-6);
    QVERIFY(nothing.width() < 1e-6);
    QVERIFY(four.bottom() <= m_chart->barOf(0, 1).top());
    QVERIFY(m_chart->barOf(0, 1).bottom() < two.top());
    QCOMPARE(colorAt(four.center()), QColor(Qt::blue));
    QCOMPARE(colorAt(less.center()), QColor(Qt::blue));
}

void TestBarChart::whatWasNotMeasuredHasNoBar()
{
    const QRectF above = m_chart->barOf(1, 0);
    const QPointF below = above.center() + QPointF(0, above.height() + 2);
    QVERIFY(colorAt(below) != QColor(Qt::red));
    QTest::keyClick(m_chart.get(), Qt::Key_Home);
    QTest::keyClick(m_chart.get(), Qt::Key_Down);
    QCOMPARE(m_chart->readOut(), QString("run \"fast\"; take: 2 m/s; clip: not measured"));
}

void TestBarChart::hoveringReadsACategory()
{
    QCOMPARE(m_chart->readOut(), QString());
    QSignalSpy moved(m_chart.get(), &BarChart::readingMoved);
    QTest::mouseMove(m_chart.get(), m_chart->barOf(0, 1).center().toPoint());
    QTRY_COMPARE(m_chart->readOut(), QString("walk; take: 4 m/s; clip: 1 m/s"));
    QCOMPARE(m_chart->toolTip(), QString("walk\ntake: 4 m/s\nclip: 1 m/s"));
    QCOMPARE(moved.size(), 1);
    QVERIFY(moved[0][0].toInt() <= m_chart->barOf(0, 0).top());
    QVERIFY(moved[0][1].toInt() >= m_chart->barOf(0, 1).bottom());
    QTest::mouseMove(m_chart.get(), {200, 299});
    QTRY_COMPARE(m_chart->readOut(), QString());
}

void TestBarChart::keysReadFromCategoryToCategory()
{
    QTest::keyClick(m_chart.get(), Qt::Key_Up);
    QCOMPARE(m_chart->accessibleDescription(), QString("jump; take: -2 m/s; clip: 0 m/s"));
    QTest::keyClick(m_chart.get(), Qt::Key_Down);
    QVERIFY(m_chart->readOut().startsWith("jump"));
    QTest::keyClick(m_chart.get(), Qt::Key_Home);
    QVERIFY(m_chart->readOut().startsWith("walk"));
    QTest::keyClick(m_chart.get(), Qt::Key_Up);
    QVERIFY(m_chart->readOut().startsWith("walk"));
    QTest::keyClick(m_chart.get(), Qt::Key_End);
    QVERIFY(m_chart->readOut().startsWith("jump"));
}

void TestBarChart::valuesAreCopiedAsCsv()
{
    QTest::keyClick(m_chart.get(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QString("\"Slide\",\"take (m/s)\",\"clip (m/s)\"\n"
                                                        "\"walk\",4,1\n"
                                                        "\"run \"\"fast\"\"\",2,\n"
                                                        "\"jump\",-2,0\n"));
}

void TestBarChart::itIsAsHighAsItsBarsNeed()
{
    const int before = m_chart->minimumSizeHint().height();
    m_chart->setBars({"Slide", "m/s", false}, {"a", "b", "c", "d", "e"},
                     {{"take", Qt::blue, {1, 2, 3, 4, 5}}});
    QVERIFY(m_chart->minimumSizeHint().height() > before);
    QVERIFY(m_chart->barOf(4, 0).bottom() <= m_chart->minimumSizeHint().height());
    m_chart->setBars({}, {}, {});
    QVERIFY(m_chart->isEmpty());
    QVERIFY(!m_chart->grab().isNull());
}

void TestBarChart::namesLeaveRoomForBars()
{
    m_chart->setBars({"Slide", "m/s", false}, {QString(200, 'w')}, {{"take", Qt::blue, {1}}});
    m_chart->resize(m_chart->minimumSizeHint());
    const QRectF bar = m_chart->barOf(0, 0);
    QVERIFY(bar.width() > 50);
    QVERIFY(bar.right() < m_chart->width());
}

QUADRILLE_QT_TEST(TestBarChart);
#include "tst_barchart.moc"
