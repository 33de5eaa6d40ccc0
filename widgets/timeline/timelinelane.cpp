// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinelane.h"

#include "widgets/theme/theme.h"

#include <QContextMenuEvent>
#include <QPainter>

namespace quadrille::widgets {

TimelineLane::TimelineLane(Timeline& timeline, QWidget* parent) : QWidget(parent), m_timeline(timeline)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&timeline, &Timeline::viewChanged, this, qOverload<>(&QWidget::update));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TimelineLane::setFps(double fps)
{
    m_fps = fps;
    update();
}

void TimelineLane::setTexts(const QString& title, const QString& notice)
{
    m_title = title;
    m_notice = notice;
    setAccessibleName(title);
    update();
}

double TimelineLane::pixelsPerSecond() const
{
    return m_timeline.scale().pixelsPerFrame() * m_fps;
}

double TimelineLane::xOf(double seconds) const
{
    return area().left() + m_timeline.scale().xOf(seconds * m_fps);
}

double TimelineLane::secondsAt(double x) const
{
    return m_timeline.scale().frameAt(x - area().left()) / m_fps;
}

QRectF TimelineLane::area() const
{
    const int left = m_timeline.rulerRect().left();
    return {static_cast<double>(left), 0, static_cast<double>(width() - left), static_cast<double>(height())};
}

QSize TimelineLane::sizeHint() const
{
    return {320, isEmpty() ? 22 : 34};
}

void TimelineLane::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        update();
    QWidget::changeEvent(event);
}

void TimelineLane::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Theme::color(ColorRole::Window));
    const QRectF content = area();
    painter.fillRect(content.adjusted(0, 1, 0, -1), Theme::color(ColorRole::Base));
    painter.setPen(Theme::color(ColorRole::TextMuted));
    const QRectF title(20, 0, content.left() - 22, height()); // in line with those of the timeline
    painter.drawText(title, Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(m_title, Qt::ElideRight, static_cast<int>(title.width())));
    painter.save();
    painter.setClipRect(content);
    if (isEmpty())
        painter.drawText(
            content.adjusted(8, 0, -8, 0), Qt::AlignVCenter | Qt::AlignLeft,
            fontMetrics().elidedText(m_notice, Qt::ElideRight, static_cast<int>(content.width()) - 16));
    else
        paintContent(painter, content);
    painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.5));
    const double playhead = m_timeline.xOfFrame(m_timeline.currentFrame());
    painter.drawLine(QPointF(playhead, 0), QPointF(playhead, height()));
    painter.restore();
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void TimelineLane::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuRequested(secondsAt(event->pos().x()), event->globalPos());
}

} // namespace quadrille::widgets

#include "moc_timelinelane.cpp"
