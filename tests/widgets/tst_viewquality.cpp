// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How well pictures are drawn that follow each other.
#include "tests/qt/viewapplication.h"
#include "viewportfixture.h"

#include <QSignalSpy>

using namespace quadrille::test;
using namespace quadrille::widgets;

class TestViewQuality : public ViewportFixture
{
    Q_OBJECT
private slots:
    void aPictureIsDrawnInFullOnceNothingMoves();
    void fewerPixelsShowTheSameScene();
    void theGovernorFollowsWhatPicturesTake();
    void theGovernorDoesNotGoBackAndForth();
};

void TestViewQuality::aPictureIsDrawnInFullOnceNothingMoves()
{
    addSquare(Qt::red);
    QTRY_VERIFY(m_viewport->view()->quality() == RenderQuality());
    QSignalSpy qualities(m_viewport->view(), &VtkView::qualityChanged);
    for (int i = 0; i < 12; ++i) {
        Turntable camera = m_viewport->camera();
        camera.yaw += 2;
        m_viewport->setCamera(camera);
        QSignalSpy rendered(m_viewport.get(), &Viewport::rendered);
        QVERIFY(rendered.wait());
    }
    QTRY_VERIFY(m_viewport->view()->quality() == RenderQuality());
    QTRY_VERIFY(qualities.isEmpty() || qualities.back().front().value<RenderQuality>() == RenderQuality());
    // While something plays, a long wait for the next picture is no rest.
    m_viewport->setMoving(true);
    Turntable camera = m_viewport->camera();
    camera.yaw += 2;
    QSignalSpy rendered(m_viewport.get(), &Viewport::rendered);
    m_viewport->setCamera(camera);
    QVERIFY(rendered.wait());
    qualities.clear();
    QVERIFY(!qualities.wait(400));
    m_viewport->setMoving(false);
    QTRY_VERIFY(m_viewport->view()->quality() == RenderQuality());
}

void TestViewQuality::fewerPixelsShowTheSameScene()
{
    const int figure = addSquare(Qt::red);
    Turntable camera = m_viewport->camera();
    camera.target += QVector3D(0.4F, 0.7F, 0); // the square lies off the middle
    m_viewport->setCamera(camera);
    VtkView& view = *m_viewport->view();
    const QPointF onIt(view.width() * 0.45, view.height() * 0.6);
    QImage images[2];
    for (const double scale : {1.0, 0.5}) {
        view.holdQuality(RenderQuality{.samples = 0, .scale = scale});
        QSignalSpy rendered(m_viewport.get(), &Viewport::rendered);
        QVERIFY(rendered.wait());
        QCOMPARE(view.pixelRatio(), scale * view.devicePixelRatioF());
        images[scale < 1 ? 1 : 0] = m_viewport->grab().toImage().convertToFormat(QImage::Format_RGB32);
        const auto picked = m_viewport->pick(onIt);
        QVERIFY(picked && picked->figure == figure);
    }
    QCOMPARE(images[0].size(), images[1].size());
    QVERIFY(images[0] != images[1]);
    const auto isRed = [](QRgb color) { return qRed(color) > 2 * qGreen(color); };
    int red = 0;
    int different = 0;
    for (int y = 0; y < images[0].height(); ++y) {
        for (int x = 0; x < images[0].width(); ++x) {
            const bool is = isRed(images[0].pixel(x, y));
            red += is ? 1 : 0;
            different += is != isRed(images[1].pixel(x, y)) ? 1 : 0;
        }
    }
    QVERIFY2(red > 2000 && different < red / 20, qPrintable(QString("%1 %2").arg(red).arg(different)));
    // A picture in a file has all of its pixels.
    QCOMPARE(m_viewport->snapshot().size(), view.size() * view.devicePixelRatioF());
}

void TestViewQuality::theGovernorFollowsWhatPicturesTake()
{
    RenderGovernor governor;
    const auto draw = [&governor](int pictures, double milliseconds) {
        for (int i = 0; i < pictures; ++i)
            governor.drawn(milliseconds);
    };
    draw(60, 60.0);
    QCOMPARE(governor.level(), RenderGovernor::levels - 1);
    draw(20, 2.0); // room must last
    QCOMPARE(governor.level(), RenderGovernor::levels - 1);
    draw(400, 2.0);
    QCOMPARE(governor.level(), 0);
    QVERIFY(governor.quality() == RenderQuality());
    draw(20, 14.0);
    QCOMPARE(governor.level(), 0);
    governor.setBudget(RenderGovernor::budgetFor(60)); // they are to follow each other faster
    draw(20, 14.0);
    QVERIFY(governor.level() > 0);
}

void TestViewQuality::theGovernorDoesNotGoBackAndForth()
{
    // Each level takes this long; only the third and later ones are quick enough.
    constexpr std::array costs{60.0, 45.0, 22.0, 15.0, 14.0, 12.0, 10.0, 9.0};
    RenderGovernor governor;
    int changes = 0;
    int level = governor.level();
    for (int picture = 0; picture < 2000; ++picture) {
        governor.drawn(costs[static_cast<std::size_t>(governor.level())]);
        changes += governor.level() != level ? 1 : 0;
        level = governor.level();
    }
    QCOMPARE(governor.level(), 2);
    QVERIFY2(changes <= 3, qPrintable(QString::number(changes)));
}

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, TestViewQuality);
#include "tst_viewquality.moc"
