// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/graph/linechart.h"
#include "widgets/graph/logslider.h"

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTest>

using namespace quadrille::widgets;

class TestLineChart : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void ticksAreRound_data();
    void ticksAreRound();
    void numbersShowWhatMatters_data();
    void numbersShowWhatMatters();
    void pointsLieWhereTheScaleSays();
    void hoveringReadsTheNearestPoint();
    void keysReadFromPointToPoint();
    void theMarkerFollowsADrag();
    void returnMovesTheMarker();
    void valuesAreCopiedAsCsv();
    void aSliderOverPowersOfTenTellsDragsAndSteps();
    void theNumberBesideTheSliderCanBeTyped();
    void aSliderNamesItsEndsBeforeACurve();

private:
    std::unique_ptr<LineChart> m_chart;
};

void TestLineChart::init()
{
    m_chart = std::make_unique<LineChart>();
    m_chart->setAxes({"α", "", true}, {"Edges, all", "1", false});
    m_chart->setSeries(
        {{"Essential", Qt::blue, ChartSeries::Sign::Circle, false, {{0.01, 100}, {0.1, 40}, {1, 10}}},
         {"Motion", Qt::red, ChartSeries::Sign::Diamond, true, {{0.01, 60}, {1, 60}}}});
    m_chart->setMarker(0.1, "α");
    m_chart->resize(480, 300);
    m_chart->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_chart.get()));
    QTest::mouseMove(m_chart.get(), {2, 2});
}

void TestLineChart::ticksAreRound_data()
{
    QTest::addColumn<double>("minimum");
    QTest::addColumn<double>("maximum");
    QTest::addColumn<bool>("isLogarithmic");
    QTest::addColumn<int>("most");
    QTest::addColumn<QList<double>>("ticks");
    QTest::newRow("tenths") << 0.0 << 1.0 << false << 5 << QList<double>{0, 0.2, 0.4, 0.6, 0.8, 1.0};
    QTest::newRow("not from zero") << 13.0 << 42.0 << false << 4 << QList<double>{20, 30, 40};
    QTest::newRow("never one alone") << 31.0 << 49.0 << false << 2 << QList<double>{35, 40, 45};
    QTest::newRow("powers") << 1e-4 << 1.0 << true << 6 << QList<double>{1e-4, 1e-3, 1e-2, 0.1, 1};
    QTest::newRow("within powers") << 0.01 << 0.2 << true << 8 << QList<double>{0.01, 0.02, 0.05, 0.1, 0.2};
}

void TestLineChart::ticksAreRound()
{
    QFETCH(const double, minimum);
    QFETCH(const double, maximum);
    QFETCH(const bool, isLogarithmic);
    QFETCH(const int, most);
    QFETCH(const QList<double>, ticks);
    const auto found = chartTicks({minimum, maximum, isLogarithmic, 0, 100}, most);
    QCOMPARE(static_cast<qsizetype>(found.size()), ticks.size());
    for (qsizetype i = 0; i < ticks.size(); ++i)
        QVERIFY(std::abs(found[static_cast<std::size_t>(i)] - ticks[i]) < 1e-9);
}

void TestLineChart::numbersShowWhatMatters_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << 0.0 << "0";
    QTest::newRow("small") << 0.00012 << "0.00012";
    QTest::newRow("rounded") << 0.0123456 << "0.0123";
    QTest::newRow("whole") << 5.0 << "5";
    QTest::newRow("hundred") << 100.0 << "100";
    QTest::newRow("large") << 12345.0 << "12345";
    QTest::newRow("negative") << -2.5 << "-2.5";
}

void TestLineChart::numbersShowWhatMatters()
{
    QFETCH(const double, value);
    QFETCH(const QString, text);
    QCOMPARE(chartNumber(value), text);
}

void TestLineChart::pointsLieWhereTheScaleSays()
{
    const QPointF left = m_chart->positionOf({0.01, 100});
    const QPointF middle = m_chart->positionOf({0.1, 40});
    const QPointF right = m_chart->positionOf({1, 10});
    QVERIFY(std::abs((left.x() + right.x()) / 2 - middle.x()) < 1e-6);
    QVERIFY(left.y() < middle.y() && middle.y() < right.y());
    const QImage picture = m_chart->grab().toImage();
    const auto at = (m_chart->positionOf({0.01, 60}) * picture.devicePixelRatio()).toPoint();
    QCOMPARE(picture.pixelColor(at), QColor(Qt::red));
}

void TestLineChart::hoveringReadsTheNearestPoint()
{
    QTest::mouseMove(m_chart.get(), m_chart->positionOf({0.012, 50}).toPoint());
    QTRY_COMPARE(m_chart->readX(), 0.01);
    QCOMPARE(m_chart->readOut(), QString("α = 0.01; Essential: 100 1; Motion: 60 1"));
}

void TestLineChart::keysReadFromPointToPoint()
{
    QTest::keyClick(m_chart.get(), Qt::Key_Home);
    QTest::keyClick(m_chart.get(), Qt::Key_Right);
    QCOMPARE(m_chart->readX(), 0.1);
    QCOMPARE(m_chart->accessibleDescription(), QString("α = 0.1; Essential: 40 1"));
    QTest::keyClick(m_chart.get(), Qt::Key_End);
    QTest::keyClick(m_chart.get(), Qt::Key_Right);
    QCOMPARE(m_chart->readX(), 1.0);
}

void TestLineChart::theMarkerFollowsADrag()
{
    QSignalSpy moved(m_chart.get(), &LineChart::markerMoved);
    const QPoint from = m_chart->positionOf({0.1, 50}).toPoint();
    const QPoint to = m_chart->positionOf({0.02, 50}).toPoint();
    QTest::mousePress(m_chart.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_chart.get(), (from + to) / 2);
    QTest::mouseMove(m_chart.get(), to);
    QTest::mouseRelease(m_chart.get(), Qt::LeftButton, {}, to);
    QVERIFY(moved.size() >= 2);
    QCOMPARE(moved.first().at(1).toBool(), false);
    QCOMPARE(moved.last().at(1).toBool(), true);
    QVERIFY(std::abs(moved.last().at(0).toDouble() - 0.02) < 0.001);
}

void TestLineChart::returnMovesTheMarker()
{
    QSignalSpy moved(m_chart.get(), &LineChart::markerMoved);
    QTest::keyClick(m_chart.get(), Qt::Key_End);
    QTest::keyClick(m_chart.get(), Qt::Key_Return);
    QCOMPARE(moved.size(), 1);
    QCOMPARE(moved.at(0), QVariantList({1.0, true}));
}

void TestLineChart::valuesAreCopiedAsCsv()
{
    m_chart->setAxes({"α", "", true}, {"Edges", "1,000", false});
    QTest::keyClick(m_chart.get(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QString("α,\"Essential (1,000)\",\"Motion (1,000)\"\n"
                                                        "0.01,100,60\n0.1,40,\n1,10,60\n"));
}

void TestLineChart::aSliderOverPowersOfTenTellsDragsAndSteps()
{
    LogSlider slider(1e-4, 1);
    slider.resize(500, 28);
    slider.setValue(0.01);
    slider.show();
    QVERIFY(QTest::qWaitForWindowExposed(&slider));
    QSignalSpy edited(&slider, &LogSlider::valueEdited);
    QSlider* handle = slider.slider();
    QCOMPARE(handle->value(), 500);
    QStyleOptionSlider option;
    option.initFrom(handle);
    option.minimum = 0;
    option.maximum = 1000;
    option.sliderPosition = option.sliderValue = 500;
    option.orientation = Qt::Horizontal;
    const QPoint from =
        handle->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, handle).center();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    QTest::mouseMove(handle, from + QPoint(30, 0));
    QTest::mouseMove(handle, from + QPoint(60, 0));
    QVERIFY(edited.size() >= 2);
    QCOMPARE(edited.last().at(1).toBool(), false);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, from + QPoint(60, 0));
    QCOMPARE(edited.last().at(1).toBool(), true);
    const double dragged = slider.value();
    QVERIFY(dragged > 0.015 && dragged < 0.2);
    QTest::keyClick(handle, Qt::Key_Left);
    QCOMPARE(edited.last().at(1).toBool(), true);
    QVERIFY(slider.value() < dragged);
    QTest::keyClick(handle, Qt::Key_Home);
    QCOMPARE(slider.value(), 1e-4);
}

void TestLineChart::theNumberBesideTheSliderCanBeTyped()
{
    LogSlider slider(1e-4, 1);
    slider.show();
    QVERIFY(QTest::qWaitForWindowExposed(&slider));
    QSignalSpy edited(&slider, &LogSlider::valueEdited);
    slider.spinBox()->setFocus();
    slider.spinBox()->selectAll();
    QTest::keyClicks(slider.spinBox(), "0.035");
    QTest::keyClick(slider.spinBox(), Qt::Key_Return);
    QCOMPARE(edited.size(), 1);
    QCOMPARE(edited.at(0), QVariantList({0.035, true}));
    QTest::keyClick(slider.spinBox(), Qt::Key_Up);
    QCOMPARE(slider.value(), 0.0371);
    QCOMPARE(slider.spinBox()->text(), QString("0.0371"));
}

void TestLineChart::aSliderNamesItsEndsBeforeACurve()
{
    LogSlider slider(1e-4, 1);
    slider.resize(500, 60);
    slider.setEnds("sparse", "dense");
    slider.setValue(0.01);
    slider.show();
    QVERIFY(QTest::qWaitForWindowExposed(&slider));
    QVERIFY(slider.findChild<QLabel*>("logSliderLow")->isVisible());
    QCOMPARE(slider.findChild<QLabel*>("logSliderHigh")->text(), QString("dense"));
    const QImage before = slider.grab().toImage();
    slider.setCurve({{1e-4, 0}, {0.01, 0.5}, {1, 1}});
    const QImage after = slider.grab().toImage();
    const QPoint inside = (slider.curvePosition({0.5, 0.1}) * after.devicePixelRatio()).toPoint();
    QVERIFY(before.pixelColor(inside) != after.pixelColor(inside));
    // The curve and the handle agree about where a value is.
    QStyleOptionSlider option;
    option.initFrom(slider.slider());
    option.maximum = 1000;
    option.sliderPosition = option.sliderValue = slider.slider()->value();
    option.orientation = Qt::Horizontal;
    const QRect handle = slider.slider()->style()->subControlRect(QStyle::CC_Slider, &option,
                                                                  QStyle::SC_SliderHandle, slider.slider());
    const double middle = slider.slider()->mapTo(&slider, handle.center()).x();
    QVERIFY(std::abs(slider.curvePosition({0.01, 0}).x() - middle) < 2);
}

QUADRILLE_QT_TEST(TestLineChart);
#include "tst_linechart.moc"
