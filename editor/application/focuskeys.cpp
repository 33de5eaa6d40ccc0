// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/focuskeys.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QTabBar>

namespace quadrille {

namespace {

constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

bool isArrow(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

/// Whether a control does something of its own with a key.
bool uses(const QObject* control, int key)
{
    const bool movesUpOrDown = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    const bool isEnd = key == Qt::Key_Home || key == Qt::Key_End;
    if (qobject_cast<const QAbstractSlider*>(control) != nullptr)
        return isArrow(key) || movesUpOrDown || isEnd;
    if (qobject_cast<const QTabBar*>(control) != nullptr)
        return key == Qt::Key_Left || key == Qt::Key_Right;
    if (qobject_cast<const QComboBox*>(control) != nullptr)
        return key == Qt::Key_Up || key == Qt::Key_Down || movesUpOrDown || isEnd;
    return false;
}

} // namespace

FocusKeys::FocusKeys(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// What Space does elsewhere. \return whether the key was for the control.
bool FocusKeys::press(QObject* control, const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter)
        return false;
    const auto* widget = qobject_cast<QWidget*>(control);
    if (widget == nullptr || !widget->isEnabled() || qobject_cast<QDialog*>(widget->window()) != nullptr)
        return false;
    if (auto* button = qobject_cast<QAbstractButton*>(control)) {
        if (!event.isAutoRepeat())
            button->click();
        return true;
    }
    if (auto* choice = qobject_cast<QComboBox*>(control); choice != nullptr && !choice->isEditable()) {
        choice->showPopup();
        return true;
    }
    return false;
}

bool FocusKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return false;
    auto* key = static_cast<QKeyEvent*>(event);
    if ((key->modifiers() & (commands | Qt::ShiftModifier)) != Qt::NoModifier)
        return false;
    if (event->type() == QEvent::KeyPress)
        return press(watched, *key);
    if (!uses(watched, key->key()))
        return false;
    key->accept();
    return true;
}

} // namespace quadrille

#include "moc_focuskeys.cpp"
