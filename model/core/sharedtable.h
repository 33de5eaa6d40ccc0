// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/mappedbytes.h"
#include "model/core/table.h"

#include <cassert>
#include <memory>
#include <utility>

namespace quadrille {

/// A table that is never changed and that all who have a copy of this share: as cheap to copy as a pointer,
/// however large the table is. It is in memory, or in a file of which only what is looked at takes memory.
/// Its numbers are also a range, row by row. Equal where the numbers are.
template <typename Value>
class SharedTable
{
public:
    using value_type = Value;

    SharedTable() = default;
    explicit SharedTable(Table<Value> table)
        : m_table(std::make_shared<Table<Value>>(std::move(table))), m_view(*m_table)
    {
    }
    /// \pre As many bytes as the table takes, aligned as its numbers need.
    SharedTable(std::shared_ptr<const MappedBytes> file, Eigen::Index rows, Eigen::Index columns)
        : m_file(std::move(file))
        , m_view(reinterpret_cast<const Value*>(m_file->bytes().data()), rows, columns)
    {
        assert(m_file->bytes().size() == size() * sizeof(Value));
    }

    const TableView<Value>& operator*() const { return m_view; }
    const TableView<Value>* operator->() const { return &m_view; }
    const Value& operator()(Eigen::Index row, Eigen::Index column) const
    {
        return m_view.coeffRef(row, column);
    }
    const Value* data() const { return m_view.data(); }
    std::size_t size() const { return static_cast<std::size_t>(m_view.size()); }
    bool empty() const { return size() == 0; }
    const Value* begin() const { return data(); }
    const Value* end() const { return data() + size(); }
    const Value& operator[](std::size_t index) const { return data()[index]; }

    /// The table to be changed: itself where it is in memory and nobody else shares it, else a copy.
    Table<Value> take() &&
    {
        if (m_table && m_table.use_count() == 1)
            return std::move(*m_table);
        Table<Value> copy = m_view;
        unload();
        return copy;
    }

    /// Gives back the memory of a table in a file until it is looked at again.
    void unload() const
    {
        if (m_file)
            m_file->unload();
    }

    bool operator==(const SharedTable& other) const
    {
        return m_view.rows() == other->rows() && m_view.cols() == other->cols() &&
               (data() == other.data() || (m_view == *other).all());
    }

private:
    std::shared_ptr<Table<Value>> m_table; ///< null where it is in a file; changed by nobody
    std::shared_ptr<const MappedBytes> m_file;
    TableView<Value> m_view;
};

} // namespace quadrille
