// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/npy.h"
#include "model/geometry/symmetry.h"

#include <charconv>
#include <cstring>
#include <limits>

namespace quadrille {

namespace {

/// Numbers of a file in rows: of one column, or of two.
struct Numbers
{
    std::vector<std::int64_t> values;
    bool areRowsOfTwo = false;
};

[[noreturn]] void refuse(const std::filesystem::path& file, std::string reason,
                         std::optional<std::int64_t> line = {})
{
    throw Error(
        ErrorCode::FileSyntax,
        {file, {.line = line, .column = {}, .byte = {}, .frame = {}}, {{"reason", std::move(reason)}}});
}

template <typename Value>
std::vector<std::int64_t> valuesOf(std::string_view bytes)
{
    std::vector<std::int64_t> values;
    for (std::size_t i = 0; i + sizeof(Value) <= bytes.size(); i += sizeof(Value)) {
        Value value;
        std::memcpy(&value, bytes.data() + i, sizeof value);
        const bool fits = std::in_range<std::int64_t>(value);
        values.push_back(fits ? static_cast<std::int64_t>(value) : std::numeric_limits<std::int64_t>::max());
    }
    return values;
}

Numbers readArray(std::string_view content, const std::filesystem::path& file)
{
    const NpyHeader header = parseNpyHeader(content, file);
    Numbers numbers;
    const auto& shape = header.shape;
    numbers.areRowsOfTwo = shape.size() == 2 && shape[1] == 2 && !header.isFortranOrder;
    if (shape.size() != 1 && !numbers.areRowsOfTwo)
        refuse(file, "an array of one row of numbers, or of rows of two in C order, is needed");
    const std::string_view bytes = content.substr(header.size);
    if (header.type == "<i8")
        numbers.values = valuesOf<std::int64_t>(bytes);
    else if (header.type == "<i4")
        numbers.values = valuesOf<std::int32_t>(bytes);
    else if (header.type == "<i2")
        numbers.values = valuesOf<std::int16_t>(bytes);
    else if (header.type == "<u8")
        numbers.values = valuesOf<std::uint64_t>(bytes);
    else if (header.type == "<u4")
        numbers.values = valuesOf<std::uint32_t>(bytes);
    else if (header.type == "<u2")
        numbers.values = valuesOf<std::uint16_t>(bytes);
    else
        refuse(file, "whole numbers of 2, 4 or 8 bytes are needed, not " + header.type);
    const auto found = static_cast<std::int64_t>(numbers.values.size() / (numbers.areRowsOfTwo ? 2 : 1));
    if (shape[0] != found)
        throw Error(ErrorCode::FileTruncated,
                    {file, {}, {{"expected", std::to_string(shape[0])}, {"found", std::to_string(found)}}});
    return numbers;
}

/// Numbers of one line; a comment ends it.
std::vector<std::int64_t> numbersOf(std::string_view line, const std::filesystem::path& file,
                                    std::int64_t number)
{
    constexpr std::string_view between = " \t\r,;";
    line = line.substr(0, line.find('#'));
    std::vector<std::int64_t> values;
    std::size_t place = line.find_first_not_of(between);
    while (place != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(between, place), line.size());
        const std::string_view word = line.substr(place, end - place);
        std::int64_t value = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || stop != word.data() + word.size())
            refuse(file, "“" + std::string(word) + "” is no whole number", number);
        values.push_back(value);
        place = line.find_first_not_of(between, end);
    }
    return values;
}

Numbers readText(std::string_view content, const std::filesystem::path& file)
{
    Numbers numbers;
    std::int64_t line = 0;
    std::int64_t rows = 0;
    bool areRowsOfTwo = true;
    while (!content.empty()) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        const std::vector<std::int64_t> values = numbersOf(content.substr(0, end), file, ++line);
        content.remove_prefix(std::min(end + 1, content.size()));
        if (values.empty())
            continue;
        ++rows;
        areRowsOfTwo = areRowsOfTwo && values.size() == 2;
        numbers.values.insert(numbers.values.end(), values.begin(), values.end());
    }
    // One row of two numbers is the map of a mesh of two vertices, which has no triangle.
    numbers.areRowsOfTwo = areRowsOfTwo && rows > 0;
    return numbers;
}

VertexIndex vertexOf(std::int64_t value, std::uint32_t count, const std::filesystem::path& file)
{
    if (value < 0 || value >= std::int64_t{count})
        throw Error(ErrorCode::SymmetryMapWrong,
                    {file, {}, {{"reason", "there is no vertex " + std::to_string(value)}}});
    return VertexIndex(value);
}

} // namespace

Symmetry readSymmetry(const Topology& topology, const std::filesystem::path& file)
{
    const FileContent content = readFile(file);
    const std::string_view text = content.text();
    const bool isArray = text.starts_with("\x93NUMPY");
    const Numbers numbers = isArray ? readArray(text, file) : readText(text, file);
    const std::uint32_t count = topology.vertexCount();
    std::vector<VertexIndex> opposite;
    if (!numbers.areRowsOfTwo) {
        for (const std::int64_t value : numbers.values)
            opposite.push_back(vertexOf(value, count, file));
        return checkedSymmetry(topology, std::move(opposite), file);
    }
    for (std::uint32_t v = 0; v < count; ++v)
        opposite.emplace_back(v);
    for (std::size_t i = 0; i < numbers.values.size(); i += 2) {
        const VertexIndex a = vertexOf(numbers.values[i], count, file);
        const VertexIndex b = vertexOf(numbers.values[i + 1], count, file);
        opposite[a.value] = b;
        opposite[b.value] = a;
    }
    return checkedSymmetry(topology, std::move(opposite), file);
}

} // namespace quadrille
