// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QListView>

namespace quadrille {

/// The list of cards: what is dragged shows the picture of the card that is taken, and where there is no card
/// it says why.
class CardsView : public QListView
{
    Q_OBJECT

public:
    explicit CardsView(QWidget* parent = nullptr);

    /// What stands there while there are no cards.
    void setEmptyText(const QString& text);
    /// Where a menu about the current card opens that was asked for by key; in pixels of the list.
    QPoint menuPlace() const;

protected:
    void startDrag(Qt::DropActions actions) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_emptyText;
};

} // namespace quadrille
