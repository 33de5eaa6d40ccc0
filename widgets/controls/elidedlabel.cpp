// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/elidedlabel.h"

#include <QEvent>
#include <QStylePainter>

namespace quadrille::widgets {

ElidedLabel::ElidedLabel(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setText(const QString& text)
{
    if (text == m_text)
        return;
    m_text = text;
    setAccessibleName(text);
    update();
}

void ElidedLabel::setAlignment(Qt::Alignment alignment)
{
    m_alignment = alignment;
    update();
}

QSize ElidedLabel::sizeHint() const
{
    return QSize(0, fontMetrics().height()).grownBy(contentsMargins());
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/)
{
    const QRect room = contentsRect();
    const QString shown = fontMetrics().elidedText(m_text, Qt::ElideRight, room.width());
    QStylePainter(this).drawItemText(
        room, static_cast<int>(QStyle::visualAlignment(layoutDirection(), m_alignment)), palette(),
        isEnabled(), shown, foregroundRole());
}

void ElidedLabel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        updateGeometry();
    QWidget::changeEvent(event);
}

} // namespace quadrille::widgets

#include "moc_elidedlabel.cpp"
