// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/soundlane.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double snapPixels = 6;

} // namespace

void SoundLane::setSound(const QString& name, double seconds, Peaks peaks)
{
    if (name != m_name || seconds != m_seconds)
        m_drag.reset();
    m_name = name;
    m_seconds = seconds;
    m_peaks = std::move(peaks);
    setToolTip(name);
    updateGeometry();
    update();
}

void SoundLane::setMuted(bool muted)
{
    m_muted = muted;
    update();
}

void SoundLane::setOffset(double seconds)
{
    m_offset = seconds;
    update();
}

QRectF SoundLane::soundRect() const
{
    const double left = xOf(m_offset);
    return {left, 2, xOf(m_offset + m_seconds) - left, height() - 4.0};
}

void SoundLane::paintContent(QPainter& painter, const QRectF& area)
{
    const QRectF box = soundRect();
    const QRectF seen = box.intersected(area);
    if (seen.isEmpty())
        return;
    const QColor color = Theme::color(m_muted ? ColorRole::TextDisabled : ColorRole::AccentText);
    QColor ground = color;
    ground.setAlphaF(0.14F);
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 3, 3);
    // One line for each pixel of the screen.
    const double pixel = 1 / devicePixelRatioF();
    const int count = static_cast<int>(std::ceil(seen.width() / pixel));
    if (m_peaks && count > 0) {
        const auto peaks = m_peaks(secondsAt(seen.left()) - m_offset, pixel / pixelsPerSecond(), count);
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(color, pixel));
        const double middle = box.center().y();
        const double reach = box.height() / 2 - 1;
        for (std::size_t i = 0; i < peaks.size(); ++i) {
            const double x = seen.left() + (static_cast<double>(i) + 0.5) * pixel;
            const double high = std::clamp(static_cast<double>(peaks[i].second), -1.0, 1.0);
            const double low = std::clamp(static_cast<double>(peaks[i].first), -1.0, 1.0);
            painter.drawLine(QPointF(x, middle - high * reach), QPointF(x, middle - low * reach));
        }
        painter.setRenderHint(QPainter::Antialiasing);
    }
    // The name stands where it leaves most of the sound to be seen.
    const QString name = m_muted ? tr("%1 (muted)").arg(m_name) : m_name;
    const QRectF label(seen.left() + 4, seen.top() + 1, fontMetrics().horizontalAdvance(name) + 4,
                       fontMetrics().height());
    if (label.width() * 2 > seen.width())
        return;
    QColor behind = Theme::color(ColorRole::Base);
    behind.setAlphaF(0.75F);
    painter.fillRect(label, behind);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(label, Qt::AlignCenter, name);
}

void SoundLane::edit(double offset, bool committed)
{
    m_offset = offset;
    update();
    emit offsetEdited(offset, committed);
}

void SoundLane::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && isEmpty())
        emit choiceRequested();
    else if (event->button() == Qt::LeftButton && soundRect().contains(event->position()))
        m_drag = Drag{event->position().x(), m_offset};
}

void SoundLane::mouseMoveEvent(QMouseEvent* event)
{
    const bool isOver = !isEmpty() && soundRect().contains(event->position());
    setCursor(m_drag ? Qt::ClosedHandCursor : isOver ? Qt::OpenHandCursor : Qt::ArrowCursor);
    if (!m_drag)
        return;
    double offset = m_drag->offset + (event->position().x() - m_drag->x) / pixelsPerSecond();
    if (!(event->modifiers() & Qt::AltModifier) && std::abs(offset) * pixelsPerSecond() < snapPixels)
        offset = 0;
    edit(std::round(offset * 1000) / 1000, false);
}

void SoundLane::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    const bool hasMoved = m_offset != m_drag->offset;
    m_drag.reset();
    if (hasMoved)
        edit(m_offset, true);
}

void SoundLane::keyPressEvent(QKeyEvent* event)
{
    const int direction = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1 / fps();
    if (event->key() == Qt::Key_Escape && m_drag) {
        const double before = m_drag->offset;
        m_drag.reset();
        edit(before, true);
    } else if (!isEmpty() && direction != 0) {
        edit(std::round((m_offset + direction * step) * 1000) / 1000, true);
    } else if (isEmpty() && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        emit choiceRequested();
    } else if (!isEmpty() && event->key() == Qt::Key_Delete) {
        emit removalRequested();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace quadrille::widgets

#include "moc_soundlane.cpp"
