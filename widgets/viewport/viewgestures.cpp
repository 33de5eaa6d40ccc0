// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewgestures.h"

#include "widgets/theme/theme.h"

#include <QApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

using enum CameraDrag;

ViewGestures::ViewGestures(QWidget* surface) : QObject(surface), m_surface(surface)
{
    surface->installEventFilter(this);
    m_movement.setStartValue(0.0F);
    m_movement.setEndValue(1.0F);
    m_movement.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_movement, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& t) { change(Turntable::between(m_from, m_to, t.toFloat())); });
}

void ViewGestures::setCamera(const Turntable& camera)
{
    m_movement.stop();
    change(camera);
}

void ViewGestures::moveTo(const Turntable& camera)
{
    m_movement.stop();
    const int duration = Theme::animationMilliseconds();
    if (duration == 0 || !m_surface->isVisible() || camera.upAxis != m_camera.upAxis) {
        change(camera);
        return;
    }
    m_from = m_camera;
    m_to = camera;
    m_movement.setDuration(duration);
    m_movement.start();
}

Turntable ViewGestures::destination() const
{
    return m_movement.state() == QAbstractAnimation::Running ? m_to : m_camera;
}

void ViewGestures::carry(const QVector3D& shift)
{
    m_from.target += shift;
    m_to.target += shift;
    Turntable moved = m_camera;
    moved.target += shift;
    change(moved);
}

void ViewGestures::change(const Turntable& camera)
{
    if (camera == m_camera)
        return;
    m_camera = camera;
    emit cameraChanged();
}

QSizeF ViewGestures::viewSize() const
{
    return m_surface->size();
}

bool ViewGestures::eventFilter(QObject* /*watched*/, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
        return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
        return release(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
            emit doubleClicked(static_cast<QMouseEvent*>(event)->position());
        return true;
    case QEvent::Wheel:
        return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::NativeGesture:
        return pinch(event);
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return touch(*static_cast<QTouchEvent*>(event));
    default:
        return false;
    }
}

bool ViewGestures::press(const QMouseEvent& event)
{
    if (event.buttons().testFlag(m_button) && m_button != event.button() && m_button != Qt::NoButton)
        return true;
    m_surface->setFocus(Qt::MouseFocusReason);
    m_movement.stop();
    m_button = event.button();
    m_pressedAt = m_last = event.position();
    m_dragged = false;
    m_drag.reset();
    const Qt::KeyboardModifiers keys =
        event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier);
    for (const MouseGesture& gesture : gesturesOf(m_preset)) {
        if (gesture.button == event.button() && gesture.keys == keys)
            m_drag = gesture.drag;
    }
    return true;
}

bool ViewGestures::move(const QMouseEvent& event)
{
    if (m_button == Qt::NoButton) {
        emit hovered(event.position());
        return true;
    }
    if (!m_dragged &&
        2 * (event.position() - m_pressedAt).manhattanLength() < QApplication::startDragDistance())
        return true;
    m_dragged = true;
    const QPointF delta = event.position() - m_last;
    m_last = event.position();
    if (!m_drag)
        return true;
    Turntable camera = m_camera;
    switch (*m_drag) {
    case Orbit:
        camera.orbit(delta, viewSize());
        break;
    case Pan:
        camera.pan(delta, viewSize());
        break;
    case Dolly:
        camera.zoom(static_cast<float>(std::pow(1.006, delta.y())),
                    QPointF(viewSize().width() / 2.0, viewSize().height() / 2.0), viewSize());
        break;
    }
    change(camera);
    return true;
}

bool ViewGestures::release(const QMouseEvent& event)
{
    if (event.button() != m_button)
        return true;
    m_button = Qt::NoButton;
    m_drag.reset();
    if (!m_dragged)
        emit clicked(event.position(), event.button(), event.modifiers());
    return true;
}

bool ViewGestures::wheel(const QWheelEvent& event)
{
    m_movement.stop();
    Turntable camera = m_camera;
    if (event.angleDelta().y() != 0)
        camera.zoom(static_cast<float>(std::pow(0.9988, event.angleDelta().y())), event.position(),
                    viewSize());
    if (event.angleDelta().x() != 0)
        camera.orbit(QPointF(event.angleDelta().x() / 4.0, 0.0), viewSize());
    change(camera);
    return true;
}

bool ViewGestures::pinch(QEvent* event)
{
    const auto& gesture = *static_cast<QNativeGestureEvent*>(event);
    if (gesture.gestureType() != Qt::ZoomNativeGesture)
        return false;
    Turntable camera = m_camera;
    camera.zoom(static_cast<float>(1.0 / std::max(0.1, 1.0 + gesture.value())), gesture.position(),
                viewSize());
    change(camera);
    return true;
}

bool ViewGestures::touch(QTouchEvent& event)
{
    event.accept();
    const auto& points = event.points();
    Turntable camera = m_camera;
    if (event.type() == QEvent::TouchUpdate && points.size() == 1) {
        camera.orbit(points[0].position() - points[0].lastPosition(), viewSize());
    } else if (event.type() == QEvent::TouchUpdate && points.size() == 2) {
        const QPointF before = (points[0].lastPosition() + points[1].lastPosition()) / 2.0;
        const QPointF now = (points[0].position() + points[1].position()) / 2.0;
        const auto span = [](const QPointF& a, const QPointF& b) {
            return std::hypot(a.x() - b.x(), a.y() - b.y());
        };
        const double spanBefore = span(points[0].lastPosition(), points[1].lastPosition());
        const double spanNow = span(points[0].position(), points[1].position());
        camera.pan(now - before, viewSize());
        if (spanBefore > 1.0 && spanNow > 1.0)
            camera.zoom(static_cast<float>(spanBefore / spanNow), now, viewSize());
    } else if (event.type() == QEvent::TouchEnd && points.size() == 1 &&
               (points[0].position() - points[0].pressPosition()).manhattanLength() <
                   QApplication::startDragDistance()) {
        emit clicked(points[0].position(), Qt::LeftButton, event.modifiers());
    }
    change(camera);
    return true;
}

} // namespace quadrille::widgets

#include "moc_viewgestures.cpp"
