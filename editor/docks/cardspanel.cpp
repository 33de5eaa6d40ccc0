// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/cardspanel.h"

#include "editor/commands/entrynames.h"
#include "editor/context/editorcontext.h"
#include "editor/docks/carddelegate.h"
#include "editor/docks/cardorder.h"
#include "editor/docks/cardpictures.h"
#include "editor/docks/cardsview.h"
#include "editor/docks/sequencecards.h"
#include "editor/language/menutext.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QActionGroup>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <array>

namespace quadrille {

namespace {

constexpr int pictureMilliseconds = 110;

} // namespace

CardsPanel::CardsPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_cards(new SequenceCards(context, this))
    , m_found(new CardOrder(this))
    , m_search(new QLineEdit)
    , m_order(new QToolButton)
    , m_orders(new QActionGroup(this))
    , m_view(new CardsView)
    , m_delegate(new CardDelegate(
          [this](const QModelIndex& card, const QString& name) {
              const EntryRef entry{Section::Sequences, m_cards->name(m_found->mapToSource(card))};
              return problemWithRename(m_context.document.project(), entry, name);
          },
          this))
{
    setObjectName(QStringLiteral("cardsPanel"));
    m_search->setObjectName(QStringLiteral("cardSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(widgets::icons::icon(QStringLiteral("search"), widgets::ColorRole::TextMuted),
                        QLineEdit::LeadingPosition);
    m_found->setSourceModel(m_cards);
    m_view->setObjectName(QStringLiteral("cards"));
    m_view->setModel(m_found);
    m_view->setItemDelegate(m_delegate);
    makeOrders();
    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    top->addWidget(m_search, 1);
    top->addWidget(m_order);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(top);
    column->addWidget(m_view, 1);
    connectAll();
    // They act on the selection, which cards and tree share; renaming happens on the card itself.
    for (const char* id : {"edit.duplicate", "edit.remove"})
        m_view->addAction(context.actions.action(QLatin1String(id)));
    m_clock.setInterval(pictureMilliseconds);
    retranslates(this, [this] { retranslate(); });
}

void CardsPanel::makeOrders()
{
    m_order->setObjectName(QStringLiteral("cardOrder"));
    m_order->setIcon(widgets::icons::icon(QStringLiteral("sort")));
    m_order->setPopupMode(QToolButton::InstantPopup);
    m_order->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(m_order);
    constexpr std::array orders{CardOrder::By::Project, CardOrder::By::Name, CardOrder::By::Length,
                                CardOrder::By::Label};
    if (std::ranges::find(orders, CardOrder::By(m_context.settings.cardOrder())) != orders.end())
        m_found->setBy(CardOrder::By(m_context.settings.cardOrder()));
    for (const CardOrder::By by : orders) {
        QAction* action = menu->addAction(QString(), this, [this, by] {
            m_found->setBy(by);
            m_context.settings.setCardOrder(static_cast<int>(by));
        });
        action->setCheckable(true);
        action->setChecked(by == m_found->by());
        m_orders->addAction(action);
    }
    m_order->setMenu(menu);
}

void CardsPanel::connectAll()
{
    connect(m_search, &QLineEdit::textChanged, m_found, &QSortFilterProxyModel::setFilterFixedString);
    connect(m_search, &QLineEdit::textChanged, this, &CardsPanel::showEmptyText);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &CardsPanel::takeSelection);
    connect(m_view, &QListView::customContextMenuRequested, this, &CardsPanel::showMenu);
    connect(m_view, &QListView::activated, this, [this] { open(selectedNames()); });
    connect(&m_context.selection, &Selection::changed, this, &CardsPanel::showSelection);
    connect(m_found, &QAbstractItemModel::modelReset, this, &CardsPanel::showSelection);
    connect(m_view, &QListView::entered, this, [this](const QModelIndex& card) {
        setMoving(card, 0);
        if (widgets::Theme::animationMilliseconds() > 0)
            m_clock.start();
    });
    connect(&m_clock, &QTimer::timeout, this, &CardsPanel::animate);
}

void CardsPanel::retranslate()
{
    m_search->setPlaceholderText(tr("Name or label"));
    m_search->setAccessibleName(tr("Find sequences by name or label"));
    m_order->setToolTip(tr("Order of the cards"));
    m_order->setAccessibleName(m_order->toolTip());
    const QStringList orders{tr("As in the project"), tr("By name"), tr("By length"), tr("By label")};
    for (int i = 0; i < orders.size(); ++i)
        m_orders->actions()[i]->setText(orders[i]);
    m_view->setAccessibleName(tr("Sequences"));
    showEmptyText();
}

void CardsPanel::showEmptyText()
{
    const QString sought = m_search->text();
    m_view->setEmptyText(sought.isEmpty()
                             ? tr("No sequences yet. Drop files or folders anywhere in this window.")
                             : tr("No name or label has “%1” in it.").arg(sought));
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
    m_cards->pictures().setActive(true, devicePixelRatioF());
}

void CardsPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_cards->pictures().setActive(false, devicePixelRatioF());
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

void CardsPanel::open(const QStringList& names)
{
    if (names.isEmpty())
        return;
    m_context.selection.selectSequences(names);
    m_context.actions.action(QStringLiteral("workspace.sequences"))->trigger();
}

void CardsPanel::showMenu(const QPoint& position)
{
    const QModelIndex under = m_view->indexAt(position);
    const QModelIndex card = under.isValid() ? under : m_view->currentIndex();
    const QString name = m_cards->name(m_found->mapToSource(card));
    if (name.isEmpty())
        return;
    ActionRegistry& actions = m_context.actions;
    QMenu menu(m_view);
    menu.setObjectName(QStringLiteral("cardMenu"));
    addLooking(menu, name);
    menu.addSeparator();
    menu.addAction(tr("Rename"), m_view, [&] { m_view->edit(card); });
    menu.addAction(actions.action(QStringLiteral("edit.duplicate")));
    menu.addAction(tr("Add a label"), m_view, [&] {
        open({name});
        actions.action(QStringLiteral("edit.label"))->trigger();
    });
    menu.addAction(actions.action(QStringLiteral("edit.labelTakes")));
    menu.addSeparator();
    addMending(menu, name);
    menu.addAction(actions.action(QStringLiteral("file.export")));
    menu.addSeparator();
    menu.addAction(actions.action(QStringLiteral("edit.remove")));
    menu.exec(m_view->viewport()->mapToGlobal(under.isValid() ? position : m_view->menuPlace()));
}

/// Opens a card alone, the selected ones together, or one beside another.
void CardsPanel::addLooking(QMenu& menu, const QString& name)
{
    menu.addAction(tr("Open"), m_view, [this, name] { open({name}); });
    const QStringList selected = selectedNames();
    if (selected.size() > 1) {
        menu.addAction(tr("Compare"), m_view, [this, selected] { open(selected); });
        return;
    }
    QMenu* others = menu.addMenu(tr("Compare with"));
    for (const SequenceEntry& entry : m_context.document.project().sequences) {
        const QString other = QString::fromStdString(entry.name);
        if (other == name)
            continue;
        others->addAction(menuText(other), m_view, [this, name, other] { open({name, other}); });
    }
    others->setEnabled(!others->isEmpty());
}

/// What helps where a file is elsewhere or cannot be read.
void CardsPanel::addMending(QMenu& menu, const QString& name)
{
    const auto* resultState = m_context.media.resultState(name);
    if (resultState != nullptr && resultState->error)
        menu.addAction(tr("Try again"), m_view, [this, name] { m_context.media.retry(name); });
    menu.addAction(m_context.actions.action(QStringLiteral("file.findMissing")));
    if (const SequenceEntry* sequence = m_context.document.sequence(name); sequence != nullptr) {
        const QString folder = QFileInfo(QString::fromStdString(sequence->source)).absolutePath();
        menu.addAction(tr("Show in its folder"), m_view,
                       [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    }
}

} // namespace quadrille

#include "moc_cardspanel.cpp"
