// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/wheelfocus.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QScrollBar>
#include <QTabBar>

namespace quadrille {

namespace {

/// The object as a field that the wheel would change; null for everything else.
QWidget* asField(QObject* object)
{
    const bool isField =
        qobject_cast<QAbstractSpinBox*>(object) != nullptr || qobject_cast<QComboBox*>(object) != nullptr ||
        qobject_cast<QTabBar*>(object) != nullptr ||
        (qobject_cast<QAbstractSlider*>(object) != nullptr && qobject_cast<QScrollBar*>(object) == nullptr);
    return isField ? static_cast<QWidget*>(object) : nullptr;
}

} // namespace

WheelFocus::WheelFocus(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool WheelFocus::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Polish && event->type() != QEvent::Wheel)
        return false;
    QWidget* field = asField(watched);
    if (field == nullptr)
        return false;
    if (event->type() == QEvent::Polish) {
        // Qt gives a field of this policy the keyboard before it gives it the wheel.
        if (field->focusPolicy() == Qt::WheelFocus)
            field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (field->hasFocus())
        return false;
    event->ignore();
    return true;
}

} // namespace quadrille

#include "moc_wheelfocus.cpp"
