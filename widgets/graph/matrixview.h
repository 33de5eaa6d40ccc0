// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/matrixmarks.h"
#include "widgets/graph/matrixpyramid.h"
#include "widgets/theme/colormap.h"

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Rows and columns that belong together; blocks follow each other from 0 on without gaps.
struct MatrixBlock
{
    QString name;
    int count = 0;
};

/// A cell of a matrix.
struct MatrixCell
{
    int row = 0;
    int column = 0;
    bool operator==(const MatrixCell&) const = default;
};

/// A square table as a picture that can be zoomed, with the names and pictures of its blocks and the numbers
/// of their frames along both sides, marks on cells and a legend below. Rows are where something comes from,
/// columns where it goes to. The whole table fills its place, so that cells may be broader than high.
///
/// Wheel and pinch zoom at the pointer, dragging moves, a click chooses a cell and activates it. Keys: arrows
/// move the cell that is chosen (Shift: by ten), Page Up and Page Down go to the row's block before or after,
/// with Shift the column's, Home and End to the first and last column, + and − zoom, 0 shows all, Return
/// activates.
class MatrixView : public QWidget
{
    Q_OBJECT

public:
    /// The marks of two graphs: told apart by shape as well as colour.
    enum class Layer
    {
        First, ///< light rings
        Second ///< orange diamonds
    };

    explicit MatrixView(QWidget* parent = nullptr);
    ~MatrixView() override;

    /// Shows another table; nothing with a null pyramid. One of the same size leaves the view where it is.
    /// \param values  maybe none yet, while the pyramid is that of an overview. \param pyramid  of the
    /// values, from `range`'s minimum to its maximum.
    void setMatrix(MatrixValues values, std::shared_ptr<const MatrixPyramid> pyramid,
                   const ScalarRange& range);
    /// \pre their counts add up to the table's side.
    void setBlocks(std::vector<MatrixBlock> blocks);
    const std::vector<MatrixBlock>& blocks() const;
    /// A picture beside the name of each block; null ones keep the place free. Call after setBlocks.
    void setBlockPictures(std::vector<QImage> pictures);
    /// Which pairs of blocks count now, the others are veiled: by row and column; empty for all.
    void setBlockFilter(std::function<bool(int row, int column)> passes);
    bool passesFilter(const MatrixCell& cell) const;
    /// \param title  of the legend, e.g. the name of the graph.
    void setMarks(Layer layer, const QString& title, MatrixMarkRow marks);
    void setMarksVisible(Layer layer, bool visible);
    bool areMarksVisible(Layer layer) const;
    /// What stands in the middle while there is no table.
    void setEmptyText(const QString& text);
    const MatrixValues& values() const;

    /// Emits nothing.
    void setCurrentCell(const std::optional<MatrixCell>& cell);
    std::optional<MatrixCell> currentCell() const;
    std::optional<MatrixCell> hoveredCell() const;
    /// "walk 12 → jog 3: 0.42 mm"; for tool tips, screen readers and read-outs.
    QString cellText(const MatrixCell& cell) const;

    /// Logical pixels of the screen for each cell, along the side on which there are fewer.
    double cellSize() const;
    bool isFitted() const;
    /// Makes cells larger or smaller by a factor; what is at `position`, in pixels of this widget, stays
    /// there.
    void zoomAbout(const QPointF& position, double factor);
    /// Shows all, and keeps doing so when the widget gets another size.
    void fit();
    /// Moves the view as little as needed for a cell to show.
    void reveal(const MatrixCell& cell);
    /// The cell at a place of this widget; none outside of the table or of the area where it shows.
    std::optional<MatrixCell> cellAt(const QPointF& position) const;
    /// Where a cell is drawn, in this widget's coordinates; may lie outside of the area where the table
    /// shows.
    QRectF cellRect(const MatrixCell& cell) const;
    /// Where the table shows: without names and legend.
    QRect matrixArea() const;
    /// The frames of blocks that have their number beside the table now: of rows, or of columns.
    std::vector<int> numberedFrames(Qt::Orientation orientation) const;

    QSize sizeHint() const override { return {720, 640}; }
    QSize minimumSizeHint() const override { return {240, 240}; }

signals:
    /// The pointer is over another cell.
    void cellHovered(int row, int column);
    void hoverEnded();
    /// By the user: a click or a key.
    void currentCellChanged(int row, int column);
    /// A click or Return.
    void cellActivated(int row, int column);
    /// The right button or the menu key on a cell, which becomes the current one.
    void menuRequested(int row, int column, const QPoint& globalPosition);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;

    void viewChanged();
    void moveBy(const QPointF& distance);
    void hover(const std::optional<MatrixCell>& cell);
    void choose(const MatrixCell& cell);
    bool moveByKey(int key, bool byTen);
    void updateAccessibleText();
};

} // namespace quadrille::widgets
