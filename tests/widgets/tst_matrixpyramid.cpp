// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "tests/widgets/randomvalues.h"
#include "widgets/graph/matrixview.h"

#include <QTest>
#include <algorithm>

using namespace quadrille::widgets;

namespace {

using Shades = std::vector<MatrixPyramid::Shade>;

/// Row by row.
Shades shadesOf(const MatrixPyramid& pyramid, int level)
{
    const auto side = static_cast<std::size_t>(pyramid.sideOf(level));
    Shades shades(side * side);
    for (std::size_t row = 0; row < side; ++row)
        pyramid.read(level, static_cast<int>(row), 0, std::span(shades).subspan(row * side, side));
    return shades;
}

} // namespace

class TestMatrixPyramid : public QObject
{
    Q_OBJECT
private slots:
    void everyLevelShowsTheCheapestCellThatPasses_data();
    void everyLevelShowsTheCheapestCellThatPasses();
    void anOverviewLooksLikeTheWholeFromAfar();
    void aPyramidCanBeCancelled();
    void theLevelHasAboutACellForEachPixel();
};

void TestMatrixPyramid::everyLevelShowsTheCheapestCellThatPasses_data()
{
    QTest::addColumn<int>("side");
    QTest::addColumn<bool>("filtered");
    for (const int side : {1, 2, 5, 16, 37})
        for (const bool filtered : {false, true})
            QTest::addRow("%d %s", side, filtered ? "filtered" : "all") << side << filtered;
}

void TestMatrixPyramid::everyLevelShowsTheCheapestCellThatPasses()
{
    QFETCH(const int, side);
    QFETCH(const bool, filtered);
    const MatrixValues values = randomValues(side, 11);
    const MatrixFilter filter = filtered ? MatrixFilter{0.6F, 5, 30} : MatrixFilter{};
    const auto pyramid = buildMatrixPyramid(values, 0.1F, 0.9F, filter);
    int cells = 1;
    for (int level = 0; level < pyramid->levelCount(); ++level) {
        const int levelSide = pyramid->sideOf(level);
        QCOMPARE(levelSide, (side + cells - 1) / cells);
        const Shades shades = shadesOf(*pyramid, level);
        for (int row = 0; row < levelSide; ++row) {
            for (int column = 0; column < levelSide; ++column) {
                float cheapest = nothing;
                float cheapestGrey = nothing;
                for (int i = row * cells; i < std::min((row + 1) * cells, side); ++i)
                    for (int j = column * cells; j < std::min((column + 1) * cells, side); ++j) {
                        float& least =
                            filter.passes(values.value(i, j), values.length(i, j)) ? cheapest : cheapestGrey;
                        least = std::min(least, values.value(i, j));
                    }
                const auto step = [](float value) {
                    return std::clamp(static_cast<int>((value - 0.1F) * (127 / (0.9F - 0.1F))), 0, 126);
                };
                const int expected = cheapest < nothing       ? step(cheapest)
                                     : cheapestGrey < nothing ? 127 + step(cheapestGrey)
                                                              : 255;
                QCOMPARE(static_cast<int>(shades[static_cast<std::size_t>(row * levelSide + column)]),
                         expected);
                MatrixPyramid::Shade one = 0;
                pyramid->read(level, row, column, std::span(&one, 1));
                QCOMPARE(static_cast<int>(one), expected);
            }
        }
        cells *= 2;
    }
    QCOMPARE(pyramid->sideOf(pyramid->levelCount() - 1), 1);
}

/// Before the numbers of a table are there.
void TestMatrixPyramid::anOverviewLooksLikeTheWholeFromAfar()
{
    const int side = 701;
    const int each = 4;
    const MatrixValues values = randomValues(side, 5);
    const int squares = (side + each - 1) / each;
    std::vector<float> least(static_cast<std::size_t>(squares) * static_cast<std::size_t>(squares), nothing);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            float& square = least[static_cast<std::size_t>(row / each) * static_cast<std::size_t>(squares) +
                                  static_cast<std::size_t>(column / each)];
            square = std::min(square, values.value(row, column));
        }
    }
    const MatrixOverview overview{side, each, {std::shared_ptr<void>(), least.data()}};
    QCOMPARE(overview.squares(), squares);
    const auto whole = buildMatrixPyramid(values, 0.1F, 0.9F);
    const auto known = buildMatrixPyramid(overview, 0.1F, 0.9F);
    QCOMPARE(known->side(), side);
    QCOMPARE(known->levelCount(), whole->levelCount() - 2);
    for (int level = 0; level < known->levelCount(); ++level)
        QCOMPARE(shadesOf(*known, level), shadesOf(*whole, level + 2));
    for (const double cells : {0.1, 1.0, 3.9, 4.0, 7.9, 8.0, 100.0})
        QCOMPARE(known->halvings(known->levelFor(cells)), std::max(whole->levelFor(cells), 2));

    MatrixView view;
    view.setBlocks({{"walk", side}});
    view.resize(240, 240); // more than four cells for each pixel
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    view.setMatrix({}, known, {0.1, 0.9, ColorMap::Sequential, "Cost", "mm"});
    const QImage fromAfar = view.grab().toImage();
    QCOMPARE(view.cellText({1, 2}), QString("walk 1 → walk 2: nothing"));
    view.setMatrix(values, whole, {0.1, 0.9, ColorMap::Sequential, "Cost", "mm"});
    QCOMPARE(view.grab().toImage(), fromAfar);
    QVERIFY(view.isFitted());
}

void TestMatrixPyramid::aPyramidCanBeCancelled()
{
    int asked = 0;
    QVERIFY(!buildMatrixPyramid(randomValues(300, 1), 0, 1, {}, [&] { return ++asked == 3; }));
    QCOMPARE(asked, 3);
}

void TestMatrixPyramid::theLevelHasAboutACellForEachPixel()
{
    const auto pyramid = buildMatrixPyramid(randomValues(64, 1), 0, 1);
    QCOMPARE(pyramid->levelFor(0.1), 0);
    QCOMPARE(pyramid->levelFor(1.9), 0);
    QCOMPARE(pyramid->levelFor(2), 1);
    QCOMPARE(pyramid->levelFor(9), 3);
    QCOMPARE(pyramid->levelFor(1e9), 6);
}

QUADRILLE_QT_TEST(TestMatrixPyramid);
#include "tst_matrixpyramid.moc"
