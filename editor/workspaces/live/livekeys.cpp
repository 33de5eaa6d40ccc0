// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/livekeys.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWidget>
#include <algorithm>
#include <array>

namespace quadrille {

namespace {

struct SteeringKey
{
    int key;
    SteeringAxis axis;
    int direction;
};

constexpr std::array steeringKeys{SteeringKey{Qt::Key_A, SteeringAxis::Horizontal, -1},
                                  SteeringKey{Qt::Key_Left, SteeringAxis::Horizontal, -1},
                                  SteeringKey{Qt::Key_D, SteeringAxis::Horizontal, 1},
                                  SteeringKey{Qt::Key_Right, SteeringAxis::Horizontal, 1},
                                  SteeringKey{Qt::Key_S, SteeringAxis::Vertical, -1},
                                  SteeringKey{Qt::Key_Down, SteeringAxis::Vertical, -1},
                                  SteeringKey{Qt::Key_W, SteeringAxis::Vertical, 1},
                                  SteeringKey{Qt::Key_Up, SteeringAxis::Vertical, 1},
                                  SteeringKey{Qt::Key_PageDown, SteeringAxis::Third, -1},
                                  SteeringKey{Qt::Key_PageUp, SteeringAxis::Third, 1}};

bool isDigit(int key)
{
    return key >= Qt::Key_1 && key <= Qt::Key_9;
}

bool isOther(int key)
{
    return isDigit(key) || key == Qt::Key_J || key == Qt::Key_R;
}

bool isSteering(int key)
{
    return std::ranges::any_of(steeringKeys, [key](const SteeringKey& each) { return each.key == key; });
}

/// What has keys of its own.
bool isField(const QWidget* widget)
{
    return qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(widget) != nullptr;
}

} // namespace

LiveKeys::LiveKeys(QWidget& widget) : QObject(&widget), m_widget(widget) {}

void LiveKeys::setEnabled(bool enabled)
{
    if (enabled == m_isEnabled)
        return;
    m_isEnabled = enabled;
    m_held.clear();
    if (enabled)
        QApplication::instance()->installEventFilter(this);
    else
        QApplication::instance()->removeEventFilter(this);
}

SteeringState LiveKeys::state() const
{
    SteeringState state;
    std::array<int, 3> axes{};
    for (const SteeringKey& each : steeringKeys) {
        int& axis = axes.at(static_cast<std::size_t>(each.axis));
        if (m_held.contains(each.key) && axis != -each.direction)
            axis = each.direction;
        else if (m_held.contains(each.key))
            axis = 0; // both ways
    }
    for (std::size_t a = 0; a < axes.size(); ++a)
        state.axes.at(a) = axes.at(a);
    return state;
}

bool LiveKeys::isMine(const QKeyEvent& event) const
{
    const QWidget* focus = QApplication::focusWidget();
    const bool isPlain = (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == 0;
    return isPlain && (isSteering(event.key()) || isOther(event.key())) && !isField(focus) &&
           QApplication::activeModalWidget() == nullptr && QApplication::activePopupWidget() == nullptr;
}

void LiveKeys::press(int key)
{
    if (isSteering(key))
        m_held.insert(key);
    else if (key == Qt::Key_J)
        emit jumpPressed();
    else if (key == Qt::Key_R)
        emit responsivePressed();
    else
        emit spacePressed(key - Qt::Key_1);
}

bool LiveKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ApplicationDeactivate || event->type() == QEvent::WindowDeactivate)
        m_held.clear(); // what is let go elsewhere is not heard of
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease ||
                       event->type() == QEvent::ShortcutOverride;
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (!isKey || widget == nullptr || widget->window() != m_widget.window())
        return false;
    auto* key = static_cast<QKeyEvent*>(event);
    if (event->type() == QEvent::KeyRelease && !key->isAutoRepeat() && m_held.remove(key->key()))
        return true;
    if (!isMine(*key))
        return false;
    event->accept();
    if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
        press(key->key());
    return true;
}

} // namespace quadrille

#include "moc_livekeys.cpp"
