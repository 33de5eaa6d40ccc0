// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/mousegestures.h"
#include "widgets/viewport/turntable.h"

#include <QObject>
#include <QVariantAnimation>
#include <optional>

class QMouseEvent;
class QTouchEvent;
class QWheelEvent;
class QWidget;

namespace quadrille::widgets {

/// Turns mouse, wheel, touch and pinch on a widget into camera movements and clicks. What a drag does is told
/// by a preset; a press and release in one place is a click in all of them. The wheel zooms to the pointer, a
/// sideways wheel turns; one finger orbits, two pan and pinch.
class ViewGestures : public QObject
{
    Q_OBJECT
public:
    /// \param surface  owns it, and loses the events that it takes.
    explicit ViewGestures(QWidget* surface);

    void setPreset(MousePreset preset) { m_preset = preset; }
    MousePreset preset() const { return m_preset; }
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
    MousePreset m_preset = MousePreset::Quadrille;
    std::optional<CameraDrag> m_drag;        ///< none where the preset has none for the button
    Qt::MouseButton m_button = Qt::NoButton; ///< that is down
    QPointF m_pressedAt;
    QPointF m_last;
    bool m_dragged = false;
};

} // namespace quadrille::widgets
