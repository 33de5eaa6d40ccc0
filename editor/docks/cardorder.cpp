// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/cardorder.h"

#include "editor/docks/sequencecards.h"

namespace quadrille {

CardOrder::CardOrder(QObject* parent) : QSortFilterProxyModel(parent)
{
    m_collator.setNumericMode(true);
    m_collator.setCaseSensitivity(Qt::CaseInsensitive);
    setFilterRole(SequenceCards::SearchRole);
    setFilterCaseSensitivity(Qt::CaseInsensitive);
}

void CardOrder::setBy(By by)
{
    m_by = by;
    // A column of −1 gives the order of the project back.
    sort(by == By::Project ? -1 : 0);
    invalidate();
}

bool CardOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    if (m_by == By::Length) {
        const double first = left.data(SequenceCards::SecondsRole).toDouble();
        const double second = right.data(SequenceCards::SecondsRole).toDouble();
        if (first != second)
            return first < second;
    }
    if (m_by == By::Label) {
        const QString first = left.data(SequenceCards::LabelNamesRole).toStringList().value(0);
        const QString second = right.data(SequenceCards::LabelNamesRole).toStringList().value(0);
        if (first.isEmpty() != second.isEmpty())
            return second.isEmpty();
        if (const int order = m_collator.compare(first, second); order != 0)
            return order < 0;
    }
    return m_collator.compare(left.data().toString(), right.data().toString()) < 0;
}

} // namespace quadrille

#include "moc_cardorder.cpp"
