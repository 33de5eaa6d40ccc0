// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinezoombar.h"

#include "widgets/theme/theme.h"
#include "widgets/timeline/timelinescale.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr int leastWidth = 2 * TimelineZoomBar::handleWidth + 12; ///< of the part, pixels

} // namespace

TimelineZoomBar::TimelineZoomBar(const TimelineScale& scale, QWidget* parent)
    : QWidget(parent), m_scale(scale)
{
    setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);
    hide(); // until there are frames
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QRect TimelineZoomBar::partRect() const
{
    const double share = std::min(1.0, m_scale.visibleFrames() / m_scale.frameCount());
    const double length = std::clamp(share * width(), std::min<double>(leastWidth, width()), 1.0 * width());
    const double hidden = m_scale.frameCount() - m_scale.visibleFrames();
    const double start = hidden <= 0 ? 0 : m_scale.firstVisible() / hidden * (width() - length);
    return {static_cast<int>(std::lround(start)), 0, static_cast<int>(std::lround(length)), height()};
}

TimelineZoomBar::Grip TimelineZoomBar::gripAt(const QPointF& position) const
{
    const QRect part = partRect();
    if (position.x() < part.left() || position.x() > part.right() + 1)
        return Grip::None;
    if (position.x() < part.left() + handleWidth)
        return Grip::Start;
    return position.x() > part.right() + 1 - handleWidth ? Grip::End : Grip::Part;
}

double TimelineZoomBar::framesPerPixel() const
{
    return static_cast<double>(m_scale.frameCount()) / std::max(1, width());
}

void TimelineZoomBar::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_grip = gripAt(event->position());
    m_pressedAt = event->position().x();
    m_first = m_scale.firstVisible();
    m_frames = m_scale.visibleFrames();
    // Beside the part: what is there comes to the middle, and is taken along.
    if (m_grip == Grip::None) {
        m_first = event->position().x() * framesPerPixel() - m_frames / 2;
        m_grip = Grip::Part;
        emit partRequested(m_first, m_frames);
        m_first = m_scale.firstVisible();
    }
    update();
}

void TimelineZoomBar::mouseMoveEvent(QMouseEvent* event)
{
    if (m_grip == Grip::None) {
        const Grip hovered = gripAt(event->position());
        setCursor(hovered == Grip::Start || hovered == Grip::End ? Qt::SizeHorCursor : Qt::ArrowCursor);
        if (hovered != m_hovered) {
            m_hovered = hovered;
            update();
        }
        return;
    }
    const double moved = (event->position().x() - m_pressedAt) * framesPerPixel();
    const double end = m_first + m_frames;
    constexpr double fewest = 2;
    if (m_grip == Grip::Part) {
        // Where the part is wider than it should be, its way along the bar stands for all that is hidden.
        const double way = width() - partRect().width();
        const double hidden = m_scale.frameCount() - m_frames;
        const double pixels = event->position().x() - m_pressedAt;
        emit partRequested(way > 0 ? m_first + pixels * hidden / way : m_first, m_frames);
    } else if (m_grip == Grip::Start) {
        const double first = std::clamp(m_first + moved, 0.0, std::max(0.0, end - fewest));
        emit partRequested(first, end - first);
    } else {
        emit partRequested(m_first, std::max(fewest, m_frames + moved));
    }
}

void TimelineZoomBar::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_grip = Grip::None;
        update();
    }
}

void TimelineZoomBar::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_grip = Grip::None;
    if (event->button() == Qt::LeftButton)
        emit fitRequested();
}

void TimelineZoomBar::leaveEvent(QEvent* event)
{
    m_hovered = Grip::None;
    update();
    QWidget::leaveEvent(event);
}

void TimelineZoomBar::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Theme::color(ColorRole::Raised));
    const QRectF part = QRectF(partRect()).adjusted(0.5, 2.5, -0.5, -2.5);
    const double radius = part.height() / 2;
    const QColor ground = Theme::color(ColorRole::Base);
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.setBrush(ground);
    painter.drawRoundedRect(part, radius, radius);
    const auto paintHandle = [&](Grip grip, double left) {
        const bool isHot = m_grip == grip || (m_grip == Grip::None && m_hovered == grip);
        painter.setPen(QPen(Theme::color(isHot ? ColorRole::AccentText : ColorRole::TextMuted), 1.5));
        for (const double x : {left + 5.5, left + 8.5})
            painter.drawLine(QPointF(x, part.top() + 2.5), QPointF(x, part.bottom() - 2.5));
    };
    paintHandle(Grip::Start, part.left());
    paintHandle(Grip::End, part.right() - handleWidth);
}

} // namespace quadrille::widgets

#include "moc_timelinezoombar.cpp"
