// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/cardspanel.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/projectedits.h"
#include "editor/docks/carddelegate.h"
#include "editor/docks/sequencecards.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QDrag>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr int pictureMilliseconds = 110;
constexpr int pictureOffset = 12;

/// Cards whose picture is what is dragged.
class CardsView : public QListView
{
protected:
    void startDrag(Qt::DropActions actions) override
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
};

} // namespace

CardsPanel::CardsPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_cards(new SequenceCards(context, this))
    , m_found(new QSortFilterProxyModel(this))
    , m_search(new QLineEdit)
    , m_view(new CardsView)
    , m_delegate(new CardDelegate(this))
{
    setObjectName(QStringLiteral("cardsPanel"));
    m_search->setObjectName(QStringLiteral("cardSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(widgets::icons::icon(QStringLiteral("search"), widgets::ColorRole::TextMuted),
                        QLineEdit::LeadingPosition);
    m_found->setSourceModel(m_cards);
    m_found->setFilterRole(SequenceCards::SearchRole);
    m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_view->setObjectName(QStringLiteral("cards"));
    m_view->setModel(m_found);
    m_view->setItemDelegate(m_delegate);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setUniformItemSizes(true);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setMouseTracking(true);
    m_view->setDragEnabled(true);
    m_view->setDragDropMode(QAbstractItemView::DragOnly);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_search);
    column->addWidget(m_view, 1);

    connect(m_search, &QLineEdit::textChanged, m_found, &QSortFilterProxyModel::setFilterFixedString);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &CardsPanel::takeSelection);
    connect(m_view, &QListView::customContextMenuRequested, this, &CardsPanel::showMenu);
    connect(&context.selection, &Selection::changed, this, &CardsPanel::showSelection);
    connect(m_found, &QAbstractItemModel::modelReset, this, &CardsPanel::showSelection);
    connect(m_view, &QListView::entered, this, [this](const QModelIndex& card) {
        setMoving(card, 0);
        if (widgets::Theme::animationMilliseconds() > 0)
            m_clock.start();
    });
    m_clock.setInterval(pictureMilliseconds);
    connect(&m_clock, &QTimer::timeout, this, &CardsPanel::animate);
    retranslates(this, [this] {
        m_search->setPlaceholderText(tr("Name or label"));
        m_search->setAccessibleName(tr("Find sequences by name or label"));
        m_view->setAccessibleName(tr("Sequences"));
    });
}

void CardsPanel::setMoving(const QModelIndex& card, int phase)
{
    m_delegate->setMoving(card, phase);
    m_cards->setMoving(m_found->mapToSource(card), phase);
}

/// Shows the next picture of the card under the pointer.
void CardsPanel::animate()
{
    const QModelIndex card = m_delegate->moving();
    const bool goesOn = card.isValid() && m_view->viewport()->underMouse() &&
                        m_view->indexAt(m_view->viewport()->mapFromGlobal(QCursor::pos())) == card;
    if (goesOn) {
        setMoving(card, m_delegate->phase() + 1);
    } else {
        m_clock.stop();
        setMoving({}, 0);
    }
    m_view->update(card);
}

void CardsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_cards->setActive(true, devicePixelRatioF());
}

void CardsPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_cards->setActive(false, devicePixelRatioF());
}

QStringList CardsPanel::selectedNames() const
{
    QStringList names;
    for (const QModelIndex& index : m_view->selectionModel()->selectedIndexes())
        names << m_cards->name(m_found->mapToSource(index));
    return names;
}

void CardsPanel::takeSelection()
{
    const QStringList names = selectedNames();
    if (m_isTaking || names.isEmpty())
        return;
    const QScopedValueRollback taking(m_isTaking, true);
    m_context.selection.selectSequences(names);
}

void CardsPanel::showSelection()
{
    if (m_isTaking)
        return;
    const QScopedValueRollback taking(m_isTaking, true);
    QItemSelection selected;
    for (const QString& name : m_context.selection.sequences()) {
        const QModelIndex card = m_found->mapFromSource(m_cards->indexOf(name));
        selected.select(card, card);
    }
    m_view->selectionModel()->select(selected, QItemSelectionModel::ClearAndSelect);
    const QModelIndex shown = m_found->mapFromSource(m_cards->indexOf(m_context.selection.shownSequence()));
    m_view->selectionModel()->setCurrentIndex(shown, QItemSelectionModel::NoUpdate);
    m_view->scrollTo(shown);
}

void CardsPanel::showMenu(const QPoint& position)
{
    const QModelIndex card = m_view->indexAt(position);
    const QString name = m_cards->name(m_found->mapToSource(card));
    if (name.isEmpty())
        return;
    QMenu menu(m_view);
    menu.addAction(tr("Rename"), m_view, [&] { m_view->edit(card); });
    menu.addAction(tr("Duplicate"), m_view, [&] { duplicateSequence(m_context.document, name); });
    menu.addAction(tr("Remove"), m_view,
                   [&] { removeEntries(m_context.document, Section::Sequences, selectedNames()); });
    const auto* medium = m_context.media.medium(name);
    if (medium != nullptr && medium->error)
        menu.addAction(tr("Try Again"), m_view, [&] { m_context.media.retry(name); });
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

} // namespace quadrille
