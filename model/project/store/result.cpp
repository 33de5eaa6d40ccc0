// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/result.h"

#include <array>

namespace quadrille {

std::size_t valueCount(const DataValues& values)
{
    return std::visit([](const auto& list) { return list.size(); }, values);
}

std::uint64_t bytesOf(const Result& result)
{
    const auto bytesOfArray = [](const DataArray& array) -> std::uint64_t {
        if (const auto* texts = std::get_if<TextColumn>(&array.values))
            return texts->bytes();
        return std::visit(
            [](const auto& list) {
                return list.size() * sizeof(typename std::decay_t<decltype(list)>::value_type);
            },
            array.values);
    };
    std::uint64_t bytes = sizeof(Result);
    for (const DataArray& array : result.arrays)
        bytes += bytesOfArray(array);
    for (const DataTable& table : result.tables) {
        for (const DataArray& column : table.columns)
            bytes += bytesOfArray(column);
    }
    return bytes;
}

std::string typeName(const DataValues& values)
{
    static constexpr std::array<const char*, std::variant_size_v<DataValues>> names{
        "float32", "float64", "int64", "uint8", "text", "float32", "uint16"};
    return names.at(values.index());
}

} // namespace quadrille
