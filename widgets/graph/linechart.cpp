// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/linechart.h"

#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double markerReach = 6; // logical pixels

bool fits(const ChartAxis& axis, double value)
{
    return std::isfinite(value) && (!axis.isLogarithmic || value > 0);
}

/// From the least to the greatest of the values, with a little room; never empty.
std::pair<double, double> reach(std::vector<double> values, bool isLogarithmic, bool hasRoom)
{
    if (values.empty())
        return {isLogarithmic ? 0.1 : 0.0, 1.0};
    auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    double low = *least;
    double high = *greatest;
    if (isLogarithmic) {
        const double room = hasRoom || low == high ? std::max(std::pow(high / low, 0.05), 1.05) : 1.0;
        return {low / room, high * room};
    }
    if (hasRoom && low >= 0 && low < high * 0.5)
        low = 0;
    const double room =
        low == high ? std::max(std::abs(high) * 0.1, 1e-9) : (hasRoom ? (high - low) * 0.05 : 0);
    return {low == 0 ? 0 : low - room, high + room};
}

QString csvText(const QString& text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n'))
        return text;
    QString quoted = text;
    return u'"' + quoted.replace(u'"', QLatin1String("\"\"")) + u'"';
}

} // namespace

LineChart::LineChart(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("lineChart"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void LineChart::setAxes(ChartAxis x, ChartAxis y)
{
    m_x = std::move(x);
    m_y = std::move(y);
    setAccessibleName(m_y.title);
    dataChanged();
}

void LineChart::setSeries(std::vector<ChartSeries> series)
{
    m_series = std::move(series);
    const auto known = allX();
    if (m_readX && std::find(known.begin(), known.end(), *m_readX) == known.end())
        m_readX.reset();
    dataChanged();
}

void LineChart::setMarker(std::optional<double> x, const QString& name)
{
    if (m_isDragging)
        return;
    m_marker = x;
    m_markerName = name;
    update();
}

void LineChart::setEmptyText(const QString& text)
{
    m_emptyText = text;
    dataChanged();
}

bool LineChart::isEmpty() const
{
    return std::all_of(m_series.begin(), m_series.end(),
                       [](const ChartSeries& series) { return series.points.empty(); });
}

void LineChart::dataChanged()
{
    setAccessibleDescription(isEmpty() ? m_emptyText : readOut());
    update();
}

std::vector<double> LineChart::allX() const
{
    std::vector<double> all;
    for (const ChartSeries& series : m_series)
        for (const QPointF& point : series.points)
            if (fits(m_x, point.x()))
                all.push_back(point.x());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

ChartScale LineChart::xScale() const
{
    const QRectF plot = plotArea();
    const auto [low, high] = reach(allX(), m_x.isLogarithmic, false);
    return {low, high, m_x.isLogarithmic, plot.left(), plot.right()};
}

ChartScale LineChart::yScale() const
{
    const QRectF plot = plotArea();
    return yScale(plot.bottom(), plot.top());
}

ChartScale LineChart::yScale(double bottom, double top) const
{
    std::vector<double> values;
    for (const ChartSeries& series : m_series)
        for (const QPointF& point : series.points)
            if (fits(m_y, point.y()))
                values.push_back(point.y());
    const auto [low, high] = reach(std::move(values), m_y.isLogarithmic, true);
    return {low, high, m_y.isLogarithmic, bottom, top};
}

QPointF LineChart::positionOf(const QPointF& value) const
{
    return {xScale().position(value.x()), yScale().position(value.y())};
}

QString LineChart::csv() const
{
    const auto number = [](double value) { return QString::number(value, 'g', 9); };
    const auto heading = [](const ChartAxis& axis, const QString& name) {
        return csvText(axis.unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, axis.unit));
    };
    QString text = heading(m_x, m_x.title);
    for (const ChartSeries& series : m_series)
        text += u',' + heading(m_y, series.name);
    text += u'\n';
    for (const double x : allX()) {
        text += number(x);
        for (const ChartSeries& series : m_series) {
            const auto at = std::find_if(series.points.begin(), series.points.end(),
                                         [x](const QPointF& point) { return point.x() == x; });
            text += u',' + (at == series.points.end() ? QString() : number(at->y()));
        }
        text += u'\n';
    }
    return text;
}

void LineChart::copyCsv() const
{
    QApplication::clipboard()->setText(csv());
}

QString LineChart::readOut() const
{
    if (!m_readX)
        return {};
    //: an axis and a value on it
    QStringList parts{tr("%1 = %2").arg(m_x.title, chartNumber(*m_readX))};
    for (const ChartSeries& series : m_series)
        for (const QPointF& point : series.points)
            if (point.x() == *m_readX)
                //: a series of a chart and its value, with unit
                parts += tr("%1: %2 %3").arg(series.name, chartNumber(point.y(), 4), m_y.unit).trimmed();
    return parts.join(QStringLiteral("; "));
}

void LineChart::read(std::optional<double> x)
{
    if (x == m_readX)
        return;
    m_readX = x;
    dataChanged();
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

bool LineChart::isOnMarker(const QPointF& position) const
{
    return m_marker && !isEmpty() && fits(m_x, *m_marker) &&
           plotArea().adjusted(0, -16, 0, 0).contains(position) &&
           std::abs(xScale().position(*m_marker) - position.x()) <= markerReach;
}

void LineChart::moveMarker(double position, bool committed)
{
    const ChartScale scale = xScale();
    m_marker = scale.value(std::clamp(position, scale.start, scale.end));
    update();
    emit markerMoved(*m_marker, committed);
}

void LineChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && isOnMarker(event->position()))
        m_isDragging = true;
    else
        event->ignore();
}

void LineChart::mouseMoveEvent(QMouseEvent* event)
{
    if (m_isDragging) {
        moveMarker(event->position().x(), false);
        return;
    }
    setCursor(isOnMarker(event->position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
    const auto all = allX();
    if (all.empty() || !plotArea().contains(event->position())) {
        read({});
        return;
    }
    const ChartScale scale = xScale();
    read(*std::min_element(all.begin(), all.end(), [&](double a, double b) {
        return std::abs(scale.position(a) - event->position().x()) <
               std::abs(scale.position(b) - event->position().x());
    }));
}

void LineChart::mouseReleaseEvent(QMouseEvent* event)
{
    if (std::exchange(m_isDragging, false))
        moveMarker(event->position().x(), true);
}

void LineChart::leaveEvent(QEvent* /*event*/)
{
    if (!hasFocus())
        read({});
}

bool LineChart::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        // In the window these step through frames and copy something else.
        const auto* key = static_cast<QKeyEvent*>(event);
        const int code = key->key();
        const bool steps =
            key->modifiers() == Qt::NoModifier &&
            (code == Qt::Key_Left || code == Qt::Key_Right || code == Qt::Key_Home || code == Qt::Key_End);
        if (!isEmpty() && (steps || key->matches(QKeySequence::Copy))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void LineChart::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    update();
}

bool LineChart::readByKey(int key)
{
    const auto all = allX();
    if (all.empty())
        return false;
    const auto at = m_readX ? std::find(all.begin(), all.end(), *m_readX) : all.begin();
    if (key == Qt::Key_Home || (key == Qt::Key_Left && !m_readX))
        read(all.front());
    else if (key == Qt::Key_End)
        read(all.back());
    else if (key == Qt::Key_Left)
        read(at == all.begin() ? *at : *std::prev(at));
    else if (key == Qt::Key_Right)
        read(!m_readX || std::next(at) == all.end() ? *at : *std::next(at));
    else
        return false;
    return true;
}

void LineChart::keyPressEvent(QKeyEvent* event)
{
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->matches(QKeySequence::Copy) && !isEmpty()) {
        copyCsv();
    } else if (isReturn && m_readX && m_marker) {
        m_marker = m_readX;
        update();
        emit markerMoved(*m_marker, true);
    } else if (!readByKey(event->key())) {
        QWidget::keyPressEvent(event);
    }
}

void LineChart::contextMenuEvent(QContextMenuEvent* event)
{
    if (isEmpty())
        return;
    QMenu menu(this);
    menu.addAction(tr("&Copy values as CSV"), this, &LineChart::copyCsv);
    menu.exec(event->globalPos());
}

} // namespace quadrille::widgets

#include "moc_linechart.cpp"
