// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/result.h"

#include <initializer_list>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace quadrille {

/// A table that is written row by row.
class TableBuilder
{
public:
    using Cell = std::variant<double, std::int64_t, std::string>;

    TableBuilder(std::string name, std::string description);

    // Columns, from the left to the right, before the first row.
    TableBuilder& text(std::string name);
    TableBuilder& whole(std::string name, std::string unit = {});
    TableBuilder& real(std::string name, std::string unit = {});

    /// Makes room for rows, so that large tables do not take twice theirs while they grow.
    void reserve(std::size_t rows);
    /// \pre As many cells as columns, each of its column's type.
    void add(std::span<const Cell> cells);
    void add(std::initializer_list<Cell> cells) { add(std::span(cells.begin(), cells.size())); }
    /// What was written; the builder is not used any more.
    DataTable table() &&;

private:
    DataTable m_table;
};

} // namespace quadrille
