// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/storyboard/rangestrip.h"

#include "widgets/theme/theme.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr int stripMargin = 6;
constexpr int stripHeight = 28;
constexpr int handleReach = 7;

} // namespace

RangeStrip::RangeStrip(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("rangeStrip"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    QEvent retranslate(QEvent::LanguageChange);
    changeEvent(&retranslate);
}

void RangeStrip::setFrameCount(int frames)
{
    m_frames = std::max(1, frames);
    setRange(m_first, m_last);
}

void RangeStrip::setRange(int first, int last)
{
    m_first = std::clamp(first, 0, m_frames - 1);
    m_last = std::clamp(last, m_first, m_frames - 1);
    update();
}

void RangeStrip::setSpans(std::vector<TimelineSpan> spans)
{
    m_spans = std::move(spans);
    update();
}

double RangeStrip::xOf(int frame) const
{
    return stripMargin + static_cast<double>(frame) * (width() - 2.0 * stripMargin) / m_frames;
}

int RangeStrip::frameAt(int x) const
{
    const double share = (x - stripMargin) / std::max(1.0, width() - 2.0 * stripMargin);
    return std::clamp(static_cast<int>(std::floor(share * m_frames)), 0, m_frames - 1);
}

QPoint RangeStrip::startHandle() const
{
    return {static_cast<int>(std::lround(xOf(m_first))), rect().center().y()};
}

QPoint RangeStrip::endHandle() const
{
    return {static_cast<int>(std::lround(xOf(m_last + 1))), rect().center().y()};
}

QSize RangeStrip::sizeHint() const
{
    return {220, stripHeight};
}

QSize RangeStrip::minimumSizeHint() const
{
    return {80, stripHeight};
}

RangeStrip::Part RangeStrip::partAt(const QPointF& position) const
{
    const double toStart = std::abs(position.x() - xOf(m_first));
    const double toEnd = std::abs(position.x() - xOf(m_last + 1));
    if (std::min(toStart, toEnd) <= handleReach)
        return toStart < toEnd ? Part::Start : Part::End;
    const bool inside = position.x() > xOf(m_first) && position.x() < xOf(m_last + 1);
    return inside ? Part::Both : toStart < toEnd ? Part::Start : Part::End;
}

void RangeStrip::moveTo(Part part, int first, int last, bool committed)
{
    const auto before = range();
    if (part == Part::Both) {
        const int length = m_last - m_first;
        m_first = std::clamp(first, 0, m_frames - 1 - length);
        m_last = m_first + length;
    } else if (part == Part::Start) {
        m_first = std::clamp(first, 0, m_last);
    } else {
        m_last = std::clamp(last, m_first, m_frames - 1);
    }
    update();
    if (range() != before)
        emit rangeEdited(m_first, m_last, committed);
}

void RangeStrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_before = range();
    m_dragged = partAt(event->position());
    m_grabbed = frameAt(event->position().toPoint().x());
    if (m_dragged != Part::Both)
        m_active = m_dragged;
    mouseMoveEvent(event);
    update();
}

void RangeStrip::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragged == Part::None) {
        setCursor(partAt(event->position()) == Part::Both ? Qt::ArrowCursor : Qt::SizeHorCursor);
        return;
    }
    const int x = event->position().toPoint().x();
    if (m_dragged == Part::Both)
        moveTo(m_dragged, m_before.first + frameAt(x) - m_grabbed, 0, false);
    else {
        // An end lies between two frames.
        const double perFrame = (width() - 2.0 * stripMargin) / m_frames;
        const int edge = static_cast<int>(std::lround((x - stripMargin) / perFrame));
        moveTo(m_dragged, edge, edge - 1, false);
    }
}

void RangeStrip::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        finishDrag(true);
}

void RangeStrip::finishDrag(bool commit)
{
    if (std::exchange(m_dragged, Part::None) == Part::None || range() == m_before)
        return;
    if (!commit)
        setRange(m_before.first, m_before.second);
    emit rangeEdited(m_first, m_last, true);
}

bool RangeStrip::event(QEvent* event)
{
    // Keys that move the ends come before shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_PageUp || key == Qt::Key_PageDown ||
            key == Qt::Key_Up || key == Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void RangeStrip::keyPressEvent(QKeyEvent* event)
{
    const bool both = event->modifiers().testFlag(Qt::ControlModifier);
    const auto move = [&](int frames) {
        moveTo(both ? Part::Both : m_active, m_first + frames, m_last + frames, true);
    };
    constexpr int manyFrames = 10;
    switch (event->key()) {
    case Qt::Key_Left:
        move(-1);
        break;
    case Qt::Key_Right:
        move(1);
        break;
    case Qt::Key_PageUp:
        move(manyFrames);
        break;
    case Qt::Key_PageDown:
        move(-manyFrames);
        break;
    case Qt::Key_Up:
    case Qt::Key_Down:
        m_active = m_active == Part::Start ? Part::End : Part::Start;
        update();
        break;
    case Qt::Key_Escape:
        if (m_dragged != Part::None) {
            finishDrag(false);
            break;
        }
        [[fallthrough]];
    default:
        QWidget::keyPressEvent(event);
    }
}

void RangeStrip::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF ground = QRectF(rect()).adjusted(stripMargin, 4.5, -stripMargin, -4.5);
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.setBrush(Theme::color(ColorRole::Base));
    painter.drawRoundedRect(ground, 3.0, 3.0);
    painter.setPen(Qt::NoPen);
    for (const TimelineSpan& span : m_spans) {
        painter.setBrush(span.color);
        painter.drawRect(QRectF(QPointF(xOf(span.first), ground.bottom() - 5.0),
                                QPointF(xOf(span.last + 1), ground.bottom() - 1.0)));
    }
    const QColor accent = isEnabled() ? Theme::color(ColorRole::Accent) : Theme::color(ColorRole::Line);
    QColor chosen = accent;
    chosen.setAlphaF(0.3F);
    painter.setBrush(chosen);
    painter.drawRect(QRectF(QPointF(xOf(m_first), ground.top()), QPointF(xOf(m_last + 1), ground.bottom())));
    for (const auto& [part, x] :
         {std::pair{Part::Start, xOf(m_first)}, std::pair{Part::End, xOf(m_last + 1)}}) {
        const bool isActive = hasFocus() && m_active == part;
        painter.setPen(isActive ? QPen(Theme::color(ColorRole::Text), 1.5) : QPen(Qt::NoPen));
        painter.setBrush(accent);
        painter.drawRoundedRect(QRectF(x - 3.0, 1.5, 6.0, height() - 3.0), 2.0, 2.0);
    }
}

void RangeStrip::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        setAccessibleName(tr("Frames used"));
    QWidget::changeEvent(event);
}

} // namespace quadrille::widgets

#include "moc_rangestrip.cpp"
