// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/tablebuilder.h"

#include <cassert>
#include <type_traits>

namespace quadrille {

TableBuilder::TableBuilder(std::string name, std::string description)
    : m_table{std::move(name), std::move(description), {}}
{
}

TableBuilder& TableBuilder::text(std::string name)
{
    m_table.columns.push_back(columnOf(std::move(name), "", std::vector<std::string>()));
    return *this;
}

TableBuilder& TableBuilder::whole(std::string name, std::string unit)
{
    m_table.columns.push_back(columnOf(std::move(name), std::move(unit), std::vector<std::int64_t>()));
    return *this;
}

TableBuilder& TableBuilder::real(std::string name, std::string unit)
{
    m_table.columns.push_back(columnOf(std::move(name), std::move(unit), std::vector<double>()));
    return *this;
}

void TableBuilder::reserve(std::size_t rows)
{
    for (DataArray& column : m_table.columns) {
        std::visit(
            [rows](auto& values) {
                if constexpr (requires { values.reserve(rows); })
                    values.reserve(rows);
            },
            column.values);
    }
}

void TableBuilder::add(std::span<const Cell> cells)
{
    assert(cells.size() == m_table.columns.size());
    auto column = m_table.columns.begin();
    for (const Cell& cell : cells) {
        std::visit(
            [&](const auto& value) {
                using Value = std::decay_t<decltype(value)>;
                using Column =
                    std::conditional_t<std::is_same_v<Value, std::string>, TextColumn, std::vector<Value>>;
                std::get<Column>(column->values).push_back(value);
            },
            cell);
        ++column->shape.front();
        ++column;
    }
}

DataTable TableBuilder::table() &&
{
    return std::move(m_table);
}

} // namespace quadrille
