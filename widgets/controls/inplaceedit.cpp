// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/inplaceedit.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCompleter>
#include <QKeyEvent>
#include <algorithm>
#include <utility>

namespace quadrille::widgets {

InPlaceEdit::InPlaceEdit(const QString& text, QWidget& below) : QLineEdit(text, &below), m_before(text)
{
    // What takes no focus is pressed, too.
    qApp->installEventFilter(this);
}

void InPlaceEdit::begin(const QRect& place)
{
    constexpr int usualWidth = 140;
    QRect box(place.topLeft(), QSize(std::max(place.width(), usualWidth), sizeHint().height()));
    box.setWidth(std::min(box.width(), parentWidget()->width()));
    box.moveLeft(std::clamp(box.left(), 0, parentWidget()->width() - box.width()));
    box.moveTop(std::clamp(box.top(), 0, std::max(0, parentWidget()->height() - box.height())));
    setGeometry(box);
    show();
    selectAll();
    setFocus();
}

bool InPlaceEdit::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
        if (!(static_cast<QKeyEvent*>(event)->modifiers() & commands)) {
            event->accept();
            return true;
        }
    }
    // Tab would leave by the window's order, with the keyboard somewhere else.
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Tab || key == Qt::Key_Backtab) {
            finish(true);
            return true;
        }
    }
    return QLineEdit::event(event);
}

void InPlaceEdit::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        finish(false);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        finish(true);
    else
        QLineEdit::keyPressEvent(event);
    // A line edit lets such keys through to the widget below, which would act on them.
    event->accept();
}

void InPlaceEdit::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        finish(true);
}

bool InPlaceEdit::eventFilter(QObject* watched, QEvent* event)
{
    const bool leaves = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel;
    if (leaves && watched->isWidgetType() && watched != this && QApplication::activePopupWidget() == nullptr)
        finish(true);
    return QLineEdit::eventFilter(watched, event);
}

void InPlaceEdit::finish(bool accepts)
{
    if (std::exchange(m_isDone, true))
        return;
    qApp->removeEventFilter(this);
    if (completer() != nullptr)
        completer()->popup()->hide();
    if (hasFocus())
        parentWidget()->setFocus();
    hide();
    deleteLater();
    const QString typed = text().trimmed();
    if (accepts && !typed.isEmpty() && typed != m_before)
        emit accepted(typed);
    emit ended(!accepts);
}

} // namespace quadrille::widgets

#include "moc_inplaceedit.cpp"
