// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QLineEdit;
class QListView;
class QSortFilterProxyModel;

namespace quadrille {

class CardDelegate;
class SequenceCards;
struct EditorContext;

/// The sequences as cards that move while the pointer is over them, with a field that finds them by name and
/// label. Selecting shows a sequence, selecting several compares them; dragged, a card takes the frame along
/// that its picture shows.
class CardsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit CardsPanel(EditorContext& context, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void takeSelection();
    void showSelection();
    void showMenu(const QPoint& position);
    QStringList selectedNames() const;
    void setMoving(const QModelIndex& card, int phase);
    void animate();

    EditorContext& m_context;
    SequenceCards* m_cards;
    QSortFilterProxyModel* m_found;
    QLineEdit* m_search;
    QListView* m_view;
    CardDelegate* m_delegate;
    QTimer m_clock;
    bool m_isTaking = false;
};

} // namespace quadrille
