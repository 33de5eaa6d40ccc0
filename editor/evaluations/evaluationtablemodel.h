// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/dataitem.h"

#include <QAbstractTableModel>
#include <vector>

namespace quadrille {

/// One table of an evaluation; of several characters one below the other, with their names before.
class EvaluationTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role
    {
        SortRole = Qt::UserRole ///< a number or a text
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows other tables; none make it empty.
    /// \pre All are tables of the same columns.
    void show(std::vector<DataItem> tables);
    const std::vector<DataItem>& tables() const { return m_tables; }
    /// With header rows as data files have them; of several characters one block after the other.
    QString csv() const;
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    bool namesCharacter() const { return m_tables.size() > 1; }
    const DataArray& columnOf(int column) const;

    std::vector<DataItem> m_tables;
    std::vector<std::pair<std::size_t, std::size_t>> m_rows; ///< table, and row of it
};

} // namespace quadrille
