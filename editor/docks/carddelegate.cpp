// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/carddelegate.h"

#include "editor/docks/cardpictures.h"
#include "editor/docks/sequencecards.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <algorithm>

namespace quadrille {

namespace {

using widgets::ColorRole;
using widgets::Theme;

constexpr int cardMargin = 6;
constexpr int gap = 8;
constexpr int colorWidth = 3; ///< of the sequence's own colour at the left edge
constexpr int leastStripHeight = 6;
constexpr int signSize = 16;
constexpr int textLines = 3;

QRect pictureRect(const QRect& card)
{
    return {card.left() + cardMargin, card.top() + (card.height() - CardPictures::side) / 2,
            CardPictures::side, CardPictures::side};
}

QRect textRect(const QRect& card)
{
    return card.adjusted(cardMargin + CardPictures::side + gap, cardMargin, -cardMargin, -cardMargin);
}

void paintPicture(QPainter& painter, const QRect& place, const QModelIndex& index, int phase)
{
    const auto pictures = index.data(SequenceCards::PicturesRole).value<QList<QImage>>();
    const auto state = static_cast<ResultPhase>(index.data(SequenceCards::StateRole).toInt());
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::Raised));
    painter.drawRoundedRect(place, 4, 4);
    if (!pictures.isEmpty()) {
        const auto standing = pictures.size() / 3;
        painter.drawImage(place, pictures[(standing + phase) % pictures.size()]);
        return;
    }
    const bool failed = state == ResultPhase::Failed;
    QRect sign(0, 0, signSize, signSize);
    sign.moveCenter(place.center());
    painter.drawPixmap(
        sign, widgets::icons::pixmap(failed ? QStringLiteral("error") : QStringLiteral("sequence"), signSize,
                                     Theme::color(failed ? ColorRole::ErrorText : ColorRole::TextMuted),
                                     painter.device()->devicePixelRatioF()));
}

/// Labels are named where there is room for some letters.
QFont stripFont(const QFont& base)
{
    constexpr double smaller = 0.85;
    QFont font = base;
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() * smaller);
    return font;
}

int lineHeight(const QStyleOptionViewItem& option)
{
    return option.fontMetrics.height() + 2;
}

int stripHeight(const QStyleOptionViewItem& option)
{
    return std::max(leastStripHeight, QFontMetrics(stripFont(option.font)).height());
}

void paintLabels(QPainter& painter, const QRect& place, const QModelIndex& index)
{
    constexpr int leastLetters = 3;
    constexpr int padding = 3;
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::Divider));
    painter.drawRoundedRect(place, 2, 2);
    const QFontMetrics metrics(painter.font());
    for (const CardLabel& label : index.data(SequenceCards::LabelsRole).value<QList<CardLabel>>()) {
        const QRectF part(place.left() + label.first * place.width(), place.top(),
                          (label.last - label.first) * place.width(), place.height());
        painter.setPen(Qt::NoPen);
        painter.setBrush(label.color);
        painter.drawRoundedRect(part, 2, 2);
        const QRectF inner = part.adjusted(padding, 0, -padding, 0);
        const QString text = metrics.elidedText(label.text, Qt::ElideRight, static_cast<int>(inner.width()));
        if (text != label.text && text.size() <= leastLetters)
            continue;
        painter.setPen(Theme::textOn(label.color));
        painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, text);
    }
}

} // namespace

void CardDelegate::setMoving(const QModelIndex& card, int phase)
{
    m_moving = card;
    m_phase = phase;
}

void CardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    if (selected || option.state.testFlag(QStyle::State_MouseOver))
        painter->fillRect(option.rect, Theme::color(selected ? ColorRole::Selection : ColorRole::Hover));
    painter->fillRect(QRect(option.rect.left(), option.rect.top() + 1, colorWidth, option.rect.height() - 2),
                      index.data(SequenceCards::ColorRole).value<QColor>());
    paintPicture(*painter, pictureRect(option.rect), index, m_moving == index ? m_phase : 0);

    const QRect text = textRect(option.rect);
    QFont heading = option.font;
    heading.setWeight(QFont::DemiBold);
    painter->setFont(heading);
    painter->setPen(Theme::color(selected ? ColorRole::OnSelection : ColorRole::Text));
    painter->drawText(
        text, Qt::AlignLeft | Qt::AlignTop,
        QFontMetrics(heading).elidedText(index.data().toString(), Qt::ElideRight, text.width()));
    painter->setFont(Theme::tabularFont(option.font));
    painter->setPen(Theme::color(selected ? ColorRole::OnSelection : ColorRole::TextMuted));
    QStringList length = index.data(SequenceCards::LengthRole).toString().split(QLatin1Char('\n'));
    for (QString& line : length)
        line = painter->fontMetrics().elidedText(line, Qt::ElideRight, text.width());
    painter->drawText(text.adjusted(0, lineHeight(option), 0, 0), Qt::AlignLeft | Qt::AlignTop,
                      length.join(QLatin1Char('\n')));
    painter->setFont(stripFont(option.font));
    const int strip = stripHeight(option);
    paintLabels(*painter, QRect(text.left(), text.bottom() - strip + 1, text.width(), strip), index);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(Theme::color(ColorRole::AccentText));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter->restore();
}

QSize CardDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const
{
    constexpr int narrowest = 180;
    const int text = textLines * lineHeight(option) + stripHeight(option) + 2 * cardMargin;
    return {narrowest, std::max(CardPictures::side + cardMargin, text)};
}

void CardDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex& /*index*/) const
{
    const QRect text = textRect(option.rect);
    editor->setGeometry(QRect(text.topLeft(), QSize(text.width(), editor->sizeHint().height())));
}

} // namespace quadrille

#include "moc_carddelegate.cpp"
