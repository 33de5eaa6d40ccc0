// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/namedelegate.h"

#include <QPersistentModelIndex>

namespace quadrille {

/// Paints a row of SequenceCards: the sequence's colour, picture, name, length and the strip of labels.
class CardDelegate : public NameDelegate
{
    Q_OBJECT

public:
    using NameDelegate::NameDelegate;

    /// The card that moves, and how many pictures it has gone on by. An invalid card: none moves.
    void setMoving(const QModelIndex& card, int phase);
    QModelIndex moving() const { return m_moving; }
    int phase() const { return m_phase; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

private:
    QPersistentModelIndex m_moving;
    int m_phase = 0;
};

} // namespace quadrille
