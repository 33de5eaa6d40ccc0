// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/controls/textureview.h"
#include "widgets/theme/theme.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace quadrille::widgets;

namespace {

/// Left half red, right half blue; its upper left pixel is green.
QImage twoHalves(int width, int height)
{
    QImage image(width, height, QImage::Format_RGBA8888);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            image.setPixelColor(x, y, x < width / 2 ? Qt::red : Qt::blue);
    }
    image.setPixelColor(0, 0, Qt::green);
    return image;
}

} // namespace

class TestTextureView : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void fitsThePictureAndFollowsItsOwnSize();
    void textureCoordinatesHaveTheirOriginAtTheLowerLeft();
    void wheelKeepsWhatIsUnderThePointer();
    void draggingMovesThePictureAndNotOutOfSight();
    void keysZoomFitAndMove();
    void arrowsThatMoveNothingAreLeftToTheWindow();
    void hoverTellsCoordinatesAndPixel();
    void anotherPictureOfTheSizeKeepsTheView();
    void drawsPixelsSharpAndReducedPicturesSmooth();
    void drawsEdgesWhereTheyAre();
    void saysWhatIsMissingAndOffersHelp();

private:
    std::unique_ptr<TextureView> m_view;
    void wheel(const QPointF& position, int notches);
    QColor colorAt(const QPointF& position);
};

void TestTextureView::init()
{
    m_view = std::make_unique<TextureView>();
    m_view->resize(416, 316);
    m_view->setPicture({twoHalves(200, 100), {}});
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
}

void TestTextureView::wheel(const QPointF& position, int notches)
{
    QWheelEvent event(position, m_view->mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(m_view.get(), &event);
}

QColor TestTextureView::colorAt(const QPointF& position)
{
    const QImage picture = m_view->grab().toImage();
    return picture.pixelColor((position * picture.devicePixelRatio()).toPoint());
}

void TestTextureView::fitsThePictureAndFollowsItsOwnSize()
{
    QVERIFY(m_view->isFitted());
    QCOMPARE(m_view->zoom(), 2.0 * m_view->devicePixelRatioF());
    m_view->resize(216, 316);
    QTRY_COMPARE(m_view->zoom(), 1.0 * m_view->devicePixelRatioF());
    m_view->zoomAbout({100, 100}, 2);
    m_view->resize(416, 316);
    QTest::qWait(0);
    QVERIFY(!m_view->isFitted());
    QCOMPARE(m_view->zoom(), 2.0 * m_view->devicePixelRatioF());
}

void TestTextureView::textureCoordinatesHaveTheirOriginAtTheLowerLeft()
{
    // Fitted it takes 400 × 200 logical pixels from (8, 58).
    QCOMPARE(m_view->positionOf({0, 0}), QPointF(8, 258));
    QCOMPARE(m_view->positionOf({1, 1}), QPointF(408, 58));
    QCOMPARE(m_view->uvAt({108, 208}), QPointF(0.25, 0.25));
    QCOMPARE(m_view->pixelAt({8.5, 58.5}), QPoint(0, 0));
    QCOMPARE(m_view->pixelAt({407, 257}), QPoint(199, 99));
}

void TestTextureView::wheelKeepsWhatIsUnderThePointer()
{
    const QPointF pointer(300, 120);
    const QPointF before = m_view->uvAt(pointer);
    for (const int notches : {3, 2, -1}) {
        const double zoom = m_view->zoom();
        wheel(pointer, notches);
        QVERIFY(notches > 0 ? m_view->zoom() > zoom : m_view->zoom() < zoom);
        const QPointF after = m_view->uvAt(pointer);
        QVERIFY(QLineF(before, after).length() < 1e-9);
    }
    // It ends somewhere, in both directions.
    wheel(pointer, 100);
    QVERIFY(m_view->zoom() <= 64);
    wheel(pointer, -200);
    QVERIFY(m_view->zoom() * 200 >= 32);
}

void TestTextureView::draggingMovesThePictureAndNotOutOfSight()
{
    wheel({200, 150}, 6);
    const QPointF before = m_view->positionOf({0.5, 0.5});
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, {200, 150});
    QTest::mouseMove(m_view.get(), {230, 140});
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, {230, 140});
    QCOMPARE(m_view->positionOf({0.5, 0.5}), before + QPointF(30, -10));
    QTest::mouseMove(m_view.get(), {100, 100});
    QCOMPARE(m_view->positionOf({0.5, 0.5}), before + QPointF(30, -10));
    for (int i = 0; i < 10; ++i) {
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, {10, 150});
        QTest::mouseMove(m_view.get(), {410, 150});
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, {410, 150});
    }
    QVERIFY(m_view->positionOf({0, 0}).x() <= 208.5);
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, {200, 150});
    QVERIFY(m_view->isFitted());
    QCOMPARE(m_view->positionOf({0, 0}), QPointF(8, 258));
}

void TestTextureView::keysZoomFitAndMove()
{
    m_view->setFocus();
    const double fitted = m_view->zoom();
    QSignalSpy zoomed(m_view.get(), &TextureView::zoomChanged);
    QTest::keyClick(m_view.get(), Qt::Key_Plus);
    QVERIFY(m_view->zoom() > fitted);
    QCOMPARE(zoomed.last().at(0).toDouble(), m_view->zoom());
    QTest::keyClick(m_view.get(), Qt::Key_Minus);
    QVERIFY(qAbs(m_view->zoom() - fitted) < 1e-9);
    QTest::keyClick(m_view.get(), Qt::Key_0);
    QCOMPARE(m_view->zoom(), 1.0);
    QTest::keyClick(m_view.get(), Qt::Key_F);
    QVERIFY(m_view->isFitted());
    QCOMPARE(m_view->zoom(), fitted);
    for (int i = 0; i < 6; ++i)
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
    const QPointF middle(208, 158);
    const QPointF before = m_view->uvAt(middle);
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QVERIFY(m_view->uvAt(middle).x() > before.x());
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QVERIFY(m_view->uvAt(middle).y() < before.y());
    QTest::keyClick(m_view.get(), Qt::Key_Left);
    QTest::keyClick(m_view.get(), Qt::Key_Up);
    QVERIFY(QLineF(m_view->uvAt(middle), before).length() < 1e-9);
}

void TestTextureView::arrowsThatMoveNothingAreLeftToTheWindow()
{
    const auto isTaken = [this](Qt::Key key) {
        QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
        event.ignore();
        QApplication::sendEvent(m_view.get(), &event);
        return event.isAccepted();
    };
    QVERIFY(isTaken(Qt::Key_F));
    QVERIFY(!isTaken(Qt::Key_Right));
    QVERIFY(!isTaken(Qt::Key_Space));
    wheel({200, 150}, 6);
    QVERIFY(isTaken(Qt::Key_Right));
    m_view->setPicture({});
    QVERIFY(!isTaken(Qt::Key_F));
}

void TestTextureView::hoverTellsCoordinatesAndPixel()
{
    QSignalSpy hovered(m_view.get(), &TextureView::hovered);
    QSignalSpy ended(m_view.get(), &TextureView::hoverEnded);
    QTest::mouseMove(m_view.get(), {108, 208});
    QTRY_VERIFY(!hovered.isEmpty());
    QCOMPARE(hovered.last().at(0).toPointF(), QPointF(0.25, 0.25));
    QCOMPARE(hovered.last().at(1).toPoint(), QPoint(50, 75));
    // The picture may move under a pointer that stands.
    QTest::keyClick(m_view.get(), Qt::Key_Plus);
    QCOMPARE(hovered.last().at(0).toPointF(), m_view->uvAt({108, 208}));
    QTest::keyClick(m_view.get(), Qt::Key_F);
    QTest::mouseMove(m_view.get(), {108, 20});
    QTRY_COMPARE(ended.size(), 1);
}

void TestTextureView::anotherPictureOfTheSizeKeepsTheView()
{
    wheel({300, 120}, 4);
    const double zoom = m_view->zoom();
    const QPointF place = m_view->positionOf({0, 0});
    m_view->setPicture({twoHalves(200, 100).mirrored(true, false), {}});
    QCOMPARE(m_view->zoom(), zoom);
    QCOMPARE(m_view->positionOf({0, 0}), place);
    m_view->setPicture({twoHalves(50, 50), {}});
    QVERIFY(m_view->isFitted());
}

void TestTextureView::drawsPixelsSharpAndReducedPicturesSmooth()
{
    QCOMPARE(colorAt(m_view->positionOf({0.49, 0.5})), QColor(Qt::red));
    QCOMPARE(colorAt(m_view->positionOf({0.51, 0.5})), QColor(Qt::blue));
    // Far in, a pixel is one colour up to its edge.
    wheel({8.5, 58.5}, 100);
    QCOMPARE(colorAt({10, 60}), QColor(Qt::green));
    QCOMPARE(m_view->pixelAt({10, 60}), QPoint(0, 0));
    // A fine pattern becomes even instead of flickering.
    QImage stripes(2048, 2048, QImage::Format_RGBA8888);
    for (int y = 0; y < stripes.height(); ++y) {
        for (int x = 0; x < stripes.width(); ++x)
            stripes.setPixelColor(x, y, x % 2 == 0 ? Qt::black : Qt::white);
    }
    const TexturePicture prepared = prepareTexture(stripes);
    QCOMPARE(prepared.halves.front().size(), QSize(1024, 1024));
    QCOMPARE(prepared.halves.back().size(), QSize(128, 128));
    m_view->setPicture(prepared);
    m_view->fit();
    for (const double u : {0.3, 0.501, 0.7}) {
        const int gray = colorAt(m_view->positionOf({u, 0.5})).red();
        QVERIFY2(gray > 110 && gray < 145, qPrintable(QString::number(gray)));
    }
}

void TestTextureView::drawsEdgesWhereTheyAre()
{
    const auto isWhite = [this](const QPointF& uv) {
        // A line between two rows of pixels is half in each.
        const QPointF place = m_view->positionOf(uv) - QPointF(0.5, 0.5);
        return colorAt(place).lightness() > 150 || colorAt(place - QPointF(0.5, 0.5)).lightness() > 150;
    };
    QVERIFY(!isWhite({0.5, 0.25}));
    m_view->setUvEdges({{0.1, 0.25, 0.9, 0.25}, {0.2, 0.25, 0.2, 0.9}});
    QVERIFY(isWhite({0.5, 0.25}));
    QVERIFY(isWhite({0.2, 0.8}));
    QVERIFY(!isWhite({0.5, 0.75}));
    wheel({200, 150}, 3);
    QVERIFY(isWhite({0.5, 0.25}));
    // A great many are thinned out and still make the same shape.
    QList<QLineF> many;
    for (int i = 0; i < 250'000; ++i)
        many += QLineF(0.49, 0.25, 0.51, 0.25);
    m_view->setUvEdges(many);
    QVERIFY(isWhite({0.5, 0.25}));
    m_view->setUvEdges({});
    QVERIFY(!isWhite({0.5, 0.25}));
}

void TestTextureView::saysWhatIsMissingAndOffersHelp()
{
    auto* offer = new QPushButton(QStringLiteral("Choose"));
    QSignalSpy clicked(offer, &QPushButton::clicked);
    m_view->setEmptyText(QStringLiteral("There is no texture."));
    m_view->setEmptyAction(offer);
    auto* text = m_view->findChild<QLabel*>(QStringLiteral("textureViewEmpty"));
    QVERIFY(!text->isVisible());
    m_view->setPicture({});
    QVERIFY(m_view->isEmpty());
    QVERIFY(m_view->focusPolicy() == Qt::NoFocus);
    QTRY_VERIFY(text->isVisible() && offer->isVisible());
    QCOMPARE(text->text(), QStringLiteral("There is no texture."));
    QTest::mouseClick(offer, Qt::LeftButton);
    QCOMPARE(clicked.size(), 1);
    // Edges alone are worth looking at, over the unit square.
    const double halfPixel = 1 - 150.5 / 300; // down to the middle of a row: the line fills it
    m_view->setUvEdges({{0, halfPixel, 1, halfPixel}});
    QVERIFY(!text->isVisible());
    const QPointF onEdge = m_view->positionOf({0.25, halfPixel}) - QPointF(0, 0.5);
    QVERIFY(Theme::contrast(colorAt(onEdge), colorAt(onEdge + QPointF(0, 30))) > 3);
    QCOMPARE(m_view->uvAt(m_view->positionOf({0.25, 0.5})), QPointF(0.25, 0.5));
}

QUADRILLE_QT_TEST(TestTextureView);
#include "tst_textureview.moc"
