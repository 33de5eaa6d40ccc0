// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/comparedview.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double lineReach = 7;  // logical pixels
constexpr double handleSize = 7; // logical pixels, half
constexpr double splitStep = 0.05;
constexpr double brushStep = 0.5; ///< of its radius, for one press of an arrow
constexpr double sideGap = 6;     // logical pixels

} // namespace

ComparedView::ComparedView(QWidget* parent) : TextureView(parent)
{
    setObjectName(QStringLiteral("comparedView"));
}

void ComparedView::setOther(TexturePicture other)
{
    m_other = std::move(other);
    if (m_other.image.isNull() && m_gesture == Gesture::Splitting)
        m_gesture = Gesture::None;
    update();
}

void ComparedView::setSides(const QString& left, const QString& right)
{
    m_left = left;
    m_right = right;
    update();
}

void ComparedView::setSplit(double split)
{
    m_split = std::clamp(split, 0.0, 1.0);
    update();
}

void ComparedView::setTint(QImage tint)
{
    m_tint = std::move(tint);
    update();
}

void ComparedView::setBrush(std::optional<TextureBrush> brush)
{
    m_brush = brush;
    if (!m_brush && m_gesture == Gesture::Painting)
        m_gesture = Gesture::None;
    update();
}

bool ComparedView::isOnLine(const QPointF& position) const
{
    const QRectF place = textureRect();
    return !m_other.image.isNull() && position.y() >= place.top() && position.y() <= place.bottom() &&
           std::abs(position.x() - positionOf({m_split, 0}).x()) <= lineReach;
}

void ComparedView::moveSplit(double split)
{
    setSplit(split);
    emit splitMoved(m_split);
}

void ComparedView::moveBrush(const QPointF& place)
{
    m_brushPlace = {std::clamp(place.x(), 0.0, 1.0), std::clamp(place.y(), 0.0, 1.0)};
    m_isBrushSeen = true;
    update();
}

void ComparedView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && isOnLine(event->position())) {
        m_gesture = Gesture::Splitting;
    } else if (event->button() == Qt::LeftButton && m_brush && !isEmpty()) {
        m_gesture = Gesture::Painting;
        moveBrush(uvAt(event->position()));
        m_stroke = {uvAt(event->position())};
        emit strokePainted(m_stroke, false);
    } else {
        TextureView::mousePressEvent(event);
    }
}

void ComparedView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_gesture == Gesture::Splitting) {
        moveSplit(uvAt(event->position()).x());
        return;
    }
    if (m_brush)
        moveBrush(uvAt(event->position()));
    if (m_gesture == Gesture::Painting) {
        m_stroke += uvAt(event->position());
        emit strokePainted(m_stroke, false);
        return;
    }
    if (event->buttons() == Qt::NoButton) {
        if (isOnLine(event->position()))
            setCursor(Qt::SplitHCursor);
        else
            unsetCursor();
    }
    TextureView::mouseMoveEvent(event);
}

void ComparedView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool isOver = event->button() == Qt::LeftButton && m_gesture != Gesture::None;
    if (!isOver) {
        TextureView::mouseReleaseEvent(event);
        return;
    }
    if (std::exchange(m_gesture, Gesture::None) == Gesture::Painting)
        emit strokePainted(std::exchange(m_stroke, {}), true);
}

void ComparedView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_brush || isOnLine(event->position()))
        mousePressEvent(event); // the second of two quick dabs
    else
        TextureView::mouseDoubleClickEvent(event);
}

void ComparedView::leaveEvent(QEvent* event)
{
    m_isBrushSeen = false;
    update();
    TextureView::leaveEvent(event);
}

bool ComparedView::isOurKey(const QKeyEvent& key) const
{
    const bool isArrow = key.key() == Qt::Key_Left || key.key() == Qt::Key_Right;
    const bool isUpright = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
    const bool isEnd = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    if (!m_other.image.isNull() && key.modifiers() == Qt::ShiftModifier && (isArrow || isEnd))
        return true;
    const bool isPlain = key.modifiers() == Qt::NoModifier || key.modifiers() == Qt::KeypadModifier;
    return m_brush && !isEmpty() && isPlain &&
           (isArrow || isUpright || key.key() == Qt::Key_Space ||
            (key.key() == Qt::Key_Escape && m_gesture == Gesture::Painting));
}

bool ComparedView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && isOurKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return TextureView::event(event);
}

void ComparedView::keyPressEvent(QKeyEvent* event)
{
    if (!isOurKey(*event)) {
        TextureView::keyPressEvent(event);
        return;
    }
    const int key = event->key();
    if (event->modifiers() == Qt::ShiftModifier) {
        if (key == Qt::Key_Home || key == Qt::Key_End)
            moveSplit(key == Qt::Key_Home ? 0 : 1);
        else
            moveSplit(m_split + (key == Qt::Key_Left ? -splitStep : splitStep));
    } else if (key == Qt::Key_Escape) {
        m_gesture = Gesture::None;
        m_stroke.clear();
        emit strokeCancelled();
    } else if (key == Qt::Key_Space) {
        moveBrush(m_brushPlace);
        emit strokePainted({m_brushPlace}, true);
    } else {
        const double step = brushStep * m_brush->radius;
        const double across = key == Qt::Key_Left ? -step : key == Qt::Key_Right ? step : 0;
        const double up = key == Qt::Key_Down ? -step : key == Qt::Key_Up ? step : 0;
        moveBrush(m_brushPlace + QPointF(across, up));
    }
}

void ComparedView::paintOver(QPainter& painter)
{
    if (!m_other.image.isNull() && !image().isNull()) {
        const double line = positionOf({m_split, 0}).x();
        painter.save();
        painter.setClipRect(QRectF(line, 0, std::max(0.0, width() - line), height()));
        paintPicture(painter, m_other);
        painter.restore();
        paintSides(painter, line);
    }
    if (!m_tint.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
        paintPicture(painter, {m_tint, {}});
    }
    if (m_brush && !isEmpty() && (m_isBrushSeen || hasFocus()))
        paintBrush(painter);
}

/// The line with its handle, and what is on either side.
void ComparedView::paintSides(QPainter& painter, double line) const
{
    const QRectF place = textureRect().intersected(QRectF(rect()));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
    painter.drawLine(QPointF(line, place.top()), QPointF(line, place.bottom()));
    painter.setPen(QPen(Qt::white, 1));
    painter.drawLine(QPointF(line, place.top()), QPointF(line, place.bottom()));
    painter.setBrush(Theme::color(ColorRole::Accent));
    painter.drawEllipse(QPointF(line, place.center().y()), handleSize, handleSize);
    const QFontMetricsF metrics(font());
    const double height = metrics.height() + 4;
    const auto write = [&](const QString& text, bool isLeft) {
        if (text.isEmpty())
            return;
        const double width = metrics.horizontalAdvance(text) + 2 * sideGap;
        const double room = isLeft ? line - place.left() : place.right() - line;
        if (room < width + 2 * sideGap)
            return;
        const QRectF box(isLeft ? line - width - sideGap : line + sideGap, place.top() + sideGap, width,
                         height);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(Qt::white);
        painter.drawText(box, Qt::AlignCenter, text);
    };
    write(m_left, true);
    write(m_right, false);
    painter.restore();
}

void ComparedView::paintBrush(QPainter& painter) const
{
    const double radius = m_brush->radius * textureRect().width();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 180), 3));
    painter.drawEllipse(positionOf(m_brushPlace), radius, radius);
    painter.setPen(QPen(Qt::white, 1, m_brush->erases ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(positionOf(m_brushPlace), radius, radius);
    painter.restore();
}

} // namespace quadrille::widgets

#include "moc_comparedview.cpp"
