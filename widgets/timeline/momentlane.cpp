// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/momentlane.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double radius = 6;

} // namespace

void MomentLane::setMoments(std::vector<double> seconds)
{
    m_moments = std::move(seconds);
    if (m_selected >= static_cast<int>(m_moments.size())) {
        m_drag.reset();
        choose(-1);
    }
    updateGeometry();
    update();
}

void MomentLane::setSelected(int moment)
{
    m_selected = moment < static_cast<int>(m_moments.size()) ? moment : -1;
    update();
}

QPointF MomentLane::centreOf(int moment) const
{
    // In the middle of its frame, as the playhead is.
    return {xOf(m_moments.at(static_cast<std::size_t>(moment)) + 0.5 / fps()), height() / 2.0};
}

void MomentLane::paintContent(QPainter& painter, const QRectF&)
{
    for (int i = 0; i < static_cast<int>(m_moments.size()); ++i) {
        if (i > 0) {
            painter.setPen(QPen(Theme::color(ColorRole::Line), 1));
            painter.drawLine(centreOf(i - 1) + QPointF(radius, 0), centreOf(i) - QPointF(radius, 0));
        }
    }
    for (int i = 0; i < static_cast<int>(m_moments.size()); ++i) {
        const QPointF centre = centreOf(i);
        const bool isSelected = i == m_selected;
        painter.setPen(
            QPen(Theme::color(isSelected ? ColorRole::Text : ColorRole::Line), isSelected ? 2 : 1));
        painter.setBrush(Theme::color(ColorRole::Key));
        const double r = isSelected ? radius + 1 : radius;
        painter.drawPolygon(QPolygonF({centre + QPointF(0, -r), centre + QPointF(r, 0),
                                       centre + QPointF(0, r), centre + QPointF(-r, 0)}));
    }
}

int MomentLane::momentAt(const QPointF& position) const
{
    for (int i = static_cast<int>(m_moments.size()) - 1; i >= 0; --i) {
        if (std::abs(centreOf(i).x() - position.x()) <= radius + 2)
            return i;
    }
    return -1;
}

void MomentLane::choose(int moment)
{
    if (moment == m_selected)
        return;
    m_selected = moment;
    update();
    emit momentSelected(moment);
}

void MomentLane::move(double seconds, bool committed)
{
    const auto index = static_cast<std::size_t>(m_selected);
    const double step = 1 / fps();
    const double least = index == 0 ? 0 : m_moments[index - 1] + step;
    double time = std::max(std::round(seconds * fps()) / fps(), least);
    if (index + 1 < m_moments.size())
        time = std::min(time, m_moments[index + 1] - step);
    if (time < least)
        return;
    m_moments[index] = time;
    update();
    emit momentMoved(m_selected, time, committed);
}

void MomentLane::mousePressEvent(QMouseEvent* event)
{
    const int moment = momentAt(event->position());
    choose(moment);
    if (event->button() == Qt::LeftButton && moment >= 0)
        m_drag = Drag{event->position().x(), m_moments[static_cast<std::size_t>(moment)]};
}

void MomentLane::mouseMoveEvent(QMouseEvent* event)
{
    setCursor(momentAt(event->position()) >= 0 ? Qt::SizeHorCursor : Qt::ArrowCursor);
    if (!m_drag)
        return;
    m_drag->hasMoved = true;
    move(m_drag->seconds + (event->position().x() - m_drag->x) / pixelsPerSecond(), false);
}

void MomentLane::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    const bool hasMoved = m_drag->hasMoved;
    m_drag.reset();
    if (hasMoved)
        move(m_moments[static_cast<std::size_t>(m_selected)], true);
}

void MomentLane::mouseDoubleClickEvent(QMouseEvent* event)
{
    const int moment = momentAt(event->position());
    if (moment >= 0)
        emit momentActivated(moment);
    else if (area().contains(event->position()))
        emit additionRequested(std::max(0.0, std::floor(secondsAt(event->position().x()) * fps()) / fps()));
}

void MomentLane::keyPressEvent(QKeyEvent* event)
{
    const int direction = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    const int last = static_cast<int>(m_moments.size()) - 1;
    if (event->key() == Qt::Key_Escape && m_drag) {
        const double before = m_drag->seconds;
        m_drag.reset();
        move(before, true);
    } else if (direction != 0 && last >= 0 && !(event->modifiers() & Qt::ControlModifier)) {
        choose(m_selected < 0 ? (direction > 0 ? 0 : last) : std::clamp(m_selected + direction, 0, last));
    } else if (direction != 0 && m_selected >= 0) {
        move(m_moments[static_cast<std::size_t>(m_selected)] + direction / fps(), true);
    } else if (event->key() == Qt::Key_Delete && m_selected >= 0) {
        emit removalRequested(m_selected);
    } else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && m_selected >= 0) {
        emit momentActivated(m_selected);
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace quadrille::widgets

#include "moc_momentlane.cpp"
