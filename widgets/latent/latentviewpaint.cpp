// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/legendbar.h"
#include "widgets/latent/latentviewprivate.h"
#include "widgets/theme/plate.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double margin = 12; // logical pixels

/// Moved to where it is seen.
void paintInside(QPainter& painter, const QPointF& leftTop, const QString& text, const QRectF& inside)
{
    QRectF plate(leftTop, labelSize(painter, text));
    plate.moveRight(std::min(plate.right(), inside.right()));
    plate.moveLeft(std::max(plate.left(), inside.left()));
    plate.moveBottom(std::min(plate.bottom(), inside.bottom()));
    plate.moveTop(std::max(plate.top(), inside.top()));
    paintLabel(painter, plate, text);
}

QVector3D between(const std::vector<QVector3D>& points, double frame)
{
    const double last = static_cast<double>(points.size()) - 1;
    const double at = std::clamp(frame, 0.0, last);
    const auto first = static_cast<std::size_t>(at);
    const std::size_t second = std::min(first + 1, points.size() - 1);
    return points[first] + (points[second] - points[first]) * static_cast<float>(at - std::floor(at));
}

} // namespace

std::pair<QVector3D, QVector3D> LatentView::Private::box() const
{
    std::pair<QVector3D, QVector3D> box{{-1, -1, -1}, {1, 1, 1}};
    bool isFirst = true;
    for (const LatentPath& path : paths) {
        for (const QVector3D& point : path.points) {
            if (std::exchange(isFirst, false))
                box = {point, point};
            for (int axis = 0; axis < 3; ++axis) {
                box.first[axis] = std::min(box.first[axis], point[axis]);
                box.second[axis] = std::max(box.second[axis], point[axis]);
            }
        }
    }
    const float room = 0.05F * (box.second - box.first).length() + 1e-3F;
    return {box.first - QVector3D(room, room, room), box.second + QVector3D(room, room, room)};
}

std::array<QVector3D, 4> LatentView::Private::axes() const
{
    const auto [lower, upper] = box();
    const QVector3D third(lower.x(), lower.y(), dimensions < 3 ? lower.z() : upper.z());
    return {lower, QVector3D(upper.x(), lower.y(), lower.z()), QVector3D(lower.x(), upper.y(), lower.z()),
            third};
}

std::optional<QPointF> LatentView::Private::project(const QVector3D& point) const
{
    QPointF pixel;
    if (!gestures->camera().project(point, surface->size(), &pixel))
        return std::nullopt;
    return pixel;
}

bool LatentView::Private::isOwnKey(const QKeyEvent& event)
{
    if (event.modifiers() != Qt::NoModifier && event.modifiers() != Qt::KeypadModifier)
        return false;
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F:
    case Qt::Key_1:
    case Qt::Key_3:
    case Qt::Key_7:
        return true;
    default:
        return false;
    }
}

LatentView::Overlay::Overlay(LatentView& view) : QWidget(&view), m_view(view)
{
    setObjectName(QStringLiteral("latentOverlay"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void LatentView::Overlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(Theme::tabularFont(font()));
    m_view.paint(painter);
}

void LatentView::paint(QPainter& painter) const
{
    if (isEmpty()) {
        painter.fillRect(rect(), Theme::color(ColorRole::Window));
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, d->emptyText);
    } else {
        paintAxisNames(painter);
        paintPaths(painter);
        paintTexts(painter);
    }
    if (d->surface->hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void LatentView::paintAxisNames(QPainter& painter) const
{
    const std::array names{QStringLiteral("x₁"), QStringLiteral("x₂"), QStringLiteral("x₃")};
    const auto axes = d->axes();
    painter.setPen(Theme::color(ColorRole::TextMuted));
    for (std::size_t axis = 0; axis < names.size(); ++axis) {
        if (static_cast<int>(axis) >= d->dimensions)
            break;
        if (const auto pixel = d->project(axes.at(axis + 1)))
            painter.drawText(*pixel + QPointF(4, -4), names.at(axis));
    }
}

/// The plate of the legend, at the right: names of lines keep clear of it.
QRectF LatentView::legendPlace(const QFont& font) const
{
    const QSizeF size = legendSize(font, d->range);
    const QPointF leftTop(width() - 4 - size.width() - margin, 4 + margin);
    return QRectF(leftTop, size).adjusted(-8, -8, 8, 8);
}

/// Starts as rings, current frames as dots, names beside the starts of those that were learned from.
void LatentView::paintPaths(QPainter& painter) const
{
    const QFontMetricsF metrics(painter.font());
    for (std::size_t i = 0; i < d->paths.size(); ++i) {
        const LatentPath& path = d->paths[i];
        if (path.points.empty())
            continue;
        if (const auto start = d->project(path.points.front()); start && !path.isSample) {
            painter.setPen(QPen(path.color, 2));
            painter.setBrush(plateColor());
            painter.drawEllipse(*start, 5, 5);
        }
        if (!d->current[i])
            continue;
        if (const auto now = d->project(between(path.points, *d->current[i]))) {
            const double radius = path.isSample ? 4 : 5.5;
            painter.setPen(QPen(Theme::color(ColorRole::Base), 1.5));
            painter.setBrush(path.color);
            painter.drawEllipse(*now, radius, radius);
        }
    }
    const double right = d->isConfidenceShown ? legendPlace(painter.font()).left() : width();
    std::vector<QRectF> taken;
    for (const LatentPath& path : d->paths) {
        if (path.isSample || !path.isNamed || path.points.empty())
            continue;
        const auto start = d->project(path.points.front());
        if (!start)
            continue;
        constexpr double mark = 14.0; // of the dot that has the line's colour
        QRectF plate(*start + QPointF(9, -metrics.height() - 4),
                     QSizeF(metrics.horizontalAdvance(path.name) + mark + 12, metrics.height() + 4));
        plate.moveLeft(std::clamp(plate.left(), 2.0, std::max(right - plate.width() - 2.0, 2.0)));
        const auto isTaken = [&plate](const QRectF& other) { return other.intersects(plate); };
        while (std::any_of(taken.begin(), taken.end(), isTaken))
            plate.translate(0, metrics.height() + 5);
        taken.push_back(plate);
        paintPlate(painter, plate, 3);
        painter.setBrush(path.color);
        painter.drawEllipse(QPointF(plate.left() + mark / 2 + 2, plate.center().y()), 4, 4);
        painter.setPen(Theme::color(ColorRole::Text));
        painter.drawText(plate.adjusted(mark + 2, 0, -4, 0), Qt::AlignLeft | Qt::AlignVCenter, path.name);
    }
}

void LatentView::paintTexts(QPainter& painter) const
{
    const QRectF inside = QRectF(rect()).adjusted(4, 4, -4, -4);
    const QFontMetricsF metrics(painter.font());
    if (d->dimensions > 3) {
        const QString text = tr("The first three of %n dimensions", nullptr, d->dimensions);
        paintInside(painter, {inside.left(), inside.bottom() - metrics.height()}, text, inside);
    }
    if (d->isConfidenceShown) {
        const QRectF plate = legendPlace(painter.font());
        paintPlate(painter, plate, 6);
        paintLegend(painter, plate.adjusted(8, 8, -8, -8), d->range, Theme::color(ColorRole::Text));
    }
    if (!d->chosen)
        return;
    if (const auto pixel = positionOf(*d->chosen)) {
        painter.setPen(QPen(Theme::color(ColorRole::Text), 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*pixel, 8, 8);
        paintInside(painter, *pixel + QPointF(margin, margin), readOut(), inside);
    }
}

} // namespace quadrille::widgets
