// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <new>

namespace quadrille {

/// A dense table in rows, such as a value for each pair of frames; rows and columns count from zero.
template <typename Value>
using Table = Eigen::Array<Value, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A table that somebody else holds, for reading: to tables what std::span is to vectors. Every table is one;
/// what is made of a temporary must not outlive it.
template <typename Value>
class TableView : public Eigen::Map<const Table<Value>>
{
    using Base = Eigen::Map<const Table<Value>>;

public:
    TableView() : TableView(nullptr, 0, 0) {}
    TableView(const Value* data, Eigen::Index rows, Eigen::Index columns) : Base(data, rows, columns) {}
    TableView(const Table<Value>& table) : TableView(table.data(), table.rows(), table.cols()) {}
    TableView(const TableView&) noexcept = default;
    ~TableView() = default;
    /// Looks at the other table from now on.
    TableView& operator=(const TableView& other)
    {
        if (this != &other)
            new (static_cast<Base*>(this)) Base(other.data(), other.rows(), other.cols());
        return *this;
    }
};

} // namespace quadrille
