// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewportoverlay.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

class TestViewport : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void drawsATexturedFigureInItsColour();
    void drawsANewFrameAndANewTexture();
    void pickingFindsTheTriangleUnderThePointer();
    void draggingTurnsTheCameraAndTheWheelComesNearer();
    void goesOnDrawingAfterUndocking();
    void measuresBetweenTwoClicks();
    void framesWhatIsThere();
    void canBeDeletedWithItsFigures();
    void namesInOnePlaceAreAboveEachOther();

private:
    std::unique_ptr<Viewport> m_viewport;
    int addSquare(const QColor& texture);
    QColor centre();
};

namespace {

/// A square of two metres in the plane z = 0, facing +z.
FigureMesh square()
{
    return {.vertexCount = 4,
            .triangles = {{0, 1, 2}, {0, 2, 3}},
            .uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
            .triangleUvs = {{0, 1, 2}, {0, 2, 3}},
            .triangleMaterials = {}};
}

std::vector<float> corners(float z = 0)
{
    return {-1, 0, z, 1, 0, z, 1, 2, z, -1, 2, z};
}

QImage filled(const QColor& color)
{
    QImage image(16, 16, QImage::Format_RGBA8888);
    image.fill(color);
    return image;
}

} // namespace

void TestViewport::init()
{
    QVERIFY(VtkView::openGlAvailable());
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(400, 300);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    Turntable camera;
    camera.target = {0, 1, 0};
    camera.yaw = 0;
    camera.pitch = 0;
    camera.distance = 8;
    m_viewport->setCamera(camera);
}

void TestViewport::cleanup()
{
    m_viewport.reset();
}

int TestViewport::addSquare(const QColor& texture)
{
    const int figure = m_viewport->addFigure(square(), "square");
    m_viewport->setPositions(figure, corners());
    m_viewport->setTexture(figure, filled(texture));
    return figure;
}

QColor TestViewport::centre()
{
    QTest::qWait(50);
    const QImage image = m_viewport->snapshot();
    return image.isNull() ? QColor() : image.pixelColor(image.rect().center());
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

void TestViewport::draggingTurnsTheCameraAndTheWheelComesNearer()
{
    addSquare(Qt::red);
    QTest::qWait(50);
    const Turntable before = m_viewport->camera();
    QWidget* view = m_viewport->view();
    const QPoint from = view->rect().center();
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step)
        QTest::mouseMove(view, from + QPoint(12 * step, 4 * step));
    QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(60, 20));
    QTRY_VERIFY(std::abs(m_viewport->camera().yaw - before.yaw) > 5);
    QWheelEvent wheel(from, view->mapToGlobal(from), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &wheel);
    QTRY_VERIFY(m_viewport->camera().distance < before.distance);
}

void TestViewport::goesOnDrawingAfterUndocking()
{
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
        const QImage image = viewport->snapshot();
        QVERIFY(!image.isNull());
        const QColor color = image.pixelColor(image.rect().center());
        QVERIFY2(color.red() > 2 * color.green(), qPrintable(color.name()));
    }
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

void TestViewport::framesWhatIsThere()
{
    const int figure = addSquare(Qt::red);
    m_viewport->setFigureOffset(figure, {10, 0, 0});
    m_viewport->frameAll();
    QTRY_VERIFY(std::abs(m_viewport->camera().target.x() - 10) < 0.5F);
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

int main(int argc, char** argv)
{
    VtkView::setDefaultFormat();
    QApplication application(argc, argv);
    TestViewport test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_viewport.moc"
