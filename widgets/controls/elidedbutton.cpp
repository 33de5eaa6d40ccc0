// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/elidedbutton.h"

#include <QStyleOptionButton>
#include <QStylePainter>

namespace quadrille::widgets {

ElidedButton::ElidedButton(QWidget* parent) : QPushButton(parent)
{
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedButton::paintEvent(QPaintEvent* /*event*/)
{
    QStyleOptionButton option;
    initStyleOption(&option);
    int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width();
    if (menu() != nullptr)
        room -= 2 * style()->pixelMetric(QStyle::PM_MenuButtonIndicator, &option, this);
    option.text = option.fontMetrics.elidedText(text(), Qt::ElideMiddle, room);
    QStylePainter(this).drawControl(QStyle::CE_PushButton, option);
}

} // namespace quadrille::widgets

#include "moc_elidedbutton.cpp"
