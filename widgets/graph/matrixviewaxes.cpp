// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What stands along the sides of a table: names and pictures of blocks, numbers of frames.
#include "widgets/graph/labelspread.h"
#include "widgets/graph/matrixviewprivate.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr int tickLength = 4;    // logical pixels
constexpr double tickRoom = 1.6; // lines of text from one number to the next
constexpr double nameRoom = 0.9; // lines of text from one name to the next
constexpr int numberGap = 6;     // logical pixels between the numbers of columns
constexpr QLatin1String widestNumber("0000");

} // namespace

void MatrixView::Private::layOut(const MatrixView& view)
{
    const QFontMetricsF metrics(view.font());
    double widest = metrics.horizontalAdvance(MatrixView::tr("from ↓ to →"));
    for (const MatrixBlock& block : blocks)
        widest = std::max(widest, metrics.horizontalAdvance(block.name));
    const int line = static_cast<int>(std::ceil(metrics.height()));
    const int names = static_cast<int>(std::ceil(widest));
    const int pictureRoom = pictures.empty() ? 0 : blockPictureSide + matrixGap / 2;
    const int left = std::min(names, view.width() / 6) + 2 * matrixGap + pictureRoom;
    const int top = std::max(std::min(names, view.height() / 7), line) + 2 * matrixGap + pictureRoom;
    outer = view.rect().adjusted(left, top, -matrixGap, -(line + 2 * matrixGap));
    const int numbers = static_cast<int>(std::ceil(metrics.horizontalAdvance(widestNumber))) + tickLength;
    area = outer.adjusted(numbers, line + tickLength, 0, 0);
    area.setSize(area.size().expandedTo({16, 16}));
    const QSizeF fitting = fittingScale();
    if (isFitted || cell() < std::min(fitting.width(), fitting.height())) {
        isFitted = true;
        setScale(fitting, {});
    } else {
        keepInView();
    }
}

std::pair<double, double> MatrixView::Private::shownBlock(std::size_t block,
                                                          Qt::Orientation orientation) const
{
    const bool isAcross = orientation == Qt::Horizontal;
    const double from = isAcross ? origin.x() : origin.y();
    const double each = isAcross ? scale.width() : scale.height();
    const double room = isAcross ? area.width() : area.height();
    const double first = std::max(from + blockStarts[block] * each, 0.0);
    const double last = std::min(from + blockStarts[block + 1] * each, room);
    return {first, last - first};
}

double MatrixView::Private::tickDistance(Qt::Orientation orientation, const QFontMetricsF& metrics) const
{
    return orientation == Qt::Horizontal ? metrics.horizontalAdvance(widestNumber) + numberGap
                                         : metrics.height() * tickRoom;
}

/// Round numbers of frames in each block, as many as there is room for.
std::vector<MatrixView::Private::Tick> MatrixView::Private::ticks(Qt::Orientation orientation,
                                                                  double apart) const
{
    std::vector<Tick> found;
    const double each = orientation == Qt::Horizontal ? scale.width() : scale.height();
    int step = 1;
    for (int power = 1; step * each < apart; power *= 10) {
        for (const int factor : {1, 2, 5}) {
            step = factor * power;
            if (step * each >= apart)
                break;
        }
    }
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        // The last number keeps off the first one of the next block; where only the first would show, the
        // name says as much.
        const int last = blocks[block].count - 1 - static_cast<int>(apart / each / 2);
        if (last < step)
            continue;
        for (int frame = 0; frame <= last; frame += step) {
            const double middle = (blockStarts[block] + frame + 0.5) * each;
            const double place = (orientation == Qt::Horizontal ? origin.x() : origin.y()) + middle;
            if (place >= 0 && place <= (orientation == Qt::Horizontal ? area.width() : area.height()))
                found.push_back({blockStarts[block] + frame, frame});
        }
    }
    return found;
}

void MatrixView::Private::paintTicks(QPainter& painter, const QFontMetricsF& metrics) const
{
    const QLocale locale;
    painter.setPen(Theme::color(ColorRole::TextMuted));
    for (const Tick& tick : ticks(Qt::Vertical, tickDistance(Qt::Vertical, metrics))) {
        const double y = rect({tick.index, 0}).center().y();
        painter.drawLine(QPointF(area.left() - tickLength, y), QPointF(area.left() - 1, y));
        const QRectF place(outer.left() - matrixGap, y - metrics.height() / 2,
                           area.left() - tickLength - 2 - outer.left() + matrixGap, metrics.height());
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, locale.toString(tick.frame));
    }
    const double apart = tickDistance(Qt::Horizontal, metrics);
    for (const Tick& tick : ticks(Qt::Horizontal, apart)) {
        const double x = rect({0, tick.index}).center().x();
        painter.drawLine(QPointF(x, area.top() - tickLength), QPointF(x, area.top() - 1));
        const QRectF place(x - apart / 2, outer.top(), apart, area.top() - tickLength - outer.top());
        painter.drawText(place, Qt::AlignHCenter | Qt::AlignBottom, locale.toString(tick.frame));
    }
}

void MatrixView::Private::paintNames(QPainter& painter, const QFontMetricsF& metrics) const
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QFont usual = painter.font();
    for (const Qt::Orientation orientation : {Qt::Vertical, Qt::Horizontal}) {
        painter.setFont(nameFont(usual, orientation));
        const QFontMetricsF own(painter.font());
        const auto places = namePlaces(orientation, own);
        for (std::size_t block = 0; block < blocks.size(); ++block) {
            if (places[block] && orientation == Qt::Vertical)
                paintRowName(painter, own, block, *places[block]);
            else if (places[block])
                paintColumnName(painter, own, block, *places[block]);
        }
    }
    painter.setFont(usual);
    painter.setPen(Theme::color(ColorRole::TextMuted));
    //: rows of the matrix: where a transition comes from; columns: where it goes to
    painter.drawText(
        QRectF(matrixGap, 0, area.left() - 2.0 * matrixGap, outer.top() - 2.0),
        Qt::AlignLeft | Qt::AlignVCenter,
        metrics.elidedText(MatrixView::tr("from ↓ to →"), Qt::ElideRight, area.left() - 2.0 * matrixGap));
}

/// The usual font, or a smaller one where that lets more names show.
QFont MatrixView::Private::nameFont(const QFont& usual, Qt::Orientation orientation) const
{
    constexpr double smallest = 0.8;
    std::size_t names = 0;
    for (std::size_t block = 0; block < blocks.size(); ++block)
        names += shownBlock(block, orientation).second > 0 ? 1 : 0;
    const double room = orientation == Qt::Horizontal ? area.width() : area.height();
    const double wanted = QFontMetricsF(usual).height() * nameRoom * static_cast<double>(names);
    QFont font = usual;
    if (wanted > room)
        font.setPointSizeF(usual.pointSizeF() * std::max(room / wanted, smallest));
    return font;
}

std::vector<std::optional<double>> MatrixView::Private::namePlaces(Qt::Orientation orientation,
                                                                   const QFontMetricsF& metrics) const
{
    std::vector<std::size_t> seen;
    std::vector<double> wanted;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        const auto [first, length] = shownBlock(block, orientation);
        if (length <= 0)
            continue;
        seen.push_back(block);
        wanted.push_back(first + length / 2);
    }
    const double length = orientation == Qt::Horizontal ? area.width() : area.height();
    // The name of the take that is pointed at is never the one that is left out.
    std::optional<std::size_t> needed;
    if (current) {
        const int block = blockOf(orientation == Qt::Horizontal ? current->column : current->row);
        if (const auto at = std::find(seen.begin(), seen.end(), static_cast<std::size_t>(block));
            at != seen.end())
            needed = static_cast<std::size_t>(at - seen.begin());
    }
    const auto spread = spreadLabels(wanted, metrics.height() * nameRoom, length, needed);
    std::vector<std::optional<double>> places(blocks.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        places[seen[i]] = spread[i];
    return places;
}

double MatrixView::Private::pictureRoom(Qt::Orientation orientation) const
{
    for (std::size_t block = 0; block < pictures.size(); ++block) {
        if (shownBlock(block, orientation).second >= blockPictureSide)
            return blockPictureSide + matrixGap / 2.0;
    }
    return 0;
}

void MatrixView::Private::paintRowName(QPainter& painter, const QFontMetricsF& metrics, std::size_t block,
                                       double middle) const
{
    const auto [top, height] = shownBlock(block, Qt::Vertical);
    const double edge = outer.left() - matrixGap;
    const double own = area.top() + top + height / 2;
    if (block < pictures.size() && height >= blockPictureSide)
        painter.drawImage(
            QRectF(edge - blockPictureSide, own - blockPictureSide / 2.0, blockPictureSide, blockPictureSide),
            pictures[block]);
    const double right = edge - pictureRoom(Qt::Vertical);
    const double y = area.top() + middle;
    const bool isCurrent = current && blockOf(current->row) == static_cast<int>(block);
    if (std::abs(y - own) > 1) {
        painter.setPen(Theme::color(ColorRole::Line));
        painter.drawLine(QPointF(right + 2, y), QPointF(area.left() - 2, own));
    }
    const QRectF place(matrixGap, y - metrics.height() / 2, right - matrixGap, metrics.height());
    painter.setPen(Theme::color(isCurrent ? ColorRole::Text : ColorRole::TextMuted));
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(blocks[block].name, Qt::ElideMiddle, place.width()));
}

void MatrixView::Private::paintColumnName(QPainter& painter, const QFontMetricsF& metrics, std::size_t block,
                                          double middle) const
{
    const auto [left, width] = shownBlock(block, Qt::Horizontal);
    const double edge = outer.top() - matrixGap / 2.0;
    const double own = area.left() + left + width / 2;
    if (block < pictures.size() && width >= blockPictureSide)
        painter.drawImage(
            QRectF(own - blockPictureSide / 2.0, edge - blockPictureSide, blockPictureSide, blockPictureSide),
            pictures[block]);
    const double bottom = edge - pictureRoom(Qt::Horizontal);
    const double x = area.left() + middle;
    const bool isCurrent = current && blockOf(current->column) == static_cast<int>(block);
    const QColor color = Theme::color(isCurrent ? ColorRole::Text : ColorRole::TextMuted);
    const QString& name = blocks[block].name;
    const bool isAtItsPlace = std::abs(x - own) <= 1;
    // The corner at the left says which side is which: there only upright names have room.
    if (isAtItsPlace && metrics.horizontalAdvance(name) <= width && bottom >= metrics.height()) {
        painter.setPen(color);
        painter.drawText(QRectF(area.left() + left, bottom - metrics.height(), width, metrics.height()),
                         Qt::AlignCenter, name);
        return;
    }
    if (!isAtItsPlace) {
        painter.setPen(Theme::color(ColorRole::Line));
        painter.drawLine(QPointF(x, bottom + 2), QPointF(own, area.top() - 2));
    }
    const double room = bottom - matrixGap / 2.0;
    painter.setPen(color);
    painter.save();
    painter.translate(x, bottom);
    painter.rotate(-90);
    painter.drawText(QRectF(0, -metrics.height() / 2, room, metrics.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(name, Qt::ElideMiddle, room));
    painter.restore();
}

} // namespace quadrille::widgets
