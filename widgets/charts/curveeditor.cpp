// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/charts/curveeditor.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double reach = 9;      // pixels about a point that take hold of it
constexpr double headroom = 1.2; // of the time axis beyond the last point, to drag it there
constexpr int manyFrames = 10;   // that an arrow moves by with Shift

double betweenPoints(const QList<QPointF>& points, double time)
{
    if (time <= points.front().x())
        return points.front().y();
    const auto after =
        std::ranges::lower_bound(points, time, {}, [](const QPointF& point) { return point.x(); });
    if (after == points.end())
        return points.back().y();
    const QPointF& to = *after;
    const QPointF& from = *(after - 1);
    return from.y() + (to.y() - from.y()) * (time - from.x()) / (to.x() - from.x());
}

} // namespace

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("curveEditor"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    setInterpolation({});
}

void CurveEditor::setInterpolation(Interpolation interpolation)
{
    m_interpolation = interpolation ? std::move(interpolation) : [](const QList<QPointF>& points) -> Curve {
        return [points](double time) { return betweenPoints(points, time); };
    };
    pointsChanged();
}

void CurveEditor::setPoints(const QList<QPointF>& points)
{
    if (m_before || points == m_points)
        return;
    m_points = points;
    if (m_selected >= m_points.size())
        m_selected = -1;
    pointsChanged();
    fit();
}

void CurveEditor::setLength(double seconds)
{
    m_length = std::max(seconds, frame());
    fit();
}

void CurveEditor::setFps(double fps)
{
    m_fps = fps;
}

void CurveEditor::setAxisTitles(const QString& time, const QString& moment)
{
    m_timeTitle = time;
    m_momentTitle = moment;
    update();
}

void CurveEditor::pointsChanged()
{
    m_curve = m_interpolation(m_points);
    update();
}

void CurveEditor::fit()
{
    m_shown = {headroom * std::max(m_length, m_points.back().x()), std::max(m_length, m_points.back().y())};
    update();
}

void CurveEditor::select(int point)
{
    m_selected = point >= 0 && point < m_points.size() ? point : -1;
    update();
}

QPointF CurveEditor::positionOf(const QPointF& point) const
{
    const QRectF place = area();
    return {place.left() + point.x() / m_shown.width() * place.width(),
            place.bottom() - point.y() / m_shown.height() * place.height()};
}

QPointF CurveEditor::pointAt(const QPointF& position) const
{
    const QRectF place = area();
    return {(position.x() - place.left()) / place.width() * m_shown.width(),
            (place.bottom() - position.y()) / place.height() * m_shown.height()};
}

int CurveEditor::nearestPoint(const QPointF& position) const
{
    int nearest = -1;
    double least = reach;
    for (int i = 0; i < m_points.size(); ++i) {
        const QPointF away = positionOf(m_points[i]) - position;
        if (const double distance = std::hypot(away.x(), away.y()); distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

QPointF CurveEditor::snapped(const QPointF& point) const
{
    return {std::round(point.x() * m_fps) / m_fps, std::round(point.y() * m_fps) / m_fps};
}

QPointF CurveEditor::limited(int point, QPointF wanted) const
{
    const bool isFirst = point == 0;
    const bool isLast = point == m_points.size() - 1;
    if (isFirst) {
        wanted.setX(0);
    } else {
        const double earliest = m_points[point - 1].x() + frame();
        const double latest = isLast ? std::max(earliest, m_shown.width())
                                     : std::max(earliest, m_points[point + 1].x() - frame());
        wanted.setX(std::clamp(wanted.x(), earliest, latest));
    }
    const double lowest = isFirst ? 0 : std::min(m_points[point - 1].y(), m_length);
    const double highest = isLast ? m_length : std::min(m_points[point + 1].y(), m_length);
    wanted.setY(std::clamp(wanted.y(), lowest, std::max(lowest, highest)));
    return wanted;
}

bool CurveEditor::move(int point, const QPointF& wanted)
{
    const QPointF goal = limited(point, wanted);
    if (goal == m_points[point])
        return false;
    m_points[point] = goal;
    pointsChanged();
    return true;
}

void CurveEditor::add(const QPointF& wanted)
{
    // No room for another between two that are a frame apart.
    const auto after =
        std::ranges::lower_bound(m_points, wanted.x(), {}, [](const QPointF& point) { return point.x(); });
    const auto place = static_cast<int>(after - m_points.begin());
    if (place == 0 ||
        (after != m_points.end() && after->x() - m_points[place - 1].x() < 2 * frame() * (1 - 1e-9)))
        return;
    m_points.insert(place, wanted);
    m_points[place] = limited(place, wanted);
    m_selected = place;
    pointsChanged();
    emit edited(m_points, true);
    fit();
}

void CurveEditor::addAfterSelected()
{
    const int from = std::clamp(m_selected, 0, static_cast<int>(m_points.size()) - 2);
    const double time = (m_points[from].x() + m_points[from + 1].x()) / 2;
    add({std::round(time * m_fps) / m_fps, m_curve(time)});
}

void CurveEditor::removeSelected()
{
    if (m_selected <= 0 || m_selected >= m_points.size() - 1)
        return;
    m_points.removeAt(m_selected);
    pointsChanged();
    emit edited(m_points, true);
}

void CurveEditor::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    select(nearestPoint(event->position()));
    if (m_selected < 0)
        return;
    m_before = m_points;
    m_grip = positionOf(m_points[m_selected]) - event->position();
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event)
{
    if (m_before) {
        const QPointF wanted = pointAt(event->position() + m_grip);
        const bool snaps = (event->modifiers() & Qt::ShiftModifier) == 0;
        if (move(m_selected, snaps ? snapped(wanted) : wanted))
            emit edited(m_points, false);
        return;
    }
    if (const int hovered = nearestPoint(event->position()); std::exchange(m_hovered, hovered) != hovered) {
        setCursor(hovered >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor);
        update();
    }
}

void CurveEditor::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_before)
        return;
    const bool hasMoved = *std::exchange(m_before, {}) != m_points;
    if (!hasMoved)
        return;
    emit edited(m_points, true);
    fit();
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && nearestPoint(event->position()) < 0 &&
        area().contains(event->position()))
        add(snapped(pointAt(event->position())));
}

void CurveEditor::leaveEvent(QEvent* /*event*/)
{
    m_hovered = -1;
    update();
}

void CurveEditor::focusInEvent(QFocusEvent* event)
{
    if (m_selected < 0 && event->reason() != Qt::MouseFocusReason)
        select(0);
    QWidget::focusInEvent(event);
}

bool CurveEditor::isOurKey(int key) const
{
    switch (key) {
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Insert:
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return m_selected >= 0;
    case Qt::Key_Escape:
        return m_before.has_value();
    default:
        return false;
    }
}

bool CurveEditor::event(QEvent* event)
{
    // These keys mean something else in the window: here they are for the points.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if ((key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == 0 && isOurKey(key->key())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void CurveEditor::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (!isOurKey(key)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (key == Qt::Key_Escape) {
        m_points = *std::exchange(m_before, {});
        pointsChanged();
        emit edited(m_points, true);
        return;
    }
    if (m_before)
        return;
    const double step = frame() * ((event->modifiers() & Qt::ShiftModifier) != 0 ? manyFrames : 1);
    const auto last = static_cast<int>(m_points.size()) - 1;
    QPointF way;
    switch (key) {
    case Qt::Key_PageUp:
        select(std::max(m_selected - 1, 0));
        return;
    case Qt::Key_PageDown:
        select(std::min(m_selected + 1, last));
        return;
    case Qt::Key_Insert:
        addAfterSelected();
        return;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        removeSelected();
        return;
    case Qt::Key_Left:
        way = {-step, 0};
        break;
    case Qt::Key_Right:
        way = {step, 0};
        break;
    case Qt::Key_Up:
        way = {0, step};
        break;
    default:
        way = {0, -step};
    }
    if (move(m_selected, m_points[m_selected] + way)) {
        emit edited(m_points, true);
        fit();
    }
}

} // namespace quadrille::widgets

#include "moc_curveeditor.cpp"
