// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/chartscale.h"
#include "widgets/graph/matrixviewprivate.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double barLength = 96;     // of the legend
constexpr double markDistance = 9;   // logical pixels between marks at the least
constexpr double smallestRadius = 2; // of marks
constexpr double largestRadius = 5;  //

std::array<QRgb, 256> shadeColors()
{
    std::array<QRgb, 256> colors{};
    const QColor empty = Theme::color(ColorRole::Raised);
    const QColor dark = Theme::color(ColorRole::TextMuted);
    colors.fill(empty.rgb());
    constexpr std::size_t steps = MatrixPyramid::colorSteps;
    for (std::size_t step = 0; step < steps; ++step) {
        const double place = static_cast<double>(step) / (steps - 1);
        colors[step] = mapColor(ColorMap::Sequential, place).rgb();
        const double grey = 0.45 + 0.35 * place; // towards the colour of empty cells
        const auto mix = [grey](int from, int to) { return qRound(from + (to - from) * grey); };
        colors[step + MatrixPyramid::firstGrey] = qRgb(
            mix(dark.red(), empty.red()), mix(dark.green(), empty.green()), mix(dark.blue(), empty.blue()));
    }
    return colors;
}

/// The cell that each pixel of the screen shows, of a level after so many halvings; −1 beside the table.
std::vector<int> cellsOfPixels(int pixels, double ratio, double origin, double scale, int halvings, int side)
{
    std::vector<int> cells(static_cast<std::size_t>(pixels), -1);
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double cell = std::floor(((pixel + 0.5) / ratio - origin) / scale);
        if (cell >= 0 && cell < side)
            cells[static_cast<std::size_t>(pixel)] = static_cast<int>(cell) >> halvings;
    }
    return cells;
}

/// The first and the last of them that are in the table; 0 and −1 where none is.
std::pair<int, int> shownCells(const std::vector<int>& cells)
{
    const auto isShown = [](int cell) { return cell >= 0; };
    const auto first = std::ranges::find_if(cells, isShown);
    if (first == cells.end())
        return {0, -1};
    return {*first, *std::max_element(first, cells.end())};
}

} // namespace

void paintMatrixMark(QPainter& painter, MatrixView::Layer layer, const QPointF& middle, double radius)
{
    const bool isFirst = layer == MatrixView::Layer::First;
    QPainterPath path;
    if (isFirst) {
        path.addEllipse(middle, radius, radius);
    } else {
        const double reach = radius * 1.3;
        path.addPolygon(QPolygonF({middle + QPointF(0, -reach), middle + QPointF(reach, 0),
                                   middle + QPointF(0, reach), middle + QPointF(-reach, 0)}));
        path.closeSubpath();
    }
    painter.setPen(QPen(QColor(16, 17, 20), 1.0));
    painter.setBrush(isFirst ? QColor(255, 255, 255) : QColor(0xF2, 0x7A, 0x1A));
    painter.drawPath(path);
}

void MatrixView::Private::paint(QPainter& painter, const MatrixView& view)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(view.rect(), Theme::color(ColorRole::Window));
    if (isEmpty()) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(view.rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         emptyText);
    } else {
        const double ratio = view.devicePixelRatioF();
        if (picture.isNull() || picture.devicePixelRatio() != ratio)
            paintPicture(ratio);
        painter.drawImage(area.topLeft(), picture);
        painter.save();
        painter.setClipRect(area);
        paintVeil(painter);
        paintBlocks(painter);
        paintMarks(painter, ratio);
        paintCells(painter, view.hasFocus());
        painter.restore();
        paintNames(painter, QFontMetricsF(view.font()));
        paintTicks(painter, QFontMetricsF(view.font()));
        paintLegend(painter, view);
    }
    if (view.hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(view.rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

/// Every pixel of the screen shows the cell under its middle; zoomed out, a cell of the level that has about
/// as many cells as there are pixels. Pixels in one row of cells are the same and copied.
void MatrixView::Private::paintPicture(double ratio)
{
    const QSize pixels(static_cast<int>(std::lround(area.width() * ratio)),
                       static_cast<int>(std::lround(area.height() * ratio)));
    picture = QImage(pixels, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    const int level = pyramid->levelFor(1.0 / (cell() * ratio));
    const int halvings = pyramid->halvings(level);
    const auto columns = cellsOfPixels(pixels.width(), ratio, origin.x(), scale.width(), halvings, side());
    const auto rows = cellsOfPixels(pixels.height(), ratio, origin.y(), scale.height(), halvings, side());
    const std::array<QRgb, 256> colors = shadeColors();
    const QRgb outside = Theme::color(ColorRole::Window).rgb();
    const auto [first, last] = shownCells(columns);
    std::vector<MatrixPyramid::Shade> shades(static_cast<std::size_t>(last - first + 1));
    int rowBefore = -2;
    for (int y = 0; y < pixels.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        const int row = rows[static_cast<std::size_t>(y)];
        if (row == rowBefore) {
            const auto* above = reinterpret_cast<const QRgb*>(picture.constScanLine(y - 1));
            std::copy_n(above, pixels.width(), line);
        } else if (row < 0) {
            std::fill_n(line, pixels.width(), outside);
        } else {
            pyramid->read(level, row, first, shades);
            for (int x = 0; x < pixels.width(); ++x) {
                const int column = columns[static_cast<std::size_t>(x)];
                line[x] = column < 0 ? outside : colors[shades[static_cast<std::size_t>(column - first)]];
            }
        }
        rowBefore = row;
    }
}

void MatrixView::Private::paintBlocks(QPainter& painter) const
{
    const QSizeF end = scale * side();
    QColor color = Theme::color(ColorRole::Window);
    color.setAlphaF(0.6F);
    painter.setPen(QPen(color, 1.0));
    for (std::size_t i = 1; i + 1 < blockStarts.size(); ++i) {
        const double x = std::floor(area.left() + origin.x() + blockStarts[i] * scale.width()) + 0.5;
        const double y = std::floor(area.top() + origin.y() + blockStarts[i] * scale.height()) + 0.5;
        painter.drawLine(QPointF(x, area.top() + origin.y()),
                         QPointF(x, area.top() + origin.y() + end.height()));
        painter.drawLine(QPointF(area.left() + origin.x(), y),
                         QPointF(area.left() + origin.x() + end.width(), y));
    }
}

/// What does not count shows faintly: it can still be read and clicked.
void MatrixView::Private::paintVeil(QPainter& painter) const
{
    if (!passes)
        return;
    constexpr float opacity = 0.82F;
    QColor veil = Theme::color(ColorRole::Window);
    veil.setAlphaF(opacity);
    for (std::size_t row = 0; row < blocks.size(); ++row) {
        for (std::size_t column = 0; column < blocks.size(); ++column) {
            if (passes(static_cast<int>(row), static_cast<int>(column)))
                continue;
            const QRectF first = rect({blockStarts[row], blockStarts[column]});
            painter.fillRect(QRectF(first.topLeft(), QSizeF(scale.width() * blocks[column].count,
                                                            scale.height() * blocks[row].count)),
                             veil);
        }
    }
}

void MatrixView::Private::paintMarks(QPainter& painter, double ratio)
{
    int cells = 1;
    while (cells * cell() < markDistance && cells < side())
        cells *= 2;
    const double radius = std::clamp(cell() * 0.3, smallestRadius, largestRadius);
    if (radius != stampRadius || stamps[0].isNull() || stamps[0].devicePixelRatio() != ratio) {
        stampRadius = radius;
        const double reach = std::ceil(radius * 1.3 + 1.0);
        for (std::size_t i = 0; i < stamps.size(); ++i) {
            stamps[i] = QPixmap(QSizeF(2 * reach * ratio, 2 * reach * ratio).toSize());
            stamps[i].setDevicePixelRatio(ratio);
            stamps[i].fill(Qt::transparent);
            QPainter stamp(&stamps[i]);
            stamp.setRenderHint(QPainter::Antialiasing);
            paintMatrixMark(stamp, static_cast<Layer>(i), {reach, reach}, radius);
        }
    }
    // The second layer first: where both mark a cell, the smaller ring stays visible on the diamond.
    for (std::size_t i = layers.size(); i-- > 0;) {
        MatrixMarkLayer& layer = layers[i];
        if (!layer.marks || !layer.isVisible)
            continue;
        const double half = stamps[i].width() / ratio / 2;
        const MatrixPart shown = shownPart(half);
        if (layer.thinnedBy != cells || !layer.part.contains(shown)) {
            layer.part = shown.grown(side());
            layer.thinned = thinMarks(layer.marks, side(), layer.part, cells);
            layer.thinnedBy = cells;
        }
        const QRectF reach = QRectF(area).adjusted(-half, -half, half, half);
        for (const MatrixMark& mark : layer.thinned) {
            const QPointF middle = rect({mark.row, mark.column}).center();
            if (reach.contains(middle) && hasPassed({mark.row, mark.column}))
                painter.drawPixmap(middle - QPointF(half, half), stamps[i]);
        }
    }
}

void MatrixView::Private::paintCells(QPainter& painter, bool hasFocus) const
{
    const auto frame = [&](const MatrixCell& cell, const QColor& color, double width) {
        QRectF place = rect(cell);
        const double across = std::max(0.0, 6.0 - place.width()) / 2;
        const double down = std::max(0.0, 6.0 - place.height()) / 2;
        place.adjust(-across, -down, across, down);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(16, 17, 20), width + 2));
        painter.drawRect(place);
        painter.setPen(QPen(color, width));
        painter.drawRect(place);
    };
    const auto cross = [&](const MatrixCell& cell, float opacity) {
        QColor color = QColor(255, 255, 255);
        color.setAlphaF(opacity);
        painter.setPen(QPen(color, 1.0));
        const QPointF middle = rect(cell).center();
        const QSizeF end = scale * side();
        const double x = std::floor(middle.x()) + 0.5;
        const double y = std::floor(middle.y()) + 0.5;
        painter.drawLine(QPointF(x, area.top() + origin.y()),
                         QPointF(x, area.top() + origin.y() + end.height()));
        painter.drawLine(QPointF(area.left() + origin.x(), y),
                         QPointF(area.left() + origin.x() + end.width(), y));
    };
    if (current) {
        cross(*current, 0.35F);
        frame(*current, hasFocus ? Theme::color(ColorRole::Accent) : QColor(255, 255, 255), 2);
    }
    if (hovered && hovered != current) {
        cross(*hovered, 0.2F);
        frame(*hovered, QColor(255, 255, 255), 1);
    }
}

/// A bar of the colours between the ends of the range. \return where it ends.
double MatrixView::Private::paintColors(QPainter& painter, double left, double middle) const
{
    const QFontMetricsF metrics(painter.font());
    const auto text = [&](const QString& words) {
        painter.setPen(Theme::color(ColorRole::Text));
        painter.drawText(QPointF(left, middle + (metrics.ascent() - metrics.descent()) / 2), words);
        left += metrics.horizontalAdvance(words) + matrixGap;
    };
    //: title of a legend, then its unit
    text(range.unit.isEmpty() ? range.title : MatrixView::tr("%1 (%2)").arg(range.title, range.unit));
    text(chartNumber(range.minimum));
    const QRectF bar(left, middle - 5, barLength, 10);
    QLinearGradient colors(bar.topLeft(), bar.topRight());
    constexpr int stops = 16;
    for (int i = 0; i <= stops; ++i)
        colors.setColorAt(static_cast<double>(i) / stops,
                          mapColor(range.map, static_cast<double>(i) / stops));
    painter.fillRect(bar, colors);
    left += barLength + matrixGap;
    text(QStringLiteral("≥ %1").arg(chartNumber(range.maximum)));
    return left + matrixGap;
}

void MatrixView::Private::paintLegend(QPainter& painter, const MatrixView& view) const
{
    const QFontMetricsF metrics(view.font());
    const double middle = view.height() - matrixGap - metrics.height() / 2;
    double left = paintColors(painter, matrixGap, middle);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].title.isEmpty() || !layers[i].isVisible)
            continue;
        paintMatrixMark(painter, static_cast<Layer>(i), {left + 5, middle}, 4);
        left += 2.0 * matrixGap;
        painter.setPen(Theme::color(ColorRole::Text));
        const double room = std::max(view.width() - left - matrixGap, 0.0);
        painter.drawText(QPointF(left, middle + (metrics.ascent() - metrics.descent()) / 2),
                         metrics.elidedText(layers[i].title, Qt::ElideRight, room));
        left += metrics.horizontalAdvance(layers[i].title) + 2.0 * matrixGap;
    }
}

} // namespace quadrille::widgets
