// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/storyboard/storyboard.h"

#include "widgets/storyboard/storyboardlayout.h"
#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

namespace quadrille::widgets {

using namespace storyboard;

Storyboard::Storyboard(QWidget* parent)
    : QAbstractScrollArea(parent), m_empty(new QWidget(viewport())), m_emptyText(new QLabel)
{
    setObjectName(QStringLiteral("storyboard"));
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    viewport()->setAcceptDrops(true);
    viewport()->setMouseTracking(true);
    m_emptyText->setObjectName(QStringLiteral("storyboardEmpty"));
    m_emptyText->setForegroundRole(QPalette::PlaceholderText);
    // One line: what does not fit is in its tool tip.
    m_emptyText->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(m_empty);
    row->setContentsMargins(gap, margin, gap, margin);
    row->setSpacing(gap);
    row->addWidget(m_emptyText, 1);
    connect(&Theme::instance(), &Theme::changed, viewport(), qOverload<>(&QWidget::update));
    QEvent retranslate(QEvent::LanguageChange);
    changeEvent(&retranslate);
}

Storyboard::~Storyboard() = default;

void Storyboard::setCards(std::vector<StoryCard> cards)
{
    const bool changesHeight = cards.empty() != m_cards.empty();
    m_cards = std::move(cards);
    m_empty->setVisible(m_cards.empty());
    if (changesHeight)
        updateGeometry();
    if (m_drag.card >= count())
        m_drag = {};
    if (m_current >= count())
        choose(count() - 1);
    updateScrollBar();
    updateAccessibleText();
    viewport()->update();
}

void Storyboard::setCurrent(int card)
{
    if (card == m_current || card >= count())
        return;
    m_current = card;
    reveal(card);
    updateAccessibleText();
    viewport()->update();
}

void Storyboard::choose(int card)
{
    if (card == m_current)
        return;
    m_current = card;
    reveal(card);
    updateAccessibleText();
    viewport()->update();
    emit currentChanged(card);
}

void Storyboard::setEmptyText(const QString& text)
{
    m_emptyWords = text;
    m_emptyText->setToolTip(text);
    m_emptyText->setAccessibleName(text);
    fitEmptyText();
}

void Storyboard::fitEmptyText()
{
    m_empty->layout()->activate();
    m_emptyText->setText(
        m_emptyText->fontMetrics().elidedText(m_emptyWords, Qt::ElideRight, m_emptyText->width()));
}

void Storyboard::addEmptyAction(QWidget* action)
{
    m_empty->layout()->addWidget(action);
}

int Storyboard::cardHeight(int picture) const
{
    return margin + picture + lineHeight + 4 + 2 * fontMetrics().height() + margin;
}

int Storyboard::pictureHeight() const
{
    return std::clamp(viewport()->height() - 2 * above - cardHeight(0), smallestPicture, pictureSide);
}

QRect Storyboard::cardRect(int card) const
{
    return {gap + card * (cardWidth + gap) - horizontalScrollBar()->value(), above, cardWidth,
            cardHeight(pictureHeight())};
}

int Storyboard::cardAt(const QPoint& position) const
{
    for (int card = 0; card < count(); ++card)
        if (cardRect(card).contains(position))
            return card;
    return -1;
}

int Storyboard::insertionAt(const QPoint& position) const
{
    const int inside = position.x() + horizontalScrollBar()->value() - gap + (cardWidth + gap) / 2;
    return std::clamp(inside / (cardWidth + gap), 0, count());
}

QSize Storyboard::sizeHint() const
{
    if (m_cards.empty())
        return minimumSizeHint();
    constexpr int shownCards = 4;
    return {shownCards * (cardWidth + gap) + gap,
            cardHeight(pictureSide) + 2 * above + horizontalScrollBar()->sizeHint().height()};
}

QSize Storyboard::minimumSizeHint() const
{
    if (m_cards.empty())
        return {cardWidth + 2 * gap, m_empty->layout()->minimumSize().height()};
    return {cardWidth + 2 * gap, cardHeight(smallestPicture) + 2 * above};
}

void Storyboard::updateScrollBar()
{
    const int content = gap + count() * (cardWidth + gap);
    horizontalScrollBar()->setRange(0, std::max(0, content - viewport()->width()));
    horizontalScrollBar()->setPageStep(viewport()->width());
    horizontalScrollBar()->setSingleStep(cardWidth / 2);
}

void Storyboard::reveal(int card)
{
    if (card < 0)
        return;
    updateScrollBar();
    const QRect place = cardRect(card);
    QScrollBar& bar = *horizontalScrollBar();
    if (place.left() < gap)
        bar.setValue(bar.value() + place.left() - gap);
    else if (place.right() > viewport()->width() - gap)
        bar.setValue(bar.value() + place.right() - viewport()->width() + gap);
}

/// Moves on while something is held near an end.
void Storyboard::scrollNear(const QPoint& position)
{
    constexpr int reach = 24;
    QScrollBar& bar = *horizontalScrollBar();
    if (position.x() < reach)
        bar.setValue(bar.value() - reach / 2);
    else if (position.x() > viewport()->width() - reach)
        bar.setValue(bar.value() + reach / 2);
}

void Storyboard::updateAccessibleText()
{
    if (!QAccessible::isActive())
        return;
    const bool isChosen = m_current >= 0 && m_current < count();
    setAccessibleDescription(isChosen ? tr("%1 of %2: %3, %4")
                                            .arg(m_current + 1)
                                            .arg(count())
                                            .arg(m_cards[static_cast<std::size_t>(m_current)].title,
                                                 m_cards[static_cast<std::size_t>(m_current)].subtitle)
                                      : m_emptyWords);
}

bool Storyboard::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        const int card = cardAt(help.pos());
        if (card >= 0)
            QToolTip::showText(help.globalPos(), m_cards[static_cast<std::size_t>(card)].tip, this);
        else
            QToolTip::hideText();
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void Storyboard::resizeEvent(QResizeEvent* event)
{
    QAbstractScrollArea::resizeEvent(event);
    m_empty->setGeometry(viewport()->rect());
    fitEmptyText();
    updateScrollBar();
}

void Storyboard::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        setAccessibleName(tr("Storyboard"));
    QAbstractScrollArea::changeEvent(event);
}

} // namespace quadrille::widgets

#include "moc_storyboard.cpp"
