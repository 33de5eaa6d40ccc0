// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"

#include <memory>
#include <utility>

namespace quadrille {

/// A table that is never changed and that all who have a copy of this share: as cheap to copy as a pointer,
/// however large the table is. Its numbers are also a range, row by row. Equal where the numbers are.
template <typename Value>
class SharedTable
{
public:
    using value_type = Value;

    SharedTable() : SharedTable(Table<Value>()) {}
    explicit SharedTable(Table<Value> table) : m_table(std::make_shared<Table<Value>>(std::move(table))) {}

    const Table<Value>& operator*() const { return *m_table; }
    const Table<Value>* operator->() const { return m_table.get(); }
    const Value* data() const { return m_table->data(); }
    std::size_t size() const { return static_cast<std::size_t>(m_table->size()); }
    bool empty() const { return size() == 0; }
    const Value* begin() const { return data(); }
    const Value* end() const { return data() + size(); }
    const Value& operator[](std::size_t index) const { return data()[index]; }

    /// The table to be changed: itself where nobody else shares it, else a copy.
    Table<Value> take() &&
    {
        if (m_table.use_count() > 1)
            return *m_table;
        return std::move(*m_table);
    }

    bool operator==(const SharedTable& other) const
    {
        const Table<Value>& own = *m_table;
        return m_table == other.m_table ||
               (own.rows() == other->rows() && own.cols() == other->cols() && (own == *other).all());
    }

private:
    std::shared_ptr<Table<Value>> m_table; ///< never null; changed by nobody
};

} // namespace quadrille
