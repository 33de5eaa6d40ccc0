// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/elidedpair.h"

#include <QApplication>
#include <QStyle>
#include <algorithm>

namespace quadrille::widgets {

namespace {

QString between()
{
    return QStringLiteral(" › ");
}

} // namespace

QString pairText(const QString& from, const QString& to)
{
    return from + between() + to;
}

QString elidedPair(const QString& text, const QFontMetrics& metrics, int width)
{
    const auto place = text.indexOf(between());
    if (place < 0 || metrics.horizontalAdvance(text) <= width)
        return metrics.elidedText(text, Qt::ElideMiddle, width);
    const QString from = text.left(place);
    const QString to = text.mid(place + between().size());
    const int room = width - metrics.horizontalAdvance(between());
    const int fromWidth = metrics.horizontalAdvance(from);
    const int toWidth = metrics.horizontalAdvance(to);
    // What a short name leaves goes to the other one.
    const int fromRoom = std::min(fromWidth, std::max(room / 2, room - toWidth));
    return metrics.elidedText(from, Qt::ElideMiddle, fromRoom) + between() +
           metrics.elidedText(to, Qt::ElideMiddle, room - fromRoom);
}

void PairDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (!option->text.contains(between()) || option->rect.width() <= 0)
        return;
    const QStyle* style = option->widget != nullptr ? option->widget->style() : QApplication::style();
    const int room = style->subElementRect(QStyle::SE_ItemViewItemText, option, option->widget).width() -
                     2 * (style->pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1);
    option->text = elidedPair(option->text, option->fontMetrics, room);
}

} // namespace quadrille::widgets

#include "moc_elidedpair.cpp"
