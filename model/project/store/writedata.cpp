// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/message.h"
#include "model/core/npy.h"
#include "model/core/stagedfiles.h"
#include "model/project/json/jsontext.h"
#include "model/project/store/dataitem.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>

namespace quadrille {

namespace {

template <typename T>
void appendBytes(std::string& out, T value)
{
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    out.append(bytes.data(), bytes.size());
}

/// A value as readers of data get it: counts as numbers that may be infinite.
template <typename T>
decltype(auto) given(const T& value)
{
    if constexpr (std::is_same_v<T, std::uint16_t>)
        return value == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(value);
    else
        return (value);
}

/// Shortest text that reads back as the same number; "inf" and "nan" where there is no value.
template <typename T>
std::string toText(T value)
{
    if constexpr (std::is_same_v<T, std::string>) {
        return value;
    } else {
        std::array<char, 32> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
        return {text.data(), end};
    }
}

std::u32string codePoints(const std::string& utf8)
{
    std::u32string points;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        const std::size_t more = byte < 0x80 ? 0 : byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
        char32_t point = more == 0 ? byte : byte & (0x3FU >> more);
        for (std::size_t k = 1; k <= more && i + k < utf8.size(); ++k)
            point = (point << 6U) | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
        points += point;
        i += more + 1;
    }
    return points;
}

/// NumPy's name of a type and the bytes of one row.
struct NpyColumn
{
    std::string type;
    std::function<void(std::string&, std::size_t)> append;
};

NpyColumn npyColumn(const DataValues& values)
{
    static constexpr std::array<const char*, std::variant_size_v<DataValues>> types{
        "<f4", "<f8", "<i8", "|u1", "", "<f4", "<f4"};
    if (const auto* texts = std::get_if<TextColumn>(&values)) {
        std::size_t width = 1;
        for (const std::string& text : texts->words())
            width = std::max(width, codePoints(text).size());
        return {"<U" + std::to_string(width), [texts, width](std::string& out, std::size_t row) {
                    std::u32string points = codePoints((*texts)[row]);
                    points.resize(width);
                    for (const char32_t point : points)
                        appendBytes(out, static_cast<std::uint32_t>(point));
                }};
    }
    return {types.at(values.index()), [&values](std::string& out, std::size_t row) {
                std::visit(
                    [&](const auto& list) {
                        if constexpr (!std::is_same_v<std::decay_t<decltype(list)>, TextColumn>)
                            appendBytes(out, given(list[row]));
                    },
                    values);
            }};
}

std::string npy(const std::string& description, const std::vector<std::int64_t>& shape,
                const std::vector<NpyColumn>& columns, std::size_t rows)
{
    std::string out = npyHeader(description, shape);
    for (std::size_t row = 0; row < rows; ++row) {
        for (const NpyColumn& column : columns)
            column.append(out, row);
    }
    return out;
}

std::string toNpy(const DataArray& array)
{
    const NpyColumn column = npyColumn(array.values);
    return npy("'" + column.type + "'", array.shape, {column}, valueCount(array.values));
}

std::string toNpy(const DataTable& table)
{
    std::string description = "[";
    std::vector<NpyColumn> columns;
    for (const DataArray& column : table.columns) {
        columns.push_back(npyColumn(column.values));
        description += "('" + column.name + "', '" + columns.back().type + "'), ";
    }
    const std::size_t rows = table.columns.empty() ? 0 : valueCount(table.columns.front().values);
    return npy(description + "]", {static_cast<std::int64_t>(rows)}, columns, rows);
}

std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted.append(c == '"' ? "\"\"" : std::string(1, c));
    return quoted + "\"";
}

std::string withUnit(const std::string& name, const std::string& unit)
{
    return csvField(unit.empty() ? name : name + " (" + unit + ")");
}

std::string valueText(const DataValues& values, std::size_t index)
{
    return std::visit([index](const auto& list) { return toText(given(list[index])); }, values);
}

/// As valueText; empty where a table has no value.
std::string cellText(const DataValues& values, std::size_t index)
{
    const bool isNone = std::visit(
        [index](const auto& list) {
            if constexpr (std::is_floating_point_v<typename std::decay_t<decltype(list)>::value_type>)
                return std::isnan(list[index]);
            else
                return false;
        },
        values);
    return isNone ? std::string() : valueText(values, index);
}

/// One row per index of the first dimension, the others side by side.
std::string toCsv(const DataArray& array)
{
    const std::size_t count = valueCount(array.values);
    const std::size_t rows = array.shape.empty() ? 1 : static_cast<std::size_t>(array.shape.front());
    const std::size_t width = rows == 0 ? array.columns.size() : count / rows;
    std::string out;
    for (std::size_t c = 0; c < width; ++c) {
        const std::string name = c < array.columns.size() ? array.columns[c]
                                 : width == 1             ? array.name
                                                          : std::to_string(c);
        out.append(c == 0 ? "" : ",").append(withUnit(name, array.unit));
    }
    out += '\n';
    for (std::size_t i = 0; i < count; ++i) {
        out += csvField(valueText(array.values, i));
        out += (i + 1) % width == 0 ? '\n' : ',';
    }
    return out;
}

std::string toCsv(const DataTable& table)
{
    std::string out;
    const std::size_t rows = table.columns.empty() ? 0 : valueCount(table.columns.front().values);
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        out.append(c == 0 ? "" : ",").append(withUnit(table.columns[c].name, table.columns[c].unit));
    out += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            out.append(c == 0 ? "" : ",").append(csvField(cellText(table.columns[c].values, row)));
        out += '\n';
    }
    return out;
}

/// Numbers that JSON cannot hold become null.
Json jsonValue(const DataValues& values, std::size_t index)
{
    return std::visit(
        [index](const auto& list) -> Json {
            const auto& value = given(list[index]);
            if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
                if (!std::isfinite(value))
                    return nullptr;
            }
            return value;
        },
        values);
}

Json nested(const DataArray& array, std::size_t dimension, std::size_t& next)
{
    if (dimension == array.shape.size())
        return jsonValue(array.values, next++);
    Json json = Json::array();
    for (std::int64_t i = 0; i < array.shape[dimension]; ++i)
        json.push_back(nested(array, dimension + 1, next));
    return json;
}

Json toJson(const DataArray& array)
{
    Json json = Json::object();
    json["description"] = array.description;
    json["unit"] = array.unit;
    json["shape"] = array.shape;
    if (!array.columns.empty())
        json["columns"] = array.columns;
    std::size_t next = 0;
    json["values"] = nested(array, 0, next);
    return json;
}

Json toJson(const DataTable& table)
{
    Json json = Json::object();
    json["description"] = table.description;
    json["units"] = Json::object();
    json["columns"] = Json::object();
    for (const DataArray& column : table.columns) {
        std::size_t next = 0;
        json["units"][column.name] = column.unit;
        json["columns"][column.name] = nested(column, 0, next);
    }
    return json;
}

} // namespace

std::string dataAsCsv(const DataItem& item)
{
    return std::visit([](const auto& data) { return toCsv(data); }, item.content);
}

void writeData(const DataItem& item, const std::filesystem::path& file, WriteGuard* guard)
{
    const std::string extension = lowerExtension(file);
    const auto content = std::visit(
        [&](const auto& data) -> std::string {
            if (extension == ".npy")
                return toNpy(data);
            if (extension == ".csv")
                return toCsv(data);
            if (extension != ".json")
                throw Error(ErrorCode::BadArgument,
                            {file,
                             {},
                             {{"reason", QUADRILLE_MESSAGE("Data cannot be written in this format")},
                              {"remedy", QUADRILLE_MESSAGE("Choose .npy, .csv or .json.")}}});
            Json json = toJson(data);
            json["name"] = item.name;
            return writeJson(json);
        },
        item.content);
    writeGuarded(file, content, guard);
}

} // namespace quadrille
