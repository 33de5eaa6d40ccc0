// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/matrixview.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <algorithm>
#include <optional>
#include <utility>

class QPainter;

namespace quadrille::widgets {

struct MatrixMarkLayer
{
    QString title;
    MatrixMarkRow marks; ///< null for none
    bool isVisible = true;
    std::vector<MatrixMark> thinned; ///< those of a part that shows, for the zoom now
    MatrixPart part;
    int thinnedBy = 0; ///< cells along each side that share a mark; 0: not thinned yet
};

struct MatrixView::Private
{
    MatrixValues values;
    std::shared_ptr<const MatrixPyramid> pyramid;
    ScalarRange range;
    std::vector<MatrixBlock> blocks;
    std::vector<int> blockStarts{0};      ///< of each block, and the end of the last
    std::vector<QImage> pictures;         ///< of blocks; none where there are no pictures at all
    std::function<bool(int, int)> passes; ///< pairs of blocks that count; empty for all
    std::array<MatrixMarkLayer, 2> layers;
    QString emptyText;
    std::optional<MatrixCell> current;
    std::optional<MatrixCell> hovered;

    QRect area;         ///< where the table shows
    QRect outer;        ///< the area with the numbers of frames beside it
    QSizeF scale{1, 1}; ///< logical pixels for each cell
    QPointF origin;     ///< upper left corner of the table, in the area's coordinates
    bool isFitted = true;

    QPointF pressedAt;
    QPointF pointer;
    bool isPressed = false;
    bool isDragging = false;

    QImage picture; ///< the part of the table that shows; null when it has to be painted again
    std::array<QPixmap, 2> stamps;
    double stampRadius = 0;

    bool isEmpty() const { return !pyramid || pyramid->levelCount() == 0; }
    int side() const { return isEmpty() ? 0 : pyramid->side(); }
    QSizeF fittingScale() const;
    /// The smaller side of a cell.
    double cell() const { return std::min(scale.width(), scale.height()); }
    void setScale(const QSizeF& to, const QPointF& newOrigin);
    void keepInView();
    int blockOf(int index) const;
    QRectF rect(const MatrixCell& cell) const;
    /// What shows of the table, and a little more around it. \pre Not empty.
    MatrixPart shownPart(double around) const;
    QString frameText(int index) const;
    bool hasPassed(const MatrixCell& cell) const;
    /// A number beside the table, and its row or column.
    struct Tick
    {
        int index = 0; ///< of the table
        int frame = 0; ///< of its block
    };
    std::vector<Tick> ticks(Qt::Orientation orientation, double apart) const;
    double tickDistance(Qt::Orientation orientation, const QFontMetricsF& metrics) const;
    /// Where a block lies along a side of the area, as far as it shows: start and length.
    std::pair<double, double> shownBlock(std::size_t block, Qt::Orientation orientation) const;

    void layOut(const MatrixView& view);
    void paint(QPainter& painter, const MatrixView& view);
    void paintPicture(double ratio);
    void paintBlocks(QPainter& painter) const;
    void paintVeil(QPainter& painter) const;
    void paintNames(QPainter& painter, const QFontMetricsF& metrics) const;
    /// Middles of the blocks' names along a side of the table; those of blocks that are not seen have none.
    QFont nameFont(const QFont& usual, Qt::Orientation orientation) const;
    std::vector<std::optional<double>> namePlaces(Qt::Orientation orientation,
                                                  const QFontMetricsF& metrics) const;
    /// What a side keeps free for pictures: nothing while no block is broad enough for one.
    double pictureRoom(Qt::Orientation orientation) const;
    void paintRowName(QPainter& painter, const QFontMetricsF& metrics, std::size_t block,
                      double middle) const;
    void paintColumnName(QPainter& painter, const QFontMetricsF& metrics, std::size_t block,
                         double middle) const;
    void paintTicks(QPainter& painter, const QFontMetricsF& metrics) const;
    void paintMarks(QPainter& painter, double ratio);
    void paintCells(QPainter& painter, bool hasFocus) const;
    void paintLegend(QPainter& painter, const MatrixView& view) const;
    double paintColors(QPainter& painter, double left, double middle) const;
};

/// Between what stands beside the table, logical pixels.
constexpr int matrixGap = 8;
/// The side of a block's picture.
constexpr int blockPictureSide = 28;

/// How a mark of a layer looks, about the origin.
void paintMatrixMark(QPainter& painter, MatrixView::Layer layer, const QPointF& middle, double radius);

} // namespace quadrille::widgets
