// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/sharedtable.h"
#include "model/project/store/textcolumn.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace quadrille {

/// Numbers or texts of one type, row-major. Of all pairs of frames they are tables that are shared: numbers
/// of single precision, or counts, where 0 says that there is none (for those who read data, ∞). A matrix of
/// single precision is always such a table.
using DataValues =
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::int64_t>,
                 std::vector<std::uint8_t>, TextColumn, SharedTable<float>, SharedTable<std::uint16_t>>;

/// A named array with its shape and unit.
struct DataArray
{
    std::string name;        ///< inside its result, kebab-case ("bounds")
    std::string description; ///< English, one sentence
    std::string unit;        ///< "m", "frames", …; empty for numbers without one
    std::vector<std::int64_t> shape;
    DataValues values; ///< as many as the product of the shape
    /// Names of what stands along all dimensions but the first, flattened; for tables' headers. May be empty.
    std::vector<std::string> columns;

    bool operator==(const DataArray&) const = default;
};

static_assert(std::is_nothrow_move_constructible_v<DataArray>, "lists of large ones grow without copies");

/// A table: columns of one length.
struct DataTable
{
    std::string name;
    std::string description;
    std::vector<DataArray> columns; ///< each of one dimension

    bool operator==(const DataTable&) const = default;
};

/// A file that a step wrote outside of the store.
struct WrittenFile
{
    std::string path; ///< relative to the project's folder
    std::string hash; ///< of its content

    bool operator==(const WrittenFile&) const = default;
};

/// What a step computes.
struct Result
{
    std::vector<DataArray> arrays;
    std::vector<DataTable> tables;
    std::vector<WrittenFile> files;

    bool operator==(const Result&) const = default;
};

using ResultPointer = std::shared_ptr<const Result>;

/// The values of a table's column. \param Column  an alternative of DataValues. \pre There is one of this
/// name and type.
template <typename Column>
const Column& columnNamed(const DataTable& table, const std::string& name)
{
    return std::get<Column>(std::ranges::find(table.columns, name, &DataArray::name)->values);
}

std::size_t valueCount(const DataValues& values);
/// Bytes that a result takes, about.
std::uint64_t bytesOf(const Result& result);
/// "float32", "float64", "int64", "uint8", "uint16" or "text".
std::string typeName(const DataValues& values);

/// The rows of a table column or of an array as one number each.
template <typename T>
DataArray columnOf(std::string name, std::string unit, std::vector<T> values)
{
    DataArray column;
    column.name = std::move(name);
    column.unit = std::move(unit);
    column.shape = {static_cast<std::int64_t>(values.size())};
    column.values = std::move(values);
    return column;
}

} // namespace quadrille
