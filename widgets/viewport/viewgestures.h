// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QObject>
#include <QVariantAnimation>

class QMouseEvent;
class QTouchEvent;
class QWheelEvent;
class QWidget;

namespace quadrille::widgets {

/// Turns mouse, wheel, touch and pinch on a widget into camera movements and clicks. Left or middle drag
/// orbits, with Shift (or the right button) pans, with Ctrl dollies; the wheel zooms to the pointer, a
/// sideways wheel turns; one finger orbits, two pan and pinch.
class ViewGestures : public QObject
{
    Q_OBJECT
public:
    explicit ViewGestures(QWidget* surface);

    const Turntable& camera() const { return m_camera; }
    /// At once, ending any movement.
    void setCamera(const Turntable& camera);
    /// In a short movement, where the system wants movement.
    void moveTo(const Turntable& camera);
    /// Where a running movement ends; else the camera.
    Turntable destination() const;
    /// Shifts camera and any running movement along with a figure.
    void carry(const QVector3D& shift);

signals:
    void cameraChanged();
    /// A press and release in one place.
    void clicked(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    void doubleClicked(const QPointF& position);
    /// The pointer moved with no button down.
    void hovered(const QPointF& position);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag
    {
        None,
        Orbit,
        Pan,
        Dolly
    };
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool wheel(const QWheelEvent& event);
    bool touch(QTouchEvent& event);
    bool pinch(QEvent* event);
    void change(const Turntable& camera);
    QSizeF viewSize() const;

    QWidget* m_surface;
    Turntable m_camera;
    QVariantAnimation m_movement;
    Turntable m_from;
    Turntable m_to;
    Drag m_drag = Drag::None;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_pressedAt;
    QPointF m_last;
    bool m_dragged = false;
};

} // namespace quadrille::widgets
