// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixviewprivate.h"
#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double largestCell = 48; // logical pixels

} // namespace

MatrixView::MatrixView(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    setObjectName(QStringLiteral("matrixView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        d->stamps = {};
        viewChanged();
    });
    d->layOut(*this);
    updateAccessibleText();
}

MatrixView::~MatrixView() = default;

void MatrixView::setMatrix(MatrixValues values, std::shared_ptr<const MatrixPyramid> pyramid,
                           const ScalarRange& range)
{
    const int before = d->side();
    d->values = std::move(values);
    d->pyramid = std::move(pyramid);
    d->range = range;
    const auto isInside = [this](const std::optional<MatrixCell>& cell) {
        return cell && cell->row < d->side() && cell->column < d->side();
    };
    if (d->side() != before) {
        d->isFitted = true;
        if (!isInside(d->current))
            d->current.reset();
        if (!isInside(d->hovered))
            hover({});
    }
    d->layOut(*this);
    updateAccessibleText();
    viewChanged();
}

void MatrixView::setBlocks(std::vector<MatrixBlock> blocks)
{
    d->blocks = std::move(blocks);
    d->blockStarts = {0};
    for (const MatrixBlock& block : d->blocks)
        d->blockStarts.push_back(d->blockStarts.back() + block.count);
    d->pictures.clear();
    d->passes = {};
    d->layOut(*this);
    updateAccessibleText();
    viewChanged();
}

const std::vector<MatrixBlock>& MatrixView::blocks() const
{
    return d->blocks;
}

void MatrixView::setBlockPictures(std::vector<QImage> pictures)
{
    const bool isLayOutSame = pictures.empty() == d->pictures.empty();
    d->pictures = std::move(pictures);
    if (!isLayOutSame) {
        d->layOut(*this);
        viewChanged();
    }
    update();
}

void MatrixView::setBlockFilter(std::function<bool(int row, int column)> passes)
{
    d->passes = std::move(passes);
    update();
}

bool MatrixView::passesFilter(const MatrixCell& cell) const
{
    return d->hasPassed(cell);
}

bool MatrixView::Private::hasPassed(const MatrixCell& cell) const
{
    return !passes || passes(blockOf(cell.row), blockOf(cell.column));
}

void MatrixView::setMarks(Layer layer, const QString& title, MatrixMarkRow marks)
{
    MatrixMarkLayer& own = d->layers[static_cast<std::size_t>(layer)];
    const bool isLayOutSame = own.title == title;
    own.title = title;
    own.marks = std::move(marks);
    own.thinnedBy = 0;
    if (!isLayOutSame) {
        d->layOut(*this);
        viewChanged();
    }
    update();
}

void MatrixView::setMarksVisible(Layer layer, bool visible)
{
    d->layers[static_cast<std::size_t>(layer)].isVisible = visible;
    update();
}

bool MatrixView::areMarksVisible(Layer layer) const
{
    return d->layers[static_cast<std::size_t>(layer)].isVisible;
}

void MatrixView::setEmptyText(const QString& text)
{
    d->emptyText = text;
    updateAccessibleText();
    update();
}

const MatrixValues& MatrixView::values() const
{
    return d->values;
}

void MatrixView::setCurrentCell(const std::optional<MatrixCell>& cell)
{
    if (cell == d->current)
        return;
    d->current = cell;
    updateAccessibleText();
    update();
}

std::optional<MatrixCell> MatrixView::currentCell() const
{
    return d->current;
}

std::optional<MatrixCell> MatrixView::hoveredCell() const
{
    return d->hovered;
}

QString MatrixView::cellText(const MatrixCell& cell) const
{
    const QString from = d->frameText(cell.row);
    const QString to = d->frameText(cell.column);
    if (!d->values.has(cell.row, cell.column))
        //: two frames, the first the source, the second the destination
        return tr("%1 → %2: nothing").arg(from, to);
    const QString value = QLocale().toString(d->values.value(cell.row, cell.column), 'g', 3);
    //: two frames, a number and its unit
    return tr("%1 → %2: %3 %4").arg(from, to, value, d->range.unit).trimmed();
}

QString MatrixView::Private::frameText(int index) const
{
    const int block = blockOf(index);
    if (block < 0)
        return QLocale().toString(index);
    const auto at = static_cast<std::size_t>(block);
    //: a sequence and one of its frames
    return MatrixView::tr("%1 %2").arg(blocks[at].name, QLocale().toString(index - blockStarts[at]));
}

int MatrixView::Private::blockOf(int index) const
{
    const auto after = std::upper_bound(blockStarts.begin(), blockStarts.end(), index);
    const auto block = static_cast<int>(after - blockStarts.begin()) - 1;
    return block < static_cast<int>(blocks.size()) ? block : -1;
}

double MatrixView::cellSize() const
{
    return d->cell();
}

bool MatrixView::isFitted() const
{
    return d->isFitted;
}

QSizeF MatrixView::Private::fittingScale() const
{
    return QSizeF(area.size()) / std::max(side(), 1);
}

void MatrixView::Private::setScale(const QSizeF& to, const QPointF& newOrigin)
{
    scale = to;
    origin = newOrigin;
    keepInView();
}

/// The table covers the area.
void MatrixView::Private::keepInView()
{
    const auto kept = [this](double at, double each, double room) {
        const double size = side() * each;
        return size <= room ? 0.0 : std::clamp(at, room - size, 0.0);
    };
    origin = {kept(origin.x(), scale.width(), area.width()), kept(origin.y(), scale.height(), area.height())};
}

void MatrixView::zoomAbout(const QPointF& position, double factor)
{
    if (d->isEmpty())
        return;
    const QSizeF fitting = d->fittingScale();
    const double smallest = std::min(fitting.width(), fitting.height());
    const double cell = std::clamp(d->cell() * factor, smallest, std::max(largestCell, smallest));
    if (cell == smallest) {
        fit();
        return;
    }
    const double change = cell / d->cell();
    const QPointF inArea = position - QPointF(d->area.topLeft());
    d->isFitted = false;
    d->setScale(d->scale * change, inArea - (inArea - d->origin) * change);
    viewChanged();
}

void MatrixView::fit()
{
    d->isFitted = true;
    d->setScale(d->fittingScale(), {});
    viewChanged();
}

void MatrixView::moveBy(const QPointF& distance)
{
    d->isFitted = false;
    d->origin += distance;
    d->keepInView();
    viewChanged();
}

void MatrixView::reveal(const MatrixCell& cell)
{
    const QRectF place = d->rect(cell);
    const auto missing = [](double low, double high, double least, double greatest) {
        return low < least ? least - low : std::min(greatest - high, 0.0);
    };
    const QPointF distance(missing(place.left(), place.right(), d->area.left(), d->area.right() + 1),
                           missing(place.top(), place.bottom(), d->area.top(), d->area.bottom() + 1));
    if (!distance.isNull())
        moveBy(distance);
}

std::optional<MatrixCell> MatrixView::cellAt(const QPointF& position) const
{
    if (d->isEmpty() || !QRectF(d->area).contains(position))
        return {};
    const QPointF inTable = position - QPointF(d->area.topLeft()) - d->origin;
    const MatrixCell found{static_cast<int>(std::floor(inTable.y() / d->scale.height())),
                           static_cast<int>(std::floor(inTable.x() / d->scale.width()))};
    if (found.row < 0 || found.column < 0 || found.row >= d->side() || found.column >= d->side())
        return {};
    return found;
}

QRectF MatrixView::Private::rect(const MatrixCell& cell) const
{
    return {area.left() + origin.x() + cell.column * scale.width(),
            area.top() + origin.y() + cell.row * scale.height(), scale.width(), scale.height()};
}

MatrixPart MatrixView::Private::shownPart(double around) const
{
    const auto cell = [this](double place, double start, double size) {
        return static_cast<int>(std::clamp(std::floor((place - start) / size), 0.0, side() - 1.0));
    };
    return {.firstRow = cell(-around, origin.y(), scale.height()),
            .lastRow = cell(area.height() + around, origin.y(), scale.height()),
            .firstColumn = cell(-around, origin.x(), scale.width()),
            .lastColumn = cell(area.width() + around, origin.x(), scale.width())};
}

QRectF MatrixView::cellRect(const MatrixCell& cell) const
{
    return d->rect(cell);
}

QRect MatrixView::matrixArea() const
{
    return d->area;
}

std::vector<int> MatrixView::numberedFrames(Qt::Orientation orientation) const
{
    std::vector<int> frames;
    for (const Private::Tick& tick :
         d->ticks(orientation, d->tickDistance(orientation, QFontMetricsF(font()))))
        frames.push_back(tick.frame);
    return frames;
}

void MatrixView::viewChanged()
{
    d->picture = {};
    update();
}

void MatrixView::hover(const std::optional<MatrixCell>& cell)
{
    if (cell == d->hovered)
        return;
    d->hovered = cell;
    update();
    if (cell)
        emit cellHovered(cell->row, cell->column);
    else
        emit hoverEnded();
}

void MatrixView::choose(const MatrixCell& cell)
{
    const bool isNew = cell != d->current;
    setCurrentCell(cell);
    if (isNew)
        emit currentCellChanged(cell.row, cell.column);
}

void MatrixView::updateAccessibleText()
{
    setAccessibleDescription(d->isEmpty() ? d->emptyText
                             : d->current ? cellText(*d->current)
                                          : tr("No cell is chosen"));
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

} // namespace quadrille::widgets

#include "moc_matrixview.cpp"
