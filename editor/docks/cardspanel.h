// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QActionGroup;
class QLineEdit;
class QMenu;
class QToolButton;

namespace quadrille {

class CardDelegate;
class CardOrder;
class CardsView;
class SequenceCards;
struct EditorContext;

/// The sequences as cards that move while the pointer is over them, with a field that finds them by name and
/// label, in an order that can be chosen. Selecting shows a sequence, selecting several compares them;
/// dragged, a card takes the frame along that its picture shows.
class CardsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit CardsPanel(EditorContext& context, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeOrders();
    void connectAll();
    void retranslate();
    void takeSelection();
    void showSelection();
    void showEmptyText();
    void showMenu(const QPoint& position);
    void addLooking(QMenu& menu, const QString& name);
    void addMending(QMenu& menu, const QString& name);
    void open(const QStringList& names);
    QStringList selectedNames() const;
    void setMoving(const QModelIndex& card, int phase);
    void animate();

    EditorContext& m_context;
    SequenceCards* m_cards;
    CardOrder* m_found;
    QLineEdit* m_search;
    QToolButton* m_order;
    QActionGroup* m_orders;
    CardsView* m_view;
    CardDelegate* m_delegate;
    QTimer m_clock;
    bool m_isTaking = false;
};

} // namespace quadrille
