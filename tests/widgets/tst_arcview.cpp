// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/graph/arcview.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace quadrille::widgets;

class TestArcView : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void alikeArcsAreJoinedToTheLightest();
    void everyPairOfSequencesKeepsItsLightest();
    void theDistanceToAnArcIsThatOfItsCurve();
    void hoveringNamesAnArc();
    void clickingTheTopOfAnArcActivatesIt();
    void keysGoFromArcToArc();
    void zoomShowsArcsThatWereJoined();

private:
    QPoint topOf(ArcView::Side side, const Arc& arc) const
    {
        const ArcCurve curve = m_view->curve(side, arc);
        return QPointF((curve.from + curve.to) / 2, curve.base - curve.height).toPoint();
    }
    std::unique_ptr<ArcView> m_view;
    const std::vector<Arc> m_above{{5, 80, 0.5F}, {20, 130, 0.25F}, {140, 60, 0.75F}};
    const std::vector<Arc> m_below{{10, 90, 1.5F}};
};

void TestArcView::init()
{
    m_view = std::make_unique<ArcView>();
    m_view->setSequences({{"walk", 50, Qt::blue}, {"jog", 70, Qt::green}, {"kick", 30, Qt::yellow}});
    m_view->setArcs(ArcView::Side::Above, "Essential", std::make_shared<std::vector<Arc>>(m_above));
    m_view->setArcs(ArcView::Side::Below, "Motion", std::make_shared<std::vector<Arc>>(m_below));
    m_view->resize(800, 360);
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
    QTest::mouseMove(m_view.get(), {2, 2});
}

void TestArcView::alikeArcsAreJoinedToTheLightest()
{
    const std::vector<Arc> arcs = {{0, 40, 3}, {1, 41, 2}, {3, 43, 1}, {4, 44, 5}};
    const auto bundles = bundleArcs(arcs, {0, 50}, 4, 100);
    QCOMPARE(bundles.size(), std::size_t{2});
    QCOMPARE(bundles[0].lightest, arcs[2]);
    QCOMPARE(bundles[0].count, 3);
    QCOMPARE(bundles[1].count, 1);
}

void TestArcView::everyPairOfSequencesKeepsItsLightest()
{
    // Between two sequences everything is dear, within one cheap.
    const std::vector<Arc> arcs = {{0, 2, 0.1F}, {1, 3, 0.2F}, {2, 4, 0.3F}, {0, 12, 5}, {1, 14, 4}};
    const auto bundles = bundleArcs(arcs, {0, 10, 20}, 1, 2);
    QCOMPARE(bundles.size(), std::size_t{2});
    QCOMPARE(bundles[0].lightest, arcs[0]);
    QCOMPARE(bundles[1].lightest, arcs[4]);
}

void TestArcView::theDistanceToAnArcIsThatOfItsCurve()
{
    const ArcCurve curve{100, 300, 200, 80};
    for (const double angle : {0.3, 1.0, 1.57, 2.5}) {
        const QPointF on(200 + 100 * std::cos(angle), 200 - 80 * std::sin(angle));
        QVERIFY(curve.distance(on) < 1e-9);
        const QPointF normal(std::cos(angle) / 100, -std::sin(angle) / 80);
        const QPointF beside = on + normal * (3 / std::hypot(normal.x(), normal.y()));
        QVERIFY(std::abs(curve.distance(beside) - 3) < 0.2);
    }
    const ArcCurve below{300, 100, 200, -80};
    QVERIFY(below.distance({200, 280}) < 1e-9);
    QVERIFY(below.distance({200, 120}) > 70);
}

void TestArcView::hoveringNamesAnArc()
{
    QSignalSpy hovered(m_view.get(), &ArcView::arcHovered);
    QSignalSpy ended(m_view.get(), &ArcView::hoverEnded);
    QTest::mouseMove(m_view.get(), topOf(ArcView::Side::Below, m_below[0]));
    QTRY_COMPARE(hovered.size(), 1);
    QCOMPARE(hovered.at(0), QVariantList({10, 90}));
    QCOMPARE(m_view->accessibleDescription(), QString("walk 10 → jog 40: 1.5"));
    QTest::mouseMove(m_view.get(), {2, 2});
    QTRY_COMPARE(ended.size(), 1);
}

void TestArcView::clickingTheTopOfAnArcActivatesIt()
{
    QSignalSpy activated(m_view.get(), &ArcView::arcActivated);
    for (const Arc& arc : m_above) {
        QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, topOf(ArcView::Side::Above, arc));
        QCOMPARE(activated.last(), QVariantList({arc.from, arc.to}));
    }
    QCOMPARE(activated.size(), 3);
}

void TestArcView::keysGoFromArcToArc()
{
    QSignalSpy activated(m_view.get(), &ArcView::arcActivated);
    m_view->setFocus();
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QCOMPARE(m_view->currentArc(), (ArcView::Place{ArcView::Side::Above, m_above[1]}));
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QCOMPARE(m_view->currentArc(), (ArcView::Place{ArcView::Side::Below, m_below[0]}));
    QTest::keyClick(m_view.get(), Qt::Key_Return);
    QCOMPARE(activated.size(), 1);
    QCOMPARE(activated.at(0), QVariantList({10, 90}));
}

void TestArcView::zoomShowsArcsThatWereJoined()
{
    std::vector<Arc> arcs;
    for (int i = 0; i < 5000; ++i)
        arcs.push_back({i, 10000 + i, static_cast<float>(i % 7)});
    m_view->setSequences({{"long", 20000, Qt::blue}});
    m_view->setArcs(ArcView::Side::Above, "Essential", std::make_shared<std::vector<Arc>>(arcs));
    const auto& fitted = m_view->shown(ArcView::Side::Above);
    int edges = 0;
    for (const ArcBundle& bundle : fitted)
        edges += bundle.count;
    QCOMPARE(edges, 5000);
    QVERIFY(fitted.size() <= 400);
    m_view->zoomBy(1000);
    for (const ArcBundle& bundle : m_view->shown(ArcView::Side::Above))
        QCOMPARE(bundle.count, 1);
}

QUADRILLE_QT_TEST(TestArcView);
#include "tst_arcview.moc"
