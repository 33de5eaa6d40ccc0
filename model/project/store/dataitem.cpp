// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/dataitem.h"

namespace quadrille {

std::vector<std::int64_t> DataItem::shape() const
{
    if (const auto* array = std::get_if<DataArray>(&content))
        return array->shape;
    const auto& columns = std::get<DataTable>(content).columns;
    const std::int64_t rows = columns.empty() ? 0 : columns.front().shape.front();
    return {rows, static_cast<std::int64_t>(columns.size())};
}

std::string DataItem::unit() const
{
    if (const auto* array = std::get_if<DataArray>(&content))
        return array->unit;
    return "table";
}

std::string DataItem::description() const
{
    return std::visit([](const auto& data) { return data.description; }, content);
}

} // namespace quadrille
