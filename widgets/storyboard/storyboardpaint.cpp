// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/storyboard/storyboard.h"
#include "widgets/storyboard/storyboardlayout.h"
#include "widgets/theme/icons.h"

#include <QPainter>
#include <QPainterPath>

namespace quadrille::widgets {

using namespace storyboard;

void Storyboard::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(viewport());
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.fillRect(viewport()->rect(), Theme::color(ColorRole::Window));
    for (int card = 0; card < count(); ++card) {
        const QRect place = cardRect(card);
        if (card > 0) {
            const QPixmap sign = icons::pixmap(QStringLiteral("chevronright"), gap,
                                               Theme::color(ColorRole::TextMuted), devicePixelRatioF());
            painter.drawPixmap(QRect(place.left() - gap, place.center().y() - gap / 2, gap, gap), sign);
        }
        const bool isLifted = m_drag.moved && m_drag.card == card && !m_drag.copies;
        painter.setOpacity(isLifted ? 0.35 : 1.0);
        paintCard(painter, card, place);
        painter.setOpacity(1.0);
    }
    if (m_drag.moved) {
        painter.setOpacity(0.8);
        paintCard(painter, m_drag.card,
                  cardRect(m_drag.card).translated(m_drag.at.x() - m_drag.pressedAt.x(), 0));
        painter.setOpacity(1.0);
    }
    paintInsertion(painter);
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(viewport()->rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void Storyboard::paintCard(QPainter& painter, int card, const QRect& place) const
{
    const StoryCard& shown = m_cards[static_cast<std::size_t>(card)];
    const bool isCurrent = card == m_current;
    const QRectF box = QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(Theme::color(isCurrent        ? ColorRole::AccentText
                                     : shown.isFaulty ? ColorRole::ErrorText
                                                      : ColorRole::Line),
                        isCurrent ? 2.0 : 1.0));
    painter.setBrush(Theme::color(isCurrent ? ColorRole::Selection : ColorRole::Base));
    painter.drawRoundedRect(box, 4.0, 4.0);

    const QRect inner = place.adjusted(margin, margin, -margin, -margin);
    const QRect picture(inner.left(), inner.top(), inner.width(), pictureHeight());
    paintPicture(painter, shown, picture);
    painter.setPen(Qt::NoPen);
    painter.setBrush(shown.color.isValid() ? shown.color : Theme::color(ColorRole::Original));
    painter.drawRoundedRect(QRect(inner.left(), picture.bottom() + 1, inner.width(), lineHeight), 2, 2);

    const QRect text(inner.left(), picture.bottom() + 1 + lineHeight + 3, inner.width(),
                     fontMetrics().height());
    QFont heading = font();
    heading.setWeight(QFont::DemiBold);
    painter.setFont(heading);
    painter.setPen(Theme::color(isCurrent ? ColorRole::OnSelection : ColorRole::Text));
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(heading).elidedText(shown.title, Qt::ElideMiddle, text.width()));
    painter.setFont(Theme::tabularFont(font()));
    painter.setPen(Theme::color(shown.isFaulty ? ColorRole::ErrorText
                                : isCurrent    ? ColorRole::OnSelection
                                               : ColorRole::TextMuted));
    painter.drawText(text.translated(0, text.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(shown.subtitle, Qt::ElideRight, text.width()));
}

void Storyboard::paintPicture(QPainter& painter, const StoryCard& card, const QRect& place) const
{
    QPainterPath rounded;
    rounded.addRoundedRect(place, 3.0, 3.0);
    painter.fillPath(rounded, Theme::color(ColorRole::Raised));
    if (card.picture.isNull()) {
        constexpr int signSize = 16;
        QRect sign(0, 0, signSize, signSize);
        sign.moveCenter(place.center());
        painter.drawPixmap(
            sign,
            icons::pixmap(card.isFaulty ? QStringLiteral("error") : QStringLiteral("sequence"), signSize,
                          Theme::color(card.isFaulty ? ColorRole::ErrorText : ColorRole::TextMuted),
                          devicePixelRatioF()));
    } else {
        QRect square(0, 0, place.height(), place.height());
        square.moveCenter(place.center());
        painter.drawImage(square, card.picture);
    }
    if (card.badge.isEmpty())
        return;
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF badge(0, 0, metrics.horizontalAdvance(card.badge) + 10.0, metrics.height() + 2.0);
    badge.moveTopRight(QPointF(place.right() - 2.0, place.top() + 3.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::Accent));
    painter.drawRoundedRect(badge, 3.0, 3.0);
    painter.setPen(Theme::color(ColorRole::OnAccent));
    painter.drawText(badge, Qt::AlignCenter, card.badge);
}

void Storyboard::paintInsertion(QPainter& painter) const
{
    const bool isNowhere = m_drag.moved && !m_drag.copies && !isMove(m_drag.card, m_insertion);
    if (m_insertion < 0 || isNowhere)
        return;
    const QRect next = cardRect(m_insertion);
    const double middle = next.left() - gap / 2.0;
    const QColor color = Theme::color(ColorRole::AccentText);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(middle - 1.5, next.top(), 3.0, next.height()), 1.5, 1.5);
    painter.drawEllipse(QPointF(middle, next.top()), 4.0, 4.0);
    painter.drawEllipse(QPointF(middle, next.bottom() + 1.0), 4.0, 4.0);
}

} // namespace quadrille::widgets
