// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/viewapplication.h"
#include "viewportfixture.h"
#include "widgets/viewport/viewportoverlay.h"
#include "widgets/viewport/viewtool.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QPainter>
#include <QSignalSpy>

using namespace quadrille::test;
using namespace quadrille::widgets;

class TestViewport : public ViewportFixture
{
    Q_OBJECT
private slots:
    void drawsATexturedFigureInItsColour();
    void drawsANewFrameAndANewTexture();
    void pickingFindsTheTriangleUnderThePointer();
    void goesOnDrawingAfterUndocking_data();
    void goesOnDrawingAfterUndocking();
    void aProcessorsPictureIsShownAsACards();
    void measuresBetweenTwoClicks();
    void canBeDeletedWithItsFigures();
    void namesInOnePlaceAreAboveEachOther();
    void aNoticeLeavesTheMiddleToATool();
    void aFigureAloneStandsWhereItIs();
    void severalStandInLanesThatTheirTakesDoNotLeave();
    void lanesLieBehindEachOtherWhereTakesGoFarAcross();
    void feetHaveAShadowThatFollowsThem();
    void pinnedGhostsTellTheirFrame();

private:
    /// Makes the view anew, shown as pictures of a processor or of a graphics card are.
    void drawBy(bool processor);
};

void TestViewport::drawBy(bool processor)
{
    cleanup();
    VtkView::setDrawnByProcessor(processor);
    init();
    VtkView::setDrawnByProcessor({});
}

void TestViewport::drawsATexturedFigureInItsColour()
{
    addSquare(Qt::red);
    const QColor color = centre();
    QVERIFY2(color.red() > 2 * color.green() && color.red() > 2 * color.blue(), qPrintable(color.name()));
}

void TestViewport::drawsANewFrameAndANewTexture()
{
    const int figure = addSquare(Qt::red);
    m_viewport->setTexture(figure, filled(Qt::blue));
    const QColor blue = centre();
    QVERIFY2(blue.blue() > 2 * blue.red(), qPrintable(blue.name()));
    auto moved = corners();
    for (std::size_t i = 0; i < moved.size(); i += 3)
        moved[i] += 50;
    m_viewport->setPositions(figure, moved);
    QVERIFY(centre() != blue);
}

void TestViewport::pickingFindsTheTriangleUnderThePointer()
{
    const int figure = addSquare(Qt::red);
    QTest::qWait(50);
    const QPointF middle(m_viewport->width() / 2.0, m_viewport->height() / 2.0);
    const auto lowerRight = m_viewport->pick(middle + QPointF(30, 10));
    QVERIFY(lowerRight);
    QCOMPARE(lowerRight->figure, figure);
    QCOMPARE(lowerRight->triangle, 0U);
    QVERIFY(std::abs(lowerRight->point.z()) < 1e-3F);
    const auto upperLeft = m_viewport->pick(middle + QPointF(-30, -10));
    QVERIFY(upperLeft);
    QCOMPARE(upperLeft->triangle, 1U);
    QVERIFY(!m_viewport->pick({2, 2}));
}

void TestViewport::goesOnDrawingAfterUndocking_data()
{
    QTest::addColumn<bool>("processor");
    QTest::newRow("graphics card") << false;
    QTest::newRow("processor") << true;
}

void TestViewport::goesOnDrawingAfterUndocking()
{
    QFETCH(bool, processor);
    drawBy(processor);
    addSquare(Qt::red);
    QMainWindow window;
    auto* dock = new QDockWidget;
    window.setCentralWidget(new QWidget);
    window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    dock->setWidget(m_viewport.release());
    auto* viewport = qobject_cast<Viewport*>(dock->widget());
    window.resize(700, 500);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    for (const bool floating : {true, false, true}) {
        dock->setFloating(floating);
        QTest::qWait(150);
        for (const QImage& image : {viewport->snapshot(), viewport->grab().toImage()}) {
            QVERIFY(!image.isNull());
            const QColor color = image.pixelColor(image.rect().center());
            QVERIFY2(color.red() > 2 * color.green(), qPrintable(color.name()));
        }
    }
}

void TestViewport::aProcessorsPictureIsShownAsACards()
{
    QImage images[2];
    for (const bool processor : {false, true}) {
        drawBy(processor);
        addSquare(Qt::red);
        Turntable camera = m_viewport->camera();
        camera.target += QVector3D(0.4F, 0.7F, 0); // the square lies off the middle
        camera.yaw = 25;
        m_viewport->setCamera(camera);
        QTRY_VERIFY(m_viewport->view()->quality() == RenderQuality());
        QTest::qWait(50);
        images[processor ? 1 : 0] = m_viewport->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    QVERIFY(images[0].size() == images[1].size() && !images[0].isNull());
    const auto isRed = [](const QColor& color) { return color.red() > 2 * color.green(); };
    int red = 0;
    int different = 0;
    for (int y = 0; y < images[0].height(); ++y) {
        for (int x = 0; x < images[0].width(); ++x) {
            const QColor one = images[0].pixelColor(x, y);
            const QColor other = images[1].pixelColor(x, y);
            red += isRed(one) ? 1 : 0;
            const int apart =
                std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                          std::abs(one.blue() - other.blue())});
            different += apart > 2 ? 1 : 0;
        }
    }
    QVERIFY(red > 500);
    QVERIFY2(different == 0, qPrintable(QString::number(different)));
}

void TestViewport::measuresBetweenTwoClicks()
{
    addSquare(Qt::red);
    QTest::qWait(50);
    m_viewport->setTool(Viewport::Tool::Measure);
    QSignalSpy measured(m_viewport.get(), &Viewport::measured);
    QWidget* view = m_viewport->view();
    const double metresPerPixel = m_viewport->camera().metresPerPixel(view->size());
    const QPoint middle = view->rect().center();
    QTest::mouseClick(view, Qt::LeftButton, {}, middle - QPoint(25, 0));
    QTest::mouseClick(view, Qt::LeftButton, {}, middle + QPoint(25, 0));
    QCOMPARE(measured.size(), 1);
    // The square lies at the camera's target, so that 50 pixels are 50 times this long.
    QVERIFY(std::abs(measured.at(0).at(0).toDouble() - 50 * metresPerPixel) < 0.02);
}

void TestViewport::canBeDeletedWithItsFigures()
{
    addSquare(Qt::red);
    QTest::qWait(50);
    m_viewport.reset();
    Viewport another;
    another.show();
    QVERIFY(QTest::qWaitForWindowExposed(&another));
    QVERIFY(another.isWorking());
}

void TestViewport::namesInOnePlaceAreAboveEachOther()
{
    QImage image(400, 300, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    const QVector3D head(0, 1, 0);
    paintAnnotations(
        painter, image.size(),
        {.camera = m_viewport->camera(), .names = {{head, "one", Qt::red}, {head, "two", Qt::blue}}});
    painter.end();
    const auto lowest = [&image](const QColor& mark) {
        for (int y = image.height() - 1; y >= 0; --y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixelColor(x, y) == mark)
                    return y;
        return -1;
    };
    QVERIFY(lowest(Qt::blue) > 0);
    QVERIFY(lowest(Qt::red) > lowest(Qt::blue) + 12);
}

void TestViewport::aNoticeLeavesTheMiddleToATool()
{
    struct Disc : public ViewTool
    {
        bool handle(QEvent& /*event*/) override { return false; }
        void paint(QPainter& painter) const override { painter.fillRect(150, 100, 100, 100, Qt::red); }
    };
    ViewportOverlay overlay(nullptr);
    overlay.resize(400, 300);
    Annotations annotations;
    annotations.notice = QStringLiteral("Seeking a walk that goes along the path that was drawn");
    overlay.show(annotations);
    const auto isRed = [&overlay](const QPoint& point) {
        return overlay.grab().toImage().pixelColor(point) == QColor(Qt::red);
    };
    QVERIFY(!isRed({200, 150}));
    const QImage without = overlay.grab().toImage();
    Disc disc;
    overlay.setTool(&disc);
    for (const QPoint point : {QPoint(155, 150), QPoint(200, 150), QPoint(245, 150)})
        QVERIFY(isRed(point));
    const QRect low(150, 240, 100, 55);
    QVERIFY(overlay.grab().toImage().copy(low) != without.copy(low));
}

void TestViewport::aFigureAloneStandsWhereItIs()
{
    m_viewport->setLayoutMode(Viewport::Layout::SideBySide);
    const int figure = m_viewport->addFigure(square(), "alone");
    auto far = corners();
    for (std::size_t i = 0; i < far.size(); i += 3)
        far[i] += 1.43F;
    m_viewport->setPositions(figure, far);
    QCOMPARE(m_viewport->figureShape(figure)->place(0), QVector3D(far[0], far[1], far[2]));
    // What comes beside it does not move it, and what goes leaves it in place, too.
    const int other = m_viewport->addFigure(square(), "other");
    m_viewport->setPositions(other, corners());
    QCOMPARE(m_viewport->figureShape(figure)->place(0), QVector3D(far[0], far[1], far[2]));
    QVERIFY(m_viewport->figureShape(other)->place(0).x() > 1.43F + 1.0F);
    m_viewport->setFigureVisible(figure, false);
    QCOMPARE(m_viewport->figureShape(other)->shift, QVector3D());
    m_viewport->setFigureVisible(figure, true);
    m_viewport->removeFigure(figure);
    QCOMPARE(m_viewport->figureShape(other)->shift, QVector3D());
}

void TestViewport::severalStandInLanesThatTheirTakesDoNotLeave()
{
    m_viewport->setLayoutMode(Viewport::Layout::SideBySide);
    std::vector<int> figures;
    for (int i = 0; i < 3; ++i) {
        figures.push_back(m_viewport->addFigure(square()));
        m_viewport->setPositions(figures.back(), corners());
        // Each goes three metres to both sides.
        m_viewport->setFigureExtent(figures.back(), {-3, 0, -4}, {3, 2, 4});
    }
    m_viewport->setFigureOrder({figures[2], figures[0], figures[1]});
    m_viewport->setAnchor(figures[0]);
    const auto shift = [&](int i) {
        return m_viewport->figureShape(figures[static_cast<std::size_t>(i)])->shift;
    };
    QCOMPARE(shift(0), QVector3D());
    QVERIFY(shift(2).x() <= -6 && shift(2).x() > -8);
    QVERIFY(shift(1).x() >= 6 && shift(1).x() < 8);
    // Another one that stays in place takes the camera along: in the view nothing jumps.
    const Turntable before = m_viewport->camera();
    const QVector3D seen = shift(1) - before.target;
    m_viewport->setAnchor(figures[1]);
    QCOMPARE(shift(1), QVector3D());
    QVERIFY((shift(1) - m_viewport->camera().target - seen).length() < 1e-4F);
}

void TestViewport::lanesLieBehindEachOtherWhereTakesGoFarAcross()
{
    m_viewport->setLayoutMode(Viewport::Layout::SideBySide);
    const int first = m_viewport->addFigure(square());
    const int second = m_viewport->addFigure(square());
    for (const int figure : {first, second}) {
        m_viewport->setPositions(figure, corners());
        m_viewport->setFigureExtent(figure, {-6, 0, -0.5F}, {6, 2, 0.5F});
    }
    QCOMPARE(m_viewport->figureShape(second)->shift.x(), 0.0F);
    QVERIFY(m_viewport->figureShape(second)->shift.z() >= 1.0F);
}

void TestViewport::feetHaveAShadowThatFollowsThem()
{
    m_viewport->view()->holdQuality(RenderQuality());
    const int figure = m_viewport->addFigure(square());
    m_viewport->setPositions(figure, corners(-20)); // out of sight
    Turntable camera = m_viewport->camera();
    camera.target = {0, 0, 0};
    camera.pitch = 40;
    m_viewport->setCamera(camera);
    const double without = centre().lightnessF();
    std::vector<ShadowWish> wishes;
    m_viewport->setShadowMaker([&](const ShadowWish& wish) {
        wishes.push_back(wish);
        return GroundShadow{
            .corner = {-1, 0, -1}, .cell = 1, .columns = 2, .rows = 2, .darkness = {1, 1, 1, 1}};
    });
    const double with = centre().lightnessF();
    QVERIFY2(with < 0.8 * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
    QVERIFY(wishes.front().figure == figure && wishes.front().toLight.y() > 0.5F);
    // It is made again when the figure moves, and only then.
    const auto made = wishes.size();
    centre();
    QCOMPARE(wishes.size(), made);
    m_viewport->setPositions(figure, corners(-19));
    centre();
    QVERIFY(wishes.size() > made);
    m_viewport->setShadowsVisible(false);
    QVERIFY(std::abs(centre().lightnessF() - without) < 0.02);
    m_viewport->setShadowsVisible(true);
    // From below nothing lies between the eye and the soles.
    camera.pitch = -30;
    m_viewport->setCamera(camera);
    const double below = centre().lightnessF();
    m_viewport->setShadowsVisible(false);
    QVERIFY(std::abs(centre().lightnessF() - below) < 0.02);
}

void TestViewport::pinnedGhostsTellTheirFrame()
{
    const int figure = addSquare(Qt::red);
    QVERIFY(!m_viewport->findChild<ViewportOverlay*>()->isVisible());
    m_viewport->setGhosts(figure, {{corners(-1), QColor(0, 158, 115, 120), "19"}});
    QTRY_VERIFY(m_viewport->findChild<ViewportOverlay*>()->isVisible());
    m_viewport->setGhosts(figure, {{corners(-1), QColor(0, 158, 115, 120), QString()}});
    QVERIFY(!m_viewport->findChild<ViewportOverlay*>()->isVisible());
}

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, TestViewport);
#include "tst_viewport.moc"
