// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/cardsview.h"

#include "editor/docks/carddelegate.h"
#include "editor/docks/sequencecards.h"
#include "widgets/theme/theme.h"

#include <QDrag>
#include <QPainter>

namespace quadrille {

namespace {

constexpr int pictureOffset = 12;
constexpr int listMargin = 12;

} // namespace

CardsView::CardsView(QWidget* parent) : QListView(parent)
{
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    setUniformItemSizes(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setMouseTracking(true);
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
}

void CardsView::setEmptyText(const QString& text)
{
    m_emptyText = text;
    viewport()->update();
}

QPoint CardsView::menuPlace() const
{
    return currentIndex().isValid() ? visualRect(currentIndex()).center() : rect().center();
}

void CardsView::startDrag(Qt::DropActions actions)
{
    const QModelIndexList cards = selectedIndexes();
    const auto pictures = currentIndex().data(SequenceCards::PicturesRole).value<QList<QImage>>();
    if (cards.isEmpty())
        return;
    auto* drag = new QDrag(this);
    drag->setMimeData(model()->mimeData(cards));
    const auto* delegate = static_cast<const CardDelegate*>(itemDelegate());
    const int phase = delegate->moving() == currentIndex() ? delegate->phase() : 0;
    if (!pictures.isEmpty()) {
        QPixmap picture = QPixmap::fromImage(pictures[(pictures.size() / 3 + phase) % pictures.size()]);
        picture.setDevicePixelRatio(devicePixelRatioF());
        drag->setPixmap(picture);
        // Beside the pointer, where it does not hide the mark under it.
        drag->setHotSpot({-pictureOffset, -pictureOffset});
    }
    drag->exec(actions, Qt::CopyAction);
}

void CardsView::paintEvent(QPaintEvent* event)
{
    QListView::paintEvent(event);
    if (model() == nullptr || model()->rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(widgets::Theme::color(widgets::ColorRole::TextMuted));
    painter.drawText(viewport()->rect().adjusted(listMargin, listMargin, -listMargin, -listMargin),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
}

} // namespace quadrille

#include "moc_cardsview.cpp"
