// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/barchart.h"

#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double barHeight = 10;
constexpr double groupGap = 6;
constexpr double leastGroup = 18;   // so that a line of text fits
constexpr double numberWidth = 56;  // room for a value behind its bar
constexpr double mostLabels = 0.42; // of the width, for the names of categories
constexpr double keySwatch = 14;

QString withUnit(const ChartAxis& axis, const QString& text)
{
    //: what a chart shows, then its unit
    return axis.unit.isEmpty() ? text : BarChart::tr("%1 (%2)").arg(text, axis.unit);
}

QString quotedForCsv(const QString& text)
{
    QString quoted = text;
    return u'"' + quoted.replace(u'"', QLatin1String("\"\"")) + u'"';
}

void fillBar(QPainter& painter, const QRectF& bar, const QColor& color, bool isHatched)
{
    painter.setPen(QPen(color, 1.0));
    painter.setBrush(isHatched ? QBrush(color, Qt::BDiagPattern) : QBrush(color));
    painter.drawRect(bar);
}

} // namespace

BarChart::BarChart(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("barChart"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void BarChart::setBars(const ChartAxis& axis, const QStringList& categories, std::vector<BarSeries> series)
{
    m_axis = axis;
    m_categories = categories;
    m_series = std::move(series);
    m_read = -1;
    setAccessibleName(axis.title);
    setAccessibleDescription({});
    updateGeometry();
    update();
}

/// The title, and below it the series where there are several.
double BarChart::headHeight() const
{
    const double line = QFontMetricsF(font()).height();
    return 2 * line + (m_series.size() > 1 ? line + chartGap / 2 : 0) + chartGap;
}

double BarChart::groupHeight() const
{
    return std::max(leastGroup, static_cast<double>(m_series.size()) * barHeight) + groupGap;
}

double BarChart::labelWidth() const
{
    const QFontMetricsF metrics(font());
    double widest = 0;
    for (const QString& category : m_categories)
        widest = std::max(widest, metrics.horizontalAdvance(category));
    return std::min(widest + 2 * chartGap, mostLabels * width());
}

QSize BarChart::minimumSizeHint() const
{
    const double height = headHeight() + groupHeight() * static_cast<double>(m_categories.size()) + chartGap;
    return {220, static_cast<int>(std::ceil(height))};
}

QRectF BarChart::groupOf(int category) const
{
    return {0, headHeight() + category * groupHeight(), static_cast<double>(width()), groupHeight()};
}

ChartScale BarChart::scale() const
{
    double low = 0;
    double high = 0;
    for (const BarSeries& series : m_series)
        for (const std::optional<double>& value : series.values)
            if (value && std::isfinite(*value)) {
                low = std::min(low, *value);
                high = std::max(high, *value);
            }
    if (low == high)
        high = 1;
    const double left = labelWidth() + (low < 0 ? numberWidth : 0);
    return {low, high, false, left, std::max(left + 1, width() - numberWidth)};
}

QRectF BarChart::barOf(int category, int series) const
{
    const ChartScale along = scale();
    const double value =
        m_series[static_cast<std::size_t>(series)].values[static_cast<std::size_t>(category)].value();
    const QRectF group = groupOf(category);
    const double rows = static_cast<double>(m_series.size()) * barHeight;
    const double top = group.top() + (group.height() - rows) / 2 + series * barHeight;
    const double zero = along.position(0);
    const double end = along.position(value);
    return QRectF(QPointF(std::min(zero, end), top + 1), QPointF(std::max(zero, end), top + barHeight - 1));
}

QString BarChart::csv() const
{
    QString text = quotedForCsv(m_axis.title);
    for (const BarSeries& series : m_series)
        text += u',' + quotedForCsv(withUnit(m_axis, series.name));
    text += u'\n';
    for (int category = 0; category < m_categories.size(); ++category) {
        text += quotedForCsv(m_categories[category]);
        for (const BarSeries& series : m_series) {
            const auto& value = series.values[static_cast<std::size_t>(category)];
            text += u',' + (value ? QString::number(*value, 'g', 9) : QString());
        }
        text += u'\n';
    }
    return text;
}

void BarChart::copyCsv() const
{
    QApplication::clipboard()->setText(csv());
}

QString BarChart::readOut() const
{
    if (m_read < 0)
        return {};
    QStringList parts{m_categories[m_read]};
    for (const BarSeries& series : m_series) {
        const auto& value = series.values[static_cast<std::size_t>(m_read)];
        const QString number = value ? chartNumber(*value, 4) : tr("not measured");
        //: a series of a chart and its value, with unit
        parts += tr("%1: %2 %3").arg(series.name, number, value ? m_axis.unit : QString()).trimmed();
    }
    return parts.join(QStringLiteral("; "));
}

void BarChart::read(int category)
{
    if (category == m_read)
        return;
    m_read = category;
    setAccessibleDescription(readOut());
    setToolTip(readOut().replace(QStringLiteral("; "), QStringLiteral("\n")));
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    update();
    if (m_read >= 0) {
        const QRect group = groupOf(m_read).toAlignedRect();
        emit readingMoved(group.top(), group.bottom());
    }
}

bool BarChart::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !isEmpty()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const int code = key->key();
        const bool steps =
            key->modifiers() == Qt::NoModifier &&
            (code == Qt::Key_Up || code == Qt::Key_Down || code == Qt::Key_Home || code == Qt::Key_End);
        if (steps || key->matches(QKeySequence::Copy)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void BarChart::mouseMoveEvent(QMouseEvent* event)
{
    const double row = (event->position().y() - headHeight()) / groupHeight();
    const bool isOnOne = row >= 0 && row < static_cast<double>(m_categories.size());
    read(isOnOne ? static_cast<int>(row) : -1);
}

void BarChart::leaveEvent(QEvent* /*event*/)
{
    if (!hasFocus())
        read(-1);
}

void BarChart::keyPressEvent(QKeyEvent* event)
{
    if (isEmpty() || !readByKey(*event))
        QWidget::keyPressEvent(event);
}

bool BarChart::readByKey(const QKeyEvent& event)
{
    const auto last = static_cast<int>(m_categories.size()) - 1;
    if (event.matches(QKeySequence::Copy))
        copyCsv();
    else if (event.key() == Qt::Key_Down)
        read(std::min(m_read + 1, last));
    else if (event.key() == Qt::Key_Up)
        read(m_read < 0 ? last : std::max(m_read - 1, 0));
    else if (event.key() == Qt::Key_Home)
        read(0);
    else if (event.key() == Qt::Key_End)
        read(last);
    else
        return false;
    return true;
}

void BarChart::contextMenuEvent(QContextMenuEvent* event)
{
    if (isEmpty())
        return;
    QMenu menu(this);
    menu.addAction(tr("&Copy values as CSV"), this, &BarChart::copyCsv);
    menu.exec(event->globalPos());
}

void BarChart::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    painter.fillRect(rect(), Theme::color(ColorRole::Base));
    if (isEmpty())
        return;
    painter.setFont(Theme::tabularFont(font()));
    paintHead(painter);
    for (int category = 0; category < m_categories.size(); ++category)
        if (groupOf(category).intersects(QRectF(event->rect())))
            paintGroup(painter, category);
    const double zero = std::floor(scale().position(0)) + 0.5;
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.drawLine(QPointF(zero, headHeight()),
                     QPointF(zero, headHeight() + groupHeight() * static_cast<double>(m_categories.size())));
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void BarChart::paintHead(QPainter& painter) const
{
    const QFontMetricsF metrics(painter.font());
    QFont bold = painter.font();
    bold.setWeight(QFont::DemiBold);
    painter.save();
    painter.setFont(bold);
    painter.setPen(Theme::color(ColorRole::Text));
    const double room = width() - 2 * chartGap;
    painter.drawText(QRectF(chartGap, chartGap / 2, room, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(bold).elidedText(withUnit(m_axis, m_axis.title), Qt::ElideRight, room));
    painter.restore();
    double top = chartGap + metrics.height();
    if (m_series.size() > 1) {
        double left = chartGap;
        for (std::size_t i = 0; i < m_series.size(); ++i) {
            const QRectF sign(left, top + (metrics.height() - barHeight) / 2, keySwatch, barHeight - 2);
            fillBar(painter, sign, m_series[i].color, i % 2 == 1);
            left = sign.right() + chartGap / 2;
            painter.setPen(Theme::color(ColorRole::Text));
            const QString name = metrics.elidedText(m_series[i].name, Qt::ElideRight,
                                                    std::max(0.0, width() - left - chartGap));
            painter.drawText(QRectF(left, top, metrics.horizontalAdvance(name) + 1, metrics.height()),
                             Qt::AlignLeft | Qt::AlignVCenter, name);
            left += metrics.horizontalAdvance(name) + 2 * chartGap;
        }
        top += metrics.height() + chartGap / 2;
    }
    const ChartScale along = scale();
    constexpr double tickRoom = 56;
    const int most = std::max(2, static_cast<int>((along.end - along.start) / tickRoom));
    for (const double tick : chartTicks(along, most)) {
        const double at = std::floor(along.position(tick)) + 0.5;
        painter.setPen(Theme::color(ColorRole::Divider));
        painter.drawLine(QPointF(at, headHeight()), QPointF(at, height()));
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(at - tickRoom / 2, top, tickRoom, metrics.height()), Qt::AlignCenter,
                         chartNumber(tick));
    }
}

void BarChart::paintGroup(QPainter& painter, int category) const
{
    const QFontMetricsF metrics(painter.font());
    const QRectF group = groupOf(category);
    if (category == m_read)
        painter.fillRect(group, Theme::color(ColorRole::Window));
    const double room = labelWidth() - chartGap;
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(QRectF(chartGap / 2, group.top(), room, group.height()),
                     Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(m_categories[category], Qt::ElideMiddle, room));
    QFont small = painter.font();
    small.setPixelSize(static_cast<int>(barHeight));
    for (int i = 0; i < static_cast<int>(m_series.size()); ++i) {
        const auto& value = m_series[static_cast<std::size_t>(i)].values[static_cast<std::size_t>(category)];
        if (!value || !std::isfinite(*value))
            continue;
        const QRectF bar = barOf(category, i);
        fillBar(painter, bar, m_series[static_cast<std::size_t>(i)].color, i % 2 == 1);
        painter.save();
        painter.setFont(m_series.size() > 1 ? small : painter.font());
        painter.setPen(Theme::color(ColorRole::TextMuted));
        const bool isLeft = *value < 0;
        const QRectF place(isLeft ? bar.left() - numberWidth : bar.right() + chartGap / 2, bar.top() - 4,
                           numberWidth - chartGap / 2, bar.height() + 8);
        painter.drawText(place, (isLeft ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                         chartNumber(*value));
        painter.restore();
    }
}

} // namespace quadrille::widgets

#include "moc_barchart.cpp"
