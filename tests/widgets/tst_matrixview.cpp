// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "tests/widgets/randomvalues.h"
#include "widgets/graph/labelspread.h"
#include "widgets/graph/matrixview.h"

#include <QContextMenuEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace quadrille::widgets;

namespace {

/// \param marks  in any order.
MatrixMarkRow rowsOf(const std::vector<MatrixMark>& marks)
{
    return [marks](int row, std::vector<MatrixMark>& ofRow) {
        for (const MatrixMark& mark : marks)
            if (mark.row == row)
                ofRow.push_back(mark);
    };
}

} // namespace

class TestMatrixView : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void namesStandAsNearAsCanBeWithoutCoveringEachOther();
    void clickingAPixelActivatesItsCell();
    void hoveringTellsTheCellAndItsEnd();
    void thePictureShowsTheCellUnderEachPixel();
    void zoomKeepsTheCellUnderThePointer();
    void draggingMovesAndActivatesNothing();
    void keysMoveTheCellAndActivateIt();
    void pageKeysGoFromBlockToBlock();
    void marksThinOutToTheLightest();
    void marksShowOnTheirCells();
    void marksShowWhereTheTableIsMoved();
    void theCellIsReadOut();
    void theTableFillsItsPlace();
    void framesAreNumberedAsThereIsRoom();
    void picturesKeepTheirPlace();
    void whatDoesNotCountIsVeiled();
    void theRightButtonAsksForTheMenu();
    void anEmptyViewSaysSo();

private:
    QPoint middleOf(int row, int column) const { return m_view->cellRect({row, column}).center().toPoint(); }
    std::unique_ptr<MatrixView> m_view;
    MatrixValues m_values = randomValues(40, 3);
};

void TestMatrixView::init()
{
    m_view = std::make_unique<MatrixView>();
    m_view->setMatrix(m_values, buildMatrixPyramid(m_values, 0, 1),
                      {0, 1, ColorMap::Sequential, "Cost", "mm"});
    m_view->setBlocks({{"walk", 10}, {"jog", 18}, {"kick", 12}});
    m_view->resize(700, 560);
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
}

void TestMatrixView::namesStandAsNearAsCanBeWithoutCoveringEachOther()
{
    using Places = std::vector<std::optional<double>>;
    const auto spread = [](const std::vector<double>& wanted, double length) {
        return spreadLabels(wanted, 10, length);
    };
    QVERIFY(spread({}, 100).empty());
    QCOMPARE(spread({20, 50, 80}, 100), (Places{20, 50, 80}));
    QCOMPARE(spread({50, 50}, 100), (Places{45, 55}));
    QCOMPARE(spread({48, 52, 54}, 100), (Places{124.0 / 3, 154.0 / 3, 184.0 / 3}));
    QCOMPARE(spread({1, 2, 99, 99}, 100), (Places{5, 15, 85, 95}));
    // Room for two of four, and for none.
    const std::vector<double> four{2, 9, 16, 22};
    QCOMPARE(spread(four, 25), (Places{5, {}, 16, {}}));
    QCOMPARE(spread({2, 3}, 5), (Places{{}, {}}));
    // One that is pointed at takes the place of its neighbour.
    QCOMPARE(spreadLabels(four, 10, 25, 1), (Places{{}, 7.5, 17.5, {}}));
    // On both sides of what stands still, with as little moving as a plain search finds.
    const std::vector<double> wanted{12, 14, 40, 63, 64, 65};
    const Places found = spread(wanted, 100);
    double moved = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        moved += std::pow(*found[i] - wanted[i], 2);
    double least = std::numeric_limits<double>::infinity();
    for (double pair = 5; pair < 30; pair += 0.25) {
        for (double three = 45; three < 75; three += 0.25)
            least = std::min(least, std::pow(pair - 12, 2) + std::pow(pair + 10 - 14, 2) +
                                        std::pow(three - 63, 2) + std::pow(three + 10 - 64, 2) +
                                        std::pow(three + 20 - 65, 2));
    }
    QVERIFY(std::abs(moved - least) < 0.1);
}

void TestMatrixView::clickingAPixelActivatesItsCell()
{
    QSignalSpy activated(m_view.get(), &MatrixView::cellActivated);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, middleOf(7, 31));
    QCOMPARE(activated.size(), 1);
    QCOMPARE(activated.at(0), QVariantList({7, 31}));
    QCOMPARE(m_view->currentCell(), (MatrixCell{7, 31}));
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {2, 200});
    QCOMPARE(activated.size(), 1);
}

void TestMatrixView::hoveringTellsTheCellAndItsEnd()
{
    QSignalSpy hovered(m_view.get(), &MatrixView::cellHovered);
    QSignalSpy ended(m_view.get(), &MatrixView::hoverEnded);
    QTest::mouseMove(m_view.get(), middleOf(12, 3));
    QTRY_COMPARE(m_view->hoveredCell(), (MatrixCell{12, 3}));
    QCOMPARE(hovered.last(), QVariantList({12, 3}));
    QTest::mouseMove(m_view.get(), {2, 200});
    QTRY_COMPARE(ended.size(), 1);
}

void TestMatrixView::thePictureShowsTheCellUnderEachPixel()
{
    QTest::mouseMove(m_view.get(), {2, 200});
    const QImage picture = m_view->grab().toImage();
    const double ratio = picture.devicePixelRatio();
    for (const auto& [row, column] : {std::pair(3, 4), {20, 31}, {35, 2}}) {
        const QPointF place = m_view->cellRect({row, column}).center() * ratio;
        const float value = m_values.value(row, column);
        if (value == nothing)
            continue;
        const int step = std::min(static_cast<int>(value * 127), 126);
        QCOMPARE(picture.pixelColor(place.toPoint()), mapColor(ColorMap::Sequential, step / 126.0));
    }
}

void TestMatrixView::zoomKeepsTheCellUnderThePointer()
{
    const QPoint place = middleOf(25, 14);
    const double before = m_view->cellSize();
    QWheelEvent wheel(place, m_view->mapToGlobal(QPointF(place)), {}, {0, 360}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(m_view.get(), &wheel);
    QVERIFY(m_view->cellSize() > 1.5 * before);
    QCOMPARE(m_view->cellAt(place), (MatrixCell{25, 14}));
    QTest::keyClick(m_view.get(), Qt::Key_0);
    QCOMPARE(m_view->cellSize(), before);
}

void TestMatrixView::draggingMovesAndActivatesNothing()
{
    QSignalSpy activated(m_view.get(), &MatrixView::cellActivated);
    m_view->zoomAbout(middleOf(20, 20), 4);
    const QPoint from = m_view->matrixArea().center();
    const auto cell = m_view->cellAt(from);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_view.get(), from + QPoint(30, 10));
    QTest::mouseMove(m_view.get(), from + QPoint(60, 45));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, from + QPoint(60, 45));
    QCOMPARE(m_view->cellAt(from + QPoint(60, 45)), cell);
    QVERIFY(activated.isEmpty());
}

void TestMatrixView::keysMoveTheCellAndActivateIt()
{
    QSignalSpy current(m_view.get(), &MatrixView::currentCellChanged);
    QSignalSpy activated(m_view.get(), &MatrixView::cellActivated);
    m_view->setFocus();
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QCOMPARE(m_view->currentCell(), (MatrixCell{0, 0}));
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QTest::keyClick(m_view.get(), Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(m_view->currentCell(), (MatrixCell{1, 10}));
    QTest::keyClick(m_view.get(), Qt::Key_End);
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QCOMPARE(m_view->currentCell(), (MatrixCell{1, 39}));
    QCOMPARE(current.last(), QVariantList({1, 39}));
    QTest::keyClick(m_view.get(), Qt::Key_Return);
    QCOMPARE(activated.size(), 1);
    QCOMPARE(activated.at(0), QVariantList({1, 39}));
}

void TestMatrixView::pageKeysGoFromBlockToBlock()
{
    m_view->setCurrentCell(MatrixCell{5, 30});
    QTest::keyClick(m_view.get(), Qt::Key_PageDown);
    QCOMPARE(m_view->currentCell(), (MatrixCell{10, 30}));
    QTest::keyClick(m_view.get(), Qt::Key_PageUp, Qt::ShiftModifier);
    QCOMPARE(m_view->currentCell(), (MatrixCell{10, 10}));
}

void TestMatrixView::marksThinOutToTheLightest()
{
    const std::vector<MatrixMark> marks = {{0, 0, 3}, {0, 5, 9}, {1, 1, 1}, {3, 2, 2}, {3, 3, 2}};
    const MatrixMarkRow rows = rowsOf(marks);
    const MatrixPart all{0, 5, 0, 5};
    QCOMPARE(thinMarks(rows, 6, all, 1), marks);
    QCOMPARE(thinMarks(rows, 6, all, 4), (std::vector<MatrixMark>{{1, 1, 1}, {0, 5, 9}}));
    QCOMPARE(thinMarks(rows, 6, all, 2), (std::vector<MatrixMark>{{1, 1, 1}, {0, 5, 9}, {3, 2, 2}}));
    // Of a part only those of whole squares that reach into it.
    QCOMPARE(thinMarks(rows, 6, {1, 1, 1, 1}, 1), (std::vector<MatrixMark>{{1, 1, 1}}));
    QCOMPARE(thinMarks(rows, 6, {2, 2, 2, 2}, 2), (std::vector<MatrixMark>{{3, 2, 2}}));
    QCOMPARE(thinMarks(rows, 6, {0, 1, 5, 5}, 4), (std::vector<MatrixMark>{{0, 5, 9}}));
    QVERIFY(thinMarks(rows, 6, {}, 2).empty());
}

void TestMatrixView::marksShowOnTheirCells()
{
    m_view->zoomAbout(m_view->matrixArea().topLeft(), 10);
    const auto colorAt = [&](int row, int column) {
        const QImage picture = m_view->grab().toImage();
        return picture.pixelColor(
            (m_view->cellRect({row, column}).center() * picture.devicePixelRatio()).toPoint());
    };
    m_view->setMarks(MatrixView::Layer::First, "A", rowsOf({{2, 3, 1}}));
    m_view->setMarks(MatrixView::Layer::Second, "B", rowsOf({{4, 1, 1}}));
    QCOMPARE(colorAt(2, 3), QColor(Qt::white));
    QVERIFY(colorAt(4, 1).red() > 200);
    m_view->setMarksVisible(MatrixView::Layer::First, false);
    QVERIFY(colorAt(2, 3) != QColor(Qt::white));
}

/// Marks are looked for where the table shows.
void TestMatrixView::marksShowWhereTheTableIsMoved()
{
    m_view->setMarks(MatrixView::Layer::First, "A", rowsOf({{2, 3, 1}, {30, 31, 1}}));
    m_view->zoomAbout(m_view->matrixArea().topLeft(), 10);
    for (const MatrixCell& cell : {MatrixCell{2, 3}, MatrixCell{30, 31}, MatrixCell{2, 3}}) {
        m_view->reveal(cell);
        const QImage picture = m_view->grab().toImage();
        QCOMPARE(picture.pixelColor((m_view->cellRect(cell).center() * picture.devicePixelRatio()).toPoint()),
                 QColor(Qt::white));
    }
}

void TestMatrixView::theCellIsReadOut()
{
    m_view->setCurrentCell(MatrixCell{12, 3});
    const QString text = m_view->accessibleDescription();
    QVERIFY2(text.startsWith("jog 2 → walk 3"), qPrintable(text));
    QCOMPARE(text.endsWith("mm"), m_values.has(12, 3));
}

void TestMatrixView::theTableFillsItsPlace()
{
    m_view->resize(900, 420);
    QCOMPARE(m_view->cellRect({0, 0}).topLeft().toPoint(), m_view->matrixArea().topLeft());
    QCOMPARE(m_view->cellRect({39, 39}).bottomRight().toPoint(),
             m_view->matrixArea().bottomRight() + QPoint(1, 1));
    // Coming closer keeps the shape of the cells, going back ends where all shows.
    const double shape = m_view->cellRect({0, 0}).width() / m_view->cellRect({0, 0}).height();
    m_view->zoomAbout(m_view->matrixArea().center(), 3);
    QCOMPARE(m_view->cellRect({0, 0}).width() / m_view->cellRect({0, 0}).height(), shape);
    m_view->zoomAbout(m_view->matrixArea().center(), 0.1);
    QVERIFY(m_view->isFitted());
}

void TestMatrixView::framesAreNumberedAsThereIsRoom()
{
    const auto before = m_view->numberedFrames(Qt::Vertical);
    QVERIFY(std::ranges::count(before, 0) <= 3);
    m_view->zoomAbout(m_view->cellRect({0, 0}).topLeft(), 100);
    const auto after = m_view->numberedFrames(Qt::Vertical);
    QVERIFY(after.size() > 5);
    for (std::size_t i = 0; i < after.size(); ++i)
        QCOMPARE(after[i], static_cast<int>(i));
}

void TestMatrixView::picturesKeepTheirPlace()
{
    m_view->setBlockPictures(std::vector<QImage>(3));
    const QRect area = m_view->matrixArea();
    QImage picture(64, 64, QImage::Format_RGB32);
    picture.fill(QColor(10, 200, 30));
    m_view->setBlockPictures({picture, picture, picture});
    QCOMPARE(m_view->matrixArea(), area);
    const QImage shown = m_view->grab().toImage();
    int left = 0;
    int above = 0;
    const double ratio = shown.devicePixelRatio();
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
            if (shown.pixelColor(x, y) != QColor(10, 200, 30))
                continue;
            left += x < area.left() * ratio ? 1 : 0;
            above += y < area.top() * ratio ? 1 : 0;
        }
    }
    QVERIFY(left > 3 * 600 * ratio);
    QVERIFY(above > 3 * 600 * ratio);
}

void TestMatrixView::whatDoesNotCountIsVeiled()
{
    const auto colorOf = [&](int row, int column) {
        QTest::mouseMove(m_view.get(), {2, 200});
        const QImage picture = m_view->grab().toImage();
        return picture.pixelColor(
            (m_view->cellRect({row, column}).center() * picture.devicePixelRatio()).toPoint());
    };
    const QColor inside = colorOf(3, 4);
    const QColor outside = colorOf(20, 31);
    m_view->setBlockFilter([](int row, int column) { return row == 0 && column == 0; });
    QCOMPARE(colorOf(3, 4), inside);
    QVERIFY(colorOf(20, 31) != outside);
    QVERIFY(!m_view->passesFilter({20, 31}));
    QSignalSpy activated(m_view.get(), &MatrixView::cellActivated);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, middleOf(20, 31));
    QCOMPARE(activated.size(), 1);
    m_view->setBlockFilter({});
    m_view->setCurrentCell({});
    QCOMPARE(colorOf(20, 31), outside);
}

void TestMatrixView::theRightButtonAsksForTheMenu()
{
    QSignalSpy asked(m_view.get(), &MatrixView::menuRequested);
    const QPoint place = middleOf(12, 5);
    QContextMenuEvent byMouse(QContextMenuEvent::Mouse, place, m_view->mapToGlobal(place));
    QApplication::sendEvent(m_view.get(), &byMouse);
    QCOMPARE(asked.size(), 1);
    QCOMPARE(m_view->currentCell(), (MatrixCell{12, 5}));
    QContextMenuEvent byKey(QContextMenuEvent::Keyboard, {1, 1}, {1, 1});
    QApplication::sendEvent(m_view.get(), &byKey);
    QCOMPARE(asked.size(), 2);
    QCOMPARE(asked.last().at(2).toPoint(), m_view->mapToGlobal(place));
}

void TestMatrixView::anEmptyViewSaysSo()
{
    m_view->setEmptyText("Nothing computed");
    m_view->setMatrix({}, nullptr, {});
    QCOMPARE(m_view->accessibleDescription(), QString("Nothing computed"));
    QVERIFY(!m_view->cellAt(m_view->rect().center()));
    QTest::mouseClick(m_view.get(), Qt::LeftButton);
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QVERIFY(!m_view->currentCell());
}

QUADRILLE_QT_TEST(TestMatrixView);
#include "tst_matrixview.moc"
