// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/spacemap.h"

#include "editor/fields/measuretext.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille {

using widgets::ColorRole;
using widgets::Theme;

namespace {

constexpr double margin = 10;      // pixels around the area
constexpr double takeRadius = 4;   // pixels
constexpr double playedRadius = 6; // pixels
constexpr double nodeRadius = 2;   // pixels, of references
constexpr double flatHeight = 28;  // pixels, of the area of an interval
constexpr double fullHeight = 130; // pixels, of that of triangles
constexpr double nameGap = 6;      // pixels
constexpr double leastShare = 0.005;

double shareOf(double value, double least, double greatest)
{
    return greatest > least ? (value - least) / (greatest - least) : 0.5;
}

} // namespace

SpaceMap::SpaceMap(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("spaceMap"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void SpaceMap::setSpace(std::shared_ptr<const MotionSpace> space)
{
    if (space == m_space)
        return;
    m_space = std::move(space);
    m_played.reset();
    m_pointed.reset();
    updateGeometry();
    update();
}

void SpaceMap::setPlayed(const std::optional<SpacePoint>& place)
{
    if (place == m_played)
        return;
    m_played = place;
    update();
}

void SpaceMap::setEditable(bool editable)
{
    m_isEditable = editable;
    setCursor(editable ? Qt::CrossCursor : Qt::ArrowCursor);
}

QSize SpaceMap::sizeHint() const
{
    const int line = fontMetrics().height();
    // Names above an interval, its limits below; then the shares.
    const double lines = isFlat() ? 3 * line : 2 * line;
    return {160, static_cast<int>((isFlat() ? flatHeight : fullHeight) + lines + 2 * nameGap)};
}

QRectF SpaceMap::area() const
{
    const double line = fontMetrics().height();
    const double top = isFlat() ? line + nameGap : nameGap;
    const double bottom = 2 * line + nameGap;
    return {margin, top, std::max(1.0, width() - 2 * margin), std::max(1.0, height() - top - bottom)};
}

QPointF SpaceMap::positionOf(const SpacePoint& place) const
{
    const ParameterMap& map = m_space->map;
    const QRectF within = area();
    const double across = shareOf(place[0], map.least[0], map.greatest[0]);
    const double up = isFlat() ? 0.5 : shareOf(place[1], map.least[1], map.greatest[1]);
    return {within.left() + across * within.width(), within.bottom() - up * within.height()};
}

SpacePoint SpaceMap::placeAt(const QPointF& position) const
{
    const ParameterMap& map = m_space->map;
    const QRectF within = area();
    const double across = std::clamp((position.x() - within.left()) / within.width(), 0.0, 1.0);
    const double up = std::clamp((within.bottom() - position.y()) / within.height(), 0.0, 1.0);
    SpacePoint place = m_played.value_or(SpacePoint{});
    if (m_space->weights.dimension() > 0)
        place[0] = std::lerp(map.least[0], map.greatest[0], across);
    if (!isFlat())
        place[1] = std::lerp(map.least[1], map.greatest[1], up);
    if (m_space->weights.dimension() == 3 && !m_played)
        place[2] = std::midpoint(map.least[2], map.greatest[2]);
    return place;
}

std::optional<SpacePoint> SpaceMap::told() const
{
    return m_pointed ? m_pointed : m_played;
}

QString SpaceMap::sharesText() const
{
    const std::optional<SpacePoint> place = told();
    if (m_space == nullptr || !place)
        return {};
    const std::vector<double> shares = m_space->weights.shares(m_space->weights.at(*place));
    QStringList parts;
    for (std::size_t t = 0; t < shares.size(); ++t) {
        if (shares[t] < leastShare)
            continue;
        //: a take and its share in a blend
        parts += tr("%1 %2 %").arg(QString::fromStdString(m_space->takes[t].name),
                                   QLocale().toString(100 * shares[t], 'f', 0));
    }
    return parts.join(QStringLiteral(" · "));
}

void SpaceMap::mousePressEvent(QMouseEvent* event)
{
    if (m_space != nullptr && m_isEditable && event->button() == Qt::LeftButton)
        emit wanted(placeAt(event->position()));
    else
        QWidget::mousePressEvent(event);
}

void SpaceMap::mouseMoveEvent(QMouseEvent* event)
{
    if (m_space == nullptr)
        return;
    m_pointed = placeAt(event->position());
    update();
    if (m_isEditable && (event->buttons() & Qt::LeftButton) != 0)
        emit wanted(*m_pointed);
}

void SpaceMap::leaveEvent(QEvent* event)
{
    m_pointed.reset();
    update();
    QWidget::leaveEvent(event);
}

void SpaceMap::paintSimplices(QPainter& painter) const
{
    const WeightSpace& weights = m_space->weights;
    QColor covered = Theme::color(ColorRole::Accent);
    covered.setAlphaF(0.18F);
    if (weights.dimension() == 2) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(covered);
        for (const WeightSpace::Simplex& simplex : weights.simplices()) {
            QPolygonF triangle;
            for (int corner = 0; corner < 3; ++corner)
                triangle << positionOf(
                    weights
                        .nodes()[static_cast<std::size_t>(simplex.nodes.at(static_cast<std::size_t>(corner)))]
                        .place);
            painter.drawPolygon(triangle);
        }
    }
    painter.setPen(QPen(Theme::color(ColorRole::Line), weights.dimension() < 2 ? 2 : 1));
    for (const std::array<int, 2>& edge : weights.edges())
        painter.drawLine(positionOf(weights.nodes()[static_cast<std::size_t>(edge[0])].place),
                         positionOf(weights.nodes()[static_cast<std::size_t>(edge[1])].place));
}

void SpaceMap::paintTakes(QPainter& painter) const
{
    const WeightSpace& weights = m_space->weights;
    const double line = fontMetrics().height();
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::TextMuted));
    for (std::size_t n = weights.takeCount(); n < weights.nodes().size(); ++n)
        painter.drawEllipse(positionOf(weights.nodes()[n].place), nodeRadius, nodeRadius);
    std::vector<QRectF> taken;
    for (std::size_t t = 0; t < weights.takeCount(); ++t) {
        const QPointF at = positionOf(weights.nodes()[t].place);
        painter.setPen(QPen(Theme::color(ColorRole::Base), 1));
        painter.setBrush(Theme::categorical(static_cast<int>(t)));
        painter.drawEllipse(at, takeRadius, takeRadius);
        // Names that would lie over others are left out: shares tell them.
        const QString name = QString::fromStdString(m_space->takes[t].name);
        const double length = fontMetrics().horizontalAdvance(name);
        const double left = std::clamp(at.x() - length / 2, 0.0, std::max(0.0, width() - length));
        const double above = at.y() - takeRadius - nameGap / 2 - line;
        const QRectF place(left, above < 0 ? at.y() + takeRadius + nameGap / 2 : above, length, line);
        if (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(place); }))
            continue;
        taken.push_back(place);
        painter.setPen(Theme::color(ColorRole::Text));
        painter.drawText(place, Qt::AlignCenter, name);
    }
}

void SpaceMap::paintAxes(QPainter& painter) const
{
    const ParameterMap& map = m_space->map;
    const QRectF within = area();
    const double line = fontMetrics().height();
    painter.setPen(Theme::color(ColorRole::TextMuted));
    const QRectF below(within.left(), within.bottom() + 2, within.width(), line);
    const auto limit = [&](std::size_t p, double value) {
        return measureText(value, m_space->parameters[p].measure);
    };
    if (m_space->parameters.empty())
        return;
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, limit(0, map.least[0]));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, limit(0, map.greatest[0]));
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignTop,
                     QString::fromStdString(m_space->parameters[0].name));
    if (isFlat())
        return;
    painter.drawText(within, Qt::AlignLeft | Qt::AlignTop, limit(1, map.greatest[1]));
    painter.drawText(within, Qt::AlignLeft | Qt::AlignBottom, limit(1, map.least[1]));
    painter.drawText(within, Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(m_space->parameters[1].name));
}

void SpaceMap::paintEvent(QPaintEvent* /*event*/)
{
    if (m_space == nullptr)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF within = area();
    if (!isFlat()) {
        painter.setPen(QPen(Theme::color(ColorRole::Divider), 1));
        painter.setBrush(Theme::color(ColorRole::Base));
        painter.drawRect(within);
    }
    paintSimplices(painter);
    paintAxes(painter);
    paintTakes(painter);
    if (m_played) {
        painter.setPen(QPen(Theme::color(ColorRole::Base), 2));
        painter.setBrush(Theme::color(ColorRole::Accent));
        painter.drawEllipse(positionOf(*m_played), playedRadius, playedRadius);
    }
    const double line = fontMetrics().height();
    painter.setPen(Theme::color(ColorRole::Text));
    const QRectF bottom(margin, height() - line, width() - 2 * margin, line);
    painter.drawText(
        bottom, Qt::AlignHCenter | Qt::AlignVCenter,
        fontMetrics().elidedText(sharesText(), Qt::ElideRight, static_cast<int>(bottom.width())));
}

} // namespace quadrille

#include "moc_spacemap.cpp"
