// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/fieldnote.h"

#include <QAccessible>
#include <QEvent>
#include <QKeyEvent>
#include <QLayout>
#include <QLineEdit>
#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int widest = 320;
constexpr int noteGap = 4;
constexpr int lingeringMilliseconds = 8000;

/// Keys that do not edit: they may just have asked for what was refused.
bool isNoEdit(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_Meta:
        return true;
    default:
        return false;
    }
}

} // namespace

FieldNote::FieldNote(QWidget& field, const QRect& place)
    : MessageStrip(field.window()), m_field(&field), m_place(place)
{
    setObjectName(QStringLiteral("fieldNote"));
    setFrameShape(QFrame::StyledPanel);
    layout()->setContentsMargins(8, 4, 8, 4);
    m_lingering.setSingleShot(true);
    m_lingering.setInterval(lingeringMilliseconds);
    connect(&m_lingering, &QTimer::timeout, this, &QObject::deleteLater);
    connect(&field, &QObject::destroyed, this, &QObject::deleteLater);
    if (auto* line = qobject_cast<QLineEdit*>(&field))
        connect(line, &QLineEdit::textChanged, this, &QObject::deleteLater);
    field.installEventFilter(this);
    field.window()->installEventFilter(this);
}

void FieldNote::show(QWidget& field, const QString& sentence, const QString& remedy, const QRect& place)
{
    clear(*field.window());
    auto* note = new FieldNote(field, place);
    note->MessageStrip::show(Kind::Error, sentence, remedy);
    note->placeIt();
    note->raise();
    if (!field.hasFocus())
        note->m_lingering.start();
    QAccessibleEvent alert(note, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void FieldNote::clear(const QWidget& window)
{
    const auto notes = window.findChildren<FieldNote*>(QString(), Qt::FindDirectChildrenOnly);
    for (FieldNote* note : notes) {
        note->hide();
        note->deleteLater();
    }
}

void FieldNote::placeIt()
{
    if (!m_field)
        return;
    const QRect field = m_place.isNull() ? m_field->rect() : m_place;
    const QRect room = parentWidget()->rect();
    const QPoint corner = m_field->mapTo(parentWidget(), field.topLeft());
    const int width = std::min({widest, room.width(), sizeHint().width()});
    const int height = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
    int top = corner.y() + field.height() + noteGap;
    if (top + height > room.height())
        top = std::max(0, corner.y() - noteGap - height);
    const int left = isRightToLeft() ? corner.x() + field.width() - width : corner.x();
    setGeometry(std::clamp(left, 0, std::max(0, room.width() - width)), top, width, height);
}

bool FieldNote::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Hide:
        deleteLater();
        break;
    case QEvent::Resize:
    case QEvent::Move:
        placeIt();
        break;
    case QEvent::KeyPress:
        if (watched == m_field && !isNoEdit(*static_cast<QKeyEvent*>(event)))
            deleteLater();
        break;
    case QEvent::FocusOut:
        if (watched == m_field)
            m_lingering.start();
        break;
    case QEvent::FocusIn:
        if (watched == m_field)
            m_lingering.stop();
        break;
    default:
        break;
    }
    return MessageStrip::eventFilter(watched, event);
}

void FieldNote::mousePressEvent(QMouseEvent* /*event*/)
{
    deleteLater();
}

} // namespace quadrille::widgets

#include "moc_fieldnote.cpp"
