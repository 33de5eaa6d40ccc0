// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QtGlobal>

class QEvent;
class vtkRenderWindowInteractor;

namespace quadrille::widgets {

/// Hands Qt's mouse, wheel, touch, gesture and key events to a VTK interactor.
class VtkEvents
{
public:
    explicit VtkEvents(vtkRenderWindowInteractor* interactor) : m_interactor(interactor) {}
    /// \return whether the interactor took it. Drag-and-drop events are never taken: they go to the parent.
    bool forward(QEvent* event, double devicePixelRatio);

private:
    bool forwardMouse(QEvent* event, double devicePixelRatio);
    bool forwardWheel(QEvent* event, double devicePixelRatio);
    bool forwardTouch(QEvent* event, double devicePixelRatio);
    bool forwardKey(QEvent* event);
    void setPosition(const QPointF& position, Qt::KeyboardModifiers modifiers, double ratio, int repeat = 0);

    vtkRenderWindowInteractor* m_interactor;
    QPointF m_wheelRest;
};

} // namespace quadrille::widgets
