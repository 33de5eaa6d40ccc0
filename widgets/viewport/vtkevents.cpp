// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkevents.h"

#include <QHash>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <algorithm>
#include <optional>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>

namespace quadrille::widgets {

namespace {

QByteArray keySymbol(const QKeyEvent& event)
{
    static const QHash<int, const char*> special{
        {Qt::Key_Backspace, "BackSpace"}, {Qt::Key_Tab, "Tab"},       {Qt::Key_Return, "Return"},
        {Qt::Key_Enter, "Return"},        {Qt::Key_Shift, "Shift_L"}, {Qt::Key_Control, "Control_L"},
        {Qt::Key_Alt, "Alt_L"},           {Qt::Key_Escape, "Escape"}, {Qt::Key_Space, "space"},
        {Qt::Key_PageUp, "Prior"},        {Qt::Key_PageDown, "Next"}, {Qt::Key_End, "End"},
        {Qt::Key_Home, "Home"},           {Qt::Key_Left, "Left"},     {Qt::Key_Up, "Up"},
        {Qt::Key_Right, "Right"},         {Qt::Key_Down, "Down"},     {Qt::Key_Insert, "Insert"},
        {Qt::Key_Delete, "Delete"},       {Qt::Key_Plus, "plus"},     {Qt::Key_Minus, "minus"},
        {Qt::Key_Asterisk, "asterisk"},   {Qt::Key_Slash, "slash"},   {Qt::Key_Period, "period"},
        {Qt::Key_Comma, "comma"}};
    const int key = event.key();
    if (const auto it = special.find(key); it != special.end())
        return *it;
    if (key >= Qt::Key_F1 && key <= Qt::Key_F24)
        return "F" + QByteArray::number(key - Qt::Key_F1 + 1);
    if (key >= Qt::Key_0 && key <= Qt::Key_9)
        return (event.modifiers().testFlag(Qt::KeypadModifier) ? "KP_" : "") +
               QByteArray(1, static_cast<char>(key));
    if (key >= Qt::Key_A && key <= Qt::Key_Z) {
        const bool upper = event.modifiers().testFlag(Qt::ShiftModifier);
        return {1, static_cast<char>(upper ? key : key - 'A' + 'a')};
    }
    return "None";
}

std::optional<std::size_t> buttonIndex(Qt::MouseButton button)
{
    switch (button) {
    case Qt::LeftButton:
        return 0;
    case Qt::MiddleButton:
        return 1;
    case Qt::RightButton:
        return 2;
    default:
        return std::nullopt;
    }
}

} // namespace

bool VtkEvents::forward(QEvent* event, double devicePixelRatio)
{
    if (!m_interactor->GetEnabled())
        return false;
    switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
        return forwardMouse(event, devicePixelRatio);
    case QEvent::Wheel:
        return forwardWheel(event, devicePixelRatio);
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return forwardTouch(event, devicePixelRatio);
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        return forwardKey(event);
    case QEvent::Enter:
        m_interactor->InvokeEvent(vtkCommand::EnterEvent, event);
        return false;
    case QEvent::Leave:
        m_interactor->InvokeEvent(vtkCommand::LeaveEvent, event);
        return false;
    default:
        return false;
    }
}

void VtkEvents::setPosition(const QPointF& position, Qt::KeyboardModifiers modifiers, double ratio,
                            int repeat)
{
    m_interactor->SetEventInformationFlipY(
        static_cast<int>(position.x() * ratio), static_cast<int>(position.y() * ratio),
        modifiers.testFlag(Qt::ControlModifier), modifiers.testFlag(Qt::ShiftModifier), 0, repeat);
    m_interactor->SetAltKey(modifiers.testFlag(Qt::AltModifier));
}

bool VtkEvents::forwardMouse(QEvent* event, double devicePixelRatio)
{
    auto* mouse = static_cast<QMouseEvent*>(event);
    const bool doubled = event->type() == QEvent::MouseButtonDblClick;
    setPosition(mouse->position(), mouse->modifiers(), devicePixelRatio, doubled ? 1 : 0);
    if (event->type() == QEvent::MouseMove) {
        m_interactor->InvokeEvent(vtkCommand::MouseMoveEvent, mouse);
        return true;
    }
    static constexpr unsigned long commands[3][3] = {
        {vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::LeftButtonDoubleClickEvent},
        {vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
         vtkCommand::MiddleButtonDoubleClickEvent},
        {vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
         vtkCommand::RightButtonDoubleClickEvent}};
    const auto button = buttonIndex(mouse->button());
    if (!button)
        return false;
    const std::size_t kind = doubled ? 2 : event->type() == QEvent::MouseButtonPress ? 0 : 1;
    m_interactor->InvokeEvent(commands[*button][kind], mouse);
    return true;
}

bool VtkEvents::forwardWheel(QEvent* event, double devicePixelRatio)
{
    auto* wheel = static_cast<QWheelEvent*>(event);
    setPosition(wheel->position(), wheel->modifiers(), devicePixelRatio);
    constexpr double notch = 120.0;
    m_wheelRest += wheel->angleDelta();
    const auto emitNotches = [&](double& rest, unsigned long forwards, unsigned long backwards) {
        for (; rest >= notch; rest -= notch)
            m_interactor->InvokeEvent(forwards, wheel);
        for (; rest <= -notch; rest += notch)
            m_interactor->InvokeEvent(backwards, wheel);
    };
    emitNotches(m_wheelRest.ry(), vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent);
    emitNotches(m_wheelRest.rx(), vtkCommand::MouseWheelRightEvent, vtkCommand::MouseWheelLeftEvent);
    return true;
}

bool VtkEvents::forwardTouch(QEvent* event, double devicePixelRatio)
{
    auto* touch = static_cast<QTouchEvent*>(event);
    if (event->type() == QEvent::TouchCancel) {
        m_interactor->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
        return true;
    }
    for (const QEventPoint& point : touch->points()) {
        if (point.id() >= VTKI_MAX_POINTERS)
            break;
        m_interactor->SetEventInformationFlipY(static_cast<int>(point.position().x() * devicePixelRatio),
                                               static_cast<int>(point.position().y() * devicePixelRatio), 0,
                                               0, 0, 0, nullptr, point.id());
        m_interactor->SetPointerIndex(point.id());
        if (point.state() == QEventPoint::Pressed)
            m_interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent, nullptr);
        else if (point.state() == QEventPoint::Released)
            m_interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent, nullptr);
        else
            m_interactor->InvokeEvent(vtkCommand::MouseMoveEvent, nullptr);
    }
    return true;
}

bool VtkEvents::forwardKey(QEvent* event)
{
    auto* key = static_cast<QKeyEvent*>(event);
    const char text = key->text().isEmpty() ? '\0' : key->text().at(0).toLatin1();
    m_interactor->SetKeyEventInformation(key->modifiers().testFlag(Qt::ControlModifier),
                                         key->modifiers().testFlag(Qt::ShiftModifier), text, key->count(),
                                         keySymbol(*key).constData());
    m_interactor->SetAltKey(key->modifiers().testFlag(Qt::AltModifier));
    if (event->type() == QEvent::KeyRelease) {
        m_interactor->InvokeEvent(vtkCommand::KeyReleaseEvent, key);
        return true;
    }
    m_interactor->InvokeEvent(vtkCommand::KeyPressEvent, key);
    if (text != '\0')
        m_interactor->InvokeEvent(vtkCommand::CharEvent, key);
    // Keys stay free for the window's shortcuts and focus.
    return false;
}

} // namespace quadrille::widgets
