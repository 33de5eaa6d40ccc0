// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/focuskeys.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QTabBar>

namespace quadrille {

namespace {

bool isArrow(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool movesAlong(int key)
{
    return isArrow(key) || key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_PageUp ||
           key == Qt::Key_PageDown;
}

/// Whether a control does something of its own with a key.
bool uses(const QObject* control, const QKeyEvent& event)
{
    const int key = event.key();
    if (qobject_cast<const QAbstractButton*>(control) != nullptr)
        return key == Qt::Key_Space;
    if (qobject_cast<const QAbstractSlider*>(control) != nullptr)
        return movesAlong(key);
    if (qobject_cast<const QTabBar*>(control) != nullptr)
        return key == Qt::Key_Left || key == Qt::Key_Right;
    if (qobject_cast<const QComboBox*>(control) != nullptr) // letters look for an item
        return movesAlong(key) || (!event.text().isEmpty() && event.text().at(0).isPrint());
    return false;
}

} // namespace

FocusKeys::FocusKeys(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool FocusKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride)
        return false;
    auto* key = static_cast<QKeyEvent*>(event);
    constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    if ((key->modifiers() & commands) != Qt::NoModifier || !uses(watched, *key))
        return false;
    key->accept();
    return true;
}

} // namespace quadrille
